// SPDX-License-Identifier: GPL-3.0-or-later
#include "search_reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::load {

SearchReach whole_reach(LoadProblem const& problem)
{
    double const limit = search_limit(problem);
    return {.limit = limit, .solved_limit = limit};
}

double largest_fall(LoadProblem const& problem, LoadedShape const& from, double turn_from, LoadedShape const& to,
                    double turn_to)
{
    if (problem.deviation)
        return std::numeric_limits<double>::infinity();
    profile::Profile const& tooth = problem.context.tooth;
    double const height = std::max(tooth.pitch_line + tooth.addendum, tooth.dedendum - tooth.pitch_line),
                 extent = std::hypot(tooth.root_half_width, height);
    double moved = 0;
    for (std::size_t i = 0; i < from.places.pose.size(); ++i) {
        Pose const &a = from.places.pose[i], &b = to.places.pose[i];
        auto const apart = [&](Vec2 const& at_a, Vec2 const& at_b) {
            return (turned_clockwise(at_b, turn_to) - turned_clockwise(at_a, turn_from)).norm();
        };
        moved = std::max(moved, apart(a.origin, b.origin) + extent * apart(a.rotate({1, 0}), b.rotate({1, 0})));
    }
    return moved;
}

void follow_step(LoadProblem const& problem, LoadedShape before, double turn, LoadedDrive const& drive,
                 SearchReach& reach)
{
    constexpr double least = 16;  // times the tolerance of gaps
    double const fall = largest_fall(problem, before, turn, drive.shape, drive.state.turn);
    reach.known.lower(fall);
    reach.shape = std::move(before);
    reach.turn = turn;
    reach.solved_limit = reach.limit;
    reach.limit = std::min(std::max(fall, least * gap_tolerance(problem)), search_limit(problem));
}

void widen(LoadProblem const& problem, FlankSearch const& search, SearchReach& reach, LoadedDrive& drive)
{
    reach.known.lower(largest_fall(problem, drive.shape, drive.state.turn, reach.shape, reach.turn));
    reach.limit = search_limit(problem);
    if (!(reach.solved_limit < search.limit))
        return;
    contact::GapField const field = gap_field(problem, reach.shape, problem.edges);
    std::vector<FlankContact> contacts = std::move(drive.contacts);
    std::vector<double> force = std::move(drive.state.flank);
    for (FlankContact const& c : flank_contacts(field, search, problem.context.threads, &reach.known))
        if (c.gap > reach.solved_limit) {
            contacts.push_back(c);
            force.push_back(0);
        }
    std::vector<std::size_t> order(contacts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        FlankContact const& c = contacts[i];
        return std::tuple(c.space, c.flank, c.slice, c.arc_length);
    });
    drive.contacts.clear();
    drive.state.flank.clear();
    for (std::size_t const i : order) {
        drive.contacts.push_back(contacts[i]);
        drive.state.flank.push_back(force[i]);
    }
    reach.solved_limit = search.limit;
}

}  // namespace hdconj::load
