// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/error.hpp"
#include "reference_drive.hpp"
#include "reference_fitter.hpp"

namespace hdconj::accuracy {
namespace {

using Point = Pair<Fifty>;

/// A stretch of boundary with ends in 50 digits: of a contact arc, of the tip circle, or straight.
struct Stretch
{
    conjugate::BoundaryPiece piece;
    Fifty begin, end;          ///< u; on a tip circle the angle
    bool folds_begin = false;  ///< two contacts merge there, and this one runs infinitely fast along the profile
    bool folds_end = false;
    Point from, to;  ///< of a straight one
};

/// u along a stretch, 0 ... 1, quadratic at an end where two contacts merge: there the contact moves at finite speed.
Fifty along(Stretch const& stretch, Fifty const& s)
{
    Fifty share = s;
    if (stretch.folds_begin && stretch.folds_end)
        share = s * s * (3 - 2 * s);
    else if (stretch.folds_begin)
        share = s * s;
    else if (stretch.folds_end)
        share = s * (2 - s);
    return stretch.begin + share * (stretch.end - stretch.begin);
}

[[noreturn]] void lost(std::string const& what, Stretch const& at)
{
    throw NumericalError(
        ErrorCode::not_converged, "reference",
        "profile piece " + std::to_string(at.piece.arc) + " at u = " + std::to_string(static_cast<double>(at.begin)),
        what + " did not converge in 50 digits");
}

constexpr int corner_steps = 30;

/// Newton's method with difference quotients on f(u) = 0.
template <class F>
void solve_for(F const& f, std::string const& what, Stretch const& at, Fifty& u)
{
    Fifty const h("1e-22"), enough("1e-32");
    for (int i = 0; i < corner_steps; ++i) {
        Fifty const value = f(u), slope = (f(u + h) - value) / h;
        Fifty const step = value / slope;
        u -= step;
        if (abs(step) < enough)
            return;
    }
    lost(what, at);
}

/// The same on p_a(u) = p_b(u'); stretches that join in one tangent keep their ends: an error along both is none
/// across.
void meet(ReferenceDrive const& drive, Stretch& a, Stretch& b)
{
    Fifty const h("1e-22"), enough("1e-32");
    ReferenceContact<Fifty> const at_a = drive.contact(a.piece, a.end), at_b = drive.contact(b.piece, b.begin);
    Fifty const crossing = abs(at_a.normal.x * at_b.normal.y - at_a.normal.y * at_b.normal.x);
    Fifty const smooth(0x1p-20);
    if (crossing < smooth)
        return;
    // a corner of the tooth takes over from its flank: the same instant, and the path of the corner need not cross the
    // flank's
    if (a.piece.copy == b.piece.copy && a.end == b.begin && a.piece.arc != b.piece.arc)
        return;
    for (int i = 0; i < corner_steps; ++i) {
        Point const p = drive.point(a.piece, a.end), q = drive.point(b.piece, b.begin);
        Point const dp = (1 / h) * (drive.point(a.piece, a.end + h) - p),
                    dq = (1 / h) * (drive.point(b.piece, b.begin + h) - q);
        Point const gap = p - q;
        Fifty const determinant = -dp.x * dq.y + dp.y * dq.x;
        Fifty const ua = (-gap.x * dq.y + gap.y * dq.x) / determinant;
        Fifty const ub = (dp.x * gap.y - dp.y * gap.x) / determinant;
        a.end -= ua;
        b.begin -= ub;
        if (abs(ua) < enough && abs(ub) < enough)
            return;
    }
    lost("a corner of the boundary", a);
}

/// A stretch of @p piece; ends where contacts merge, or at a break, are those of 50 digits.
Stretch stretch_of(StudyDrive const& drive, ReferenceDrive const& fifty, conjugate::BoundaryPiece const& piece)
{
    Stretch stretch{piece, Fifty(piece.begin), Fifty(piece.end), false, false, {}, {}};
    if (piece.arc < 0)
        return stretch;
    envelope::ContactArc const& arc = drive.arc(piece);
    auto const folds = [&](double u) {
        return (u == arc.u_begin && arc.begins == envelope::BranchEnd::double_root) ||
               (u == arc.u_end && arc.ends == envelope::BranchEnd::double_root);
    };
    stretch.folds_begin = folds(piece.begin);
    stretch.folds_end = folds(piece.end);
    stretch.begin = fifty.merged(piece, piece.begin);
    stretch.end = fifty.merged(piece, piece.end);
    Fifty const roundings(0x1p-44);
    for (Fifty* end : {&stretch.begin, &stretch.end})
        for (Fifty const& at : fifty.breaks())
            if (abs(*end - at) < roundings)
                *end = at;
    return stretch;
}

/// @p stretch, cut where the speed of contacts jumps.
std::vector<Stretch> cut(ReferenceDrive const& fifty, Stretch const& stretch)
{
    std::vector<Fifty> inside;
    for (Fifty const& at : fifty.breaks())
        if ((at - stretch.begin) * (at - stretch.end) < 0)
            inside.push_back(at);
    if (stretch.end < stretch.begin)
        std::reverse(inside.begin(), inside.end());
    std::vector<Stretch> parts{stretch};
    for (Fifty const& at : inside) {
        Stretch rest = parts.back();
        parts.back().end = rest.begin = at;
        parts.back().folds_end = rest.folds_begin = false;
        parts.push_back(rest);
    }
    return parts;
}

void add_stretch(Fitter& fitter, StudyDrive const& drive, ReferenceDrive const& fifty, Stretch const& stretch,
                 int number)
{
    if (stretch.piece.arc >= 0) {
        for (Stretch const& part : cut(fifty, stretch))
            fitter.add([&](Fifty const& s) { return fifty.point(part.piece, along(part, s)); }, number);
        return;
    }
    if (drive.reverse()) {
        fitter.add([&](Fifty const& s) { return stretch.from + s * (stretch.to - stretch.from); }, number);
        return;
    }
    Fifty const radius(drive.geometry.circular_spline_inner_radius);
    fitter.add(
        [&](Fifty const& s) -> Point {
            Fifty const angle = stretch.begin + s * (stretch.end - stretch.begin);
            return {radius * sin(angle), radius * cos(angle)};
        },
        number);
}

/// Ends of the lands on the tip circle, which flanks come down to.
void finish_space(StudyDrive const& drive, ReferenceDrive const& fifty, std::vector<Stretch>& stretches)
{
    Fifty const radius(drive.geometry.circular_spline_inner_radius);
    auto const come_down = [&](Stretch const& flank, Fifty& u, Fifty& angle) {
        solve_for([&](Fifty const& at) -> Fifty { return length(fifty.point(flank.piece, at)) - radius; },
                  "the crossing of the tip circle", flank, u);
        Point const p = fifty.point(flank.piece, u);
        angle = atan2(p.x, p.y);
    };
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i) {
        Stretch& a = stretches[i];
        Stretch& b = stretches[i + 1];
        if (a.piece.arc < 0)
            come_down(b, b.begin, a.end);
        else if (b.piece.arc < 0)
            come_down(a, a.end, b.begin);
    }
    stretches.front().begin = -fifty.half_pitch();
    stretches.back().end = fifty.half_pitch();
}

/// Where a flank of the flexspline tooth ends: its contact is at the very end of the other tooth's tip, or half the
/// pitch is reached, whichever the program has found there.
void finish_foot(StudyDrive const& drive, ReferenceDrive const& fifty, Stretch const& flank, Fifty& u)
{
    Fifty const half_width(drive.limits.half_width), start = u;
    Fifty const lean = abs(fifty.lean(flank.piece, u)), room = abs(1 - abs(fifty.point(flank.piece, u).x) / half_width);
    // an end of an arc that is neither stays where it is
    Fifty const near(0x1p-30);
    if (lean > near && room > near)
        return;
    if (lean < room)
        solve_for([&](Fifty const& at) { return fifty.lean(flank.piece, at); }, "the foot of a flank", flank, u);
    else
        solve_for([&](Fifty const& at) -> Fifty { return abs(fifty.point(flank.piece, at).x) - half_width; },
                  "the foot of a flank", flank, u);
    if (abs(u - start) > near)
        lost("the foot of a flank", flank);
}

/// The tip land, the feet and the walls below them.
void finish_body(StudyDrive const& drive, ReferenceDrive const& fifty, std::vector<Stretch>& stretches)
{
    Fifty const pitch_line(drive.geometry.pitch_line), tip = Fifty(drive.limits.tip) - pitch_line,
                                                       root = Fifty(drive.limits.root) - pitch_line;
    auto const cross_tip = [&](Stretch const& flank, Fifty& u) {
        solve_for([&](Fifty const& at) -> Fifty { return fifty.point(flank.piece, at).y - tip; },
                  "the crossing of the tip", flank, u);
        return fifty.point(flank.piece, u);
    };
    std::size_t const last = stretches.size() - 1;
    for (std::size_t i = 1; i < last; ++i) {
        if (stretches[i].piece.arc >= 0)
            continue;
        stretches[i].from = cross_tip(stretches[i - 1], stretches[i - 1].end);
        stretches[i].to = cross_tip(stretches[i + 1], stretches[i + 1].begin);
    }
    auto const below = [&](Point const& foot) -> Point {
        Fifty const depth = foot.y - root, room = Fifty(drive.limits.half_width) - abs(foot.x);
        Fifty const out = std::min<Fifty>(depth, std::max<Fifty>(Fifty(0), room) / 2);
        return {foot.x < 0 ? Fifty(foot.x - out) : Fifty(foot.x + out), root};
    };
    finish_foot(drive, fifty, stretches[1], stretches[1].begin);
    finish_foot(drive, fifty, stretches[last - 1], stretches[last - 1].end);
    stretches.front().to = fifty.point(stretches[1].piece, stretches[1].begin);
    stretches.front().from = below(stretches.front().to);
    stretches.back().from = fifty.point(stretches[last - 1].piece, stretches[last - 1].end);
    stretches.back().to = below(stretches.back().from);
}

}  // namespace

