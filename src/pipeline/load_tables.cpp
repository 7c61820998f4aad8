// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "hdconj/contact/contact_area.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/numeric/tolerance.hpp"

namespace hdconj::detail {
namespace {

/// Area of the strip under pressure between two slices, line loads q0 and q1 with half widths c sqrt(q).
double strip(double q0, double q1, double c0, double c1, double length)
{
    double const c = 0.5 * (c0 + c1);
    double const difference = q1 - q0;
    if (std::abs(difference) <= 1e3 * unit_roundoff * (q0 + q1))
        return 2 * c * std::sqrt(0.5 * (q0 + q1)) * length;
    return 2 * c * length * (2.0 / 3) * (q1 * std::sqrt(q1) - q0 * std::sqrt(q0)) / difference;
}

/// Flank values of one state over (space, flank, slice).
struct FlankTable
{
    std::size_t slices;
    std::vector<double> force, load, pressure, gap, height, half;

    FlankTable(std::size_t spaces, std::size_t count) : slices(count)
    {
        std::size_t const size = 2 * spaces * count;
        for (auto* v : {&force, &load, &pressure, &height, &half})
            v->assign(size, 0);
        gap.assign(size, std::numeric_limits<double>::infinity());
    }
    [[nodiscard]] std::size_t index(std::size_t space, std::size_t flank, std::size_t slice) const { return (2 * space + flank) * slices + slice; }
};

FlankTable table_of(LoadWork const& work, Loaded const& loaded)
{
    FlankTable table(work.spaces(), work.flanks.slices());
    std::size_t const first = work.search(0, 0).first_space;
    std::vector<double> const gives_way = local_compliance(work.drive, loaded.contacts, loaded.state.flank)(loaded.state.flank);
    for (std::size_t i = 0; i < loaded.contacts.size(); ++i)
    {
        FlankContact const& c = loaded.contacts[i];
        double const f = loaded.state.flank[i];
        std::size_t const at = table.index(c.space - first, static_cast<std::size_t>(c.flank), c.slice);
        double const q = f / work.width_of(c);
        LineContact const line = work.drive.line_contact(c);
        double const gap = f > 0 ? -gives_way[i] : c.gap;
        if (gap < table.gap[at])
        {
            table.gap[at] = gap;
            table.height[at] = c.station;
        }
        table.force[at] += f;
        table.load[at] += q;
        table.pressure[at] = std::max(table.pressure[at], largest_pressure(line, q));
        table.half[at] += half_width(line, q);
    }
    return table;
}

/// Hertz strips along the flanks: between slices that both carry force as wide as both say, and from one that does to one that does not as far as
/// the force, going down in a straight line through the gap there, reaches.
double pressed_area(LoadWork const& work, FlankTable const& t, std::size_t flank)
{
    double area = 0;
    std::vector<double> const& z = work.flanks.z;
    for (std::size_t s = 0; s < work.spaces(); ++s)
    {
        if (t.slices == 1)
            area += 2 * t.half[t.index(s, flank, 0)] * work.drive.slice_width[0];
        for (std::size_t k = 0; k + 1 < t.slices; ++k)
        {
            std::size_t const a = t.index(s, flank, k), b = t.index(s, flank, k + 1);
            double const length = z[k + 1] - z[k];
            auto const scale = [&](std::size_t i) { return t.half[i] / std::sqrt(t.load[i]); };
            if (t.load[a] > 0 && t.load[b] > 0)
                area += strip(t.load[a], t.load[b], scale(a), scale(b), length);
            else if (t.load[a] > 0 || t.load[b] > 0)
            {
                std::size_t const on = t.load[a] > 0 ? a : b, off = t.load[a] > 0 ? b : a;
                double const yields = -t.gap[on];  // by how much the contact gives way
                double const share = std::isfinite(t.gap[off]) ? yields / (yields + std::max(0.0, t.gap[off])) : 0;
                area += strip(t.load[on], 0, scale(on), scale(on), share * length);
            }
        }
    }
    return area * work.drive.response.sectors();
}

/// Area of all flanks on one side.
double flank_area(LoadWork const& work, std::size_t flank)
{
    FlankGrid const& grid = work.flanks;
    double area = 0;
    for (std::size_t k = 0; k < grid.slices(); ++k)
    {
        double length = 0;
        auto const& line = grid.point[flank][k];
        for (std::size_t i = 1; i < line.size(); ++i)
            length += (line[i] - line[i - 1]).norm();
        area += length * work.drive.slice_width[k];
    }
    return area * work.scene().drive.circular_spline_teeth;
}

/// Share of the flanks of one side that are no farther than the contact gap in the loaded shape.
double near_share(LoadWork const& work, Loaded const& loaded, int flank)
{
    GapField const field = work.field(loaded.shape, work.flanks);
    FlankSearch const search = work.search(loaded.state.turn, 0);
    double const limit = work.bench.request.gap;
    std::vector<char> is_near(search.spaces, 0);
    for (FlankContact const& c : loaded.contacts)
        if (c.gap <= 2 * limit)
            is_near[c.space - search.first_space] = 1;
    std::vector<ContactArea> area(search.spaces);
    constexpr std::size_t grain = 2;
    parallel_for(search.spaces, work.bench.threads, grain, [&](std::size_t s) {
        if (!is_near[s])
            return;
        GapMap map{work.flanks.z, work.flanks.station, {field.space_angle(search.first_space + s)}, std::vector<double>(2 * work.flanks.slices() * work.flanks.points())};
        std::vector<double> gap;
        for (std::size_t k = 0; k < work.flanks.slices(); ++k)
        {
            field.along(search.first_space + s, flank, k, search.turn, gap);
            std::copy(gap.begin(), gap.end(), map.gap.begin() + static_cast<std::ptrdiff_t>(map.index(0, flank, k, 0)));
        }
        area[s] = contact_area(map, work.flanks, flank, limit, work.bench.width);
    });
    // all spaces have the same flanks
    double contact = 0, whole = 0;
    for (ContactArea const& each : area)
    {
        contact += each.contact;
        whole = std::max(whole, each.whole);
    }
    return whole > 0 ? contact / (whole * static_cast<double>(search.spaces)) : 0;
}

}  // namespace

BallPeak ball_peak(ElasticDrive const& drive, Equilibrium const& state)
{
    BallPeak peak;
    for (std::size_t b = 0; b < state.balls.size(); ++b)
    {
        double const force = drive.ball_arc > 0 ? state.balls[b] / drive.ball_arc : state.balls[b];
        if (drive.ball_arc <= 0 && force > 0)
            peak.carrying += drive.response.sectors();
        if (force > peak.force)
        {
            peak.force = force;
            peak.phi = drive.balls->phi[b];
        }
    }
    return peak;
}

BearingMap bearing_map(ElasticDrive const& drive, Equilibrium const& state)
{
    BearingMap map;
    map.z = drive.bearing_z;
    for (std::size_t w = 0; w < drive.bearing_steps.size(); ++w)
    {
        map.angle.push_back(drive.phase + drive.response.step() * drive.bearing_steps[w]);
        for (Eigen::Index j = 0; j < state.bearing.rows(); ++j)
            map.force.push_back(state.bearing(j, static_cast<Eigen::Index>(w)));
    }
    if (drive.balls)
        map.ball_angle = drive.balls->phi;
    for (double const force : state.balls)
        map.ball_force.push_back(drive.ball_arc > 0 ? force / drive.ball_arc : force);
    return map;
}

LobeReaction lobe_reaction(BearingMap const& bearing, int sectors, int waves)
{
    constexpr double rounding = 1e-9;  // of an angle that may be the border between two lobes
    LobeReaction lobe;
    double const part = 2 * std::numbers::pi / sectors, half = std::numbers::pi / waves;
    double moment = 0;
    // a sector may hold several lobes, and its angles begin anywhere
    for (std::size_t i = 0; i < bearing.angle.size(); ++i)
    {
        double const phi = std::remainder(bearing.angle[i], part);
        if (std::abs(phi) > half + rounding)
            continue;
        // half of a force on the border is this lobe's; where lobes repeat with the sectors, the other half is so at its other end
        bool const border = std::abs(std::abs(phi) - half) <= rounding, both_ends = border && part <= 2 * half + rounding;
        double const ends = border && !both_ends ? 0.5 : 1;
        for (std::size_t j = 0; j < bearing.z.size(); ++j)
        {
            double const f = ends * bearing.force[i * bearing.z.size() + j];
            lobe.along += f * std::cos(phi);
            lobe.across += both_ends ? 0 : f * std::sin(phi);
            moment += f * std::cos(phi) * bearing.z[j];
        }
    }
    lobe.z = lobe.along > 0 ? moment / lobe.along : 0;
    return lobe;
}

LoadedState summary_of(LoadWork const& work, Loaded const& loaded, double torque, double middle)
{
    LoadedState state;
    state.torque = torque;
    state.twist = loaded.state.turn - middle;
    state.stiffness = loaded.state.stiffness;
    state.rounds = loaded.rounds;
    state.steps = loaded.steps;
    state.residual = loaded.residual;
    state.complementarity = loaded.state.complementarity;
    FlankTable const t = table_of(work, loaded);
    auto const side = static_cast<std::size_t>(torque < 0 ? GapMap::left : GapMap::right);
    std::size_t const sectors = static_cast<std::size_t>(work.drive.response.sectors());
    std::size_t carrying = 0, nodes = 0;
    for (std::size_t s = 0; s < work.spaces(); ++s)
    {
        double on_tooth[2] = {0, 0};
        for (std::size_t f = 0; f < 2; ++f)
            for (std::size_t k = 0; k < t.slices; ++k)
            {
                std::size_t const i = t.index(s, f, k);
                on_tooth[f] += t.force[i];
                if (f == side && t.force[i] > 0)
                    ++nodes;
                if (t.pressure[i] > state.largest_pressure)
                {
                    state.largest_pressure = t.pressure[i];
                    state.pressure_space = static_cast<int>(s);
                    state.pressure_z = work.flanks.z[k];
                }
            }
        carrying += on_tooth[0] > 0 || on_tooth[1] > 0 ? 1 : 0;
        state.largest_force = std::max({state.largest_force, on_tooth[0], on_tooth[1]});
    }
    state.teeth = static_cast<int>(carrying * sectors);
    state.node_share = static_cast<double>(nodes) / static_cast<double>(work.spaces() * t.slices);
    state.contact_area = pressed_area(work, t, side);
    state.contact_share = state.contact_area / flank_area(work, side);
    state.near_share = near_share(work, loaded, static_cast<int>(side));
    for (std::size_t w = 0; w < work.drive.bearing_steps.size(); ++w)
    {
        auto const col = static_cast<Eigen::Index>(w);
        double const force = loaded.state.bearing.col(col).sum();
        state.wave_generator_force += force;
        // the surface pressed on rises by its slope per radian that it turns: forces along its normal do that work
        double const phi = work.drive.phase + work.drive.response.step() * work.drive.bearing_steps[w];
        if (!work.drive.balls)
            state.wave_generator_torque -= force * work.bench.shape(phi).w1;
    }
    // under balls it is the cam that turns, and lifts them
    for (std::size_t b = 0; b < loaded.state.balls.size(); ++b)
        state.wave_generator_torque -= loaded.state.balls[b] * work.bench.shape(work.drive.balls->phi[b]).w1;
    state.wave_generator_force *= static_cast<double>(sectors);
    state.wave_generator_torque *= static_cast<double>(sectors);
    LobeReaction const lobe = lobe_reaction(bearing_map(work.drive, loaded.state), work.drive.response.sectors(), work.scene().wave_generator.waves);
    state.lobe_force = lobe.along;
    state.lobe_force_across = lobe.across;
    state.lobe_z = lobe.z;
    BallPeak const ball = ball_peak(work.drive, loaded.state);
    state.ball_force = ball.force;
    state.ball_phi = ball.phi;
    state.balls = ball.carrying;
    return state;
}

LoadMap map_of(LoadWork const& work, Loaded const& loaded, double torque)
{
    FlankTable t = table_of(work, loaded);
    LoadMap map;
    map.torque = torque;
    map.z = work.flanks.z;
    GapField const field = work.field(loaded.shape, work.flanks);
    FlankSearch const search = work.search(0, 0);
    for (std::size_t s = 0; s < work.spaces(); ++s)
        map.angle.push_back(field.space_angle(search.first_space + s));
    map.force = std::move(t.force);
    map.line_load = std::move(t.load);
    map.pressure = std::move(t.pressure);
    map.height = std::move(t.height);
    // what is farther than was looked for
    double const far = work.reach();
    for (double& gap : t.gap)
        gap = std::min(gap, far);
    map.gap = std::move(t.gap);
    return map;
}

double ball_distance(BearingMap const& fine, BearingMap const& coarse, int sectors)
{
    std::size_t const count = fine.ball_angle.size();
    double worst = 0;
    for (std::size_t b = 0; count > 0 && b < coarse.ball_angle.size(); ++b)
    {
        // even angles of a sector
        double const place = (coarse.ball_angle[b] - fine.ball_angle.front()) * sectors / (2 * std::numbers::pi) * static_cast<double>(count);
        double const share = place - std::floor(place);
        auto const at = static_cast<std::size_t>(std::floor(place)) % count;
        double const here = (1 - share) * fine.ball_force[at] + share * fine.ball_force[(at + 1) % count];
        worst = std::max(worst, std::abs(here - coarse.ball_force[b]));
    }
    return worst;
}

}  // namespace hdconj::detail
