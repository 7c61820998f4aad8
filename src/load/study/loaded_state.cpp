// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bearing_map.hpp"
#include "contact/contact_area.hpp"
#include "flank_table.hpp"
#include "hdconj/base/parallel.hpp"
#include "line_load.hpp"
#include "load/model/ring_errors.hpp"

namespace hdconj::load {
namespace {

/// Area of all flanks of one side [mm^2].
double flank_area(LoadProblem const& problem, std::size_t flank)
{
    contact::FlankGrid const& grid = problem.flanks;
    double area = 0;
    for (std::size_t k = 0; k < grid.slices(); ++k) {
        double length = 0;
        auto const& line = grid.point[flank][k];
        for (std::size_t i = 1; i < line.size(); ++i)
            length += (line[i] - line[i - 1]).norm();
        area += length * problem.drive.slice_width[k];
    }
    return area * problem.context.scene.drive.circular_spline_teeth;
}

/// Area within the contact gap and area of the flank @p flank of one space in the loaded shape.
contact::ContactArea near_area(LoadProblem const& problem, contact::GapField const& field, FlankSearch const& search,
                               std::size_t space, int flank)
{
    contact::FlankGrid const& flanks = problem.flanks;
    GapMap map{flanks.z,
               flanks.station,
               {field.space_angle(space)},
               std::vector<double>(2 * flanks.slices() * flanks.points())};
    for (std::size_t k = 0; k < flanks.slices(); ++k)
        field.along(space, flank, k, search.turn, map.gap.data() + map.index(0, flank, k, 0));
    return contact::contact_area(map, flanks, flank, problem.context.request.gap, problem.context.width);
}

/// Fraction of the flanks of one side whose gap in the loaded shape is no larger than the contact gap.
double fraction_within_gap(LoadProblem const& problem, LoadedDrive const& loaded, int flank)
{
    contact::GapField const field = gap_field(problem, loaded.shape, problem.flanks);
    FlankSearch const search = flank_search(problem, loaded.state.turn, 0);
    std::vector<char> is_near(search.spaces, 0);
    for (FlankContact const& c : loaded.contacts)
        if (c.gap <= 2 * problem.context.request.gap)
            is_near[c.space - search.first_space] = 1;
    std::vector<contact::ContactArea> area(search.spaces);
    constexpr std::size_t grain = 2;
    parallel_for(search.spaces, problem.context.threads, grain, [&](std::size_t s) {
        if (is_near[s])
            area[s] = near_area(problem, field, search, search.first_space + s, flank);
    });
    double contact = 0, whole = 0;  // all spaces have the same flanks
    for (contact::ContactArea const& each : area) {
        contact += each.contact;
        whole = std::max(whole, each.whole);
    }
    return whole > 0 ? contact / (whole * static_cast<double>(search.spaces)) : 0;
}

/// What is determined of the pressure: line loads, and pressures away from edges and ends; forces of these.
void enter_line_loads(LoadProblem const& problem, FlankTable const& t, LoadedState& state)
{
    constexpr double width = 0.5;  // of a mean, and of an end [mm]
    std::vector<double> const& z = problem.flanks.z;
    std::vector<double> const at_ends = shares_at_ends(z, width);
    // Of a face width that is all ends, the middle is left.
    double const from = z.front() + std::min(width, 0.5 * (z.back() - z.front()));
    double const to = std::max(from, z.back() - width);
    double all = 0, on_edges = 0, flowing = 0;
    for (std::size_t first = 0; first < t.force.size(); first += t.slices) {  // slices of a flank follow each other
        double edge_force = 0;
        for (std::size_t k = 0; k < t.slices; ++k) {
            edge_force += std::lerp(t.on_edges[first + k], t.force[first + k], at_ends[k]);
            all += t.force[first + k];
            flowing += t.flowing[first + k];
        }
        state.flank_pressure =
            std::max(state.flank_pressure, largest_between(z, {t.off_edges.data() + first, t.slices}, from, to));
        on_edges += edge_force;
        state.edge_force = std::max(state.edge_force, edge_force);
        state.largest_line_load =
            std::max(state.largest_line_load, largest_mean(z, {t.line_load.data() + first, t.slices}, width));
    }
    state.edge_fraction = all > 0 ? on_edges / all : 0;
    state.flowing_fraction = all > 0 ? flowing / all : 0;
}

/// Teeth, pressures, areas and gaps of the flanks.
void enter_flanks(LoadProblem const& problem, LoadedDrive const& loaded, LoadedState& state)
{
    FlankTable const t = flank_table(problem, loaded);
    auto const side = static_cast<std::size_t>(loaded.torque < 0 ? GapMap::left : GapMap::right);
    std::size_t const spaces = spaces_of(problem);
    std::size_t carrying = 0, nodes = 0;
    for (std::size_t s = 0; s < spaces; ++s) {
        double on_tooth[2] = {0, 0};
        for (std::size_t f = 0; f < 2; ++f)
            for (std::size_t k = 0; k < t.slices; ++k) {
                std::size_t const i = t.index(s, f, k);
                on_tooth[f] += t.force[i];
                if (f == side && t.force[i] > 0)
                    ++nodes;
                if (t.pressure[i] > state.largest_pressure) {
                    state.largest_pressure = t.pressure[i];
                    state.pressure_space = static_cast<int>(s);
                    state.pressure_z = problem.flanks.z[k];
                }
            }
        carrying += on_tooth[0] > 0 || on_tooth[1] > 0 ? 1 : 0;
        state.largest_force = std::max({state.largest_force, on_tooth[0], on_tooth[1]});
    }
    enter_line_loads(problem, t, state);
    state.teeth = static_cast<int>(carrying) * problem.drive.response->sectors();
    state.carrying_fraction = static_cast<double>(nodes) / static_cast<double>(spaces * t.slices);
    state.contact_area = pressed_area(problem, t, side);
    state.contact_fraction = state.contact_area / flank_area(problem, side);
    state.fraction_within_gap = fraction_within_gap(problem, loaded, static_cast<int>(side));
}

/// Force and torque of the wave generator. A surface that is pressed on rises by its slope per radian that it turns:
/// the forces along its normal do that work. With balls it is the cam that turns, and lifts them.
void enter_wave_generator(LoadProblem const& problem, Equilibrium const& forces, LoadedState& state)
{
    ElasticDrive const& drive = problem.drive;
    auto const deviation = wave_generator_deviation(problem.context.scene);
    auto const slope = [&](double phi) {
        return problem.context.shape(phi).w1 + (deviation ? deviation(phi).slope : 0);
    };
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w) {
        double const force = forces.bearing.col(static_cast<Eigen::Index>(w)).sum();
        state.wave_generator_force += force;
        double const phi = drive.phase + drive.response->step() * drive.bearing_steps[w];
        if (!drive.balls)
            state.wave_generator_torque -= force * slope(phi);
    }
    for (std::size_t b = 0; b < forces.balls.size(); ++b)
        state.wave_generator_torque -= forces.balls[b] * slope(drive.balls->phi[b]);
    state.wave_generator_force *= drive.response->sectors();
    state.wave_generator_torque *= drive.response->sectors();
}

}  // namespace

