// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The finished pair over a full turn: every outline point against every position of the other member's teeth.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "conjugate/outline.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/distance/full_turn.hpp"
#include "hdconj/motion/any_motion.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// Outline points for the check from index @p first on: all of them; of a very fine outline every k-th beside the ends
/// of its stretches, since what the check looks for (a branch that was taken for the outer one) is a stretch, not a
/// point.
[[nodiscard]] inline std::vector<std::size_t> points_to_check(conjugate::Outline const& outline, std::size_t first)
{
    constexpr std::size_t enough = 4096;
    std::size_t const count = outline.points.size() - first;
    std::size_t const stride = (count + enough - 1) / enough;
    std::vector<std::size_t> chosen;
    for (conjugate::OutlineStretch const& stretch : outline.stretches) {
        for (std::size_t i = std::max(first, stretch.first); i < stretch.last; i += stride)
            chosen.push_back(i);
    }
    chosen.push_back(outline.points.size() - 1);
    return chosen;
}

/// Smallest clearance of the points @p chosen by the law @p clearance (FullTurnClearance or its reverse).
template <class Clearance>
[[nodiscard]] PairCheck check_turn(Clearance const& clearance, motion::AnyMotion const& motion,
                                   std::vector<Vec2> const& points, std::vector<std::size_t> const& chosen, int threads)
{
    std::vector<distance::TurnMinimum> minima(chosen.size());
    // blocks of fixed size, whatever the number of threads: inside one, each point starts from its neighbour's result
    constexpr std::size_t most = 64;
    std::size_t const block = std::min(most, clearance.block());
    std::size_t const blocks_worth_a_thread = block < most ? 3 : motion::cosine_form(motion) ? 4 : 2;
    parallel_for((chosen.size() + block - 1) / block, threads, blocks_worth_a_thread, [&](std::size_t b) {
        std::size_t const first = b * block;
        std::size_t const count = std::min(block, chosen.size() - first);
        std::array<Vec2, most> at;
        for (std::size_t i = 0; i < count; ++i)
            at[i] = points[chosen[first + i]];
        clearance(std::span(at).first(count), nullptr, std::span(minima).subspan(first, count));
    });
    PairCheck result;
    auto const worst = std::min_element(
        minima.begin(), minima.end(),
        [](distance::TurnMinimum const& a, distance::TurnMinimum const& b) { return a.distance < b.distance; });
    result.smallest_clearance = worst->distance;
    result.where = points[chosen[static_cast<std::size_t>(worst - minima.begin())]];
    result.at_phi = motion.angles(worst->u).phi;
    result.points = minima.size();
    result.positions = clearance.positions();
    return result;
}

}  // namespace hdconj::conjugate
