// SPDX-License-Identifier: GPL-3.0-or-later
#include "nominal_part.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/error.hpp"
#include "profile/measured_points.hpp"

namespace hdconj::inspect {
namespace {

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
