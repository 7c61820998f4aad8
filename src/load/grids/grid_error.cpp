// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/quantile.hpp"

namespace hdconj::load {
namespace {

/// How the error of a figure follows from its difference between grids. `usual`, the mean of the differences of 48
/// random drives like type-50, makes the differences of all figures comparable. The others are those of 210 drives of
/// 20 to 100 mm, ratios from 30 to 160 and lengths of a fifth to four fifths of the diameter, at 4 to 100 % of their
/// torques (docs/explanation/load.md). Figures without a factor have errors of their own, of error_of().
struct ErrorRule
{
    double LoadedState::*figure;
    double usual;          ///< difference relative to the figure; 0: not compared
    double least;          ///< added to the difference in a drive of usual differences, relative to the figure
    double factor;         ///< of the error over the difference, times grid_safety()
    double growth;         ///< exponent of the torque below usual_torque()
    double departure = 0;  ///< share of Departure::relative that is added to the difference, relative to the figure
    double LoadedState::*scale = nullptr;  ///< that the difference is relative to; null: the figure
};

constexpr double steepness = 0.8;  ///< tan(alpha) at the rounded edges of tips; flanks have 0.3

using S = LoadedState;
constexpr ErrorRule error_rules[] = {
    {&S::twist, 0.014, 0.003, 0.8, 0.6},
    {&S::stiffness, 0.034, 0.03, 0.42, 0.3, 1},
    {&S::contact_area, 0.51, 0.01, 0.95, 0.75},
    {&S::contact_fraction, 0.51, 0.01, 0.95, 0.75},
    {&S::fraction_within_gap, 0.41, 0.01, 0.67, 0.75},
    {&S::carrying_fraction, 0, 0, 2, 0},
    {&S::largest_pressure, 0.19, 0, 0, 0.15},
    {&S::largest_force, 0.11, 1, 0.06, 0.45},
    {&S::largest_line_load, 0.28, 1, 0.13, 0.45},
    {&S::flank_pressure, 0, 1, 0.38, 0.15},
    {&S::edge_force, 0.17, 0.3, 0.38, 0.3},
    {&S::edge_fraction, 0, 0.03, 0.52, 0.3},
    {&S::flowing_fraction, 0, 0, 1, 0},
    {&S::wave_generator_force, 0.0019, 0.01, 0.28, -0.3},
    {&S::wave_generator_torque, 0.004, 0, 0, 0},
    {&S::lobe_force, 0.0023, 0.01, 0.3, -0.3},
    {&S::lobe_force_across, 0.0085, 0, 0, 0, 0, &S::lobe_force},
    {&S::ball_force, 0.0098, 0.01, 1.8, -0.3},
};

/// Of the drive whose figures are compared.
struct Scales
{
    double half_width;    ///< of the bearing [mm]
    int sectors;          ///< how often the ring repeats itself
    double teeth;         ///< of the circular spline
    double torque_ratio;  ///< of the wave generator's mean torque over a pitch to that on the circular spline
    double usual_torque;  ///< usual_torque() [N mm]
};

/// Torque of a drive as large and as stiff as @p scene says that strains it as 28 N m strain type-50 [N mm].
double usual_torque(Scene const& scene)
{
    constexpr double type_50 = 1.087e-6;  // 28 N m over E d^3
    return type_50 * scene.flexspline.cup->youngs_modulus *
           std::pow(scene.drive.module * scene.drive.flexspline_teeth, 3);
}

/// How far the wave generator's torque at one angle of the wave generator is from its mean over a tooth pitch. Without
/// friction that mean is (z_c - z_f)/z_c of the torque on the circular spline. The departure depends on which teeth
/// carry at that angle, and grids may agree on it by chance: the largest one on any grid measures the error.
struct Departure
{
    double absolute = 0;  ///< [N mm]
    double relative = 0;  ///< to the mean; 0 without torque
};

Departure departure_from_mean(LoadedState const& a, std::vector<LoadedState> const& coarser, Scales const& drive)
{
    double const mean = drive.torque_ratio * a.torque;
    double departure = std::abs(a.wave_generator_torque - mean);
    for (LoadedState const& each : coarser)
        departure = std::max(departure, std::abs(each.wave_generator_torque - mean));
    return {departure, mean != 0 ? departure / std::abs(mean) : 0};
}

/// Enters the errors of the numbers of teeth and balls. @param d  has that of the stiffness
void enter_numbers(LoadedState const& a, std::vector<LoadedState> const& coarser, double safety, int sectors,
                   LoadedState& d)
{
    for (int LoadedState::*const number : {&LoadedState::teeth, &LoadedState::balls}) {
        std::vector<int> numbers(coarser.size());
        std::ranges::transform(coarser, numbers.begin(), number);
        d.*number = count_error(a.*number, numbers, sectors, safety);
    }
    // Stiffness comes with the number of teeth.
    constexpr double of_stiffness = 1.7;
    if (a.stiffness > 0) {
        double const lobes = a.teeth * std::min(1.0, of_stiffness * d.stiffness / a.stiffness) / sectors;
        d.teeth = std::max(d.teeth, sectors * static_cast<int>(std::ceil(lobes)));
    }
}

/// Errors of @p a from its differences to @p coarser. In a single figure grids may agree by chance. The median over all
/// figures of difference over usual difference tells how far the drive as a whole has converged; to each
/// difference the least one times that median is added.
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
    Departure const departure = departure_from_mean(a, coarser, drive);
    for (ErrorRule const& rule : error_rules)
        d.*rule.figure =
            rule.factor * safety *
            (difference(rule.figure) + (spread * rule.least + departure.relative * rule.departure) * scale(rule));
    constexpr double least_height = 0.012, height_factor = 0.42;  // of half the bearing's width
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
    // Pressure on an edge or an end grows with finer grids, without a bound that differences would tell.
    auto const is_on_edge = [](LoadedState const& each) { return each.largest_pressure > each.flank_pressure; };
    d.largest_pressure = is_on_edge(a) || std::ranges::any_of(coarser, is_on_edge)
                             ? std::numeric_limits<double>::quiet_NaN()
                             : d.flank_pressure;
    constexpr double of_across = 1.05, of_difference = 0.1;
    d.wave_generator_torque = safety * departure.absolute;
    double const of_twist = a.twist != 0 ? difference(&LoadedState::twist) / std::abs(a.twist) : 0;
    d.lobe_force_across = of_across * safety *
                          ((departure.relative + of_difference * of_twist) * std::abs(a.lobe_force_across) +
                           of_difference * difference(&LoadedState::lobe_force_across));
    // A tooth that stands on an end carries most of its force there, whose error is the surer one.
    constexpr double of_edge = 0.35;
    if (a.largest_force > 0)
        d.largest_force =
            std::max(d.largest_force, of_edge * std::min(1.0, a.edge_force / a.largest_force) * d.edge_force);
    enter_numbers(a, coarser, safety, drive.sectors, d);
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
            error.*pressure = std::fmax(error.*pressure, bound - flow_pressure);  // also where it is not determined
}

/// Raises errors before the last torque. In a single state grids may agree by chance: over its figure the error of a
/// state is no smaller than those of the states beside it. The last state, whose figures are the drive's, keeps its
/// own.
void level_errors(std::vector<LoadedState> const& states, std::vector<std::optional<LoadedState>>& errors)
{
    std::vector<std::optional<LoadedState>> const own = errors;
    auto const is_known = [&](std::size_t i) { return own[i] && states[i].torque != 0; };
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        if (!is_known(i))
            continue;
        for (std::size_t const j : {i - 1, i + 1}) {
            if (j >= errors.size() || !is_known(j))
                continue;
            for (ErrorRule const& rule : error_rules)
                if (double LoadedState::*const figure = rule.figure; states[j].*figure != 0)
                    (*errors[i]).*figure = std::max(
                        (*errors[i]).*figure, std::abs(states[i].*figure / states[j].*figure) * (*own[j]).*figure);
            for (int LoadedState::*const number : {&LoadedState::teeth, &LoadedState::balls})
                (*errors[i]).*number = std::max((*errors[i]).*number, (*own[j]).*number);
        }
    }
}

