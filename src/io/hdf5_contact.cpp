// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of /contact and of the surface's mesh, as docs/hdf5.md describes them.
#include <fmt/format.h>

#include <stdexcept>

#include "contact_figures.hpp"
#include "hdconj/io/contact_files.hpp"
#include "hdf5_columns.hpp"
#include "hdf5_layout.hpp"

namespace hdconj {
namespace {

using hdf5::column;
using hdf5::Shape;
using hdf5::write_columns;
using hdf5::Writer;

void write_states(Writer const& place, std::vector<ContactState> const& states)
{
    write_columns(place, state_figures(), states);
    place.integers("teeth", column(states, [](auto const& state) { return state.teeth; }));
    place.integers("teeth_least", column(states, [](auto const& state) { return state.teeth_least; }));
    place.integers("teeth_most", column(states, [](auto const& state) { return state.teeth_most; }));
    place.integers("smallest_space", column(states, [](auto const& state) { return state.smallest_space; }));
    place.integers("smallest_spaces", column(states, [](auto const& state) { return state.smallest_spaces; }));
}

/// Three datasets of a name each: clearance, where, phi.
void write_closest(Writer const& place, std::string const& name, std::vector<Closest> const& closest)
{
    place.numbers(name + "_clearance", column(closest, [](auto const& each) { return each.clearance; }), "mm");
    place.points(name + "_where", column(closest, [](auto const& each) { return each.where; }));
    place.numbers(name + "_phi", column(closest, [](auto const& each) { return each.phi; }), "rad");
}

void write_case(Writer const& place, ContactCase const& each)
{
    auto const& slices = each.slices;
    place.numbers("z", column(slices, [](auto const& slice) { return slice.z; }), "mm");
    place.numbers("amplitude", column(slices, [](auto const& slice) { return slice.amplitude; }), "mm");
    write_closest(place, "flank", column(slices, [](auto const& slice) { return slice.flank; }));
    write_closest(place, "root", column(slices, [](auto const& slice) { return slice.root; }));
    place.numbers("flank_clearance_error", column(slices, [](auto const& slice) { return slice.flank_error; }), "mm");
    place.numbers("root_clearance_error", column(slices, [](auto const& slice) { return slice.root_error; }), "mm");
    if (!each.revolution.empty()) {
        place.group("revolution", [&](Writer const& turn) { write_states(turn, each.revolution); });
    }
}

void write_cases(Writer const& place, std::vector<ContactCase> const& cases)
{
    for (auto const& each : cases) {
        if (each.slices.empty()) {
            throw std::logic_error("a contact case without slices");
        }
    }
    place.texts("surface", column(cases, [](auto const& each) { return each.surface; }));
    place.texts("kind", column(cases, [](auto const& each) { return each.kind; }));
    write_columns(place, case_figures(), cases);
    place.integers("raised", column(cases, [](auto const& each) { return each.raised ? 1 : 0; }));
    write_closest(place, "flank", column(cases, [](auto const& each) { return each.closest_flank(); }));
    place.numbers("flank_z", column(cases, [](auto const& each) { return each.closest_slice().z; }), "mm");
    write_states(place, column(cases, [](auto const& each) { return each.state; }));
    for (std::size_t i = 0; i < cases.size(); ++i) {
        place.group(fmt::format("case_{:03}", i), [&](Writer const& group) { write_case(group, cases[i]); });
    }
}

/// What BestTilt::value is in.
std::string unit_of(BestTilt const& best)
{
    return best.what == "area" ? "1" : "mm";
}

void write_best(Writer const& place, std::vector<BestTilt> const& best)
{
    place.texts("what", column(best, [](auto const& each) { return each.what; }));
    place.texts("kind", column(best, [](auto const& each) { return each.kind; }));
    place.numbers("tilt", column(best, [](auto const& each) { return each.tilt; }), "rad");
    place.numbers("tolerance", column(best, [](auto const& each) { return each.tolerance; }), "rad");
    place.numbers("value", column(best, [](auto const& each) { return each.value; }), "1");
    place.numbers("value_error", column(best, [](auto const& each) { return each.value_error; }), "1");
    place.texts("value_units", column(best, [](auto const& each) { return unit_of(each); }));
    place.integers("on_bound", column(best, [](auto const& each) { return each.on_bound ? 1 : 0; }));
    std::vector<double> interval;
    for (auto const& each : best) {
        interval.insert(interval.end(), {each.from, each.to});
    }
    place.array("interval", {best.size(), 2}, interval.data(), "rad");
}

void write_map(Writer const& place, GapMap const& map)
{
    Shape const shape = {map.angle.size(), 2, map.z.size(), map.station.size()};
    if (map.gap.size() != shape[0] * shape[1] * shape[2] * shape[3]) {
        throw std::logic_error("the gaps of a map do not match its spaces, slices and stations");
    }
    place.attribute("flanks", std::vector<std::string>{"left", "right"});
    place.numbers("z", map.z, "mm");
    place.numbers("station", map.station, "1");
    place.numbers("angle", map.angle, "rad");
    place.array("gap", shape, map.gap.data(), "mm");
}

}  // namespace

void hdf5::write_surface(Writer const& place, Surface const& surface)
{
    place.array("points", {surface.points.size(), 3}, surface.points.empty() ? nullptr : surface.points.front().data(),
                "mm");
    place.array("quads", {surface.quads.size(), 4}, surface.quads.empty() ? nullptr : surface.quads.front().data());
    place.integers("part", surface.part);
}

void write_hdf5(ContactStudy const& study, std::filesystem::path const& file)
{
    hdf5::write_file(file, [&](Writer const& root) {
        hdf5::write_solution(root, study.solution);
        root.group("circular_spline", [&](Writer const& place) {
            hdf5::write_circular_spline(place, study.solution.circular_spline);
            place.attribute("side_clearance_mm", study.side_clearance);
            if (has_surface(study.solution)) {
                place.group("surface",
                            [&](Writer const& mesh) { hdf5::write_surface(mesh, tooth_surface(study.solution)); });
            }
        });
        root.group("contact", [&](Writer const& contact) {
            contact.attribute("contact_gap_mm", study.contact_gap);
            contact.attribute("pitch_radius_mm", study.pitch_radius);
            contact.attribute("shown", static_cast<int>(study.shown));
            write_cases(contact, study.cases);
            if (!study.best.empty()) {
                contact.group("best", [&](Writer const& best) { write_best(best, study.best); });
            }
            if (!study.map.gap.empty()) {
                contact.group("map", [&](Writer const& map) { write_map(map, study.map); });
            }
        });
    });
}

}  // namespace hdconj
