// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline's toothed boundary over one pitch, as points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/smooth_ranges.hpp"
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

/// Kind and segment of what @p arc of @p tooth traces.
[[nodiscard]] inline OutlineStretch made_by(profile::Profile const& tooth, envelope::ContactArc const& arc)
{
    profile::ProfilePiece const& origin = tooth.pieces[static_cast<std::size_t>(arc.piece)];
    return {origin.corner                       ? OutlineKind::corner
            : profile::is_tip(tooth, arc.piece) ? OutlineKind::bottom
                                                : OutlineKind::flank,
            origin.segment};
}

/// Whether the outline goes on over two neighbouring pieces of a boundary, @p a on the arc @p on_a: of one kind and
/// segment, through a joint inside it or a break of the motion. Where two branches cross it does not, although
/// neighbouring profile pieces may have made them.
[[nodiscard]] inline bool outline_goes_on(profile::Profile const& tooth, BoundaryPiece const& a,
                                          envelope::ContactArc const& on_a, BoundaryPiece const& b,
                                          envelope::ContactArc const& on_b)
{
    OutlineStretch const from = made_by(tooth, on_a), to = made_by(tooth, on_b);
    if (from.kind != to.kind || from.segment != to.segment || a.copy != b.copy)
        return false;
    int const step = std::abs(on_b.piece - on_a.piece);
    return (step == 0 && envelope::same_instant(a.end, b.begin)) ||
           (step == 1 && from.kind != OutlineKind::corner && envelope::same_at_joint(a.end, b.begin));
}

/// Stretches of the mirror image of an outline, whose last point has the index @p last.
[[nodiscard]] inline std::vector<OutlineStretch> mirrored(std::vector<OutlineStretch> const& stretches,
                                                          profile::Profile const& tooth, std::size_t last)
{
    std::vector<OutlineStretch> image;
    int const segments = static_cast<int>(tooth.segment_names.size());
    for (auto s = stretches.rbegin(); s != stretches.rend(); ++s) {
        // a corner carries the segment before it, whose image stands after the image of the corner
        int const segment = s->segment < 0 ? -1 : segments - 1 - s->segment - (s->kind == OutlineKind::corner ? 1 : 0);
        image.push_back({s->kind, segment, last - s->last, last - s->first});
    }
    return image;
}

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

/// @p more joined to the end of @p outline, whose last point is its first.
inline void append_outline(Outline& outline, Outline const& more)
{
    std::size_t const joint = outline.points.empty() ? 0 : outline.points.size() - 1;
    outline.points.insert(outline.points.end(), more.points.begin() + (outline.points.empty() ? 0 : 1),
                          more.points.end());
    for (OutlineStretch const& s : more.stretches)
        outline.stretches.push_back({s.kind, s.segment, s.first + joint, s.last + joint});
    outline.chord = std::max(outline.chord, more.chord);
    outline.error = std::max(outline.error, more.error);
    outline.evaluations += more.evaluations;
}

}  // namespace hdconj::conjugate
