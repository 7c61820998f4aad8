// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary of a tooth space moved along its normal: what is left of its pieces, cut or extended to where they meet.
#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/conjugate/crossing.hpp"
#include "hdconj/error.hpp"
#include "space_curve.hpp"

namespace hdconj::conjugate {

ToothSpaceBoundary ToothSpaceBoundary::moved_along_normal(double distance, Tolerance const& tolerance,
                                                          std::optional<double> tip) const
{
    double const circle = tip.value_or(tip_radius_ + distance);
    ToothSpaceBoundary moved(tooth_, *motion_, offset() + distance, arcs_, pieces_, circle, pitch_);
    if (distance == 0)
        return moved;
    auto const refuse = [&](Vec2 const& place, std::string const& why, char const* remedy) {
        throw NumericalError(ErrorCode::no_outline, "draft", near_text(place),
                             "moved by " + std::to_string(distance) + " mm along its normal, " + why, remedy);
    };
    std::vector<Remainder> left;
    for (BoundaryPiece const& piece : pieces_) {
        Remainder next{piece, piece};
        next.vanished = moved.vanished_part(*this, next.forward);
        if (next.vanished != Vanished::nothing && made_by(piece).kind == OutlineKind::flank)
            refuse(at(piece, piece.begin).p, "the flank would fold over itself there",
                   "write a smaller tilt.angle_deg");
        if (!left.empty() && (next.vanished == Vanished::whole || next.vanished == Vanished::begin))
            left.back().cut = true;
        next.rest = next.forward;
        next.cut = next.vanished == Vanished::end;
        if (next.vanished != Vanished::whole)
            left.push_back(next);
    }
    moved.cut_to_neighbours(left, std::abs(distance), tolerance);
    std::vector<BoundaryPiece> gone;
    while (auto const none = join(left, moved, distance, tolerance)) {
        std::size_t const i = none->piece;
        // between the tip circle and a neighbour these meet in its place, as they do where it becomes a point
        bool const between = i > 0 && i + 1 < left.size() && left[i].rest.arc >= 0;
        bool const beside_tip = between && (left[i - 1].rest.arc < 0) != (left[i + 1].rest.arc < 0);
        if (!beside_tip || made_by(left[i].rest).kind == OutlineKind::bottom)
            refuse(none->place, none->why, "write another circular_spline.inner_radius or a smaller tilt.angle_deg");
        gone.push_back(left[i].before);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        left[i - 1].cut = true;
    }
    for (BoundaryPiece const& piece : gone)
        if (moved.nearest_corner_of_land(sampled(piece, tolerance.length)) < std::abs(distance) - 2 * tolerance.length)
            refuse(at(piece, piece.begin).p, "the part of the outline beside the tip circle would vanish",
                   "write another circular_spline.inner_radius or tilt.angle_deg");
    return moved;
}

void ToothSpaceBoundary::cut_to_neighbours(std::vector<Remainder>& left, double distance,
                                           Tolerance const& tolerance) const
{
    for (std::size_t i = 0; i < left.size();) {
        Remainder& here = left[i];
        bool const begin = here.vanished == Vanished::begin;
        bool const has_neighbour = begin ? i > 0 : i + 1 < left.size();
        here.rest = here.forward;
        if (here.vanished == Vanished::nothing ||
            (has_neighbour &&
             reaches(here.rest, begin, begin ? left[i - 1].rest : left[i + 1].before, distance, tolerance))) {
            ++i;
            continue;
        }
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        if (i > 0)  // which may have been cut where it met this one
            left[--i].cut = true;
    }
}

double ToothSpaceBoundary::end_beside(BoundaryPiece const& piece, bool begin) const
{
    return (piece.begin < piece.end) != begin ? arc(piece).u_end : arc(piece).u_begin;
}

std::optional<BoundaryPiece> ToothSpaceBoundary::beyond(BoundaryPiece const& piece, bool begin,
                                                        Tolerance const& tolerance) const
{
    if (piece.arc < 0)
        return std::nullopt;
    bool const up = (piece.begin < piece.end) != begin;  // whether the piece leaves its arc there where u is largest
    double const u = end_beside(piece, begin);
    envelope::EnvelopePoint const here = envelope_.point(arc(piece), u);
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
        envelope::ContactArc const& next = arcs_[k];
        double const near = up ? next.u_begin : next.u_end;
        if (static_cast<int>(k) == piece.arc || !envelope::same_at_joint(near, u))
            continue;
        envelope::EnvelopePoint const there = envelope_.point(next, near);
        double const far = up ? next.u_end : next.u_begin;
        if ((there.p - here.p).norm() <= tolerance.coincidence() && there.n.dot(here.n) > 0)
            return BoundaryPiece{static_cast<int>(k), piece.copy, begin ? far : near, begin ? near : far};
    }
    return std::nullopt;
}

