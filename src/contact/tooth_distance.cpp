// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact/tooth_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hdconj {

namespace {

/// Keeps the foot with the smallest distance; the side of the profile gives the sign.
struct Nearest
{
    double squared = std::numeric_limits<double>::infinity();
    Vec2 point = Vec2::Zero();
    Vec2 normal = Vec2::Zero();

    void offer(Vec2 const& p, Vec2 const& foot, Vec2 const& n)
    {
        double const d = (p - foot).squaredNorm();
        if (d < squared)
        {
            squared = d;
            point = foot;
            normal = n;
        }
    }
};

void foot_on(LinePiece const& line, Vec2 const& p, Nearest& nearest)
{
    Vec2 const d = line.b - line.a;
    double const t = (p - line.a).dot(d) / d.squaredNorm();
    if (t > 0 && t < 1)
        nearest.offer(p, line.a + t * d, left_of(d).normalized());
}

void foot_on(ArcPiece const& arc, Vec2 const& p, Nearest& nearest)
{
    Vec2 const from_centre = p - arc.centre;
    double const length = from_centre.norm();
    if (length == 0)
        return;
    Vec2 const n = (arc.radius > 0 ? 1.0 : -1.0) / length * from_centre;
    Vec2 const first = direction(arc.from);
    double const t = std::atan2(cross(first, n), first.dot(n)) / (arc.to - arc.from);
    if (t > 0 && t < 1)
        nearest.offer(p, arc.centre + arc.radius * n, n);
}

void foot_on(CurvePiece const& curve, Vec2 const& p, Nearest& nearest)
{
    // (p - x).x' in Bernstein form: A - p_y B + p_x C with the three functions of the meshing condition
    BernsteinWork work{};
    double size = 0;
    std::size_t const n = curve.a().size();
    for (std::size_t i = 0; i < n; ++i)
    {
        work[i] = curve.a()[i] - p.y() * curve.b()[i] + p.x() * curve.c()[i];
        size = std::max(size, std::abs(curve.a()[i]) + std::abs(p.y() * curve.b()[i]) + std::abs(p.x() * curve.c()[i]));
    }
    BernsteinRoots const feet = bernstein_roots({work.data(), n}, 8 * unit_roundoff * size);
    for (int k = 0; k < feet.count; ++k)
    {
        double const t = feet.t[static_cast<std::size_t>(k)];
        nearest.offer(p, curve.point(t), left_of(curve.first(t)).normalized());
    }
}

}  // namespace

ToothDistance::ToothDistance(Profile const& profile)
{
    top_ = -std::numeric_limits<double>::infinity();
    PieceShape const* before = nullptr;
    for (ProfilePiece const& piece : profile.pieces)
    {
        if (piece.corner)
            continue;
        PieceEnd const start = start_of(piece.shape);
        Vec2 const normal = before != nullptr ? Vec2(start.normal + end_of(*before).normal) : start.normal;
        vertices_.push_back({start.point, normal.normalized(), before == nullptr});
        before = &piece.shape;
        Vec2 low = start.point;
        Vec2 high = start.point;
        auto const include = [&](Vec2 const& p) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        };
        include(end_of(piece.shape).point);
        if (auto const* arc = std::get_if<ArcPiece>(&piece.shape))
        {
            include(arc->centre.array() - std::abs(arc->radius));
            include(arc->centre.array() + std::abs(arc->radius));
        }
        if (auto const* curve = std::get_if<CurvePiece>(&piece.shape))
            for (std::size_t i = 0; i < curve->x().size(); ++i)
                include({curve->x()[i], curve->y()[i]});
        patches_.push_back({&piece.shape, low, high});
    }
    PieceEnd const last = end_of(*before);
    vertices_.push_back({last.point, last.normal, true});
    // the box of an arc's whole circle would be far too wide for the quick bound; a polygon and its chord error are not
    double const chord = (profile.addendum + profile.dedendum) * 0x1p-12;
    for (Vec2 const& p : polygon_of(profile, chord))
    {
        top_ = std::max(top_, p.y() + chord);
        half_width_ = std::max(half_width_, std::abs(p.x()) + chord);
    }
}

NearestPoint ToothDistance::operator()(Vec2 const& p) const
{
    Nearest nearest;
    bool at_open_end = false;
    for (Vertex const& vertex : vertices_)
    {
        double const before = nearest.squared;
        nearest.offer(p, vertex.point, vertex.normal);
        if (nearest.squared < before)
            at_open_end = vertex.open_end;
    }
    for (Patch const& patch : patches_)
    {
        Vec2 const outside = (patch.low - p).cwiseMax(p - patch.high).cwiseMax(0.0);
        if (outside.squaredNorm() > nearest.squared)
            continue;
        double const before = nearest.squared;
        std::visit([&](auto const& shape) { foot_on(shape, p, nearest); }, *patch.shape);
        if (nearest.squared < before)
            at_open_end = false;
    }
    Vec2 const away = p - nearest.point;
    double const distance = std::sqrt(nearest.squared);
    bool const outside = at_open_end || away.dot(nearest.normal) >= 0;
    NearestPoint result{outside ? distance : -distance, nearest.point, nearest.normal};
    // at a corner the gradient points from the corner to p; on a smooth foot this is the normal itself, but the
    // difference of two close points loses digits, so the exact normal is kept there
    constexpr double aligned = 1 - 0x1p-20;
    if (distance > 0 && std::abs(away.dot(nearest.normal)) < aligned * distance)
        result.normal = (outside ? 1.0 : -1.0) / distance * away;
    return result;
}

}  // namespace hdconj
