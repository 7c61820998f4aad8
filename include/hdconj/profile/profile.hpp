// SPDX-License-Identifier: GPL-3.0-or-later
// A flexspline tooth profile: ordered pieces, grouped into named segments.
#pragma once

#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/profile/pieces.hpp"

namespace hdconj::profile {

using PieceShape = std::variant<LinePiece, ArcPiece, CurvePiece>;

/// One piece and its place in its segment.
struct ProfilePiece
{
    PieceShape shape;
    int segment = 0;     ///< index into Profile::segment_names; for a corner the segment before it
    double t_begin = 0;  ///< segment parameter at the piece's start, 0 ... 1
    double t_end = 1;
    bool corner = false;
};

/// One tooth in its own frame (origin on the neutral curve, y outward) from left root to right root. Convex corners
/// are pieces of radius 0; joints with a common tangent have none.
struct Profile
{
    std::vector<ProfilePiece> pieces;
    std::vector<std::string> segment_names;
    bool mirror_symmetric = false;  ///< about the y axis
    double pitch_line = 0;          ///< y of the pitch line
    double addendum = 0;            ///< height of the tip above the pitch line
    double dedendum = 0;            ///< depth of the root below it
    double root_half_width = 0;     ///< largest |x|
};

/// Whether any piece is a curve, whose contacts and distances are roots of polynomials. A point of it takes some thirty
/// times as long as one of a line or an arc.
[[nodiscard]] inline bool has_curves(Profile const& profile)
{
    return std::any_of(profile.pieces.begin(), profile.pieces.end(),
                       [](ProfilePiece const& piece) { return std::holds_alternative<CurvePiece>(piece.shape); });
}

/// First and last point and outward normal of a piece.
struct PieceEnd
{
    Vec2 point;
    Vec2 normal;
};
[[nodiscard]] PieceEnd start_of(PieceShape const& shape);
[[nodiscard]] PieceEnd end_of(PieceShape const& shape);

/// Point of a piece at local parameter @p t in 0 ... 1 (proportional to arc length on lines and arcs).
[[nodiscard]] Vec2 point_at(PieceShape const& shape, double t);

/// Equal steps of the local parameter that keep the chord error of a piece within @p chord [mm].
[[nodiscard]] int steps_of(PieceShape const& shape, double chord);

/// A piece, or a whole tooth, raised along y by @p rise [mm].
[[nodiscard]] PieceShape moved_up(PieceShape shape, double rise);
[[nodiscard]] Profile moved_up(Profile profile, double rise);

/// Polygon of the whole tooth, chord error <= @p chord [mm], in the tooth frame.
[[nodiscard]] std::vector<Vec2> polygon_of(Profile const& profile, double chord);

/// Whether a piece of the profile is its tip: the flat land there or a corner at its height.
[[nodiscard]] inline bool is_tip(Profile const& profile, int piece)
{
    PieceShape const& shape = profile.pieces[static_cast<std::size_t>(piece)].shape;
    double const top = profile.pitch_line + profile.addendum;
    double const near = 1024 * unit_roundoff * std::abs(top);
    bool const corner = profile.pieces[static_cast<std::size_t>(piece)].corner;
    bool const flat = std::holds_alternative<LinePiece>(shape);
    return (corner || flat) && std::abs(start_of(shape).point.y() - top) <= near &&
           std::abs(end_of(shape).point.y() - top) <= near;
}

}  // namespace hdconj::profile
