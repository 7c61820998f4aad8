// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/profile/profile.hpp"

#include <cmath>
#include <utility>

namespace hdconj::profile {
namespace {

/// @p steps rounded up to a whole number from 1 to @p most; any number may come, infinity too.
int whole_steps(double steps, int most)
{
    return steps < most ? std::max(1, static_cast<int>(std::ceil(steps))) : most;
}

/// Steps that keep the chord error of an arc, 2 r sin^2(step/4), within @p chord.
int arc_steps(ArcPiece const& arc, double chord)
{
    constexpr int most = 1 << 22;
    double const r = std::abs(arc.radius);
    if (r <= chord)
        return 1;
    // not from 1 - chord/r, which is 1 on a nearly straight arc
    double const step = 4 * std::asin(std::sqrt(chord / (2 * r)));
    return whole_steps(std::abs(arc.to - arc.from) / step, most);
}

/// Steps for a curve, from the bound (1/8) max |x''| h^2 on its chord error.
int curve_steps(CurvePiece const& curve, double chord)
{
    double bend = 0;
    constexpr int probes = 16;
    for (int i = 0; i <= probes; ++i)
        bend = std::max(bend, curve.second(static_cast<double>(i) / probes).norm());
    constexpr int most = 1 << 16;
    return whole_steps(std::sqrt(bend / (8 * chord)), most);
}

/// The end of a piece at its local parameter @p t, 0 or 1.
PieceEnd end_at(PieceShape const& shape, int t)
{
    if (auto const* line = std::get_if<LinePiece>(&shape))
        return {t == 0 ? line->a : line->b, line->normal()};
    if (auto const* arc = std::get_if<ArcPiece>(&shape)) {
        Vec2 const normal = direction(t == 0 ? arc->from : arc->to);
        return {arc->centre + arc->radius * normal, normal};
    }
    auto const& curve = std::get<CurvePiece>(shape);
    return {curve.point(t), left_of(curve.first(t)).normalized()};
}

}  // namespace

PieceEnd start_of(PieceShape const& shape)
{
    return end_at(shape, 0);
}

PieceEnd end_of(PieceShape const& shape)
{
    return end_at(shape, 1);
}

Vec2 point_at(PieceShape const& shape, double t)
{
    if (auto const* line = std::get_if<LinePiece>(&shape))
        return line->a + t * (line->b - line->a);
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
        return arc->centre + arc->radius * direction(arc->from + t * (arc->to - arc->from));
    return std::get<CurvePiece>(shape).point(t);
}

int steps_of(PieceShape const& shape, double chord)
{
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
        return arc_steps(*arc, chord);
    if (auto const* curve = std::get_if<CurvePiece>(&shape))
        return curve_steps(*curve, chord);
    return 1;
}

PieceShape moved_up(PieceShape shape, double rise)
{
    Vec2 const shift{0, rise};
    if (auto* line = std::get_if<LinePiece>(&shape)) {
        line->a += shift;
        line->b += shift;
    } else if (auto* arc = std::get_if<ArcPiece>(&shape)) {
        arc->centre += shift;
    } else {
        auto const& curve = std::get<CurvePiece>(shape);
        std::vector<double> y = curve.y();
        for (double& value : y)
            value += rise;
        shape = CurvePiece(curve.x(), std::move(y));
    }
    return shape;
}

Profile moved_up(Profile profile, double rise)
{
    for (ProfilePiece& piece : profile.pieces)
        piece.shape = moved_up(std::move(piece.shape), rise);
    profile.pitch_line += rise;
    return profile;
}

std::vector<Vec2> polygon_of(Profile const& profile, double chord)
{
    std::size_t count = 1;
    for (ProfilePiece const& piece : profile.pieces)
        count += piece.corner ? 0 : static_cast<std::size_t>(steps_of(piece.shape, chord));
    std::vector<Vec2> points;
    points.reserve(count);
    points.push_back(start_of(profile.pieces.front().shape).point);
    for (ProfilePiece const& piece : profile.pieces) {
        if (piece.corner)
            continue;
        int const steps = steps_of(piece.shape, chord);
        for (int i = 1; i <= steps; ++i)
            points.push_back(point_at(piece.shape, static_cast<double>(i) / steps));
    }
    return points;
}

}  // namespace hdconj::profile
