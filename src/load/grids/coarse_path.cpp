// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarse_path.hpp"

#include <utility>

#include "hdconj/error.hpp"

namespace hdconj::load {

CoarsePath::CoarsePath(contact::ContactContext const& context, AssembledDrive const& drive,
                       contact::FlankGrid const& finer, TorqueContinuation const& fine)
    : flanks(coarsened(finer)), problem(load_problem(context, drive.model.drive, flanks))
{
    LoadedShape const& shape = drive.unloaded.shape;
    try {
        std::optional<Play> const play =
            fine.pressed ? play_of(problem, shape) : play_about(problem, shape, fine.middle);
        if (play)
            path.emplace(torque_continuation(problem, drive.unloaded, *play));
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
        // There is nothing to compare with.
    }
}

std::vector<std::unique_ptr<CoarsePath>> coarse_paths(contact::ContactContext const& context, DriveGrids const& drives,
                                                      TorqueContinuation const& fine)
{
    std::vector<std::unique_ptr<CoarsePath>> paths;
    contact::FlankGrid const* finer = &fine.problem.flanks;
    for (AssembledDrive const& drive : drives.coarser) {
        auto path = std::make_unique<CoarsePath>(context, drive, *finer, fine);
        if (!path->path)
            break;
        finer = &path->flanks;
        paths.push_back(std::move(path));
    }
    return paths;
}

std::vector<LoadedState> CoarseBranch::solved() const
{
    std::vector<LoadedState> result;
    for (auto const& state : states)
        if (state)
            result.push_back(*state);
    return result;
}

CoarseBranch coarse_branch(TorqueContinuation const& coarse, TorqueBranch const& branch)
{
    constexpr std::size_t most_failures = 3;  // torques without an equilibrium, after which no more are tried
    std::size_t const count = branch.states.size();
    CoarseBranch result;
    result.states.resize(count);
    std::vector<LoadedState> solved;
    std::vector<std::size_t> which;
    LoadedDrive at = coarse.start;
    for (std::size_t i = 0; i < count && i < solved.size() + most_failures; ++i) {
        try {
            at = advance(coarse, at, branch.states[i].torque);
        } catch (NumericalError const& error) {
            if (!error.is_infeasible())
                throw;
            continue;
        }
        solved.push_back(loaded_state(coarse.problem, at, coarse.middle));
        which.push_back(i);
        if (i + 1 == count)
            result.last = at;
    }
    if (solved.empty())
        return result;
    enter_stiffness(solved, free_twist(coarse, branch.states.back().torque), stiffness_at(coarse, at));
    for (std::size_t k = 0; k < which.size(); ++k)
        result.states[which[k]] = solved[k];
    return result;
}

}  // namespace hdconj::load
