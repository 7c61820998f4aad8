// SPDX-License-Identifier: GPL-3.0-or-later
#include "torque_continuation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "anderson_mixing.hpp"
#include "base/text.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "linearisation.hpp"
#include "load/elastic_drive.hpp"
#include "search_reach.hpp"

namespace hdconj::load {
namespace {

/// Settings of one attempt to converge.
struct Attempt
{
    ContactChoice choice;
    int first_mixing;  ///< iteration from which on forces are mixed: by then the contacts have been found
    int most_iterations;
};

/// Where two strips of a flank are about to merge, or one of two minima to vanish, the iteration alternates between one
/// contact and two; it does not where contacts are held, or with another depth. Mixing leads back to an unstable
/// equilibrium for ever; without it the next stable one is reached. Where two places of one strip have nearly the same
/// gap, as an edge and the flank beside it, the least gap jumps from one to the other; the middle of the strip does
/// not. Where a flank fits over a long stretch with two minima, strips that are narrow enough make two contacts of
/// them. From an equilibrium that has only just become unstable the iteration moves away in small steps: the last
/// attempt but one has many. Flanks that fit each other over a long stretch may touch in a dip of nanometres that the
/// tangents of parabolas make where a rounded edge ends.
constexpr Attempt attempts[] = {{{1}, 3, 25},
                                {{0.5}, 3, 25},
                                {{1, true}, 3, 40},
                                {{1}, 40, 60},
                                {{2}, 3, 25},
                                {{0.25}, 3, 25},
                                {{0.5, true}, 3, 40},
                                {{1, false, true}, 3, 40},
                                {{0.5, true, true}, 3, 40},
                                {{0x1p-4}, 3, 40},
                                {{0x1p-6}, 3, 40},
                                {{0x1p-10}, 3, 40},
                                {{1}, 160, 160},
                                {{1, false, false, FlankTangents::straighter}, 3, 40}};

constexpr char const* smaller_torque = "write a smaller torque";

std::string place_of(double torque)
{
    return "torque of " + short_number(torque / newton_metre) + " N m";
}

/// Runs @p body. A NumericalError from another stage is thrown again with the torque as its place; the motion of a
/// loaded shape fails because of its torque.
template <class Body>
void at_torque(double torque, Body const& body)
{
    try {
        body();
    } catch (NumericalError const& error) {
        if (error.stage() == "load")
            throw;
        NumericalError const here = error.inside("load", place_of(torque));
        bool const by_torque = torque != 0 && error.stage() == "motion";
        throw by_torque ? NumericalError(here.code(), here.stage(), here.place(), here.cause(), smaller_torque) : here;
    }
}

void require_within_pitch(LoadProblem const& problem, double torque, double turn)
{
    if (std::abs(turn) > 2 * std::numbers::pi / problem.context.scene.drive.circular_spline_teeth)
        throw NumericalError(ErrorCode::overload, "load", place_of(torque),
                             "the teeth turn by more than a pitch against each other, " + short_number(to_deg(turn)) +
                                 " deg: they slip over each other",
                             smaller_torque);
}

/// What an attempt came to.
struct AttemptResult
{
    bool converged;
    double mismatch;  ///< of the gaps [mm]
};

/// Gives @p now the shape of its forces. @param turn  of the shape before
void reshape(LoadProblem const& problem, double turn, LoadedDrive& now, SearchReach& reach)
{
    LoadedShape before = std::exchange(now.shape, loaded_shape(problem.context, problem.drive, now.forces));
    follow_step(problem, std::move(before), turn, now, reach);
}

/// Forces on the contacts of @p at under @p torque; the shape of @p now stays. Where they cannot be solved for, all of
/// @p now stays.
void solve_forces(LoadProblem const& problem, double torque, Linearisation& at, LoadedDrive& now)
{
    now.state = solved_linear(problem, now, torque, at);
    ++now.iterations;
    now.steps += now.state.steps;
    now.contacts = std::move(at.gaps.contacts);
    now.forces = forces_on_cup(problem.drive, now.contacts, now.state);
}

/// As solve_forces(). @returns false where no solution was found: other contacts may have one
bool forces_found(LoadProblem const& problem, double torque, Linearisation& at, LoadedDrive& now)
{
    try {
        solve_forces(problem, torque, at, now);
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::not_converged)
            throw;
        return false;
    }
    return true;
}

/// Goes on from @p now, which is the last state that was found.
AttemptResult attempted(LoadProblem const& problem, double torque, Attempt const& attempt, LoadedDrive& now)
{
    constexpr std::size_t depth = 5;        // of the history
    constexpr double near_tolerance = 3;    // multiple of the tolerance
    constexpr double growth = 3;            // of the mismatch: contacts have changed, and the history misleads
    constexpr int first_check_of_turn = 6;  // iteration; earlier ones may overshoot, with few contacts
    constexpr double progress = 0.7;        // of the least mismatch, within
    constexpr int patience = 6;             // iterations
    double last = std::numeric_limits<double>::infinity(), least = last;
    int at_least = 0;  // iteration of the least mismatch
    bool mixed = false;
    std::vector<MixingStep> history;
    SearchReach reach = whole_reach(problem);
    for (int iteration = 0; iteration <= attempt.most_iterations; ++iteration) {
        Linearisation at = iteration == 0 ? first_linearised(problem, now, attempt.choice, reach)
                                          : linearised(problem, now, attempt.choice, reach);
        if (iteration > 0) {
            double const mismatch = mismatch_of(at);
            if (!mixed && mismatch <= gap_tolerance(problem)) {
                now.gap_mismatch = mismatch;
                widen(problem, search_of(problem, attempt.choice, reach.turn, search_limit(problem)), reach, now);
                if (attempt.choice == ContactChoice{})
                    now.found = std::move(reach);
                return {true, mismatch};
            }
            // Only forces that were not mixed are a result: near the end every other iteration does not mix.
            mixed =
                iteration >= attempt.first_mixing && !(mixed && mismatch <= near_tolerance * gap_tolerance(problem));
            if (mismatch > last * growth)
                history.clear();
            last = mismatch;
            if (mismatch < progress * least) {
                least = mismatch;
                at_least = iteration;
            } else if (iteration >= attempt.first_mixing + patience && iteration - at_least > patience)
                break;
        }
        if (!forces_found(problem, torque, at, now))
            break;
        if (iteration >= first_check_of_turn)
            require_within_pitch(problem, torque, now.state.turn);
        if (iteration >= attempt.first_mixing - 1)
            history.push_back({now.forces, now.state.turn,
                               displacement_change(problem, now.shape, at.gaps.turn, now.forces, now.state.turn)});
        if (history.size() > depth)
            history.erase(history.begin());
        if (mixed)
            anderson_mix(history, now);
        reshape(problem, at.gaps.turn, now, reach);
    }
    return {false, last};
}

}  // namespace