bool ToothSpaceBoundary::extend(std::vector<Remainder>& left, std::size_t i, ToothSpaceBoundary const& moved,
                                double distance, Tolerance const& tolerance) const
{
    for (bool const begin : {false, true}) {
        Remainder& here = left[begin ? i + 1 : i];
        auto const more = beyond(here.before, begin, tolerance);
        bool const folded = here.vanished == (begin ? Vanished::begin : Vanished::end);
        if (!more || folded)
            continue;
        Remainder next{*more, *more, Vanished::nothing, !begin, *more};
        Vanished const part = moved.vanished_part(*this, next.forward);
        if (part == Vanished::whole || part == (begin ? Vanished::end : Vanished::begin))
            continue;
        (begin ? next.rest.begin : next.rest.end) = begin ? more->end : more->begin;  // where it is known to be
        BoundaryPiece reached = next.rest;
        BoundaryPiece other = left[begin ? i : i + 1].rest;
        if (!(begin ? moved.meet(other, reached, std::abs(distance), tolerance)
                    : moved.meet(reached, other, std::abs(distance), tolerance)))
            continue;
        double const corner = begin ? reached.begin : reached.end;
        bool const beyond_fold = begin ? (corner - next.forward.begin) * (more->end - more->begin) < 0
                                       : (corner - next.forward.end) * (more->end - more->begin) > 0;
        if (part != Vanished::nothing && beyond_fold)
            continue;
        for (BoundaryPiece* whole : {&here.before, &here.rest})
            (begin ? whole->begin : whole->end) = end_beside(here.before, begin);
        left[i].cut = begin;  // the corner is where the new piece meets the other
        left.insert(left.begin() + static_cast<std::ptrdiff_t>(i + 1), next);
        return true;
    }
    return false;
}

bool ToothSpaceBoundary::may_go(Remainder const& gone, Remainder const& before, Remainder const& after) const
{
    BoundaryPiece const &a = before.before, &b = after.before;
    if (before.cut || a.arc < 0 || b.arc < 0)
        return false;
    return outline_goes_on(*tooth_, a, arc(a), b, arc(b)) ||
           (made_by(gone.before).kind == OutlineKind::corner && envelope::same_at_joint(a.end, b.begin));
}

bool ToothSpaceBoundary::shorten(std::vector<Remainder>& left, std::size_t i, ToothSpaceBoundary const& moved,
                                 double distance, Tolerance const& tolerance) const
{
    if (left[i].rest.arc < 0 || left[i + 1].rest.arc < 0)
        return false;
    auto const at_place = [&](std::size_t k) { return left.begin() + static_cast<std::ptrdiff_t>(k); };
    auto const taken_out_between = [&](std::size_t before, std::size_t after) {
        BoundaryPiece a = left[before].rest, b = left[after].rest;
        if (!moved.meet(a, b, std::abs(distance), tolerance))
            return false;
        left.erase(at_place(before + 1), at_place(after));
        left[before].cut = true;
        return true;
    };
    for (std::size_t k = i; k > 0 && may_go(left[k], left[k - 1], left[k]); --k)
        if (taken_out_between(k - 1, i + 1))
            return true;
    for (std::size_t k = i + 1; k + 1 < left.size() && may_go(left[k], left[k], left[k + 1]); ++k)
        if (taken_out_between(i, k + 1))
            return true;
    return false;
}

std::optional<std::size_t> ToothSpaceBoundary::first_gap(std::vector<Remainder> const& left, ToothSpaceBoundary& moved,
                                                         double distance, Tolerance const& tolerance) const
{
    std::vector<BoundaryPiece>& after = moved.pieces_;
    after.clear();
    for (Remainder const& each : left)
        after.push_back(each.rest);
    for (std::size_t i = 0; i + 1 < after.size(); ++i) {
        // normals that agree to this come from one contact that goes on over a joint of the profile, or from the cut at
        // x = 0
        constexpr double smooth = 0x1p-20;
        Vec2 const n = at(left[i].before, left[i].before.end).n;
        Vec2 const next = at(left[i + 1].before, left[i + 1].before.begin).n;
        bool const corner = left[i].cut || std::abs(cross(n, next)) > smooth || n.dot(next) < 0;
        if (corner && !moved.meet(after[i], after[i + 1], std::abs(distance), tolerance))
            return i;
    }
    return std::nullopt;
}

