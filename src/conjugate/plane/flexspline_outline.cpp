// SPDX-License-Identifier: GPL-3.0-or-later
#include "flexspline_outline.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "centred_outline.hpp"
#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"

namespace hdconj::conjugate {
namespace {

void append_line(Outline& outline, OutlineKind kind, Vec2 const& from, Vec2 const& to)
{
    append_outline(outline, {{from, to}, {{kind, -1, 0, 1}}});
}

}  // namespace

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
