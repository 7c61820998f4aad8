// SPDX-License-Identifier: GPL-3.0-or-later
#include "branch_on_grids.hpp"

#include <cmath>
#include <numbers>

#include "grid_error.hpp"
#include "hdconj/error.hpp"
#include "load/model/ring_errors.hpp"
#include "load/study/twist_members.hpp"

namespace hdconj::load {

bool is_mirror_image(contact::ContactContext const& context)
{
    return contact::has_mirrored_flanks(context) && !break_the_mirror(context.scene) &&
           context.request.wave_generator == 0 && context.scene.bearing->ball_phase == 0;
}

BranchWithErrors solved_branch(PathsOnGrids const& paths, BranchTorques const& torques,
                               std::function<void(double)> const& on_state)
{
    BranchWithErrors result{torque_branch(paths.fine, torques, on_state), {}, {}};
    std::vector<LoadedState>& states = result.branch.states;
    enter_stiffness(states, free_twist(paths.fine, torques.given.back()), stiffness_at(paths.fine, result.branch.last));
    for (auto const& path : paths.coarser)
        result.coarser.push_back(coarse_branch(*path->path, result.branch));
    result.errors = branch_errors(paths.fine.problem, result.branch, result.coarser);
    if (paths.series > 0) {
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (auto& error = result.errors[i])
                error->stiffness /= std::pow(softening(paths.series, states[i].stiffness), 2);
            add_in_series(paths.series, states[i]);
            for (CoarseBranch& each : result.coarser)
                if (auto& state = each.states[i])
                    add_in_series(paths.series, *state);
        }
    }
    return result;
}

BranchWithErrors opposite_branch(contact::ContactContext const& context, PathsOnGrids const& paths,
                                 BranchWithErrors const& forth, std::vector<double> const& space_angle,
                                 std::function<bool()> const& stop, std::function<void(double)> const& on_state)
{
    if (!is_mirror_image(context)) {
        BranchTorques opposite{.given = {}, .stop = stop};
        for (LoadedState const& state : forth.branch.states)
            if (state.torque != 0)
                opposite.given.push_back(-state.torque);
        try {
            return opposite.given.empty() ? BranchWithErrors() : solved_branch(paths, opposite, on_state);
        } catch (NumericalError const& error) {
            if (error.code() != ErrorCode::stopped)
                throw;
            BranchWithErrors stopped;
            for (double const torque : opposite.given)
                stopped.branch.unsettled.push_back({torque, error.cause()});
            return stopped;
        }
    }
    double const period = 2 * std::numbers::pi / paths.fine.problem.drive.response->sectors();
    BranchWithErrors back;
    for (std::size_t i = 0; i < forth.branch.states.size(); ++i)
        if (forth.branch.states[i].torque != 0) {
            back.branch.states.push_back(mirror_image(forth.branch.states[i], space_angle, period));
            back.errors.push_back(forth.errors[i]);
        }
    for (UnsettledTorque const& each : forth.branch.unsettled)
        back.branch.unsettled.push_back({-each.torque, each.cause});
    for (CoarseBranch const& on_grid : forth.coarser) {
        CoarseBranch& mirrored = back.coarser.emplace_back();
        for (LoadedState const& state : on_grid.solved())
            mirrored.states.push_back(mirror_image(state, space_angle, period));
    }
    return back;
}

}  // namespace hdconj::load
