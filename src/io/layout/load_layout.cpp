// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of /load, as docs/reference/hdf5.md describes it.
#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "columns.hpp"
#include "figures/load_figures.hpp"
#include "figures/measured_figures.hpp"
#include "results.hpp"

namespace hdconj::io {
namespace {

using layout::About;
using layout::column;
using layout::Owner;
using layout::Shape;
using layout::write_columns;
using layout::write_error_columns;
using layout::Writer;

/// Values of which there are as many as @p shape says.
void write_checked(Writer const& place, std::string const& name, Shape const& shape, std::vector<double> const& values,
                   About const& about)
{
    if (values.size() != std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()))
        throw std::logic_error(name + " does not match what it is a function of");
    place.array(name, shape, values.data(), about);
}

void write_load_map(Writer const& place, LoadMap const& map)
{
    Shape const shape = {map.angle.size(), 2, map.z.size()};
    layout::Dims const dims = {"angle", "flank", "z"};
    layout::write_flanks(place);
    place.attribute("torque_Nmm", map.torque);
    place.numbers("z", map.z, {"mm", "slices", {"z"}});
    place.numbers("angle", map.angle, {"rad", "centre lines of the tooth spaces", {"angle"}});
    write_checked(place, "force", shape, map.force, {"N", "force along the normal", dims, Owner::result});
    write_checked(place, "line_load", shape, map.line_load,
                  {"N/mm", "force per length along the axis", dims, Owner::result});
    write_checked(place, "pressure", shape, map.pressure, {"MPa", "Hertz pressure", dims, Owner::result});
    auto const by_tooth = [&](char const* name, std::vector<double> const& values, char const* meaning) {
        if (!values.empty())
            write_checked(place, name, {map.angle.size()}, values, {"N", meaning, {"angle"}, Owner::result});
    };
    by_tooth("tooth_force", map.tooth_force, "sum of the forces on the tooth in each space");
    by_tooth("tooth_force_error", map.tooth_force_error, "estimated error of tooth_force");
    write_checked(place, "gap", shape, map.gap, {"mm", "smallest gap of the loaded shape", dims, Owner::result});
    layout::write_named(place, figures::flank_position_of_gap, [&](char const* name) {
        write_checked(place, name, shape, map.height,
                      {"1", "place of that gap, 0 at the land corner to 1 at the flank end", dims});
    });
}

void write_contacts(Writer const& place, double torque, std::vector<ContactForce> const& contacts)
{
    auto const numbers = [&](char const* name, double ContactForce::*value, char const* unit, char const* meaning) {
        place.numbers(name, column(contacts, value), {unit, meaning, {"contact"}});
    };
    auto const vectors = [&](char const* name, Vec2 ContactForce::*value, char const* unit, char const* meaning) {
        std::vector<double> flat;
        for (auto const& each : contacts)
            flat.insert(flat.end(), {(each.*value).x(), (each.*value).y()});
        place.array(name, {contacts.size(), 2}, flat.data(), {unit, meaning, {"contact", "xy"}});
    };
    auto const indices = [&](char const* name, int ContactForce::*value, char const* meaning) {
        place.integers(name, column(contacts, value), {"1", meaning, {"contact"}});
    };
    layout::write_flanks(place);
    place.attribute("torque_Nmm", torque);
    indices("space", &ContactForce::space, "number in map/angle");
    indices("flank_number", &ContactForce::flank, "number in the attribute flanks");
    indices("slice", &ContactForce::slice, "number in map/z");
    vectors("place", &ContactForce::place, "mm", "on the flank, y along the centre line of the tooth space");
    vectors("normal", &ContactForce::normal, "1", "direction of the force on the circular spline");
    numbers("lever", &ContactForce::lever, "mm", "clockwise torque of a unit force on the circular spline");
    numbers("force", &ContactForce::force, "N", "force along the normal");
    numbers("half_width", &ContactForce::half_width, "mm", "half the width of the Hertz strip");
}

void write_bearing(Writer const& place, BearingMap const& bearing, int balls)
{
    place.numbers("angle", bearing.angle, {"rad", "angles of the nodes of the bearing", {"angle"}});
    place.numbers("z", bearing.z, {"mm", "heights of the nodes of the bearing", {"z"}});
    write_checked(place, "force", {bearing.angle.size(), bearing.z.size()}, bearing.force,
                  {"N", "force outward on the cup", {"angle", "z"}});
    if (!bearing.ball_angle.empty()) {
        auto const ball = figures::loaded_state_figures(balls)["ball_force"];
        place.numbers("ball_angle", bearing.ball_angle, {"rad", "angles of the balls", {"ball_angle"}});
        write_checked(place, ball.name, {bearing.ball_angle.size()}, bearing.ball_force,
                      {ball.unit.stored, "force of a ball, or of the line of balls", {"ball_angle"}});
        if (!bearing.ball_force_error.empty())
            write_checked(place, std::string(ball.name) + "_error", {bearing.ball_angle.size()},
                          bearing.ball_force_error,
                          {ball.unit.stored, "estimated error of that force", {"ball_angle"}});
    }
}

void write_curve(Writer const& place, LoadCase const& each, figures::Rows<LoadedState> const& rows)
{
    write_columns(place, "state", rows, each.curve);
    place.group("error", [&](Writer const& group) {
        std::vector<int> estimated;
        std::vector<LoadedState> errors;  // zeros where there are none
        for (std::size_t i = 0; i < each.curve.size(); ++i) {
            auto const* error = figures::error_of(each, i);
            estimated.push_back(error != nullptr ? 1 : 0);
            errors.push_back(error != nullptr ? *error : LoadedState());
        }
        group.integers("estimated", estimated, {"1", "whether the errors were estimated", {"state"}});
        write_error_columns(group, "state", rows, errors);
    });
}

void write_load_case(Writer const& place, LoadCase const& each, int balls)
{
    place.group("curve", [&](Writer const& curve) { write_curve(curve, each, figures::loaded_state_figures(balls)); });
    if (each.catalogue)
        place.group("catalogue", [&](Writer const& group) {
            layout::write_attributes(group, figures::catalogue_rows(), *each.catalogue);
        });
    if (!each.members.empty())
        place.group("members", [&](Writer const& group) {
            group.texts("name", column(each.members, &TwistMember::name), "members in series", "member");
            write_columns(group, "member", figures::twist_member_rows(), each.members, "", each.estimated);
        });
    if (auto const names = figures::unconverged_figures(each, balls); !names.empty())
        place.texts("not_converged", names, "figures whose error exceeds a third of them or is not determined",
                    "figure");
    if (!each.unsettled.empty()) {
        place.numbers("unsettled_torque", column(each.unsettled, &UnsettledTorque::torque),
                      {"N mm", "torques without equilibrium", {"unsettled"}});
        place.texts("unsettled_cause", column(each.unsettled, &UnsettledTorque::cause), "why", "unsettled");
    }
    if (!each.bearing.angle.empty())
        place.group("bearing", [&](Writer const& bearing) { write_bearing(bearing, each.bearing, balls); });
    if (!each.contacts.empty())
        place.group("contacts", [&](Writer const& group) { write_contacts(group, each.map.torque, each.contacts); });
    if (!each.map.angle.empty())
        place.group("map", [&](Writer const& map) { write_load_map(map, each.map); });
}

/// Estimates, worth something where `estimated` is 1.
void write_errors(Writer const& place, std::vector<LoadCase> const& cases, int balls)
{
    place.integers("estimated", column(cases, &LoadCase::estimated),
                   {"1", "whether the errors were estimated", {"case"}});
    place.integers("pressure_at_edge", column(cases, &LoadCase::pressure_at_edge),
                   {"1", "whether the largest pressure is at an end of the face width", {"case"}});
    for (char const* const name : {"backlash", "backlash_offset"}) {
        auto const figure = figures::load_case_figures()[name];
        place.numbers(figure.name, column(cases, figure.error), layout::about_error(figure, "", "case"));
    }
    write_error_columns(place, "case", figures::loaded_state_figures(balls), column(cases, &LoadCase::error));
}

void write_load_cases(Writer const& place, std::vector<LoadCase> const& cases, int balls)
{
    std::vector<LoadedState> rated;
    for (auto const& each : cases) {
        auto const* state = figures::rated_state(each);
        if (state == nullptr)
            throw std::logic_error("a load case without a state at its largest torque");
        rated.push_back(*state);
    }
    layout::write_surface_names(place, cases);
    write_columns(place, "case", figures::load_case_figures(), cases);
    write_columns(place, "case", figures::loaded_state_figures(balls), rated);
    place.group("error", [&](Writer const& group) { write_errors(group, cases, balls); });
    place.groups("case", cases,
                 [&](Writer const& group, LoadCase const& each) { write_load_case(group, each, balls); });
}

void write_cup(Writer const& place, AssembledCup const& cup, int balls)
{
    layout::write_attributes(place, figures::assembled_cup_figures(balls), cup);
    place.attribute("ball_force", cup.ball_force);
    place.attribute("estimated", cup.estimated ? 1 : 0);
    if (cup.estimated)
        place.attribute("displacement_error_mm", cup.displacement_error);
    place.numbers("z", cup.z, {"mm", "slices", {"z"}});
    write_checked(place, "w_major", {cup.z.size()}, cup.w_major,
                  {"mm", "radial displacement at the major axis", {"z"}});
    write_checked(place, "w_minor", {cup.z.size()}, cup.w_minor,
                  {"mm", "radial displacement at the minor axis", {"z"}});
}

/// Four corners a row; a triangle has its last one twice.
std::vector<int> four_corners(std::vector<std::vector<int>> const& cells)
{
    std::vector<int> corners;
    for (auto const& cell : cells) {
        if (cell.size() != 3 && cell.size() != 4)
            throw std::logic_error("an element of the cup with neither three corners nor four");
        for (std::size_t i = 0; i < 4; ++i)
            corners.push_back(cell[std::min(i, cell.size() - 1)]);
    }
    return corners;
}

void write_shape(Writer const& place, CupShape const& shape)
{
    Shape const size = {shape.phi.size(), shape.r.size()};
    layout::Dims const dims = {"phi", "node"};
    place.numbers("r", shape.r, {"mm", "radius of the nodes of the section", {"node"}});
    write_checked(place, "z", {shape.r.size()}, shape.z, {"mm", "height of the nodes of the section", {"node"}});
    place.array("cells", {shape.cells.size(), 4}, four_corners(shape.cells).data(),
                {"1", "nodes at the corners of an element, counter-clockwise", {"cell", "corner"}});
    place.numbers("phi", shape.phi, {"rad", "angles, clockwise from the major axis", {"phi"}});
    write_checked(place, "u_r", size, shape.u_r, {"mm", "radial displacement", dims, Owner::result});
    write_checked(place, "u_t", size, shape.u_t, {"mm", "tangential displacement", dims, Owner::result});
    write_checked(place, "u_z", size, shape.u_z, {"mm", "axial displacement", dims, Owner::result});
    if (!shape.stress.empty())
        write_checked(place, "stress", size, shape.stress, {"MPa", "von Mises stress", dims, Owner::result});
    place.integers("seat", shape.seat, {"1", "nodes at the bearing, whose stress is not determined", {"seat"}});
}

void write_teeth(Writer const& place, LoadedTeeth const& teeth)
{
    std::size_t const count = teeth.phi.size(), slices = teeth.z.size();
    if (teeth.origin.size() != count * slices)
        throw std::logic_error("the loaded teeth do not match their angles and slices");
    place.attribute("turn_rad", teeth.turn);
    place.numbers("z", teeth.z, {"mm", "slices", {"z"}});
    place.numbers("phi", teeth.phi, {"rad", "undeformed angles of the teeth, clockwise from the major axis", {"phi"}});
    place.array("origin", {count, slices, 2}, teeth.origin.front().data(),
                {"mm", "origin of the tooth's frame, y along the major axis", {"phi", "z", "xy"}, Owner::result});
    write_checked(place, "lean", {count, slices}, teeth.lean,
                  {"rad", "angle of the tooth's y axis, clockwise from the major axis", {"phi", "z"}, Owner::result});
}

void write_pitch_errors(Writer const& place, PitchErrors const& errors)
{
    auto const write = [&](std::string const& ring, std::vector<double> const& places, char const* dimension) {
        if (!places.empty())
            place.numbers(ring + "_pitch_errors", places,
                          {"mm", "how far each stands clockwise of its place on the pitch circle", {dimension}});
    };
    write("flexspline", errors.flexspline, "flexspline_tooth");
    write("circular_spline", errors.circular_spline, "tooth_space");
}

}  // namespace

