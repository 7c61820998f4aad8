// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_spline.hpp"

#include <algorithm>
#include <cmath>

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
    Apex apex;
    double highest = 0;
    bool found = false;
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
            if (!found || y > highest) {
                apex = {i, root.x};
                highest = y;
                found = true;
            }
        }
    }
    if (!found)
        throw NumericalError(ErrorCode::no_outline, "outline", "tooth of the circular spline",
                             "does not cross its own centre line");
    return apex;
}

/// A flank in the tooth's frame, from the root end to the apex.
struct Flank
{
    std::vector<Vec2> points;
    std::vector<OutlineStretch> stretches;
};

/// @param side  1: the right flank (x > 0), -1: the left one
Flank flank_of(profile::Profile const& tooth, Apex const& apex, int side, double chord)
{
    Flank flank;
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
    Flank const flank = flank_of(tooth, apex, k == 1 ? 1 : -1, chord);
    Vec2 const root = seat(flank.points.front());
    double const to = std::atan2(root.x(), root.y());
    double const to_radius = root.norm();
    auto const count = static_cast<int>(land_chords(to_radius, 0, to, chord));
    Outline half;
    for (int i = 0; i < count; ++i) {
        double const share = static_cast<double>(i) / count;
        double const r = middle_radius + share * (to_radius - middle_radius);
        half.points.emplace_back(r * std::sin(share * to), r * std::cos(share * to));
    }
    auto const first = static_cast<std::size_t>(count);
    half.stretches.push_back({OutlineKind::root, -1, 0, first});
    for (Vec2 const& p : flank.points)
        half.points.push_back(seat(p));
    for (OutlineStretch const& s : flank.stretches)
        half.stretches.push_back({s.kind, s.segment, s.first + first, s.last + first});
    half.chord = chord;
    half.error = 8 * unit_roundoff * radius;
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

}  // namespace hdconj::conjugate
