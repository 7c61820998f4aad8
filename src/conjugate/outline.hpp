// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The circular spline's toothed boundary over one pitch, as points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hdconj/profile/profile.hpp"

namespace hdconj::conjugate {

/// What a stretch of outline is.
enum class OutlineKind
{
    land,       ///< on the tip circle
    flank,      ///< traced by a flank of the tooth
    corner,     ///< traced by a corner of the tooth
    bottom,     ///< traced by the tip land of the tooth
    root_wall,  ///< straight, made by root clearance
    root        ///< bottom moved outward by root clearance
};

/// A stretch of outline with its source.
struct OutlineStretch
{
    OutlineKind kind = OutlineKind::land;
    int segment = -1;       ///< profile segment; -1: land, root wall
    std::size_t first = 0;  ///< index of its first point
    std::size_t last = 0;   ///< index of its last point, shared with the next stretch
};

/// One pitch of outline, left mid-land to right mid-land.
struct Outline
{
    std::vector<Vec2> points;
    std::vector<OutlineStretch> stretches;
    double chord = 0;  ///< largest chord error, estimated [mm]
    double error = 0;  ///< largest rounding error of a point, estimated [mm]
    std::size_t evaluations = 0;
};

/// Chords that a land takes. @param from, to  [rad]
[[nodiscard]] inline std::size_t land_chords(double radius, double from, double to, double chord)
{
    double const step = 2 * std::acos(1 - std::min(0.5, chord / radius));
    return static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(to - from) / step)));
}

inline void append_land(Outline& outline, double radius, double from, double to, double chord)
{
    std::size_t const count = land_chords(radius, from, to, chord);
    std::size_t const first = outline.points.empty() ? 0 : outline.points.size() - 1;
    for (std::size_t k = outline.points.empty() ? 0 : 1; k <= count; ++k) {
        double const angle = k == count ? to : from + (to - from) * static_cast<double>(k) / static_cast<double>(count);
        outline.points.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
    }
    double const half = 0.5 * std::abs(to - from) / static_cast<double>(count);
    outline.chord = std::max(outline.chord, radius * (1 - std::cos(half)));
    outline.stretches.push_back({OutlineKind::land, -1, first, outline.points.size() - 1});
}

}  // namespace hdconj::conjugate
