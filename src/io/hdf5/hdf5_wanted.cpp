// SPDX-License-Identifier: GPL-3.0-or-later
// The file of a neutral curve that was wanted, as docs/reference/hdf5.md describes it.
#include "figures/wanted_figures.hpp"
#include "hdconj/version.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "hdf5_columns.hpp"
#include "hdf5_layout.hpp"

namespace hdconj::io {
namespace {

constexpr int wanted_version = 1;

void write_root(hdf5::Writer const& root, WantedCurve const& found)
{
    root.attribute("format", std::string("hdconj-neutral-curve"));
    root.attribute("format_version", wanted_version);
    root.attribute("program_version", std::string(program_version()));
    root.attribute("git_revision", std::string(git_revision()));
    root.attribute("build", std::string(build_description()));
    root.attribute("date", hdf5::date_text());
    root.attribute("drive", found.scene.drive.name);
    root.attribute("scene", found.scene.text);
    root.attribute("kinematics", std::string(to_string(found.scene.solver.kinematics)));
    if (!found.notes.empty())
        root.attribute("notes", found.notes);
}

}  // namespace
}  // namespace hdconj::io

namespace hdconj {

void write_hdf5(WantedCurve const& found, std::filesystem::path const& file)
{
    using namespace io;
    hdf5::write_file(file, [&](hdf5::Writer const& root) {
        write_root(root, found);
        root.points("neutral_curve", found.neutral_curve, "deformed neutral curve in the fixed frame, closed",
                    "curve_point");
        root.points("inner_surface", found.inner_surface, "surface of the cam, parallel to the neutral curve",
                    "curve_point");
        root.group("wanted_curve", [&](hdf5::Writer const& place) {
            hdf5::write_attributes(place, figures::wanted_figures(), found);
            place.attribute("ends", found.ends);
            hdf5::write_columns(place, "row", figures::wanted_rows(), found.rows);
        });
    });
}

}  // namespace hdconj