std::optional<ToothSpaceBoundary::NoPlace> ToothSpaceBoundary::join(std::vector<Remainder>& left,
                                                                    ToothSpaceBoundary& moved, double distance,
                                                                    Tolerance const& tolerance) const
{
    std::vector<BoundaryPiece> const& after = moved.pieces_;
    auto const is_land = [&](std::size_t i) { return i < after.size() && after[i].arc < 0; };
    std::size_t changes = left.size() + arcs_.size();  // no part need come and go
    while (auto const gap = first_gap(left, moved, distance, tolerance)) {
        std::size_t const i = *gap;
        bool const changed = changes > 0 && (shorten(left, i, moved, distance, tolerance) ||
                                             extend(left, i, moved, distance, tolerance));
        if (!changed)
            return NoPlace{is_land(i) || (!is_land(i + 1) && is_land(i + 2)) ? i + 1 : i,
                           at(left[i].before, left[i].before.end).p,
                           "neighbouring parts of the outline would no longer meet there"};
        --changes;
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
        double const was = left[i].before.end - left[i].before.begin;
        double const is = after[i].end - after[i].begin;
        if (std::signbit(was) != std::signbit(is) && was != 0)
            return NoPlace{i, at(left[i].before, left[i].before.begin).p, "a part of the outline would vanish"};
    }
    return std::nullopt;
}

double ToothSpaceBoundary::nearest_corner_of_land(envelope::SampledArc const& from) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < pieces_.size(); ++i) {
        if ((pieces_[i].arc < 0) == (pieces_[i + 1].arc < 0))
            continue;
        Vec2 const corner = at(pieces_[i], pieces_[i].end).p;
        for (std::size_t k = 0; k + 1 < from.points.size(); ++k) {
            Vec2 const a = from.points[k].p, along = from.points[k + 1].p - a;
            double const share =
                along.squaredNorm() > 0 ? std::clamp((corner - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
            nearest = std::min(nearest, (corner - a - share * along).norm());
        }
    }
    return nearest;
}

/// What runs backwards lies beyond a centre of curvature; @p piece is cut down to what does not.
ToothSpaceBoundary::Vanished ToothSpaceBoundary::vanished_part(ToothSpaceBoundary const& base,
                                                               BoundaryPiece& piece) const
{
    if (piece.arc < 0)
        return Vanished::nothing;
    auto const place = [&](double share) { return piece.begin + share * (piece.end - piece.begin); };
    auto const forward = [&](double share) {
        return turned(piece).velocity(place(share)).dot(base.turned(piece).velocity(place(share)));
    };
    // the speed may have no finite value at an end itself
    constexpr double near_end = 0x1p-10;
    bool const begin = forward(near_end) < 0;
    bool const end = forward(1 - near_end) < 0;
    if (begin == end)
        return begin ? Vanished::whole : Vanished::nothing;
    double kept = begin ? 1 - near_end : near_end;
    double lost = begin ? near_end : 1 - near_end;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
        double const middle = 0.5 * (kept + lost);
        (forward(middle) < 0 ? lost : kept) = middle;
    }
    (begin ? piece.begin : piece.end) = place(kept);
    return begin ? Vanished::begin : Vanished::end;
}

bool ToothSpaceBoundary::reaches(BoundaryPiece& rest, bool begin, BoundaryPiece const& neighbour, double distance,
                                 Tolerance const& tolerance) const
{
    if (neighbour.arc < 0)
        return false;
    // Newton cannot start at the fold itself, where the piece stands still
    for (double const share : {0.5, 0.125, 0.875}) {
        double const guess = rest.begin + share * (rest.end - rest.begin);
        auto const u = crossing_of_arcs(turned(rest), guess, turned(neighbour), begin ? neighbour.end : neighbour.begin,
                                        distance, tolerance);
        if (u && (*u)[0] > std::min(rest.begin, rest.end) && (*u)[0] < std::max(rest.begin, rest.end)) {
            (begin ? rest.begin : rest.end) = (*u)[0];
            return true;
        }
    }
    return false;
}

bool ToothSpaceBoundary::meet(BoundaryPiece& before, BoundaryPiece& after, double distance,
                              Tolerance const& tolerance) const
{
    if (before.arc < 0 || after.arc < 0) {
        BoundaryPiece& flank = before.arc < 0 ? after : before;
        double& end = before.arc < 0 ? flank.begin : flank.end;
        auto const u = crossing_with_circle(turned(flank), tip_radius_, end, distance);
        if (!u)
            return false;
        end = *u;
        Vec2 const p = at(flank, *u).p;
        (before.arc < 0 ? before.end : after.begin) = std::atan2(p.x(), p.y());
        return true;
    }
    auto const u = crossing_of_arcs(turned(before), before.end, turned(after), after.begin, distance, tolerance);
    if (!u)
        return false;
    before.end = (*u)[0];
    after.begin = (*u)[1];
    return true;
}

}  // namespace hdconj::conjugate
