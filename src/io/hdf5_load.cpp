// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of /load, as docs/hdf5.md describes it.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "hdf5_columns.hpp"
#include "hdf5_layout.hpp"
#include "load_figures.hpp"

namespace hdconj {
namespace {

using hdf5::column;
using hdf5::Shape;
using hdf5::write_columns;
using hdf5::Writer;

void write_states(Writer const& place, std::vector<LoadedState> const& states, char const* ball_units)
{
    write_columns(place, loaded_state_figures(), states);
    place.numbers("ball_force", column(states, [](auto const& state) { return state.ball_force; }), ball_units);
    place.integers("teeth", column(states, [](auto const& state) { return state.teeth; }));
    place.integers("pressure_space", column(states, [](auto const& state) { return state.pressure_space; }));
    place.integers("balls", column(states, [](auto const& state) { return state.balls; }));
    place.integers("rounds", column(states, [](auto const& state) { return state.rounds; }));
    place.integers("steps", column(states, [](auto const& state) { return state.steps; }));
}

/// Values of which there are as many as @p shape says.
void write_checked(Writer const& place, std::string const& name, Shape const& shape, std::vector<double> const& values, char const* units)
{
    hsize_t size = 1;
    for (auto const each : shape) {
        size *= each;
    }
    if (values.size() != size) {
        throw std::logic_error(name + " does not match what it is a function of");
    }
    place.array(name, shape, values.data(), units);
}

void write_map(Writer const& place, LoadMap const& map)
{
    Shape const shape = {map.angle.size(), 2, map.z.size()};
    place.attribute("flanks", std::vector<std::string>{"left", "right"});
    place.attribute("torque_Nmm", map.torque);
    place.numbers("z", map.z, "mm");
    place.numbers("angle", map.angle, "rad");
    write_checked(place, "force", shape, map.force, "N");
    write_checked(place, "line_load", shape, map.line_load, "N/mm");
    write_checked(place, "pressure", shape, map.pressure, "MPa");
    write_checked(place, "gap", shape, map.gap, "mm");
    write_checked(place, "height", shape, map.height, "1");
}

void write_bearing(Writer const& place, BearingMap const& bearing, char const* ball_units)
{
    place.numbers("angle", bearing.angle, "rad");
    place.numbers("z", bearing.z, "mm");
    write_checked(place, "force", {bearing.angle.size(), bearing.z.size()}, bearing.force, "N");
    if (!bearing.ball_angle.empty()) {
        place.numbers("ball_angle", bearing.ball_angle, "rad");
        write_checked(place, "ball_force", {bearing.ball_angle.size()}, bearing.ball_force, ball_units);
    }
}

/// Estimates of one state each, zeros where there are none.
void write_error_columns(Writer const& place, std::vector<LoadedState> const& errors, char const* ball_units)
{
    write_columns(place, loaded_error_figures(), errors);
    place.numbers("ball_force", column(errors, [](auto const& error) { return error.ball_force; }), ball_units);
}

void write_curve(Writer const& place, LoadCase const& each, char const* ball_units)
{
    write_states(place, each.curve, ball_units);
    place.group("error", [&](Writer const& group) {
        std::vector<int> estimated;
        std::vector<LoadedState> errors;
        for (std::size_t i = 0; i < each.curve.size(); ++i) {
            auto const* error = error_of(each, i);
            estimated.push_back(error != nullptr ? 1 : 0);
            errors.push_back(error != nullptr ? *error : LoadedState());
        }
        group.integers("estimated", estimated);
        write_error_columns(group, errors, ball_units);
    });
}

void write_case(Writer const& place, LoadCase const& each, char const* ball_units)
{
    place.group("curve", [&](Writer const& curve) { write_curve(curve, each, ball_units); });
    if (!each.bearing.angle.empty()) {
        place.group("bearing", [&](Writer const& bearing) { write_bearing(bearing, each.bearing, ball_units); });
    }
    if (!each.map.angle.empty()) {
        place.group("map", [&](Writer const& map) { write_map(map, each.map); });
    }
}

/// Estimates, worth something where `estimated` is 1.
void write_errors(Writer const& place, std::vector<LoadCase> const& cases, char const* ball_units)
{
    std::vector<LoadedState> errors;
    for (auto const& each : cases) {
        errors.push_back(each.error);
    }
    place.integers("estimated", column(cases, [](auto const& each) { return each.estimated ? 1 : 0; }));
    place.integers("pressure_at_edge", column(cases, [](auto const& each) { return each.pressure_at_edge ? 1 : 0; }));
    place.numbers("backlash", column(cases, [](auto const& each) { return each.backlash_error; }), "rad");
    write_error_columns(place, errors, ball_units);
}

void write_cases(Writer const& place, std::vector<LoadCase> const& cases, char const* ball_units)
{
    std::vector<LoadedState> rated;
    for (auto const& each : cases) {
        auto const* state = rated_state(each);
        if (state == nullptr) {
            throw std::logic_error("a load case without a state at its largest torque");
        }
        rated.push_back(*state);
    }
    place.texts("surface", column(cases, [](auto const& each) { return each.surface; }));
    place.texts("kind", column(cases, [](auto const& each) { return each.kind; }));
    write_columns(place, load_case_figures(), cases);
    place.integers("raised", column(cases, [](auto const& each) { return each.raised ? 1 : 0; }));
    place.integers("stages_found", column(cases, [](auto const& each) { return each.stages.found ? 1 : 0; }));
    write_states(place, rated, ball_units);
    place.group("error", [&](Writer const& group) { write_errors(group, cases, ball_units); });
    for (std::size_t i = 0; i < cases.size(); ++i) {
        place.group(fmt::format("case_{:03}", i), [&](Writer const& group) { write_case(group, cases[i], ball_units); });
    }
}

void write_cup(Writer const& place, AssembledCup const& cup)
{
    for (auto const& figure : assembled_cup_figures()) {
        place.attribute(figure.column, figure.value(cup));
    }
    place.attribute("ball_force", cup.ball_force);
    place.attribute("estimated", cup.estimated ? 1 : 0);
    place.attribute("coning_major_error_rad", cup.coning_major_error);
    place.attribute("coning_minor_error_rad", cup.coning_minor_error);
    place.attribute("wave_generator_force_error_N", cup.wave_generator_force_error);
    place.attribute("largest_stress_error_MPa", cup.largest_stress_error);
    place.attribute("contacts", cup.contacts);
    place.numbers("z", cup.z, "mm");
    write_checked(place, "w_major", {cup.z.size()}, cup.w_major, "mm");
    write_checked(place, "w_minor", {cup.z.size()}, cup.w_minor, "mm");
}

/// Four corners a row; a triangle has its last one twice.
std::vector<int> four_corners(std::vector<std::vector<int>> const& cells)
{
    std::vector<int> corners;
    for (auto const& cell : cells) {
        if (cell.size() != 3 && cell.size() != 4) {
            throw std::logic_error("an element of the cup with neither three corners nor four");
        }
        for (std::size_t i = 0; i < 4; ++i) {
            corners.push_back(cell[std::min(i, cell.size() - 1)]);
        }
    }
    return corners;
}

void write_shape(Writer const& place, CupShape const& shape)
{
    Shape const size = {shape.phi.size(), shape.r.size()};
    place.numbers("r", shape.r, "mm");
    write_checked(place, "z", {shape.r.size()}, shape.z, "mm");
    auto const corners = four_corners(shape.cells);
    place.array("cells", {shape.cells.size(), 4}, corners.data());
    place.numbers("phi", shape.phi, "rad");
    write_checked(place, "u_r", size, shape.u_r, "mm");
    write_checked(place, "u_t", size, shape.u_t, "mm");
    write_checked(place, "u_z", size, shape.u_z, "mm");
    if (!shape.stress.empty()) {
        write_checked(place, "stress", size, shape.stress, "MPa");
    }
}

void write_measured(Writer const& place, Measurement const& measured)
{
    auto const& [curve, found] = measured;
    place.attribute("path", curve.file);
    place.attribute("columns", curve.columns);
    place.attribute("torque_constant_Nm_per_A", curve.rig.torque_constant);
    place.attribute("counts_per_turn", curve.rig.counts_per_turn);
    place.attribute("ratio", curve.rig.ratio);
    place.attribute("efficiency", curve.rig.efficiency);
    place.attribute("angle_per_spline", curve.rig.angle_per_spline);
    place.attribute("cycles", found.cycles);
    place.attribute("straight_branches", found.straight);
    place.attribute("angle_step_rad", found.angle_step);
    place.attribute("middle_rad", found.middle);
    place.numbers("twist", curve.twist, "rad");
    place.numbers("torque", curve.torque, "N mm");
    for (auto const& figure : measured_figures()) {
        Estimate const& estimate = figure.value(found);
        if (estimate.count > 0) {
            place.numbers(figure.name, {estimate.value, estimate.error}, figure.units);
            place.integers(std::string(figure.name) + "_count", {estimate.count});
        }
    }
}

}  // namespace

void write_hdf5(LoadStudy const& study, std::filesystem::path const& file, Measurement const* measured)
{
    hdf5::write_file(file, [&](Writer const& root) {
        hdf5::write_solution(root, study.solution);
        root.group("circular_spline", [&](Writer const& place) {
            hdf5::write_circular_spline(place, study.solution.circular_spline);
            if (has_surface(study.solution)) {
                place.group("surface", [&](Writer const& mesh) { hdf5::write_surface(mesh, tooth_surface(study.solution)); });
            }
        });
        root.group("load", [&](Writer const& load) {
            load.attribute("rated_torque_Nmm", study.rated_torque);
            load.attribute("contact_gap_mm", study.contact_gap);
            load.attribute("pitch_radius_mm", study.pitch_radius);
            load.attribute("harmonics", study.harmonics);
            load.attribute("sectors", study.sectors);
            load.attribute("shown", static_cast<int>(study.shown));
            load.attribute("edge_radius_mm", study.edge_radius);
            load.attribute("balls", study.balls);
            write_cases(load, study.cases, ball_units(study));
            load.group("cup", [&](Writer const& cup) { write_cup(cup, study.cup); });
            if (!study.shape.r.empty()) {
                load.group("shape", [&](Writer const& shape) { write_shape(shape, study.shape); });
            }
            if (measured != nullptr) {
                load.group("measured", [&](Writer const& place) { write_measured(place, *measured); });
            }
        });
    });
}

}  // namespace hdconj
