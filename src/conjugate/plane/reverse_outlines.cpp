// SPDX-License-Identifier: GPL-3.0-or-later
#include "reverse_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "hdconj/motion/inverse_motion.hpp"
#include "outline_records.hpp"

namespace hdconj::conjugate {
namespace {

/// Where the tooth's centre line leaves it at the tip.
struct Apex
{
    std::size_t piece = 0;
    double t = 0;
};

Apex apex_of(profile::Profile const& tooth)
{
    std::optional<Apex> apex;
    double highest = 0;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i) {
        profile::PieceShape const& shape = tooth.pieces[i].shape;
        if (tooth.pieces[i].corner)
            continue;
        auto const x = [&](double t) { return profile::point_at(shape, t).x(); };
        constexpr int steps = 64;
        for (int k = 0; k < steps; ++k) {
            double const a = static_cast<double>(k) / steps;
            double const b = static_cast<double>(k + 1) / steps;
            numeric::BracketedRoot const root = numeric::bracketed_root(x, a, b);
            if (!root.found)
                continue;
            double const y = profile::point_at(shape, root.x).y();
            if (!apex || y > highest) {
                apex = {i, root.x};
                highest = y;
            }
        }
    }
    if (!apex)
        throw NumericalError(ErrorCode::no_outline, "outline", "tooth of the circular spline",
                             "does not cross its own centre line");
    return *apex;
}

/// A flank in the tooth's frame, from the root end to the apex.
/// @param side  1: the right flank (x > 0), -1: the left one
Outline flank_of(profile::Profile const& tooth, Apex const& apex, int side, double chord)
{
    Outline flank;
    std::ptrdiff_t const root = side > 0 ? static_cast<std::ptrdiff_t>(tooth.pieces.size()) - 1 : 0;
    for (auto i = root;; i -= side) {
        auto const index = static_cast<std::size_t>(i);
        profile::ProfilePiece const& piece = tooth.pieces[index];
        if (!piece.corner) {
            double const from = side > 0 ? 1 : 0;
            double const to = index == apex.piece ? apex.t : 1 - from;
            int const steps = profile::steps_of(piece.shape, chord);
            bool const straight = std::holds_alternative<profile::LinePiece>(piece.shape);
            int const count = straight ? 1 : std::max(1, static_cast<int>(std::ceil(steps * std::abs(to - from))));
            std::size_t const first = flank.points.empty() ? 0 : flank.points.size() - 1;
            for (int k = flank.points.empty() ? 0 : 1; k <= count && (to != from || k == 0); ++k)
                flank.points.push_back(profile::point_at(piece.shape, from + (to - from) * k / count));
            OutlineKind const kind =
                profile::is_tip(tooth, static_cast<int>(i)) ? OutlineKind::land : OutlineKind::flank;
            bool const goes_on = !flank.stretches.empty() && flank.stretches.back().kind == kind &&
                                 flank.stretches.back().segment == piece.segment;
            if (goes_on)
                flank.stretches.back().last = flank.points.size() - 1;
            else if (flank.points.size() - 1 > first)
                flank.stretches.push_back({kind, piece.segment, first, flank.points.size() - 1});
        }
        if (index == apex.piece)
            break;
    }
    flank.points.back().x() = 0;
    return flank;
}

/// From the middle of the space to the middle of the tooth @p k beside it.
Outline half_of(profile::Profile const& tooth, Apex const& apex, int k, double radius, double middle_radius,
                double pitch, double chord)
{
    Pose const seat = motion::circular_spline_seat(k, pitch, radius);
    Outline flank = flank_of(tooth, apex, k == 1 ? 1 : -1, chord);
    for (Vec2& p : flank.points)
        p = seat(p);
    Vec2 const root = flank.points.front();
    double const to = std::atan2(root.x(), root.y());
    double const to_radius = root.norm();
    std::size_t const count = land_chords(to_radius, 0, to, chord);
    Outline half{{}, {{OutlineKind::root, -1, 0, count}}, chord, 8 * unit_roundoff * radius};
    for (std::size_t i = 0; i < count; ++i) {
        double const share = static_cast<double>(i) / static_cast<double>(count);
        double const r = middle_radius + share * (to_radius - middle_radius);
        half.points.emplace_back(r * std::sin(share * to), r * std::cos(share * to));
    }
    half.points.push_back(root);
    append_outline(half, flank);
    return half;
}

Outline reversed(Outline half)
{
    std::reverse(half.points.begin(), half.points.end());
    std::reverse(half.stretches.begin(), half.stretches.end());
    std::size_t const last = half.points.size() - 1;
    for (OutlineStretch& s : half.stretches)
        s = {s.kind, s.segment, last - s.last, last - s.first};
    return half;
}

void append_line(Outline& outline, OutlineKind kind, Vec2 const& from, Vec2 const& to)
{
    append_outline(outline, {{from, to}, {{kind, -1, 0, 1}}});
}

}  // namespace

