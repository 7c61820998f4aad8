// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Judgement of a design: the limits, and what a scene alone says.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/note.hpp"
#include "hdconj/scene.hpp"

namespace hdconj {

/// A closed interval. A figure on one of its ends lies inside, whatever rounding made of it.
struct DesignRange
{
    double low = -std::numeric_limits<double>::infinity();  ///< smallest value inside
    double high = std::numeric_limits<double>::infinity();  ///< largest value inside
    /// Whether @p value lies inside, or outside by no more than figure_roundoff.
    [[nodiscard]] bool contains(double value) const
    {
        return value >= low - figure_roundoff * std::abs(low) && value <= high + figure_roundoff * std::abs(high);
    }
};

/// The limits of one figure.
struct DesignLimit
{
    NoteCode code;         ///< what it limits
    char const* figure;    ///< in words and symbols
    char const* unit;      ///< "1" for a pure number
    DesignRange usual;     ///< outside: information
    DesignRange accepted;  ///< outside: warning
    char const* source;    ///< of the limits
};

/// All limits, in the order of NoteCode.
[[nodiscard]] std::span<DesignLimit const> design_limits();

/// The same for @p scene: wall_stress is limited by flexspline.cup.fatigue_strength where that differs from the usual
/// steel's.
[[nodiscard]] std::vector<DesignLimit> design_limits(Scene const& scene);

/// The notes that follow from @p scene without solving it. Solution::judgement holds these and those of the solved
/// pair.
/// @param scene  that check_scene() finds no fault in
[[nodiscard]] Notes judge(Scene const& scene);

}  // namespace hdconj
