// SPDX-License-Identifier: GPL-3.0-or-later
// The file of an inspection, as docs/reference/hdf5.md describes it.
#include "columns.hpp"
#include "figures/inspect_figures.hpp"
#include "results.hpp"

namespace hdconj::io {
namespace {

using layout::column;
using layout::write_columns;
using layout::Writer;

constexpr int inspection_version = 1;

template <class Records>
void write_flank_words(Writer const& place, Records const& records, char const* dim)
{
    place.texts("flank", column(records, [](auto const& each) { return std::string(figures::flank_word(each.right)); }),
                "left or right", dim);
}

void write_root(Writer const& root, Inspection const& inspection)
{
    layout::write_origin(root, "hdconj-inspection", inspection_version, inspection.scene);
    layout::write_scene(root, inspection.scene);
    root.attribute("part", std::string(to_string(inspection.options.part)));
    root.attribute("points_file", inspection.file);
    root.attribute("registration", std::string(to_string(inspection.options.registration)));
    if (!inspection.notes.empty())
        root.attribute("notes", inspection.notes);
}

void write_points(Writer const& place, std::vector<PointDeviation> const& points)
{
    write_columns(place, "point", figures::point_rows(), points);
    write_flank_words(place, points, "point");
    place.texts("fate", column(points, [](auto const& each) { return std::string(to_string(each.fate)); }),
                "used, beside or stray", "point");
}

}  // namespace

void layout::write_result(Writer const& root, Inspection const& inspection)
{
    write_root(root, inspection);
    root.group("inspection", [&](Writer const& all) {
        layout::write_attributes(all, figures::inspection_figures(), inspection);
        all.group("placement", [&](Writer const& place) {
            layout::write_attributes(place, figures::placement_figures(), inspection.placement);
        });
        all.group("nominal", [&](Writer const& place) {
            write_columns(place, "plane", figures::nominal_figures(), inspection.nominal);
        });
        all.group("points", [&](Writer const& place) { write_points(place, inspection.points); });
        all.group("flanks", [&](Writer const& place) {
            write_columns(place, "row", figures::flank_rows(), inspection.flanks);
            write_flank_words(place, inspection.flanks, "row");
        });
        all.group("teeth",
                  [&](Writer const& place) { write_columns(place, "row", figures::tooth_rows(), inspection.teeth); });
        all.group("sides", [&](Writer const& place) {
            write_columns(place, "row", figures::side_rows(), inspection.sides);
            write_columns(place, "row", figures::pitch_rows(), inspection.sides);
            write_flank_words(place, inspection.sides, "row");
        });
        all.group("planes", [&](Writer const& place) {
            write_columns(place, "row", figures::plane_rows(), inspection.planes);
            write_columns(place, "row", figures::eccentricity_rows(), inspection.planes);
        });
        if (!inspection.mean_flank.empty())
            all.points("mean_flank", inspection.mean_flank, "mean right flank from tip to root, y from the pitch line",
                       "mean_point");
    });
}

}  // namespace hdconj::io
