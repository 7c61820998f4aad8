// SPDX-License-Identifier: GPL-3.0-or-later
// The verb `contact`: contact area and clearance of each surface, kind of tilt and tilt.
#include "hdconj/contact.hpp"

#include <algorithm>

#include "arguments.hpp"
#include "hdconj/contact_files.hpp"
#include "hdconj/error.hpp"
#include "hdconj/mesh_files.hpp"
#include "hdconj/scene/schema.hpp"
#include "run_verb.hpp"

namespace hdconj::cli {
namespace {

namespace fs = std::filesystem;

struct ContactArguments
{
    CaseArguments cases;
    bool best = false;
    int revolution = 0;
    bool no_errors = false;
    std::string output;  ///< result file; empty: named after the scene file
    std::string picture;
    std::string xdmf, stl, vtk;
    bool ring = false;
};

/// The toothed surface in the formats asked for. @param result  the result file, which XDMF can refer to
void add_surfaces(Work<ContactStudy>& work, ContactArguments const& own, fs::path const& result)
{
    SurfaceOptions surface;
    surface.ring = own.ring;
    add_file(work, "xdmf", "--xdmf", own.xdmf, [result, surface](ContactStudy const& study, fs::path const& file) {
        if (surface.ring)
            write_xdmf(study.solution, file, surface);
        else
            write_xdmf(study.solution, file, result);
    });
    if (!own.xdmf.empty() && own.ring)
        work.outputs.back().target.members = {own.xdmf + ".h5"};
    add_file(work, "stl", "--stl", own.stl,
             [surface](ContactStudy const& study, fs::path const& file) { write_stl(study.solution, file, surface); });
    add_file(work, "vtk", "--vtk", own.vtk,
             [surface](ContactStudy const& study, fs::path const& file) { write_vtk(study, file, surface); });
}

void add_files(Work<ContactStudy>& work, CommonOptions const& common, ContactArguments const& own, Scene const& scene)
{
    fs::path const result = output_name(common, own.output, scene, "-contact.h5");
    add_file(work, "hdf5", "--output", result,
             [](ContactStudy const& study, fs::path const& file) { write_hdf5(study, file); });
    add_surfaces(work, own, result);
    if (own.picture.empty())
        return;
    fs::path const picture = own.picture;
    auto const [tilt, map, flank] = contact_picture_names(picture);
    work.outputs.push_back(
        {{"picture", "--picture", picture, [picture] { check_contact_pictures(picture); }, {tilt, map, flank}},
         [picture](ContactStudy const& study) { return write_contact_pictures(study, picture); }});
}

ContactOptions options_of(ContactArguments const& own)
{
    ContactOptions options;
    own.cases.enter(options);
    options.best = own.best;
    options.revolution = own.revolution;
    options.errors = !own.no_errors;
    if (own.best && !options.tilts.empty()) {
        auto const [low, high] = std::minmax_element(options.tilts.begin(), options.tilts.end());
        options.best_from = *low;
        options.best_to = *high;
    }
    return options;
}

int run_contact(CommonOptions const& common, ContactArguments const& own)
{
    auto const reading = examine_drive(common);
    Scene const& scene = reading.scene;
    ContactOptions const options = options_of(own);
    Work<ContactStudy> work;
    work.faults = reading.faults;
    if (work.faults.empty())
        append(work.faults, check_contact(scene, options));
    sort_by_place(work.faults);
    if (own.ring && own.xdmf.empty() && own.stl.empty() && own.vtk.empty())
        work.faults.push_back({"--ring", 0, "", "no surface file is asked for that could hold the whole ring",
                               "write --xdmf, --stl or --vtk with a file name, or leave --ring out"});
    work.inputs = inputs_of(common, scene);
    add_files(work, common, own, scene);
    work.compute = [&](ProgressLine const& progress) {
        return study_contact(scene, options, progress.stages(), progress.shares());
    };
    work.text = [](ContactStudy const& study, Written const& written) { return summary_text(study, written); };
    work.json = [](ContactStudy const& study, Written const& written) { return summary_json(study, written); };
    work.status = [](ContactStudy const& study) { return status_of_missing(study.missing); };
    work.judgement = [](ContactStudy const& study) { return study.solution.judgement; };
    return run_verb(common, work);
}

constexpr char const* contact_footer =
    "A gap is the distance from a point of the circular spline's flank to the nearest tooth, in the plane of its "
    "slice.\n"
    "The circular spline turns, with wave generator and flexspline held, until teeth touch. Flank with a gap up to "
    "contact.contact_gap is then in contact.\n"
    "Where the side clearance of the scene leaves interference, the smallest without interference is used instead, and "
    "the table marks it with *.\n"
    "A surface, kind or tilt that has no result is named with its cause. The others are written, and the exit status "
    "is 1.\n"
    "Examples:\n"
    "  hdconj contact drive.toml --tilt 0,0.1,0.2,0.3 --picture tilt.svg\n"
    "  hdconj contact --set coning.model=linear --set coning.bottom_to_middle=9 --surface tilted,ruled,per-slice\n"
    "  hdconj contact drive.toml --kind radial,draft --best --tilt 0,2\n"
    "  hdconj contact drive.toml --revolution 24 --stl ring.stl --ring";

}  // namespace

void add_contact(CLI::App& program, CommonOptions& common)
{
    auto [verb, own] = add_verb(program, common, "contact",
                                "contact area, clearance and backlash, against tilt and surface", run_contact);
    add_scene_options(verb, common);
    add_strict(verb, common);
    add_case_options(verb, own.cases,
                     "tilt angles in degrees, such as 0,0.1,0.2; with --best the interval searched [the scene's]");
    verb.add_flag("--best", own.best,
                  "search the tilt with the largest contact area, and that with the smallest least side clearance");
    add_option(verb, "--revolution", own.revolution,
               "angles of the wave generator over a revolution; the table shows the one with least contact", "N",
               whole_number(1, scene::bounds::most_revolution_angles));
    verb.add_flag("--no-errors", own.no_errors, "the same figures without their errors, in less time");
    add_name(verb, "-o,--output", own.output,
             "result file, HDF5 [the scene file's name and -contact.h5, in this folder]", "FILE");
    add_name(verb, "--picture", own.picture, "drawings NAME-tilt, NAME-map, NAME-flank; needs gnuplot",
             "NAME.svg|NAME.png");
    add_name(verb, "--xdmf", own.xdmf, "toothed surface for ParaView", "FILE");
    add_name(verb, "--stl", own.stl, "toothed surface as triangles", "FILE");
    add_name(verb, "--vtk", own.vtk, "toothed surface with the gap on its flanks", "FILE");
    verb.add_flag("--ring", own.ring, "surfaces of the whole ring in place of one tooth space");
    verb.footer(contact_footer);
}

}  // namespace hdconj::cli
