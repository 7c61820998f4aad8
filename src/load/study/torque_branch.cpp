// SPDX-License-Identifier: GPL-3.0-or-later
#include "torque_branch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing_map.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"

namespace hdconj::load {
namespace {

/// Solves the torques of a branch one after the other.
class BranchSolver
{
  public:
    BranchSolver(TorqueContinuation const& path, BranchTorques const& torques,
                 std::function<void(double)> const& on_state)
        : path_(path), torques_(torques), largest_(torques.given.back()), on_state_(on_state)
    {
    }

    /// The drive at @p torque; nothing where it has no equilibrium, which is noted.
    std::optional<LoadedDrive> solved(LoadedDrive const& from, double torque)
    {
        std::optional<LoadedDrive> drive;
        try {
            if (torques_.is_stopped())
                throw NumericalError(ErrorCode::stopped, "load", "torques", "the run was stopped before");
            drive = advance(path_, from, torque);
        } catch (NumericalError const& error) {
            if (!error.is_infeasible() && error.code() != ErrorCode::stopped)
                throw;
            std::string const remedy = error.remedy().empty() ? "" : "; " + error.remedy();
            branch_.unsettled.push_back({torque, error.cause() + remedy});
            if (!first_)
                first_.emplace(error);
        }
        if (on_state_)
            on_state_(largest_ != 0 ? from.torque / largest_ : 1);
        return drive;
    }

    void add(LoadedDrive const& drive)
    {
        branch_.states.push_back(loaded_state(path_.problem, drive, path_.middle));
        branch_.bearing.push_back(bearing_map(path_.problem.drive, drive.state));
    }

    /// Adds what lies between two drives, where the curve is not straight.
    void refine(LoadedDrive const& a, LoadedDrive const& b)
    {
        constexpr double straight = 0.1;        // difference of the two halves, relative
        constexpr double widest = 1.0 / 8;      // of the branch: wider intervals may hide a bend
        constexpr double narrowest = 1.0 / 64;  // of the branch
        double const width = (b.torque - a.torque) / largest_;
        if (width < 2 * narrowest || torques_.is_stopped())
            return;
        std::optional<LoadedDrive> const middle = solved(a, 0.5 * (a.torque + b.torque));
        if (!middle)
            return;
        double const low = compliance(a, *middle), high = compliance(*middle, b);
        bool const bent = std::abs(high - low) > straight * std::min(low, high);
        if (bent || width > 2 * widest)
            refine(a, *middle);
        add(*middle);
        if (bent || width > 2 * widest)
            refine(*middle, b);
    }

    /// The finished branch. @param last  its last drive
    TorqueBranch finished(LoadedDrive last) &&
    {
        if (first_ && last.torque == 0)
            throw NumericalError(*first_);
        std::ranges::sort(branch_.unsettled, {}, [](auto const& each) { return std::abs(each.torque); });
        branch_.last = std::move(last);
        return std::move(branch_);
    }

  private:
    TorqueContinuation const& path_;
    BranchTorques const& torques_;
    double largest_;
    std::function<void(double)> const& on_state_;
    TorqueBranch branch_;
    std::optional<NumericalError> first_;

    [[nodiscard]] double twist(LoadedDrive const& drive) const
    {
        return drive.torque == 0 ? free_twist(path_, largest_) : drive.state.turn - path_.middle;
    }
    [[nodiscard]] double compliance(LoadedDrive const& a, LoadedDrive const& b) const
    {
        return (twist(b) - twist(a)) / (b.torque - a.torque);
    }
};

}  // namespace

TorqueBranch torque_branch(TorqueContinuation const& path, BranchTorques const& torques,
                           std::function<void(double)> const& on_state)
{
    BranchSolver solver(path, torques, on_state);
    LoadedDrive at = path.start;
    for (double const torque : torques.given) {
        std::optional<LoadedDrive> next = solver.solved(at, torque);
        if (!next)
            continue;
        if (torques.refined && torque != at.torque)
            solver.refine(at, *next);
        at = std::move(*next);
        solver.add(at);
    }
    return std::move(solver).finished(std::move(at));
}

double free_twist(TorqueContinuation const& path, double torque)
{
    return path.pressed ? 0 : std::copysign(0.5 * width_of(path.play), torque);
}

bool is_same_torque(double a, double b)
{
    return std::abs(a - b) <= figure_roundoff * std::abs(a);
}

LoadedState const* state_at(std::vector<LoadedState> const& branch, double torque)
{
    auto const found =
        std::ranges::find_if(branch, [torque](auto const& state) { return is_same_torque(state.torque, torque); });
    return found != branch.end() ? &*found : nullptr;
}

void enter_stiffness(std::vector<LoadedState>& branch, double free, double end)
{
    struct Interval
    {
        double torque, twist;
        [[nodiscard]] double compliance() const { return twist / torque; }
    };
    auto const between = [&](std::size_t i) {  // from the state before
        bool const first = i == 0 || branch[i - 1].torque == 0;
        return Interval{branch[i].torque - (first ? 0 : branch[i - 1].torque),
                        branch[i].twist - (first ? free : branch[i - 1].twist)};
    };
    branch.back().stiffness = end;
    for (std::size_t i = 0; i + 1 < branch.size(); ++i) {
        if (branch[i].torque == 0)
            continue;
        Interval const low = between(i), high = between(i + 1);
        double const compliance =
            (high.torque * low.compliance() + low.torque * high.compliance()) / (low.torque + high.torque);
        branch[i].stiffness = compliance > 0 ? 1 / compliance : 0;
    }
}

double stiffness_at(TorqueContinuation const& path, LoadedDrive const& drive)
{
    constexpr double smaller = 31.0 / 32;
    if (drive.torque == 0)
        return 0;
    try {
        double const torque = smaller * drive.torque;
        double const twist =
            std::copysign(1, drive.torque) * (drive.state.turn - turn_near(path.problem, torque, drive));
        if (twist * path.problem.context.geometry.r_m > gap_tolerance(path.problem))
            return std::abs(drive.torque - torque) / twist;
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
    }
    return drive.state.stiffness;
}

LoadedState mirror_image(LoadedState state, std::vector<double> const& space_angle, double period)
{
    auto const wrapped = [&](double angle) { return angle - period * std::floor(angle / period); };
    auto const off = [&](double a, double b) { return std::abs(std::remainder(a - b, period)); };
    for (double LoadedState::*const odd : {&LoadedState::torque, &LoadedState::twist,
                                           &LoadedState::wave_generator_torque, &LoadedState::lobe_force_across})
        state.*odd = -(state.*odd);
    for (double LoadedState::*const angle : {&LoadedState::ball_phi, &LoadedState::stress_phi})
        state.*angle = wrapped(-(state.*angle));
    auto const here = static_cast<std::size_t>(state.pressure_space);
    if (here < space_angle.size()) {
        auto const there =
            std::ranges::min_element(space_angle, {}, [&](double angle) { return off(angle, -space_angle[here]); });
        state.pressure_space = static_cast<int>(there - space_angle.begin());
    }
    return state;
}

}  // namespace hdconj::load