CentredOutline given_spline(profile::Profile const& tooth, double radius, double pitch, double chord)
{
    Apex const apex = apex_of(tooth);
    auto const root_radius = [&](int k, Vec2 const& end) {
        return motion::circular_spline_seat(k, pitch, radius)(end).norm();
    };
    double const middle = 0.5 * (root_radius(0, profile::start_of(tooth.pieces.front().shape).point) +
                                 root_radius(1, profile::end_of(tooth.pieces.back().shape).point));
    Outline const right = half_of(tooth, apex, 1, radius, middle, pitch, chord);
    CentredOutline result{tooth.mirror_symmetric ? mirrored(right, tooth)
                                                 : reversed(half_of(tooth, apex, 0, radius, middle, pitch, chord)),
                          0};
    Outline& whole = result.outline;
    result.middle = whole.points.size() - 1;
    // the bottom is one stretch
    whole.stretches.back().last = result.middle + right.stretches.front().last;
    whole.points.insert(whole.points.end(), right.points.begin() + 1, right.points.end());
    for (auto s = right.stretches.begin() + 1; s != right.stretches.end(); ++s)
        whole.stretches.push_back({s->kind, s->segment, s->first + result.middle, s->last + result.middle});
    return result;
}

void publish_given_spline(Solution& out, profile::Profile const& tooth, CentredOutline const& spline, double pitch)
{
    Outline const& outline = spline.outline;
    CircularSplineOutline& cs = out.circular_spline;
    cs.z = {0.0};
    cs.outline = {outline.points};
    cs.pieces = piece_records(outline, tooth);
    auto const bottom = std::find_if(outline.stretches.begin(), outline.stretches.end(),
                                     [](OutlineStretch const& s) { return s.kind == OutlineKind::root; });
    bool const has_land = outline.stretches.front().kind == OutlineKind::land;
    std::size_t const left_land = has_land ? outline.stretches.front().last : 0;
    std::size_t const right_land =
        outline.stretches.back().kind == OutlineKind::land ? outline.stretches.back().first : outline.points.size() - 1;
    for (std::size_t index : {left_land, bottom->first, spline.middle, bottom->last, right_land})
        cs.landmarks.push_back(static_cast<int>(index));
    measure_space(outline, left_land, right_land, pitch, out.geometry, out.error);
}

Outline FlexsplineOutline::flank(std::vector<BoundaryPiece> const& pieces) const
{
    Outline flank;
    for (auto from = pieces.begin(); from != pieces.end();) {
        auto const to =
            std::find_if(from, pieces.end(), [from](BoundaryPiece const& p) { return p.copy != from->copy; });
        Swept const& tooth = teeth_[static_cast<std::size_t>(from->copy)];
        std::vector<BoundaryPiece> own(from, to);
        for (BoundaryPiece& piece : own)
            piece.copy = 0;
        append_outline(flank, sample_outline(tooth.envelope, tooth.arcs, own, 0, 0, tolerance_.length, threads_));
        from = to;
    }
    return flank;
}

Outline FlexsplineOutline::operator()(ToothBody const& body) const
{
    Outline right = flank(body.right);
    right.points.front().y() = limits_.tip;
    std::vector<BoundaryPiece> back(body.left.rbegin(), body.left.rend());
    for (BoundaryPiece& piece : back)
        std::swap(piece.begin, piece.end);
    Outline left = symmetric_ ? mirrored(right, given_) : flank(back);
    left.points.back().y() = limits_.tip;
    Vec2 const left_foot = left.points.front();
    Vec2 const right_foot = right.points.back();
    for (Vec2 const& foot : {left_foot, right_foot}) {
        if (!(foot.y() > limits_.root))
            throw NumericalError(
                ErrorCode::interference, "region", "root of the flexspline tooth",
                "the circular spline's tips reach " + std::to_string(limits_.root - foot.y()) + " mm below it",
                "write a larger flexspline.dedendum or a smaller circular_spline.profile.addendum");
    }
    Outline tooth;
    append_line(tooth, OutlineKind::root_wall, root_below(left_foot), left_foot);
    append_outline(tooth, left);
    append_line(tooth, OutlineKind::land, tooth.points.back(), right.points.front());
    append_outline(tooth, right);
    append_line(tooth, OutlineKind::root_wall, right_foot, root_below(right_foot));
    // the points are small differences of lengths of this size
    tooth.error += 8 * unit_roundoff * tolerance_.scale;
    return tooth;
}

Vec2 FlexsplineOutline::root_below(Vec2 const& foot) const
{
    double const depth = foot.y() - limits_.root;
    double const room = std::max(0.0, limits_.half_width - std::abs(foot.x()));
    return {foot.x() + std::copysign(std::min(depth, room / 2), foot.x()), limits_.root};
}

}  // namespace hdconj::conjugate
