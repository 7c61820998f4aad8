// SPDX-License-Identifier: GPL-3.0-or-later
// What a wire does not cut.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/units.hpp"
#include "limits.hpp"

namespace hdconj::judgement {
namespace {

/// Wire, gap and accepted residual: of [wedm], or those of its examples.
struct Wire
{
    explicit Wire(Scene const& scene) : given(scene.wedm.has_value())
    {
        if (!given)
            return;
        diameter = scene.wedm->wire_diameter;
        gap = scene.wedm->spark_gap;
        residual_limit = scene.wedm->residual_limit;
    }
    /// Distance of the wire's centre from the part [mm].
    [[nodiscard]] double reach() const { return diameter / 2 + gap; }
    /// "the wire of [wedm]"
    [[nodiscard]] std::string name() const
    {
        return given ? "the wire of [wedm]" : "a wire of " + short_number(diameter) + " mm";
    }

    bool given;
    double diameter = 0.10;        // [mm], the thinnest that is common
    double gap = 0.006;            // [mm]
    double residual_limit = 0.01;  // [mm], the default of the key
};

/// A corner of the space, where the outline turns from one direction to another over a length.
struct Corner
{
    Corner(Vec2 const& in, Vec2 const& out, double length)
    {
        double const turn = std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
        if (!(turn < 0))  // the corner of a tooth
            return;
        radius = -length / turn;
        height_per_reach = 1 / std::cos(turn / 2) - 1;
    }
    /// Height of the material that a wire with the centre @p reach from the part leaves: (reach - rho) (1/cos(a/2) - 1)
    /// for a turn by a and a mean radius rho = length/a. An upper bound where a side is short [mm].
    [[nodiscard]] double left_by(double reach) const { return std::max(0.0, reach - radius) * height_per_reach; }
    /// The reach that leaves the height @p left [mm].
    [[nodiscard]] double reach_of(double left) const { return radius + left / height_per_reach; }

    double radius = 0, height_per_reach = 0;
};

}  // namespace

std::optional<Note> sharp_corner(Solution const& solution)
{
    if (solution.scene.is_reverse())
        return std::nullopt;
    Wire const wire(solution.scene);
    std::vector<Vec2> const& points = solution.circular_spline.outline.front();
    double highest = 0, reach = wire.reach();
    Vec2 where = Vec2::Zero();
    auto const look = [&](std::size_t first, std::size_t last) {
        if (first == 0 || last + 1 >= points.size())
            return;
        double length = 0;
        for (std::size_t i = first; i < last; ++i)
            length += (points[i + 1] - points[i]).norm();
        Corner const corner(points[first] - points[first - 1], points[last + 1] - points[last], length);
        double const height = corner.left_by(wire.reach());
        if (height > 0)
            reach = std::min(reach, corner.reach_of(wire.residual_limit));
        if (height > highest) {
            highest = height;
            where = points[last];
        }
    };
    for (OutlinePiece const& piece : solution.circular_spline.pieces) {
        look(piece.last, piece.last);
        if (piece.kind == "corner")
            look(piece.first, piece.last);
    }
    auto note = note_on(NoteCode::sharp_corner, highest / wire.residual_limit);
    if (!note)
        return note;
    note->place =
        "corner of the tooth space near (" + short_number(where.x(), 4) + ", " + short_number(where.y(), 6) + ") mm";
    note->cause = wire.name() + " leaves up to " + short_number(highest * per_um, 2) +
                  " um there, where a corner of the flexspline's tip passes";
    double const thinner = std::floor(2 * (reach - wire.gap) * 1000) / 1000;  // wires are sold in um
    note->advice = "take a thinner wire" + (thinner > 0 ? ", of at most " + short_number(thinner) + " mm," : "") +
                   " or round the tip's corner; a larger circular_spline.root_clearance moves the corner away from the "
                   "teeth, but leaves it sharp";
    return note;
}

std::optional<Note> narrow_space(Solution const& solution)
{
    if (solution.scene.is_reverse())
        return std::nullopt;
    Wire const wire(solution.scene);
    PairGeometry const& g = solution.geometry;
    double const deepest = g.circular_spline_inner_radius + g.space_depth - wire.reach();
    double narrowest = std::numeric_limits<double>::infinity();
    for (Vec2 const& p : solution.circular_spline.outline.front())
        if (p.norm() <= deepest)
            narrowest = std::min(narrowest, 2 * std::abs(p.x()));
    double const slot = 2 * wire.reach();
    auto note = note_on(NoteCode::narrow_space, narrowest / slot);
    if (!note)
        return note;
    note->place = "tooth space";
    note->cause = wire.name() + " cuts a slot of " + short_number(slot) + " mm, and the space is " +
                  short_number(narrowest, 3) + " mm wide";
    note->advice = "take a thinner wire, or a wider tip of the flexspline's tooth";
    return note;
}

}  // namespace hdconj::judgement