LoadedDrive converged_at(LoadProblem const& problem, double torque, LoadedDrive const& start)
{
    LoadedDrive drive = start;
    drive.torque = torque;
    drive.iterations = drive.steps = 0;
    double mismatch = std::numeric_limits<double>::infinity();
    for (Attempt const& attempt : attempts) {
        AttemptResult result{};
        at_torque(torque, [&] { result = attempted(problem, torque, attempt, drive); });
        if (result.converged)
            return drive;
        if (std::isfinite(result.mismatch))
            mismatch = result.mismatch;
    }
    std::string const how_far = std::isfinite(mismatch)
                                    ? "gaps still differ by " + short_number(mismatch * per_um) + " um"
                                    : "no forces are in balance";
    throw NumericalError(
        ErrorCode::not_converged, "load", place_of(torque),
        "forces and loaded shape do not converge: after " + std::to_string(drive.iterations) + " iterations " + how_far,
        problem.drive.flow_pressure < std::numeric_limits<double>::infinity()
            ? "remove [flow], or write a much larger flow.pressure"
            : "write a larger load.edge_radius, or another circular_spline.backlash_offset");
}

double turn_near(LoadProblem const& problem, double torque, LoadedDrive const& start)
{
    constexpr double enough = 0x1p-10;  // of the turn from the start on
    constexpr int budget = 8;
    LoadedDrive now = start;
    SearchReach reach = whole_reach(problem);
    for (int i = 0; i < budget; ++i) {
        double const before = now.state.turn;
        double at_turn = 0;
        at_torque(torque, [&] {
            Linearisation at = i == 0 ? first_linearised(problem, now, {}, reach) : linearised(problem, now, {}, reach);
            at_turn = at.gaps.turn;
            solve_forces(problem, torque, at, now);
        });
        if (i > 0 && std::abs(now.state.turn - before) <= enough * std::abs(now.state.turn - start.state.turn))
            return now.state.turn;
        reshape(problem, at_turn, now, reach);
    }
    return converged_at(problem, torque, start).state.turn;
}

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
