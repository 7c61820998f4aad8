// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_error.hpp"

#include <algorithm>
#include <cmath>

#include "load/study/bearing_map.hpp"

namespace hdconj::load {
namespace {

/// How the error of a figure follows from its difference between grids. `usual` and `factor` are those of 48 random
/// drives: the mean of the differences, and what lets none of the errors be too small (docs/explanation/load.md).
struct ErrorRule
{
    double LoadedState::*figure;
    double usual;                          ///< difference relative to the figure; 0: not used
    double factor;                         ///< of the error over the difference, times grid_safety()
    double LoadedState::*scale = nullptr;  ///< that the difference is relative to; null: the figure
};

using S = LoadedState;
constexpr ErrorRule error_rules[] = {
    {&S::twist, 0.014, 1.3},
    {&S::stiffness, 0.034, 0.95},
    {&S::contact_area, 0.51, 2.1},
    {&S::contact_fraction, 0.51, 2.1},
    {&S::fraction_within_gap, 0.41, 1.2},
    {&S::carrying_fraction, 0, 2},
    {&S::largest_pressure, 0.19, 1},
    {&S::largest_force, 0.11, 0.45},
    {&S::largest_line_load, 0.28, 0.25},
    {&S::flank_pressure, 0, 0.65},
    {&S::edge_force, 0.17, 0.33},
    {&S::edge_fraction, 0, 0.12},
    {&S::flowing_fraction, 0, 1},
    {&S::wave_generator_force, 0.0019, 1.4},
    {&S::wave_generator_torque, 0.004, 1.4},
    {&S::lobe_force, 0.0023, 1.4},
    {&S::lobe_force_across, 0.0085, 0.15, &S::lobe_force},
    {&S::ball_force, 0.0098, 1.6},
};

/// Largest difference between the forces of the balls of two grids.
double bearing_distance(AssembledDrive const& a, AssembledDrive const& b)
{
    return ball_distance(bearing_map(a.model.drive, a.unloaded.state), bearing_map(b.model.drive, b.unloaded.state),
                         a.model.drive.response->sectors());
}

/// Largest difference between the displacements of two grids in the slices of the coarse one, which the fine one has.
double displacement_distance(AssembledCup const& fine, AssembledCup const& coarse)
{
    double worst = 0;
    for (std::size_t k = 0, at = 0; k < coarse.z.size(); ++k) {
        while (at + 1 < fine.z.size() && fine.z[at] < coarse.z[k])
            ++at;
        worst = std::max(
            {worst, std::abs(fine.w_major[at] - coarse.w_major[k]), std::abs(fine.w_minor[at] - coarse.w_minor[k])});
    }
    return worst;
}

/// The middle one of @p values. Domain: at least one.
double median(std::vector<double> values)
{
    auto const middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Errors of @p a from its differences to @p coarser. In a single figure grids may agree by chance. The median over all
/// figures of difference over usual difference tells how far the drive as a whole has converged; no figure gets less
/// than its usual difference times that median.
/// @param half_width  of the bearing [mm]
LoadedState error_of(LoadedState const& a, std::vector<LoadedState> const& coarser, double safety, double half_width)
{
    auto const difference = [&](double LoadedState::*figure) {
        std::vector<double> values(coarser.size());
        std::ranges::transform(coarser, values.begin(), figure);
        return grid_difference(a.*figure, values);
    };
    auto const usual = [&](ErrorRule const& rule) {
        return rule.usual * std::abs(a.*(rule.scale ? rule.scale : rule.figure));
    };
    std::vector<double> over_usual = {0};
    for (ErrorRule const& rule : error_rules)
        if (usual(rule) > 0)
            over_usual.push_back(difference(rule.figure) / usual(rule));
    double const spread = median(over_usual);
    LoadedState d;
    for (ErrorRule const& rule : error_rules)
        d.*rule.figure = rule.factor * safety * std::max(difference(rule.figure), spread * usual(rule));
    constexpr double usual_height = 0.0011, height_factor = 2.1;  // of half the bearing's width
    d.lobe_z = height_factor * safety * std::max(difference(&LoadedState::lobe_z), spread * usual_height * half_width);
    // Forces on single slices have no strip between slices: what is under pressure lies within the gap.
    if (a.contact_fraction == 0 && a.teeth > 0)
        d.contact_fraction = std::max(d.contact_fraction, a.fraction_within_gap);
    // All grids may have all forces on edges where a finer one has some beside them, at a pressure that is unknown.
    if (a.twist != 0)
        d.edge_fraction = std::max(d.edge_fraction, std::min(1.0, d.twist / std::abs(a.twist)) * a.edge_fraction);
    if (a.flank_pressure == 0)
        d.flank_pressure = a.largest_pressure;
    d.teeth = std::abs(a.teeth - coarser.front().teeth);
    d.balls = std::abs(a.balls - coarser.front().balls);
    return d;
}

}  // namespace

double grid_difference(double fine, std::span<double const> coarser)
{
    double const half = std::abs(fine - coarser[0]);
    return coarser.size() == 1 ? half : std::max(half, std::abs(coarser[0] - coarser[1]) / 4);
}

double stress_error(double fine, std::span<double const> coarser, double at_corners, double safety)
{
    constexpr double part = 0.5, least = 0.08;
    return std::max(part * (safety * grid_difference(fine, coarser) + at_corners), least * fine);
}

void estimate_errors(contact::ContactContext const& context, DriveGrids const& drives, AssembledCup& cup)
{
    double const safety = grid_safety(cup.z.size());
    std::vector<AssembledCup> coarser;
    std::vector<double> balls, displacements;
    for (AssembledDrive const& drive : drives.coarser) {
        coarser.push_back(assembled_cup(context, drive));
        balls.push_back(bearing_distance(drives.fine, drive));
        displacements.push_back(displacement_distance(cup, coarser.back()));
    }
    auto const difference = [&](double AssembledCup::*figure) {
        std::vector<double> values(coarser.size());
        std::ranges::transform(coarser, values.begin(), figure);
        return grid_difference(cup.*figure, values);
    };
    cup.displacement_error = safety * grid_difference(0, displacements);
    cup.coning_major_error = safety * difference(&AssembledCup::coning_major);
    cup.coning_minor_error = safety * difference(&AssembledCup::coning_minor);
    constexpr double force = 0.8, ball = 0.16;  // they converge faster than the shape
    cup.wave_generator_force_error = force * safety * difference(&AssembledCup::wave_generator_force);
    cup.ball_force_error = ball * safety * std::max(grid_difference(0, balls), difference(&AssembledCup::ball_force));
    std::vector<double> stress(coarser.size());
    std::ranges::transform(coarser, stress.begin(), &AssembledCup::largest_stress);
    cup.largest_stress_error = stress_error(cup.largest_stress, stress, cup.largest_stress_error, safety);
    cup.estimated = true;
}

std::vector<std::optional<LoadedState>> branch_errors(LoadProblem const& problem, TorqueBranch const& branch,
                                                      std::vector<CoarseBranch> const& coarser)
{
    ElasticDrive const& drive = problem.drive;
    double const half_width = 0.5 * (drive.bearing_z.back() - drive.bearing_z.front());
    std::vector<std::optional<LoadedState>> errors(branch.states.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        std::vector<LoadedState> states;
        for (auto each = coarser.begin(); each != coarser.end() && each->states[i]; ++each)
            states.push_back(*each->states[i]);
        if (states.empty())
            continue;
        errors[i] = error_of(branch.states[i], states, grid_safety(drive.slice_z.size()), half_width);
        errors[i]->twist += branch.states[i].gap_mismatch / problem.context.geometry.r_m;
    }
    return errors;
}

}  // namespace hdconj::load
