// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elastic/bent_cup.hpp"
#include "load/model/cup_shape.hpp"
#include "load/study/bearing_map.hpp"
#include "numeric/quantile.hpp"

namespace hdconj::load {
namespace {

/// How the error of a figure follows from its difference between grids. `usual`, the mean of the differences of 48
/// random drives like type-50, makes the differences of all figures comparable. `least` and `factor` are those of 121
/// drives of 20 to 100 mm, ratios 50 to 160 and lengths of a fifth to four fifths of the diameter, type-50 among them
/// (docs/explanation/load.md).
struct ErrorRule
{
    double LoadedState::*figure;
    double usual;                          ///< difference relative to the figure; 0: not compared
    double least;                          ///< that a drive of usual differences gets, relative to the figure
    double factor;                         ///< of the error over the difference, times grid_safety()
    double LoadedState::*scale = nullptr;  ///< that the difference is relative to; null: the figure
};

using S = LoadedState;
constexpr ErrorRule error_rules[] = {
    {&S::twist, 0.014, 0.0033, 1.15},
    {&S::stiffness, 0.034, 0.077, 0.75},
    {&S::contact_area, 0.51, 0.82, 1.4},
    {&S::contact_fraction, 0.51, 0.82, 1.4},
    {&S::fraction_within_gap, 0.41, 0.56, 0.88},
    {&S::carrying_fraction, 0, 0, 2},
    {&S::largest_pressure, 0.19, 0.83, 0.43},
    {&S::largest_force, 0.11, 0.19, 0.27},
    {&S::largest_line_load, 0.28, 0.7, 0.24},
    {&S::flank_pressure, 0, 0.46, 0.85},
    {&S::edge_force, 0.17, 0.64, 0.26},
    {&S::edge_fraction, 0, 0.08, 0.52},
    {&S::flowing_fraction, 0, 0, 1},
    {&S::wave_generator_force, 0.0019, 0.0069, 0.44},
    {&S::wave_generator_torque, 0.004, 0.004, 1.8},
    {&S::lobe_force, 0.0023, 0.0097, 0.41},
    {&S::lobe_force_across, 0.0085, 0.0031, 0.34, &S::lobe_force},
    {&S::ball_force, 0.0098, 0.075, 0.27},
};

/// Largest difference between the forces of the balls of two grids.
double bearing_distance(AssembledDrive const& a, AssembledDrive const& b)
{
    return ball_distance(bearing_map(a.model.drive, a.unloaded.state), bearing_map(b.model.drive, b.unloaded.state),
                         a.model.drive.response->sectors());
}

/// Radial displacement of the assembled wall in each slice, at @p phi from the major axis [mm].
std::vector<double> wall_at(AssembledDrive const& assembled, double phi)
{
    ElasticDrive const& drive = assembled.model.drive;
    std::vector<double> result;
    for (std::size_t k = 0; k < drive.slice_z.size(); ++k)
        result.push_back(series_at(drive, assembled.unloaded.shape.series[drive.stations.radial(k)], phi).value);
    return result;
}

/// Largest difference between the displacements of two grids at both axes, in the slices of the coarse one, which the
/// fine one has.
double displacement_distance(AssembledDrive const& fine, AssembledDrive const& coarse, double minor)
{
    std::vector<double> const &z = fine.model.drive.slice_z, &others = coarse.model.drive.slice_z;
    double worst = 0;
    for (double const phi : {0.0, minor}) {
        std::vector<double> const here = wall_at(fine, phi), there = wall_at(coarse, phi);
        for (std::size_t k = 0, at = 0; k < others.size(); ++k) {
            while (at + 1 < z.size() && z[at] < others[k])
                ++at;
            worst = std::max(worst, std::abs(here[at] - there[k]));
        }
    }
    return worst;
}

/// Of the drive whose figures are compared.
struct Scales
{
    double half_width;  ///< of the bearing [mm]
    int sectors;        ///< how often the ring repeats itself
};

/// Errors of @p a from its differences to @p coarser. In a single figure grids may agree by chance. The median over all
/// figures of difference over usual difference tells how far the drive as a whole has converged; no figure gets less
/// than its least difference times that median.
LoadedState error_of(LoadedState const& a, std::vector<LoadedState> const& coarser, double safety, Scales const& drive)
{
    auto const difference = [&](double LoadedState::*figure) {
        std::vector<double> values(coarser.size());
        std::ranges::transform(coarser, values.begin(), figure);
        return grid_difference(a.*figure, values);
    };
    auto const scale = [&](ErrorRule const& rule) { return std::abs(a.*(rule.scale ? rule.scale : rule.figure)); };
    std::vector<double> over_usual = {0};
    for (ErrorRule const& rule : error_rules)
        if (rule.usual * scale(rule) > 0)
            over_usual.push_back(difference(rule.figure) / (rule.usual * scale(rule)));
    double const spread = numeric::quantile(over_usual, 0.5);
    LoadedState d;
    for (ErrorRule const& rule : error_rules)
        d.*rule.figure = rule.factor * safety * std::max(difference(rule.figure), spread * rule.least * scale(rule));
    constexpr double least_height = 0.0055, height_factor = 0.42;  // of half the bearing's width
    bool const has_height = std::ranges::none_of(coarser, [](auto const& each) { return std::isnan(each.lobe_z); });
    // A grid without it leaves open where on the bearing it is.
    d.lobe_z = std::isnan(a.lobe_z) ? a.lobe_z
               : !has_height        ? 2 * drive.half_width
                                    : height_factor * safety *
                                   std::max(difference(&LoadedState::lobe_z), spread * least_height * drive.half_width);
    // Forces on single slices have no strip between slices: what is under pressure lies within the gap.
    if (a.contact_fraction == 0 && a.teeth > 0)
        d.contact_fraction = std::max(d.contact_fraction, a.fraction_within_gap);
    // All grids may have all forces on edges where a finer one has some beside them, at a pressure that is unknown.
    if (a.twist != 0)
        d.edge_fraction = std::max(d.edge_fraction, std::min(1.0, d.twist / std::abs(a.twist)) * a.edge_fraction);
    if (a.flank_pressure == 0)
        d.flank_pressure = a.largest_pressure;
    // What the teeth press to one side of the lobe depends on their place, which is no better known than the twist.
    for (double LoadedState::*const figure : {&LoadedState::wave_generator_torque, &LoadedState::lobe_force_across})
        if (a.twist != 0)
            d.*figure = std::max(d.*figure, std::min(1.0, d.twist / std::abs(a.twist)) * std::abs(a.*figure));
    for (int LoadedState::*const number : {&LoadedState::teeth, &LoadedState::balls}) {
        std::vector<int> numbers(coarser.size());
        std::ranges::transform(coarser, numbers.begin(), number);
        d.*number = count_error(a.*number, numbers, drive.sectors, safety);
    }
    return d;
}

/// Where steel flows the largest pressure is an upper bound, and the mean @p flow_pressure a lower one. All grids give
/// the same value there, so that their difference says nothing of its error.
void reach_mean_of_flow(double flow_pressure, LoadedState const& state, LoadedState& error)
{
    constexpr double rounding = 1e-9;  // of a mean over the half millimetre at an end
    double const bound = 4 / std::numbers::pi * flow_pressure;
    for (double LoadedState::*const pressure : {&LoadedState::largest_pressure, &LoadedState::flank_pressure})
        if (state.*pressure >= (1 - rounding) * bound)
            error.*pressure = std::max(error.*pressure, bound - flow_pressure);
}

/// Raises errors before the last torque. In a single state grids may agree by chance: over its figure the error of a
/// state is no smaller than those of the states beside it. Below half of the largest torque fewer teeth carry than in
/// the states that error_rules are of. The last state, whose figures are the drive's, keeps its own.
void level_errors(std::vector<LoadedState> const& states, std::vector<std::optional<LoadedState>>& errors)
{
    constexpr double half = 0.5, of_few_teeth = 1.5;
    std::vector<std::optional<LoadedState>> const own = errors;
    auto const is_known = [&](std::size_t i) { return own[i] && states[i].torque != 0; };
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        if (!is_known(i))
            continue;
        double const factor = std::abs(states[i].torque) < half * std::abs(states.back().torque) ? of_few_teeth : 1;
        for (ErrorRule const& rule : error_rules) {
            double LoadedState::*const figure = rule.figure;
            for (std::size_t const j : {i - 1, i + 1})
                if (j < errors.size() && is_known(j) && states[j].*figure != 0)
                    (*errors[i]).*figure = std::max(
                        (*errors[i]).*figure, std::abs(states[i].*figure / states[j].*figure) * (*own[j]).*figure);
            (*errors[i]).*figure *= factor;
        }
        for (int LoadedState::*const number : {&LoadedState::teeth, &LoadedState::balls})
            for (std::size_t const j : {i - 1, i + 1})
                if (j < errors.size() && is_known(j))
                    (*errors[i]).*number = std::max((*errors[i]).*number, (*own[j]).*number);
    }
}

}  // namespace

