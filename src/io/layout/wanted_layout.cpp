// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a neutral curve that was wanted, as docs/reference/hdf5.md describes it.
#include "columns.hpp"
#include "figures/wanted_figures.hpp"
#include "hdconj/version.hpp"
#include "results.hpp"

namespace hdconj::io {
namespace {

using layout::Writer;

constexpr int wanted_version = 1;

void write_root(Writer const& root, WantedCurve const& found)
{
    root.attribute("format", std::string("hdconj-neutral-curve"));
    root.attribute("format_version", wanted_version);
    root.attribute("program_version", std::string(program_version()));
    root.attribute("git_revision", std::string(git_revision()));
    root.attribute("build", std::string(build_description()));
    root.attribute("date", layout::date_text());
    root.attribute("drive", found.scene.drive.name);
    layout::write_scene(root, found.scene);
    root.attribute("kinematics", std::string(to_string(found.scene.solver.kinematics)));
    if (!found.notes.empty())
        root.attribute("notes", found.notes);
}

}  // namespace

void layout::write_result(Writer const& root, WantedCurve const& found)
{
    write_root(root, found);
    root.points("neutral_curve", found.neutral_curve, "deformed neutral curve in the fixed frame, closed",
                "curve_point");
    root.points("inner_surface", found.inner_surface, "surface of the cam, parallel to the neutral curve",
                "curve_point");
    root.group("wanted_curve", [&](Writer const& place) {
        layout::write_attributes(place, figures::wanted_figures(), found);
        place.attribute("ends", found.ends);
        layout::write_columns(place, "row", figures::wanted_rows(), found.rows);
    });
}

}  // namespace hdconj::io