/// Changes the errors of a state below the usual torque: fewer teeth carry than in the states that error_rules are of,
/// and they yield less, so that an error of their gaps is a larger part of it. The bearing's forces are mostly those of
/// the assembly there, which are known better. At less than a hundredth of the usual torque the errors change no more:
/// teeth that press on both flanks carry much the same forces there as without torque.
void scale_at_small_torques(LoadedState const& state, Scales const& drive, LoadedState& error)
{
    constexpr double most = 100;
    double const ratio = std::min(most, drive.usual_torque / std::abs(state.torque));
    if (state.torque == 0 || ratio <= 1)
        return;
    for (ErrorRule const& rule : error_rules)
        error.*rule.figure *= std::pow(ratio, rule.growth);
    constexpr double of_teeth = 0.4, of_height = -0.2;
    error.lobe_z *= std::pow(ratio, of_height);
    double const lobes = std::ceil(error.teeth * std::pow(ratio, of_teeth) / drive.sectors);
    error.teeth = drive.sectors * static_cast<int>(std::min(lobes, std::floor(drive.teeth / drive.sectors)));
}

}  // namespace

double grid_difference(double fine, std::span<double const> coarser)
{
    double const half = std::abs(fine - coarser[0]);
    return coarser.size() == 1 ? half : std::max(half, std::abs(coarser[0] - coarser[1]) / 4);
}

double turn_to_close(double length, double radius)
{
    return length * std::hypot(1, steepness) / radius;
}

double backlash_error(double width, std::span<double const> coarser, double wall, double radius, double safety)
{
    // Teeth that press on both flanks are a balance, whose error varies more than that of a gap.
    double const factor = width < 0 ? 3.8 : 0.8;
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

std::vector<std::optional<LoadedState>> branch_errors(LoadProblem const& problem, TorqueBranch const& branch,
                                                      std::vector<CoarseBranch> const& coarser)
{
    ElasticDrive const& drive = problem.drive;
    auto const& gears = problem.context.scene.drive;
    double const torque_ratio =
        static_cast<double>(gears.circular_spline_teeth - gears.flexspline_teeth) / gears.circular_spline_teeth;
    Scales const scales{0.5 * (drive.bearing_z.back() - drive.bearing_z.front()), drive.response->sectors(),
                        static_cast<double>(gears.circular_spline_teeth), torque_ratio,
                        usual_torque(problem.context.scene)};
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
        if (errors[i]) {
            scale_at_small_torques(branch.states[i], scales, *errors[i]);
            reach_mean_of_flow(drive.flow_pressure, branch.states[i], *errors[i]);
        }
    return errors;
}

}  // namespace hdconj::load