double grid_difference(double fine, std::span<double const> coarser)
{
    double const half = std::abs(fine - coarser[0]);
    return coarser.size() == 1 ? half : std::max(half, std::abs(coarser[0] - coarser[1]) / 4);
}

double wall_difference(contact::ContactContext const& context, DriveGrids const& drives)
{
    double const minor = std::numbers::pi / context.scene.wave_generator.waves;
    std::vector<double> distances;
    for (AssembledDrive const& drive : drives.coarser)
        distances.push_back(displacement_distance(drives.fine, drive, minor));
    return grid_difference(0, distances);
}

double backlash_error(double width, std::span<double const> coarser, double wall, double radius, double safety)
{
    // Teeth that press on both flanks are a balance, whose error varies more than that of a gap.
    double const factor = width < 0 ? 2.4 : 0.8;
    constexpr double steepness = 0.8;  // tan(alpha) at the rounded edges of tips; flanks have 0.3
    return std::max(factor * safety * grid_difference(width, coarser), 2 * steepness * wall / radius);
}

int count_error(int fine, std::span<int const> coarser, int sectors, double safety)
{
    if (fine == 0 && std::ranges::all_of(coarser, [](int count) { return count == 0; }))
        return 0;
    int const next = std::abs(fine - coarser[0]),
              before = coarser.size() > 1 ? (std::abs(coarser[0] - coarser[1]) + 1) / 2 : 0;
    constexpr double factor = 0.5;  // of the safety: twice the difference with nine slices or more
    return std::max(sectors, static_cast<int>(std::ceil(factor * safety * std::max(next, before))));
}

