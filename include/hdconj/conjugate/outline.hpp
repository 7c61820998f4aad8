// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points of the circular spline's toothed boundary over one pitch, from the pieces that bound its tooth space.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/smooth_ranges.hpp"

namespace hdconj {

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
    double chord = 0;              ///< largest chord error, estimated [mm]
    double error = 0;              ///< largest rounding error of a point, estimated [mm]
    std::size_t evaluations = 0;
};

namespace detail {

/// Whether a piece of the profile is its tip: the flat land there or a corner at its height.
[[nodiscard]] inline bool is_tip(Profile const& profile, int piece)
{
    PieceShape const& shape = profile.pieces[static_cast<std::size_t>(piece)].shape;
    double const top = profile.pitch_line + profile.addendum;
    double const near = 1024 * unit_roundoff * std::abs(top);
    bool const corner = profile.pieces[static_cast<std::size_t>(piece)].corner;
    bool const flat = std::holds_alternative<LinePiece>(shape);
    return (corner || flat) && std::abs(start_of(shape).point.y() - top) <= near && std::abs(end_of(shape).point.y() - top) <= near;
}

inline void append_land(Outline& outline, double radius, double from, double to, double chord)
{
    double const step = 2 * std::acos(1 - std::min(0.5, chord / radius));
    auto const count = static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(to - from) / step)));
    std::size_t const first = outline.points.empty() ? 0 : outline.points.size() - 1;
    for (std::size_t k = outline.points.empty() ? 0 : 1; k <= count; ++k)
    {
        double const angle = k == count ? to : from + (to - from) * static_cast<double>(k) / static_cast<double>(count);
        outline.points.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
    }
    double const half = 0.5 * std::abs(to - from) / static_cast<double>(count);
    outline.chord = std::max(outline.chord, radius * (1 - std::cos(half)));
    outline.stretches.push_back({OutlineKind::land, -1, first, outline.points.size() - 1});
}

}  // namespace detail

/// Samples every piece to the chord error; neighbours share their common point.
template<RelativeMotion Motion>
[[nodiscard]] Outline sample_outline(Envelope<Motion> const& envelope, std::vector<ContactArc> const& arcs, std::vector<BoundaryPiece> const& pieces,
                                     double tip_radius, double pitch, double chord, int threads)
{
    Outline outline;
    Profile const& profile = envelope.profile();
    BoundaryPiece const* before = nullptr;   // the one that ends where this one begins, unless it is land
    for (BoundaryPiece const& piece : pieces)
    {
        if (piece.arc < 0)
        {
            detail::append_land(outline, tip_radius, piece.begin, piece.end, chord);
            before = nullptr;
            continue;
        }
        ContactArc const& arc = arcs[static_cast<std::size_t>(piece.arc)];
        ProfilePiece const& made_by = profile.pieces[static_cast<std::size_t>(arc.piece)];
        SampledArc const sampled = sample_arc(envelope, arc, piece.begin, piece.end, chord, threads);
        outline.chord = std::max(outline.chord, sampled.chord);
        outline.error = std::max(outline.error, sampled.error);
        outline.evaluations += sampled.evaluations;
        std::size_t const first = outline.points.empty() ? 0 : outline.points.size() - 1;
        for (std::size_t k = outline.points.empty() ? 0 : 1; k < sampled.points.size(); ++k)
        {
            Vec2 const& p = sampled.points[k].p;
            outline.points.push_back(piece.copy == 0 ? p : turned_clockwise(p, piece.copy * pitch));
        }
        OutlineKind const kind = made_by.corner ? OutlineKind::corner
                                 : detail::is_tip(profile, arc.piece) ? OutlineKind::bottom
                                                                      : OutlineKind::flank;
        // pieces that follow each other inside a segment make one stretch, and so do both sides of a break of the motion
        int const step = before == nullptr ? 0 : std::abs(arc.piece - arcs[static_cast<std::size_t>(before->arc)].piece);
        bool const next_piece = before != nullptr && step == 1 && !made_by.corner;
        bool const across_break = before != nullptr && step == 0 && before->copy == piece.copy
                                  && same_instant(std::min(before->end, piece.begin), std::max(before->end, piece.begin));
        bool const goes_on = (next_piece || across_break) && outline.stretches.back().kind == kind
                             && outline.stretches.back().segment == made_by.segment;
        if (goes_on)
            outline.stretches.back().last = outline.points.size() - 1;
        else
            outline.stretches.push_back({kind, made_by.segment, first, outline.points.size() - 1});
        before = &piece;
    }
    return outline;
}

}  // namespace hdconj