void layout::write_result(Writer const& root, LoadStudy const& study, Measurement const* measured)
{
    write_solution(root, study.solution, written_side_clearance(study));
    root.group("load", [&](Writer const& load) {
        write_attributes(load, figures::load_study_figures(), study);
        write_load_cases(load, study.cases, study.balls);
        load.group("cup", [&](Writer const& cup) { write_cup(cup, study.cup, study.balls); });
        if (!study.shape.r.empty())
            load.group("shape", [&](Writer const& shape) { write_shape(shape, study.shape); });
        if (!study.teeth.phi.empty())
            load.group("loaded_teeth", [&](Writer const& teeth) { write_teeth(teeth, study.teeth); });
        write_pitch_errors(load, study.pitch_errors);
        if (measured != nullptr)
            load.group("measured", [&](Writer const& place) { layout::write_result(place, *measured); });
    });
}

void layout::write_result(Writer const& place, Measurement const& measured)
{
    auto const& [curve, found] = measured;
    place.attribute("path", curve.file);
    place.attribute("columns", curve.columns);
    place.attribute("torque_constant_Nm_per_A", curve.rig.torque_constant);
    place.attribute("counts_per_turn", curve.rig.counts_per_turn);
    place.attribute("ratio", curve.rig.ratio);
    place.attribute("efficiency", curve.rig.efficiency);
    place.attribute("angle_per_spline", curve.rig.angle_per_spline);
    layout::write_attributes(place, figures::measured_curve_figures(), found);
    place.numbers("twist", curve.twist, {"rad", "twist of the samples at the output", {"sample"}});
    place.numbers("torque", curve.torque, {"N mm", "torque of the samples at the output", {"sample"}});
    for (auto const& figure : figures::measured_figures()) {
        Estimate const& estimate = figure.value(found);
        if (estimate.count == 0)
            continue;
        layout::write_named(place, figure.name, [&](char const* name) {
            place.numbers(name, {estimate.value, estimate.error},
                          {figure.unit.stored, std::string(figure.words) + ": value and standard error", {"estimate"}});
        });
        place.figure({figure.name.now, figure.name.now, figure.name.now, figure.unit.stored, figure.words, false});
        place.integers(std::string(figure.name.now) + "_count", {estimate.count},
                       {"1", "number of values averaged", {"average"}});
        if (figure.name.former != nullptr)
            place.link(figure.name.now + std::string("_count"), figure.name.former + std::string("_count"));
    }
}

}  // namespace hdconj::io
