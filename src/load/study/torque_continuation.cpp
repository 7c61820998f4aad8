// SPDX-License-Identifier: GPL-3.0-or-later
#include "torque_continuation.hpp"

#include "loaded_equilibrium.hpp"

namespace hdconj::load {

TorqueContinuation torque_continuation(LoadProblem const& problem, LoadedDrive const& unloaded, Play const& play)
{
    TorqueContinuation path{problem, play, unloaded, middle_of(play), width_of(play) < 0};
    if (path.pressed) {
        path.start.state.turn = path.middle;
        path.start = converged_at(problem, 0, path.start);
        path.middle = path.start.state.turn;
    }
    return path;
}

LoadedDrive advance(TorqueContinuation const& path, LoadedDrive const& from, double torque)
{
    if (path.pressed || from.torque * torque > 0)
        return converged_at(path.problem, torque, from);
    LoadedDrive drive = path.start;
    drive.state.turn = torque == 0 ? path.middle : torque > 0 ? path.play.right : -path.play.left;
    return torque == 0 ? drive : converged_at(path.problem, torque, drive);
}

}  // namespace hdconj::load
