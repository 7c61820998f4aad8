// SPDX-License-Identifier: GPL-3.0-or-later
#include "loaded_state.hpp"

#include <algorithm>
#include <vector>

#include "bearing_map.hpp"
#include "contact/contact_area.hpp"
#include "flank_table.hpp"
#include "hdconj/base/parallel.hpp"

namespace hdconj::load {
namespace {

/// Area within the contact gap and area of the flank @p flank of one space in the loaded shape.
contact::ContactArea near_area(LoadProblem const& problem, contact::GapField const& field, FlankSearch const& search,
                               std::size_t space, int flank)
{
    contact::FlankGrid const& flanks = problem.flanks;
    GapMap map{flanks.z,
               flanks.station,
               {field.space_angle(space)},
               std::vector<double>(2 * flanks.slices() * flanks.points())};
    std::vector<double> gap;
    for (std::size_t k = 0; k < flanks.slices(); ++k) {
        field.along(space, flank, k, search.turn, gap);
        std::copy(gap.begin(), gap.end(), map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(0, flank, k, 0)));
    }
    return contact::contact_area(map, flanks, flank, problem.context.request.gap, problem.context.width);
}

/// Fraction of the flanks of one side whose gap in the loaded shape is no larger than the contact gap.
double near_share(LoadProblem const& problem, LoadedDrive const& loaded, int flank)
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
    state.teeth = static_cast<int>(carrying) * problem.drive.response.sectors();
    state.node_share = static_cast<double>(nodes) / static_cast<double>(spaces * t.slices);
    state.contact_area = pressed_area(problem, t, side);
    state.contact_share = state.contact_area / flank_area(problem, side);
    state.near_share = near_share(problem, loaded, static_cast<int>(side));
}

/// Force and torque of the wave generator. A surface that is pressed on rises by its slope per radian that it turns:
/// the forces along its normal do that work. With balls it is the cam that turns, and lifts them.
void enter_wave_generator(LoadProblem const& problem, Equilibrium const& forces, LoadedState& state)
{
    ElasticDrive const& drive = problem.drive;
    wavegen::AnyWaveShape const& shape = problem.context.shape;
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w) {
        double const force = forces.bearing.col(static_cast<Eigen::Index>(w)).sum();
        state.wave_generator_force += force;
        double const phi = drive.phase + drive.response.step() * drive.bearing_steps[w];
        if (!drive.balls)
            state.wave_generator_torque -= force * shape(phi).w1;
    }
    for (std::size_t b = 0; b < forces.balls.size(); ++b)
        state.wave_generator_torque -= forces.balls[b] * shape(drive.balls->phi[b]).w1;
    state.wave_generator_force *= drive.response.sectors();
    state.wave_generator_torque *= drive.response.sectors();
}

}  // namespace

LoadedState loaded_state(LoadProblem const& problem, LoadedDrive const& loaded, double middle)
{
    LoadedState state;
    state.torque = loaded.torque;
    state.twist = loaded.state.turn - middle;
    state.stiffness = loaded.state.stiffness;
    state.rounds = loaded.iterations;
    state.steps = loaded.steps;
    state.residual = loaded.residual;
    state.complementarity = loaded.state.complementarity;
    enter_flanks(problem, loaded, state);
    enter_wave_generator(problem, loaded.state, state);
    LobeReaction const lobe = lobe_reaction(bearing_map(problem.drive, loaded.state), problem.drive.response.sectors(),
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
