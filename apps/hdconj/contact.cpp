// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `contact`: which surfaces and tilts, which files, and what is said about them.
#include "hdconj/pipeline/contact.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iostream>
#include <memory>

#include "cli.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/contact_files.hpp"
#include "hdconj/io/surface_files.hpp"
#include "hdconj/scene/schema.hpp"
#include "lists.hpp"
#include "outputs.hpp"
#include "words.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

/// What only `contact` is asked.
struct VerbOptions
{
    std::vector<double> tilts_deg;
    std::vector<std::string> surfaces;
    std::vector<std::string> kinds;
    bool best = false;
    int revolution = 0;
    std::string output;   ///< result file; empty: named after the drive
    std::string picture;  ///< empty: none
    std::string xdmf, stl, vtk;
    bool ring = false;
};

/// One file to write, and how.
struct Job
{
    OutputJob output;
    std::function<std::vector<WrittenFile>(ContactStudy const&)> write;
};

/// One file written by @p write.
template <class Write>
Job single(std::string const& kind, fs::path const& file, Write write)
{
    return {{kind, "--" + kind, file, [file] { check_target(file); }}, [kind, file, write](ContactStudy const& study) {
                return std::vector<WrittenFile>{timed(kind, file, [&] { write(study, file); })};
            }};
}

std::vector<Job> jobs_of(VerbOptions const& own, Scene const& scene)
{
    fs::path const result = own.output.empty() ? fs::path(file_name(scene.drive.name) + "-contact.h5") : fs::path(own.output);
    SurfaceOptions surface;
    surface.ring = own.ring;
    std::vector<Job> jobs;
    jobs.push_back(single("hdf5", result, [](ContactStudy const& study, fs::path const& file) { write_hdf5(study, file); }));
    jobs.back().output.option = "--output";
    if (!own.xdmf.empty()) {
        bool const whole = own.ring;
        jobs.push_back(single("xdmf", own.xdmf, [result, whole, surface](ContactStudy const& study, fs::path const& file) {
            if (whole) {
                write_xdmf(study.solution, file, surface);
            } else {
                write_xdmf(study.solution, file, result);
            }
        }));
        if (whole) {
            jobs.back().output.members = {own.xdmf + ".h5"};
        }
    }
    if (!own.stl.empty()) {
        jobs.push_back(single("stl", own.stl, [surface](ContactStudy const& study, fs::path const& file) { write_stl(study.solution, file, surface); }));
    }
    if (!own.vtk.empty()) {
        jobs.push_back(single("vtk", own.vtk, [surface](ContactStudy const& study, fs::path const& file) { write_vtk(study, file, surface); }));
    }
    if (!own.picture.empty()) {
        fs::path const picture = own.picture;
        jobs.push_back({{"picture", "--picture", picture, [picture] { check_contact_pictures(picture); }},
                        [picture](ContactStudy const& study) { return write_contact_pictures(study, picture); }});
        auto const [tilt, map, flank] = contact_picture_names(picture);
        jobs.back().output.members = {tilt, map, flank};
    }
    return jobs;
}

ContactOptions options_of(VerbOptions const& own)
{
    ContactOptions options;
    for (double const tilt : own.tilts_deg) {
        options.tilts.push_back(tilt * rad_per_deg);
    }
    options.surfaces = own.surfaces;
    options.kinds = own.kinds;
    options.best = own.best;
    options.revolution = own.revolution;
    if (own.best && !own.tilts_deg.empty()) {
        auto const [low, high] = std::minmax_element(options.tilts.begin(), options.tilts.end());
        options.best_from = *low;
        options.best_to = *high;
    }
    return options;
}

