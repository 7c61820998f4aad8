// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "bearing_map.hpp"
#include "contact/contact_area.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/tolerance.hpp"

namespace hdconj::load {
namespace {

/// Values over (space, flank, slice) of one sector, all contacts of a flank and slice together.
struct FlankTable
{
    std::size_t slices = 0;
    std::vector<double> force;       ///< [N]
    std::vector<double> line_load;   ///< [N/mm]
    std::vector<double> pressure;    ///< largest [MPa]
    std::vector<double> gap;         ///< smallest [mm]; of a loaded contact minus its approach; infinite: none is near
    std::vector<double> height;      ///< of that contact along the flank, 0 at the land corner ... 1 at the flank end
    std::vector<double> half_width;  ///< of the strips under pressure [mm]

    [[nodiscard]] std::size_t index(std::size_t space, std::size_t flank, std::size_t slice) const
    {
        return (2 * space + flank) * slices + slice;
    }
};

/// Area of the strip under pressure between two slices: line loads q0 and q1, half widths c0 sqrt(q0) and c1 sqrt(q1).
double strip_area(double q0, double q1, double c0, double c1, double length)
{
    double const c = 0.5 * (c0 + c1);
    double const difference = q1 - q0;
    if (std::abs(difference) <= 1e3 * unit_roundoff * (q0 + q1))
        return 2 * c * std::sqrt(0.5 * (q0 + q1)) * length;
    return 2 * c * length * (2.0 / 3) * (q1 * std::sqrt(q1) - q0 * std::sqrt(q0)) / difference;
}

/// Area of the strip between the entries @p a and @p b of neighbouring slices.
double area_between(FlankTable const& t, std::size_t a, std::size_t b, double length)
{
    auto const scale = [&](std::size_t i) { return t.half_width[i] / std::sqrt(t.line_load[i]); };
    bool const a_loaded = t.line_load[a] > 0, b_loaded = t.line_load[b] > 0;
    if (a_loaded && b_loaded)
        return strip_area(t.line_load[a], t.line_load[b], scale(a), scale(b), length);
    if (!a_loaded && !b_loaded)
        return 0;
    std::size_t const on = a_loaded ? a : b, off = a_loaded ? b : a;
    double const approach = -t.gap[on];
    double const fraction = std::isfinite(t.gap[off]) ? approach / (approach + std::max(0.0, t.gap[off])) : 0;
    return strip_area(t.line_load[on], 0, scale(on), scale(on), fraction * length);
}

FlankTable flank_table(LoadProblem const& problem, LoadedDrive const& loaded)
{
    FlankTable table;
    table.slices = problem.flanks.slices();
    std::size_t const size = 2 * spaces_of(problem) * table.slices;
    for (auto* v : {&table.force, &table.line_load, &table.pressure, &table.height, &table.half_width})
        v->assign(size, 0);
    table.gap.assign(size, std::numeric_limits<double>::infinity());
    std::size_t const first = flank_search(problem, 0, 0).first_space;
    std::vector<double> const approach =
        local_compliance(problem.drive, loaded.contacts, loaded.state.flank)(loaded.state.flank);
    for (std::size_t i = 0; i < loaded.contacts.size(); ++i) {
        FlankContact const& c = loaded.contacts[i];
        double const f = loaded.state.flank[i];
        std::size_t const at = table.index(c.space - first, static_cast<std::size_t>(c.flank), c.slice);
        double const q = f / problem.drive.slice_width[c.slice];
        LineContact const line = problem.drive.line_contact(c);
        double const gap = f > 0 ? -approach[i] : c.gap;
        if (gap < table.gap[at]) {
            table.gap[at] = gap;
            table.height[at] = c.arc_fraction;
        }
        table.force[at] += f;
        table.line_load[at] += q;
        table.pressure[at] = std::max(table.pressure[at], largest_pressure(line, q));
        table.half_width[at] += half_width(line, q);
    }
    return table;
}

/// Area under pressure on the flanks of one side [mm^2]: Hertz strips. Between two loaded slices the strip has the
/// widths of both; from a loaded slice to an unloaded one it reaches as far as the force, which falls linearly through
/// the gap there.
double pressed_area(LoadProblem const& problem, FlankTable const& table, std::size_t flank)
{
    double area = 0;
    std::vector<double> const& z = problem.flanks.z;
    std::size_t const spaces = spaces_of(problem);
    for (std::size_t s = 0; s < spaces; ++s) {
        if (table.slices == 1)
            area += 2 * table.half_width[table.index(s, flank, 0)] * problem.drive.slice_width[0];
        for (std::size_t k = 0; k + 1 < table.slices; ++k)
            area += area_between(table, table.index(s, flank, k), table.index(s, flank, k + 1), z[k + 1] - z[k]);
    }
    return area * problem.drive.response.sectors();
}

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