double stress_error(double fine, std::span<double const> coarser, double unresolved, double of_slices, double safety)
{
    constexpr double part = 0.5, least = 0.08, slices = 1.5;
    return std::max({part * (safety * grid_difference(fine, coarser) + unresolved), slices * of_slices, least * fine});
}

void estimate_errors(contact::ContactContext const& context, DriveGrids const& drives, AssembledCup& cup)
{
    double const safety = grid_safety(cup.z.size());
    std::vector<AssembledCup> coarser;
    std::vector<double> balls;
    for (AssembledDrive const& drive : drives.coarser) {
        coarser.push_back(assembled_cup(context, drive));
        balls.push_back(bearing_distance(drives.fine, drive));
    }
    auto const difference = [&](double AssembledCup::*figure) {
        std::vector<double> values(coarser.size());
        std::ranges::transform(coarser, values.begin(), figure);
        return grid_difference(cup.*figure, values);
    };
    cup.displacement_error = safety * wall_difference(context, drives);
    // The slope over three slices is that over the two at the ends, so a coarser grid does not show this part.
    auto const between_slices = [&, field = cup_field(drives.fine.model, drives.fine.unloaded.forces, context.threads)](
                                    double slope, double phi) {
        LoadModel const& model = drives.fine.model;
        return std::abs(slope - elastic::wall_slope(model.solid.mesh(), field, model.middle + cup.z.front(),
                                                    model.middle + cup.z.back(), phi));
    };
    auto const coning_error = [&](double AssembledCup::*coning, double phi) {
        double const grids = difference(coning);
        return std::max(safety * grids, grids + between_slices(cup.*coning, phi));
    };
    cup.coning_major_error = coning_error(&AssembledCup::coning_major, 0);
    cup.coning_minor_error =
        coning_error(&AssembledCup::coning_minor, std::numbers::pi / context.scene.wave_generator.waves);
    constexpr double force = 0.85, ball = 0.25;  // they converge faster than the shape
    constexpr double least_force = 0.005;        // of it: grids agree by chance, and share their harmonics
    cup.wave_generator_force_error = std::max(force * safety * difference(&AssembledCup::wave_generator_force),
                                              least_force * std::abs(cup.wave_generator_force));
    cup.ball_force_error = ball * safety * std::max(grid_difference(0, balls), difference(&AssembledCup::ball_force));
    std::vector<double> stress(coarser.size());
    std::ranges::transform(coarser, stress.begin(), &AssembledCup::largest_stress);
    cup.largest_stress_error = stress_error(cup.largest_stress, stress, cup.largest_stress_error, 0, safety);
    cup.estimated = true;
}

std::vector<std::optional<LoadedState>> branch_errors(LoadProblem const& problem, TorqueBranch const& branch,
                                                      std::vector<CoarseBranch> const& coarser)
{
    ElasticDrive const& drive = problem.drive;
    Scales const scales{0.5 * (drive.bearing_z.back() - drive.bearing_z.front()), drive.response->sectors()};
    std::vector<std::optional<LoadedState>> errors(branch.states.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        std::vector<LoadedState> states;
        for (auto each = coarser.begin(); each != coarser.end() && each->states[i]; ++each)
            states.push_back(*each->states[i]);
        if (states.empty())
            continue;
        errors[i] = error_of(branch.states[i], states, grid_safety(drive.slice_z.size()), scales);
        errors[i]->twist += branch.states[i].gap_mismatch / problem.context.geometry.r_m;
    }
    level_errors(branch.states, errors);
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (errors[i])
            reach_mean_of_flow(drive.flow_pressure, branch.states[i], *errors[i]);
    return errors;
}

}  // namespace hdconj::load