int run_contact(CommonOptions const& common, VerbOptions const& own)
{
    std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size becomes a failed write, with its reason
    if (own.ring && own.xdmf.empty() && own.stl.empty() && own.vtk.empty()) {
        throw InputError(Fault{"--ring", 0, "", "no surface is written that could be the whole ring's", "write --xdmf, --stl or --vtk with a file name, or leave --ring out"});
    }
    Scene const scene = load_scene(common);
    ContactOptions const options = options_of(own);
    if (Faults faults = check_contact(scene, options); !faults.empty()) {
        throw InputError(std::move(faults));
    }
    auto const jobs = jobs_of(own, scene);
    std::vector<OutputJob> outputs;
    for (auto const& job : jobs) {
        outputs.push_back(job.output);
    }
    check_outputs(outputs, inputs_of(common, scene));
    hdconj::cli::Progress const progress(!common.quiet);
    ContactStudy const study = contact(scene, options, [&](Stage stage) { progress.say(to_string(stage)); },
                                       [&](std::string const& what, double share) { progress.say(what, share); });
    std::vector<WrittenFile> written;
    for (auto const& job : jobs) {
        progress.say(job.output.kind);
        auto const files = job.write(study);
        written.insert(written.end(), files.begin(), files.end());
    }
    progress.clear();
    if (common.json) {
        std::cout << summary_json(study, written);
    } else if (!common.quiet) {
        std::cout << summary_text(study, written);
    }
    if (common.json && !common.quiet) {
        for (auto const& each : written) {
            std::cerr << "wrote " << each.file.string() << '\n';
        }
    }
    return status_of_cases(study.missing, study.cases.size());
}

constexpr char const* footer =
    "A gap is the distance from a point of the circular spline's flank to the nearest tooth, in the plane of its slice.\n"
    "The circular spline is turned, wave generator and flexspline held, until teeth touch; where the gap is then no larger than contact.contact_gap there is contact.\n"
    "Where the side clearance leaves interference, the least that clears is taken, and the table says so.\n"
    "Of several surfaces, kinds or tilts those that cannot be made are named, the others written, and the exit status is 1.\n"
    "Examples:\n"
    "  hdconj contact drive.toml --tilt 0,0.1,0.2,0.3 --picture tilt.svg\n"
    "  hdconj contact --set coning.model=linear --set coning.bottom_to_middle=9 --surface tilted,ruled,per-slice\n"
    "  hdconj contact drive.toml --kind radial,draft --best --tilt 0,2\n"
    "  hdconj contact drive.toml --revolution 24 --stl ring.stl --ring";

}  // namespace

void add_contact(CLI::App& program, CommonOptions& common)
{
    auto* verb = program.add_subcommand("contact", "contact area, clearance and play, against tilt and surface");
    add_scene_options(*verb, common);
    auto own = std::make_shared<VerbOptions>();
    add_list(*verb, "--tilt", [own](std::string const& given) { own->tilts_deg.push_back(angle_deg(given)); }, [](std::string const& given) { return angle_fault(given); },
             "tilt angles in degrees, such as 0,0.1,0.2; with --best the interval searched [the scene's]")
        ->type_name("DEG,...");
    add_list(*verb, "--surface", [own](std::string const& given) { own->surfaces.push_back(given); },
             [](std::string const& given) { return word_fault(given, {"tilted", "ruled", "per-slice"}); },
             "how the teeth of the circular spline are made: tilted, ruled, per-slice [the scene's, or tilted]")
        ->type_name("WORD,...");
    add_list(*verb, "--kind", [own](std::string const& given) { own->kinds.push_back(given); }, [](std::string const& given) { return word_fault(given, {"radial", "draft"}); },
             "what tilt means: radial, outline moved along its radii, or draft, along its normal [the scene's, or radial]")
        ->type_name("WORD,...");
    verb->add_flag("--best", own->best, "search the tilt of largest contact area, and that of least clearing offset");
    verb->add_option("--revolution", own->revolution, "angles of the wave generator over a revolution; the one with least contact counts")
        ->check(CLI::Range(1, 10000))
        ->type_name("N");
    verb->add_option("-o,--output", own->output, "result file, HDF5 [the drive's name and -contact.h5, in this folder]")->check(name_fault)->type_name("FILE");
    verb->add_option("--picture", own->picture, "drawings NAME-tilt, NAME-map, NAME-flank; needs gnuplot")->check(name_fault)->type_name("NAME.svg|NAME.png");
    verb->add_option("--xdmf", own->xdmf, "toothed surface for ParaView")->check(name_fault)->type_name("FILE");
    verb->add_option("--stl", own->stl, "toothed surface as triangles")->check(name_fault)->type_name("FILE");
    verb->add_option("--vtk", own->vtk, "toothed surface with the gap on its flanks")->check(name_fault)->type_name("FILE");
    verb->add_flag("--ring", own->ring, "surfaces of the whole ring in place of one tooth space");
    verb->footer(footer);
    verb->callback([&common, own] { common.action = [&common, own] { return run_contact(common, *own); }; });
}

}  // namespace hdconj::cli