LoadMap load_map(LoadProblem const& problem, LoadedDrive const& loaded)
{
    FlankTable table = flank_table(problem, loaded);
    LoadMap map;
    map.torque = loaded.torque;
    map.z = problem.flanks.z;
    contact::GapField const field = gap_field(problem, loaded.shape, problem.flanks);
    FlankSearch const search = flank_search(problem, 0, 0);
    for (std::size_t s = 0; s < search.spaces; ++s)
        map.angle.push_back(field.space_angle(search.first_space + s));
    map.tooth_force.assign(search.spaces, 0);
    for (std::size_t i = 0; i < table.force.size(); ++i)
        map.tooth_force[i / (2 * table.slices)] += table.force[i];
    map.force = std::move(table.force);
    map.line_load = std::move(table.line_load);
    map.pressure = std::move(table.pressure);
    map.height = std::move(table.height);
    // No gap beyond the limit was looked for.
    double const limit = search_limit(problem);
    for (double& gap : table.gap)
        gap = std::min(gap, limit);
    map.gap = std::move(table.gap);
    return map;
}

std::vector<ContactForce> contact_forces(LoadProblem const& problem, LoadedDrive const& loaded)
{
    std::vector<ContactForce> result;
    std::size_t const first = flank_search(problem, 0, 0).first_space;
    for (std::size_t i = 0; i < loaded.contacts.size(); ++i) {
        FlankContact const& c = loaded.contacts[i];
        double const force = loaded.state.flank[i];
        if (force > 0)
            result.push_back({static_cast<int>(c.space - first), c.flank, static_cast<int>(c.slice), c.point, c.normal,
                              c.lever, force,
                              half_width(problem.drive.line_contact(c), force / problem.drive.slice_width[c.slice])});
    }
    return result;
}

LoadedState loaded_state(LoadProblem const& problem, LoadedDrive const& loaded, double middle)
{
    LoadedState state;
    state.torque = loaded.torque;
    state.twist = loaded.state.turn - middle;
    state.stiffness = loaded.state.stiffness;
    state.iterations = loaded.iterations;
    state.steps = loaded.steps;
    state.gap_mismatch = loaded.gap_mismatch;
    state.complementarity = loaded.state.complementarity;
    enter_flanks(problem, loaded, state);
    enter_wave_generator(problem, loaded.state, state);
    LobeReaction const lobe = lobe_reaction(bearing_map(problem.drive, loaded.state), problem.drive.response->sectors(),
                                            problem.context.scene.wave_generator.waves);
    state.lobe_force = lobe.along;
    state.lobe_force_across = lobe.across;
    state.lobe_z = lobe.z;
    BallPeak const ball = ball_peak(problem.drive, loaded.state);
    state.ball_force = ball.force;
    state.ball_phi = ball.phi;
    state.balls = ball.carrying;
    return state;
}

}  // namespace hdconj::load
