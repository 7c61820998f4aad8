// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of /contact and of the surface's mesh, as docs/reference/hdf5.md describes them.
#include <algorithm>
#include <stdexcept>

#include "columns.hpp"
#include "figures/contact_figures.hpp"
#include "results.hpp"

namespace hdconj::io {
namespace {

using layout::column;
using layout::Shape;
using layout::write_columns;
using layout::Writer;

/// Columns of the places where flanks or roots come closest.
void write_closest(Writer const& place, char const* dim, std::string const& prefix,
                   std::vector<figures::ClosestPlace> const& closest, bool estimated)
{
    write_columns(place, dim, figures::closest_figures(), closest, prefix, estimated);
    place.points(prefix + "where", column(closest, [](auto const& each) { return each.at.where; }),
                 "where, in the frame of the tooth space", dim);
}

void write_smallest_gaps(Writer const& place, SmallestGaps const& gaps, std::size_t slices)
{
    Shape const shape = {gaps.angle.size(), 2, slices};
    if (gaps.gap.size() != shape[0] * shape[1] * shape[2])
        throw std::logic_error("the smallest gaps of a case do not match its spaces and slices");
    layout::write_flanks(place);
    place.numbers("angle", gaps.angle, {"rad", "centre line of the space, clockwise from the major axis", {"angle"}});
    place.array("gap", shape, gaps.gap.data(),
                {"mm",
                 "smallest gap of the flank in the plane of the slice; negative: interference",
                 {"angle", "flank", "z"},
                 layout::Owner::result});
}

void write_contact_case(Writer const& place, ContactCase const& each, bool estimated)
{
    auto const& slices = each.slices;
    using figures::ClosestPlace;
    auto const flank = [](SliceClearance const& slice) { return ClosestPlace{slice.flank, slice.flank_error}; };
    auto const root = [](SliceClearance const& slice) { return ClosestPlace{slice.root, slice.root_error}; };
    write_columns(place, "z", figures::slice_figures(), slices);
    write_closest(place, "z", "flank_", column(slices, flank), estimated);
    write_closest(place, "z", "root_", column(slices, root), estimated);
    if (!each.gaps.angle.empty())
        place.group("gaps", [&](Writer const& gaps) { write_smallest_gaps(gaps, each.gaps, slices.size()); });
    if (!each.revolution.empty()) {
        place.group("revolution", [&](Writer const& turn) {
            write_columns(turn, "wave_generator", figures::state_figures(), each.revolution, "", estimated);
        });
    }
}

void write_contact_cases(Writer const& place, std::vector<ContactCase> const& cases, bool estimated)
{
    if (std::any_of(cases.begin(), cases.end(), [](auto const& each) { return each.slices.empty(); }))
        throw std::logic_error("a contact case without slices");
    auto const closest = [](ContactCase const& each) {
        return figures::ClosestPlace{each.closest_flank(), each.clearance_error};
    };
    layout::write_surface_names(place, cases);
    write_columns(place, "case", figures::case_figures(), cases, "", estimated);
    write_closest(place, "case", "flank_", column(cases, closest), estimated);
    place.numbers("flank_z", column(cases, [](auto const& each) { return each.closest_slice().z; }),
                  {"mm", "slice where the flanks come closest", {"case"}});
    write_columns(place, "case", figures::state_figures(), column(cases, &ContactCase::state), "", estimated);
    place.groups("case", cases,
                 [&](Writer const& group, ContactCase const& each) { write_contact_case(group, each, estimated); });
}

void write_best(Writer const& place, std::vector<BestTilt> const& best, bool estimated)
{
    place.texts("goal", column(best, figures::goal_name), "what the tilt is best for", "optimum");
    place.texts("what", column(best, figures::former_goal_name), "former name of goal", "optimum");
    place.texts("kind", column(best, [](auto const& each) { return std::string(to_string(each.kind)); }),
                "kind of tilt", "optimum");
    write_columns(place, "optimum", figures::best_tilt_figures(), best);
    // one column for all cases, whose units differ
    place.numbers("value", column(best, &BestTilt::value), {"1", "what is best, in value_units", {"optimum"}});
    if (estimated)
        place.numbers("value_error", column(best, &BestTilt::value_error),
                      {"1", "estimated error of value", {"optimum"}});
    auto const units = [](BestTilt const& each) { return std::string(figures::best_value_figure(each).unit.stored); };
    place.texts("value_units", column(best, units), "units of value and value_error", "optimum");
    std::vector<double> interval;
    for (auto const& each : best)
        interval.insert(interval.end(), {each.from, each.to});
    place.array("interval", {best.size(), 2}, interval.data(), {"rad", "tilts searched", {"optimum", "end"}});
}

void write_gap_map(Writer const& place, GapMap const& map)
{
    Shape const shape = {map.angle.size(), 2, map.z.size(), map.station.size()};
    if (map.gap.size() != shape[0] * shape[1] * shape[2] * shape[3])
        throw std::logic_error("the gaps of a map do not match its spaces, slices and stations");
    layout::write_flanks(place);
    place.numbers("z", map.z, {"mm", "slices", {"z"}});
    layout::write_named(place, figures::flank_position, [&](char const* name) {
        place.numbers(name, map.station, {"1", "place along the flank, 0 at the land corner", {name}});
    });
    place.numbers("angle", map.angle, {"rad", "centre line of the space, clockwise from the major axis", {"angle"}});
    place.array("gap", shape, map.gap.data(),
                {"mm",
                 "gap in the plane of the slice; negative: interference",
                 {"angle", "flank", "z", figures::flank_position.now},
                 layout::Owner::result});
}

}  // namespace

void layout::write_flanks(layout::Writer const& place)
{
    std::vector<std::string> const flanks = {"left", "right"};
    place.attribute("flanks", flanks);
    place.texts("flank", flanks, "flank of the tooth space", "flank");
}

void layout::write_surface(layout::Writer const& place, Surface const& surface)
{
    place.array("points", {surface.points.size(), 3}, surface.points.empty() ? nullptr : surface.points.front().data(),
                {"mm", "points of the mesh, slice by slice", {"node", "xyz"}});
    place.array("quads", {surface.quads.size(), 4}, surface.quads.empty() ? nullptr : surface.quads.front().data(),
                {"1", "corners, counter-clockwise from the tooth space", {"cell", "corner"}});
    place.integers("part", surface.part, {"1", "0 land, 1 left flank, 2 root, 3 right flank", {"cell"}});
}

void layout::write_solution(Writer const& root, Solution const& solution, double side_clearance)
{
    write_solution(root, solution);
    root.group("circular_spline", [&](Writer const& place) {
        write_circular_spline(place, solution.circular_spline);
        if (has_surface(solution))
            place.group("surface", [&](Writer const& mesh) { write_surface(mesh, tooth_surface(solution)); });
        place.attribute("side_clearance_mm", side_clearance);
    });
}

void layout::write_result(Writer const& root, ContactStudy const& study)
{
    write_solution(root, study.solution, written_side_clearance(study));
    root.group("contact", [&](Writer const& contact) {
        write_attributes(contact, figures::contact_study_figures(), study);
        write_contact_cases(contact, study.cases, study.estimated);
        if (!study.best.empty())
            contact.group("best", [&](Writer const& best) { write_best(best, study.best, study.estimated); });
        if (!study.map.gap.empty())
            contact.group("map", [&](Writer const& map) { write_gap_map(map, study.map); });
    });
}

}  // namespace hdconj::io
