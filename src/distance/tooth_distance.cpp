// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/distance/tooth_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/numeric/bernstein_roots.hpp"

namespace hdconj::distance {

/// Keeps the foot with the smallest distance; the side of the profile gives the sign.
struct ToothDistance::Nearest
{
    double squared = std::numeric_limits<double>::infinity();
    Vec2 point = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
    bool open_end = false;
    bool vertex = false;                          ///< the foot is one
    profile::CurvePiece const* all_of = nullptr;  ///< of which all feet were looked at last

    void offer(Vec2 const& p, Vec2 const& foot, Vec2 const& n, bool at_vertex = false, bool at_open_end = false)
    {
        double const d = (p - foot).squaredNorm();
        if (d < squared) {
            squared = d;
            point = foot;
            normal = n;
            open_end = at_open_end;
            vertex = at_vertex;
        }
    }
};

namespace {

/// Of a point from a box; 0 inside.
double squared_distance(Vec2 const& low, Vec2 const& high, Vec2 const& p)
{
    return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

}  // namespace

void ToothDistance::foot_on(Line const& line, Vec2 const& p, Nearest& nearest)
{
    double const along = (p - line.a).dot(line.along);
    if (along > 0 && along < line.length)
        nearest.offer(p, line.a + along * line.along, line.normal);
}

void ToothDistance::foot_on(Arc const& arc, Vec2 const& p, Nearest& nearest)
{
    Vec2 const from_centre = p - arc.centre;
    double const length = from_centre.norm();
    if (length == 0)
        return;
    Vec2 const n = (arc.radius > 0 ? 1.0 : -1.0) / length * from_centre;
    // inside the cone of normals about its middle; any span below a full turn
    if (n.dot(arc.middle) > arc.cos_half_span)
        nearest.offer(p, arc.centre + arc.radius * n, n);
}

void ToothDistance::foot_on(CurveStretch const& stretch, Vec2 const& p, Nearest& nearest)
{
    StretchFoot const foot = distance::foot_on(stretch, p);
    if (foot.found)
        nearest.offer(p, foot.point, foot.normal);
    if (!foot.certain && nearest.all_of != stretch.curve)
        all_feet_on(*stretch.curve, p, nearest);
}

void ToothDistance::all_feet_on(profile::CurvePiece const& curve, Vec2 const& p, Nearest& nearest)
{
    nearest.all_of = &curve;
    // (p - x).x' in Bernstein form: A - p_y B + p_x C with the three functions of the meshing condition
    numeric::BernsteinWork work{};
    double size = 0;
    std::size_t const n = curve.a().size();
    for (std::size_t i = 0; i < n; ++i) {
        double const b = p.y() * curve.b()[i];
        double const c = p.x() * curve.c()[i];
        work[i] = curve.a()[i] - b + c;
        size = std::max(size, std::abs(curve.a()[i]) + std::abs(b) + std::abs(c));
    }
    numeric::BernsteinRoots const feet = numeric::bernstein_roots({work.data(), n}, 8 * unit_roundoff * size);
    for (int k = 0; k < feet.count; ++k) {
        double const t = feet.t[static_cast<std::size_t>(k)];
        nearest.offer(p, curve.point(t), left_of(curve.first(t)).normalized());
    }
}

ToothDistance::ToothDistance(profile::Profile const& profile)
{
    top_ = -std::numeric_limits<double>::infinity();
    profile::PieceShape const* before = nullptr;
    for (profile::ProfilePiece const& piece : profile.pieces) {
        if (piece.corner)
            continue;
        profile::PieceEnd const start = profile::start_of(piece.shape);
        Vec2 const normal = before != nullptr ? Vec2(start.normal + profile::end_of(*before).normal) : start.normal;
        vertices_.push_back({start.point, normal.normalized(), before == nullptr});
        before = &piece.shape;
        add_patches(piece.shape);
    }
    profile::PieceEnd const last = profile::end_of(*before);
    vertices_.push_back({last.point, last.normal, true});
    gather_runs();
    gather_lanes();
    double const chord = (profile.addendum + profile.dedendum) * 0x1p-12;
    for (Vec2 const& p : profile::polygon_of(profile, chord)) {
        top_ = std::max(top_, p.y() + chord);
        half_width_ = std::max(half_width_, std::abs(p.x()) + chord);
    }
}

/// One patch; of a curve one for each of its stretches, with a vertex between two of them.
void ToothDistance::add_patches(profile::PieceShape const& shape)
{
    Vec2 low = profile::start_of(shape).point;
    Vec2 high = low;
    auto const include = [&](Vec2 const& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    };
    include(profile::end_of(shape).point);
    if (auto const* line = std::get_if<profile::LinePiece>(&shape)) {
        patches_.push_back({Line{line->a, line->tangent(), line->normal(), line->length()}, low, high});
    } else if (auto const* arc = std::get_if<profile::ArcPiece>(&shape)) {
        constexpr int probes = 8;
        for (int i = 1; i < probes; ++i)
            include(profile::point_at(shape, static_cast<double>(i) / probes));
        double const half = 0.5 * std::abs(arc->to - arc->from);
        // between probes the arc bulges out of their box by no more than the chord's height
        double const bulge = std::abs(arc->radius) * (1 - std::cos(half / probes));
        low.array() -= bulge;
        high.array() += bulge;
        patches_.push_back(
            {Arc{arc->centre, arc->radius, direction(0.5 * (arc->from + arc->to)), std::cos(half)}, low, high});
    } else {
        std::vector<CurveStretch> const stretches = stretches_of(std::get<profile::CurvePiece>(shape));
        for (CurveStretch const& stretch : stretches) {
            if (stretch.from > 0)
                vertices_.push_back({stretch.first, left_of(stretch.slope_first).normalized(), false});
            patches_.push_back({stretch, stretch.low, stretch.high});
        }
    }
}

/// Runs of patches under one box: a profile of n patches costs about its square root, one of a few dozen has one run.
void ToothDistance::gather_runs()
{
    constexpr std::size_t least = 16;
    auto const size = std::max(least, static_cast<std::size_t>(std::sqrt(static_cast<double>(patches_.size()))));
    for (std::size_t first = 0; first < patches_.size(); first += size) {
        Run run{first, std::min(patches_.size(), first + size), patches_[first].low, patches_[first].high};
        for (std::size_t i = first; i < run.last; ++i) {
            run.low = run.low.cwiseMin(patches_[i].low);
            run.high = run.high.cwiseMax(patches_[i].high);
        }
        runs_.push_back(run);
    }
}

void ToothDistance::gather_lanes()
{
    if (runs_.size() > 1)
        return;
    std::vector<DistanceLanes::Vertex> vertices;
    for (Vertex const& v : vertices_)
        vertices.push_back({v.point.x(), v.point.y(), v.normal.x(), v.normal.y(), v.open_end ? 1.0 : 0.0});
    std::vector<DistanceLanes::Piece> pieces;
    for (Patch const& patch : patches_) {
        DistanceLanes::Piece piece{};
        piece.low_x = patch.low.x();
        piece.low_y = patch.low.y();
        piece.high_x = patch.high.x();
        piece.high_y = patch.high.y();
        Vec2 from, along, normal = Vec2::Zero();
        if (auto const* line = std::get_if<Line>(&patch.shape)) {
            from = line->a;
            along = line->along;
            normal = line->normal;
            piece.size = line->length;
        } else if (auto const* arc = std::get_if<Arc>(&patch.shape)) {
            from = arc->centre;
            along = arc->middle;
            piece.is_arc = true;
            piece.size = arc->radius;
            piece.cos_half_span = arc->cos_half_span;
        } else {
            return;
        }
        piece.x = from.x();
        piece.y = from.y();
        piece.t_x = along.x();
        piece.t_y = along.y();
        piece.n_x = normal.x();
        piece.n_y = normal.y();
        pieces.push_back(piece);
    }
    lanes_.emplace(std::move(vertices), std::move(pieces));
}

void ToothDistance::look_at(Run const& run, Vec2 const& p, Nearest& nearest) const
{
    // patch i lies between vertices i and i + 1
    for (std::size_t i = run.first; i <= run.last; ++i)
        nearest.offer(p, vertices_[i].point, vertices_[i].normal, true, vertices_[i].open_end);
    for (std::size_t i = run.first; i < run.last; ++i) {
        Patch const& patch = patches_[i];
        if (squared_distance(patch.low, patch.high, p) <= nearest.squared)
            std::visit([&](auto const& shape) { foot_on(shape, p, nearest); }, patch.shape);
    }
}

NearestPoint ToothDistance::operator()(Vec2 const& p) const
{
    Nearest nearest;
    Run const* likely = &runs_.front();
    if (runs_.size() > 1) {
        double least = std::numeric_limits<double>::infinity();
        for (Run const& run : runs_) {
            double const away = squared_distance(run.low, run.high, p);
            likely = away < least ? &run : likely;
            least = std::min(least, away);
        }
    }
    look_at(*likely, p, nearest);
    for (Run const& run : runs_) {
        if (&run != likely && squared_distance(run.low, run.high, p) <= nearest.squared)
            look_at(run, p, nearest);
    }
    Vec2 const away = p - nearest.point;
    double const distance = std::sqrt(nearest.squared);
    double const along = away.dot(nearest.normal);
    bool const outside = nearest.open_end || along >= 0;
    NearestPoint result{outside ? distance : -distance, nearest.point, nearest.normal};
    // at a corner the gradient points from the corner to p; on a smooth foot, or at a smooth joint, this is the normal
    // itself, but the difference of two close points loses digits, so the exact normal is kept there
    constexpr double aligned = 1 - 0x1p-20;
    if (nearest.vertex && distance > 0 && std::abs(along) < aligned * distance)
        result.normal = (outside ? 1.0 : -1.0) / distance * away;
    return result;
}

}  // namespace hdconj::distance