ReferenceCurve reference_of(StudyDrive const& drive)
{
    ReferenceDrive const fifty(drive);
    std::vector<Stretch> stretches;
    for (conjugate::BoundaryPiece const& piece : drive.pieces)
        stretches.push_back(stretch_of(drive, fifty, piece));
    for (std::size_t i = 0; i + 1 < stretches.size(); ++i)
        if (stretches[i].piece.arc >= 0 && stretches[i + 1].piece.arc >= 0)
            meet(fifty, stretches[i], stretches[i + 1]);
    if (drive.reverse())
        finish_body(drive, fifty, stretches);
    else
        finish_space(drive, fifty, stretches);
    Fitter fitter(drive.geometry.circular_spline_inner_radius);
    for (std::size_t i = 0; i < stretches.size(); ++i)
        add_stretch(fitter, drive, fifty, stretches[i], static_cast<int>(i));
    return {std::move(fitter.patches), fitter.error};
}

ReferenceCurve reference_of(StudyDrive const& drive, conjugate::BoundaryPiece const& piece)
{
    ReferenceDrive const fifty(drive);
    Fitter fitter(drive.geometry.circular_spline_inner_radius);
    add_stretch(fitter, drive, fifty, stretch_of(drive, fifty, piece), 0);
    return {std::move(fitter.patches), fitter.error};
}

}  // namespace hdconj::accuracy
