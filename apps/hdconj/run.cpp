// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `run`: what the drive does while it turns.
#include <optional>

#include "arguments.hpp"
#include "hdconj/error.hpp"
#include "hdconj/running_files.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "interrupt.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct RunArguments
{
    std::optional<double> torque_nm;
    std::optional<int> positions;
    bool no_errors = false;
    std::string output;  ///< result file; empty: named after the scene file
    std::string picture;
};

void add_run_files(Work<RunStudy>& work, CommonOptions const& common, RunArguments const& own, Scene const& scene)
{
    add_file(work, "hdf5", "--output", output_name(common, own.output, scene, "-run.h5"),
             [](RunStudy const& study, fs::path const& file) { write_hdf5(study, file); });
    if (own.picture.empty())
        return;
    fs::path const picture = own.picture;
    auto const names = run_picture_names(picture);
    work.outputs.push_back({{"picture",
                             "--picture",
                             picture,
                             [picture] { check_run_pictures(picture); },
                             {names.error, names.spectrum, names.efficiency}},
                            [picture](RunStudy const& study) { return write_run_pictures(study, picture); }});
}

int run_run(CommonOptions const& common, RunArguments const& own)
{
    auto const reading = examine_drive(common);
    Scene const& scene = reading.scene;
    RunOptions options;
    if (own.torque_nm)
        options.torque = *own.torque_nm * newton_metre;
    options.positions = own.positions;
    options.errors = !own.no_errors;
    options.stop = is_stopped;
    Faults faults = reading.faults;
    if (faults.empty())
        append(faults, check_run(scene, options));
    sort_by_place(faults);
    Work<RunStudy> work;
    work.faults = std::move(faults);
    work.inputs = inputs_of(common, scene);
    add_run_files(work, common, own, scene);
    work.compute = [&](ProgressLine const& progress) {
        stop_at_interrupt();
        try {
            return study_run(scene, options, progress.stages(), progress.shares());
        } catch (NumericalError const& error) {
            if (error.code() == ErrorCode::stopped)
                end_by_interrupt();
            throw;
        }
    };
    work.text = [](RunStudy const& study, Written const& written) { return summary_text(study, written); };
    work.json = [](RunStudy const& study, Written const& written) { return summary_json(study, written); };
    work.status = [](RunStudy const& study) { return status_of_missing(study.missing); };
    work.judgement = [](RunStudy const& study) { return study.solution.judgement; };
    return run_verb(common, work);
}

constexpr char const* run_footer =
    "The transmission error is by how much the output is ahead of the wave generator's angle over the ratio.\n"
    "It is computed unloaded, where the flanks on the working side first touch, and under torque, where the elastic "
    "drive is in balance as for hdconj load.\n"
    "Positions of the wave generator go over one tooth pitch. Where [errors] names a ring of teeth, they also go over "
    "a "
    "turn of the wave generator, at whole pitches. Where both rings have errors, unloaded ones go on until both rings "
    "meet as before.\n"
    "Without a torque (load.torque, --torque) only first contacts are computed, in the shape that the scene "
    "prescribes. load.torque is a torque on the circular spline, --torque one on the output; running.output in the "
    "scene says which member turns.\n"
    "The torque on the wave generator is without friction: its mean is the torque on the output over the ratio.\n"
    "With a table [friction] losses follow: of the sliding flanks, of the bearing by Palmgren, of seals and lubricant. "
    "They give efficiency over torque, speed and temperature ([running]), the no-load running torque (the rows at "
    "torque 0), the starting torque and the back-driving torque. Without that table nothing of friction is computed.\n"
    "Ctrl-C stops after the position that is computed and keeps what is there; once more ends the run.\n"
    "Positions without a result are named with their cause, and the exit status is 1.\n"
    "Examples:\n"
    "  hdconj run drive.toml --picture run.svg\n"
    "  hdconj run --torque 0 --set errors.circular_spline.eccentricity=0.01\n"
    "  hdconj run --torque 28 --set friction.flanks=0.08 --set friction.seal=0.02";

}  // namespace

void add_run(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] =
        add_verb(program, common, "run", "the drive while it turns: transmission error, friction, efficiency", run_run);
    add_scene_options(verb, common);
    add_strict(verb, common);
    add_option(verb, "--torque", own.torque_nm,
               "largest torque on the output in N m; 0: first contact only [load.torque, on the circular spline]", "NM",
               finite_number("write a torque in N m such as --torque 28"));
    add_option(verb, "--positions", own.positions, "of the wave generator over one tooth pitch [16]", "N",
               whole_number(scene::bounds::fewest_positions, scene::bounds::most_positions));
    verb.add_flag("--no-errors", own.no_errors, "one grid alone: the same figures without their errors, in less time");
    add_name(verb, "-o,--output", own.output, "result file, HDF5 [the scene file's name and -run.h5, in this folder]",
             "FILE");
    add_name(verb, "--picture", own.picture,
             "drawings NAME-error, NAME-spectrum and, with [friction], NAME-efficiency; needs gnuplot",
             "NAME.svg|NAME.png");
    verb.footer(run_footer);
}

}  // namespace hdconj::cli
