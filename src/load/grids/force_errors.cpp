// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_errors.hpp"

#include <algorithm>
#include <cmath>

#include "grid_error.hpp"
#include "load/study/bearing_map.hpp"
#include "load/study/twist_members.hpp"

namespace hdconj::load {
namespace {

/// Forces of the balls of @p coarse at the angles of those of @p fine.
std::vector<double> forces_at_balls(BearingMap const& fine, BearingMap const& coarse, int sectors)
{
    std::vector<double> forces;
    for (double const angle : fine.ball_angle)
        forces.push_back(ball_force_at(coarse, angle, sectors));
    return forces;
}

/// Enters the errors of the members of @p result from the same members on coarser grids, in the order of
/// twist_members(): half of the backlash has half of its error; teeth and bearing no less than the whole twist, whose
/// figures tell chance from convergence; a given stiffness none.
void enter_member_errors(std::vector<std::vector<TwistMember>> const& coarser, double safety, LoadCase& result)
{
    constexpr double of_teeth = 0.6, of_cup = 0.5;
    double const whole = result.curve[result.rated].twist, whole_error = result.error.twist;
    for (std::size_t m = 0; m < result.members.size(); ++m) {
        TwistMember& member = result.members[m];
        std::vector<double> twists;
        for (auto const& members : coarser)
            twists.push_back(members[m].twist);
        double const difference = safety * grid_difference(member.twist, twists);
        member.twist_error = m == 0   ? result.backlash_error / 2
                             : m == 1 ? std::max(of_teeth * difference, whole_error)
                                      : of_cup * difference;
        if (member.twist != 0) {
            member.stiffness_error = member.stiffness * member.twist_error / std::abs(member.twist);
            member.fraction_error = (member.twist_error + std::abs(member.fraction) * whole_error) / std::abs(whole);
        }
    }
}

}  // namespace

std::vector<double> errors_side_by_side(std::vector<double> const& fine,
                                        std::vector<std::vector<double>> const& coarser, double factor)
{
    std::size_t const count = fine.size();
    std::vector<double> difference(count);
    std::vector<char> acts(count);
    double sum = 0, acting = 0;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> others;
        for (auto const& values : coarser)
            others.push_back(values[i]);
        difference[i] = grid_difference(fine[i], others);
        acts[i] = fine[i] != 0 || std::ranges::any_of(others, [](double value) { return value != 0; });
        sum += difference[i] * difference[i];
        acting += acts[i];
    }
    double const usual = acting > 0 ? std::sqrt(sum / acting) : 0;
    std::vector<double> errors(count);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t const step : {count - 2, count - 1, count, count + 1, count + 2}) {
            std::size_t const near = (i + step) % count;
            errors[i] = std::max(errors[i], factor * (acts[near] ? std::max(difference[near], usual) : 0));
        }
    return errors;
}

void enter_force_errors(PathsOnGrids const& paths, DriveGrids const& drives, std::vector<CoarseBranch> const& coarser,
                        LoadCase& result)
{
    constexpr double of_tooth = 0.7, of_ball = 1.2;
    LoadModel const& model = drives.fine.model;
    std::vector<std::vector<double>> teeth, balls;
    std::vector<std::vector<TwistMember>> members;
    for (std::size_t g = 0; g < coarser.size() && coarser[g].last; ++g) {
        TorqueContinuation const& path = *paths.coarser[g]->path;
        LoadModel const& coarse = drives.coarser[g].model;
        teeth.push_back(load_map(path.problem, *coarser[g].last).tooth_force);
        balls.push_back(forces_at_balls(result.bearing, bearing_map(coarse.drive, coarser[g].last->state),
                                        model.drive.response->sectors()));
        LoadedState const& state = *coarser[g].states.back();
        members.push_back(twist_members(state, free_twist(path, state.torque),
                                        cup_in_torsion(coarse.drive, coarse.radius), drives.series));
    }
    if (teeth.empty())
        return;
    double const safety = grid_safety(model.drive.slice_z.size());
    result.map.tooth_force_error = errors_side_by_side(result.map.tooth_force, teeth, of_tooth * safety);
    result.bearing.ball_force_error = errors_side_by_side(result.bearing.ball_force, balls, of_ball * safety);
    enter_member_errors(members, safety, result);
}

}  // namespace hdconj::load
