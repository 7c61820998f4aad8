// SPDX-License-Identifier: GPL-3.0-or-later
#include "nominal_part.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "hdconj/error.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "profile/measured_points.hpp"

namespace hdconj::inspect {
namespace {

using profile::ArcPiece;
using profile::CurvePiece;
using profile::LinePiece;
using profile::PieceShape;

/// Arc length of a piece from its start to the local parameter @p t.
double length_to(PieceShape const& shape, double t)
{
    if (auto const* line = std::get_if<LinePiece>(&shape))
        return t * line->length();
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
        return t * arc->length();
    auto const& curve = std::get<CurvePiece>(shape);
    constexpr unsigned nodes = 30;  // the speed is the root of a polynomial of degree 16 at most
    return boost::math::quadrature::gauss<double, nodes>::integrate([&](double s) { return curve.first(s).norm(); }, 0,
                                                                    t);
}

/// Local parameter of the point of a piece that is next to @p p, which is a point of it or of another piece.
double local_parameter(PieceShape const& shape, Vec2 const& p)
{
    double t = 0;
    if (auto const* line = std::get_if<LinePiece>(&shape)) {
        t = (p - line->a).dot(line->tangent()) / line->length();
    } else if (auto const* arc = std::get_if<ArcPiece>(&shape)) {
        Vec2 const middle = direction(0.5 * (arc->from + arc->to));
        Vec2 const n = (arc->radius > 0 ? 1.0 : -1.0) * (p - arc->centre);
        t = 0.5 + std::atan2(cross(middle, n), middle.dot(n)) / (arc->to - arc->from);
    } else {
        auto const& curve = std::get<CurvePiece>(shape);
        constexpr int probes = 8, newton_steps = 6;
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= probes; ++i) {
            double const s = static_cast<double>(i) / probes;
            double const away = (curve.point(s) - p).squaredNorm();
            t = away < least ? s : t;
            least = std::min(least, away);
        }
        for (int i = 0; i < newton_steps; ++i) {
            Vec2 const slope = curve.first(t);
            t = std::clamp(t + (p - curve.point(t)).dot(slope) / slope.squaredNorm(), 0.0, 1.0);
        }
    }
    return std::clamp(t, 0.0, 1.0);
}

PieceShape const& shape_of(profile::Profile const& flank, std::size_t i)
{
    return flank.pieces[i].shape;
}

Vec2 normal_at(PieceShape const& shape, double t)
{
    if (auto const* line = std::get_if<LinePiece>(&shape))
        return line->normal();
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
        return direction(arc->from + t * (arc->to - arc->from));
    return left_of(std::get<CurvePiece>(shape).first(t)).normalized();
}

using profile::Profile;
using profile::ProfilePiece;

/// A profile that lacks all but its pieces, corners at its ends removed.
Profile flank_of(std::vector<ProfilePiece> pieces, std::string const& which)
{
    while (!pieces.empty() && pieces.front().corner)
        pieces.erase(pieces.begin());
    while (!pieces.empty() && pieces.back().corner)
        pieces.pop_back();
    if (pieces.empty())
        throw NumericalError(ErrorCode::no_outline, "inspection", which + " flank",
                             "the nominal outline has no such flank");
    Profile flank;
    flank.pieces = std::move(pieces);
    double low = profile::start_of(flank.pieces.front().shape).point.y(), high = low;
    for (ProfilePiece const& piece : flank.pieces) {
        double const y = profile::end_of(piece.shape).point.y();
        low = std::min(low, y);
        high = std::max(high, y);
    }
    flank.addendum = high;
    flank.dedendum = -low;
    return flank;
}

/// Clockwise angle about the axis and distance from it.
std::pair<double, double> polar(Vec2 const& p, double seat)
{
    Vec2 const from_axis(p.x(), p.y() + seat);
    return {std::atan2(from_axis.x(), from_axis.y()), from_axis.norm()};
}

NominalPlane plane_of_flanks(Profile left, Profile right, double seat, bool space, double error)
{
    // towards its tip a tooth of the circular spline points inward: its space is traversed from tip to root on the left
    NominalPlane plane{NominalFlank(std::move(left), !space, space), NominalFlank(std::move(right), space, space), 0, 0,
                       error};
    auto const [left_angle, left_radius] = polar(plane.left.at(plane.left.length() / 2).point, seat);
    auto const [right_angle, right_radius] = polar(plane.right.at(plane.right.length() / 2).point, seat);
    plane.reference_radius = 0.5 * (left_radius + right_radius);
    plane.half_angle = 0.5 * (right_angle - left_angle);
    return plane;
}

/// A smooth curve through points: a cubic spline, chords where there are too few.
std::vector<profile::PieceShape> curve_through(std::vector<Vec2> const& points)
{
    constexpr std::size_t fewest = 4;  // of a cubic spline
    std::vector<profile::PieceShape> shapes;
    if (points.size() >= fewest)
        for (auto& piece : profile::spline_through(points))
            shapes.emplace_back(std::move(piece));
    else
        for (std::size_t i = 1; i < points.size(); ++i)
            shapes.emplace_back(profile::LinePiece{points[i - 1], points[i]});
    return shapes;
}

/// What the curve through every second point misses of the others.
double miss_of_half(std::vector<Vec2> const& points)
{
    std::vector<Vec2> half;
    for (std::size_t i = 0; i < points.size(); i += 2)
        half.push_back(points[i]);
    if (points.size() % 2 == 0)
        half.push_back(points.back());
    std::vector<ProfilePiece> pieces;
    for (auto& shape : curve_through(half))
        pieces.push_back({std::move(shape)});
    Profile const profile = flank_of(std::move(pieces), "half a");
    distance::ToothDistance const distance(profile);
    double worst = 0;
    for (Vec2 const& p : points)
        worst = std::max(worst, std::abs(distance(p).distance));
    return worst;
}

}  // namespace

NominalFlank::NominalFlank(profile::Profile flank, bool root_first, bool space)
    : flank_(std::make_unique<profile::Profile const>(std::move(flank))),
      distance_(*flank_),
      first_(profile::start_of(flank_->pieces.front().shape).point),
      last_(profile::end_of(flank_->pieces.back().shape).point),
      root_first_(root_first),
      space_(space)
{
    constexpr double margin = 1.125;  // a point of a piece is no farther from its start than the piece is long
    double length = 0;
    for (auto const& piece : flank_->pieces) {
        double const reach = margin * length_to(piece.shape, 1);
        starts_.push_back({profile::start_of(piece.shape).point, reach * reach});
        ends_.push_back(length += length_to(piece.shape, 1));
    }
}

FlankFoot NominalFlank::operator()(Vec2 const& p) const
{
    distance::NearestPoint const nearest = distance_(p);
    double const sign = space_ ? -1 : 1;
    bool const at_end = nearest.point == first_ || nearest.point == last_;
    return {!at_end, sign * nearest.distance, nearest.point, sign * nearest.normal};
}

double NominalFlank::arc_length(Vec2 const& foot) const
{
    double least = std::numeric_limits<double>::infinity(), nearest_t = 0;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
        if ((starts_[i].point - foot).squaredNorm() > starts_[i].squared_reach)
            continue;
        PieceShape const& shape = shape_of(*flank_, i);
        double const t = local_parameter(shape, foot);
        double const away = (profile::point_at(shape, t) - foot).squaredNorm();
        if (away < least) {
            least = away;
            nearest = i;
            nearest_t = t;
        }
    }
    double const at = (nearest == 0 ? 0 : ends_[nearest - 1]) + length_to(shape_of(*flank_, nearest), nearest_t);
    return root_first_ ? at : length() - at;
}

profile::PieceEnd NominalFlank::at(double arc_length) const
{
    double const s = std::clamp(root_first_ ? arc_length : length() - arc_length, 0.0, length());
    auto const i = static_cast<std::size_t>(
        std::min(std::lower_bound(ends_.begin(), ends_.end(), s) - ends_.begin(), std::ptrdiff_t(ends_.size()) - 1));
    PieceShape const& shape = shape_of(*flank_, i);
    double const within = s - (i == 0 ? 0 : ends_[i - 1]), whole = length_to(shape, 1);
    double t = whole > 0 ? std::clamp(within / whole, 0.0, 1.0) : 0;
    if (std::holds_alternative<CurvePiece>(shape) && t > 0 && t < 1)
        t = numeric::bracketed_root([&](double u) { return length_to(shape, u) - within; }, 0.0, 1.0).x;
    return {profile::point_at(shape, t), (space_ ? -1.0 : 1.0) * normal_at(shape, t)};
}

std::vector<double> NominalFlank::joints() const
{
    std::vector<double> all{0};
    all.insert(all.end(), ends_.begin(), ends_.end());
    if (!root_first_) {
        std::reverse(all.begin(), all.end());
        for (double& each : all)
            each = length() - each;
    }
    return all;
}

FlankFoot NominalPlane::foot(Vec2 const& p, bool is_right, double above) const
{
    FlankFoot here = flank(is_right)(p);
    if (raised && above != 0)
        here.distance += above / raise * (raised->flank(is_right)(p).distance - here.distance);
    return here;
}

double NominalPart::pitch() const
{
    return 2 * std::numbers::pi / teeth;
}

NominalPlane plane_of_profile(Profile const& tooth, double seat)
{
    std::vector<ProfilePiece> left, right;
    bool behind_tip = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i) {
        ProfilePiece const& piece = tooth.pieces[i];
        if (profile::is_tip(tooth, static_cast<int>(i))) {
            behind_tip = true;
            continue;
        }
        bool const is_right = behind_tip || profile::point_at(piece.shape, 0.5).x() > 0;
        (is_right ? right : left).push_back(piece);
    }
    return plane_of_flanks(flank_of(std::move(left), "left"), flank_of(std::move(right), "right"), seat, false, 0);
}

NominalPlane plane_of_outline(std::vector<Vec2> const& outline, std::vector<OutlinePiece> const& pieces, double seat,
                              bool space, double point_error)
{
    constexpr double order_of_cubic = 16;  // half the step: 2^-4 of the error
    std::vector<ProfilePiece> left, right;
    double error = point_error;
    for (OutlinePiece const& piece : pieces) {
        if ((piece.kind != "flank" && piece.kind != "corner") || piece.last <= piece.first)
            continue;
        std::vector<Vec2> const points(outline.begin() + static_cast<std::ptrdiff_t>(piece.first),
                                       outline.begin() + static_cast<std::ptrdiff_t>(piece.last) + 1);
        auto& side = points[points.size() / 2].x() < 0 ? left : right;
        for (auto& shape : curve_through(points))
            side.push_back({std::move(shape)});
        error = std::max(error, point_error + miss_of_half(points) / order_of_cubic);
    }
    return plane_of_flanks(flank_of(std::move(left), "left"), flank_of(std::move(right), "right"), seat, space, error);
}

}  // namespace hdconj::inspect
