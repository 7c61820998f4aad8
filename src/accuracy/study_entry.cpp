// SPDX-License-Identifier: GPL-3.0-or-later
// A reference against teeth that touch it and never enter it, by brute force, and what is left of the meshing
// condition at the contacts of a solution, by the reference's path.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "accuracy/reference/reference_contact.hpp"
#include "hdconj/base/stop.hpp"
#include "region/segment_tree.hpp"
#include "study_drive.hpp"

namespace hdconj::accuracy {
namespace {

constexpr double far_away = std::numeric_limits<double>::infinity();

/// Signed distance from a tooth at rest, by its polygon.
class ToothPolygon
{
  public:
    explicit ToothPolygon(std::vector<Vec2> points) : points_(std::move(points)), sides_(points_)
    {
        auto const by_height = std::minmax_element(points_.begin(), points_.end(),
                                                   [](Vec2 const& a, Vec2 const& b) { return a.y() < b.y(); });
        low_ = by_height.first->y();
        high_ = by_height.second->y();
        for (Vec2 const& p : points_)
            wide_ = std::max(wide_, std::abs(p.x()));
        for (std::size_t i = 0; i < points_.size(); ++i) {
            std::size_t const a = level(points_[i].y()), b = level(next(i).y());
            for (std::size_t k = std::min(a, b); k <= std::max(a, b); ++k)
                at_level_[k].push_back(i);
        }
    }

    /// Negative inside; infinity for what is clearly beside or above it.
    [[nodiscard]] double distance(Vec2 const& x) const
    {
        if (x.y() > high_ + wide_ || std::abs(x.x()) > 3 * wide_)
            return far_away;
        double const away = sides_.nearest(x, points_.size() / 2).distance;
        return inside(x) ? -away : away;
    }

  private:
    [[nodiscard]] Vec2 const& next(std::size_t i) const { return points_[(i + 1) % points_.size()]; }
    [[nodiscard]] std::size_t level(double y) const
    {
        return static_cast<std::size_t>(std::clamp((y - low_) / (high_ - low_), 0.0, 1.0) * (levels - 1));
    }

    /// By the even-odd rule; closed below the root.
    [[nodiscard]] bool inside(Vec2 const& x) const
    {
        if (x.y() < low_ || x.y() > high_)
            return false;
        bool odd = false;
        for (std::size_t const i : at_level_[level(x.y())]) {
            Vec2 const& a = points_[i];
            Vec2 const& b = next(i);
            if ((a.y() > x.y()) != (b.y() > x.y()) &&
                x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                odd = !odd;
        }
        return odd;
    }

    std::vector<Vec2> points_;
    region::SegmentTree sides_;
    double low_ = 0, high_ = 0, wide_ = 0;
    static constexpr std::size_t levels = 256;
    std::array<std::vector<std::size_t>, levels> at_level_;  ///< sides by height, for the even-odd rule
};

/// A tooth over the lobe, by the reference's path.
class MovingTooth
{
  public:
    MovingTooth(ToothPolygon const& tooth, ReferenceView<double> view, double half_lobe, int positions)
        : tooth_(&tooth), view_(std::move(view)), half_(half_lobe), step_(2 * half_lobe / positions)
    {
        for (int i = 0; i <= positions; ++i)
            places_.push_back(view_.at(-half_ + step_ * i));
    }

    /// Smallest signed distance of @p p, a point of the frame that the view is in.
    [[nodiscard]] double nearest_to(Vec2 const& p) const
    {
        std::vector<double> along;
        along.reserve(places_.size());
        for (MovingFrame<double> const& place : places_)
            along.push_back(distance(place, p));
        double nearest = far_away;
        for (std::size_t i = 1; i + 1 < along.size(); ++i)
            if (along[i] < far_away && along[i] <= along[i - 1] && along[i] <= along[i + 1])
                nearest = std::min(nearest, least_about(-half_ + step_ * static_cast<double>(i), p));
        return nearest;
    }

  private:
    [[nodiscard]] double distance(MovingFrame<double> const& place, Vec2 const& p) const
    {
        Pair<double> const d{p.x() - place.origin.x, p.y() - place.origin.y};
        return tooth_->distance({inner(d, place.along), inner(d, place.outward)});
    }

    /// The minimum within a step of @p u, by thirds.
    [[nodiscard]] double least_about(double u, Vec2 const& p) const
    {
        double a = u - step_, b = u + step_;
        constexpr int cuts = 40;
        for (int n = 0; n < cuts; ++n) {
            double const c = a + (b - a) / 3, d = b - (b - a) / 3;
            bool const left = distance(view_.at(c), p) < distance(view_.at(d), p);
            (left ? b : a) = left ? d : c;
        }
        return distance(view_.at(0.5 * (a + b)), p);
    }

    ToothPolygon const* tooth_;
    ReferenceView<double> view_;
    double half_, step_;
    std::vector<MovingFrame<double>> places_;
};

using Wide = long double;

/// Unit normal of a piece at @p t of its own 0 ... 1, where @p x lies on it.
Pair<Wide> normal_at(profile::PieceShape const& shape, Wide t, Pair<Wide> const& x)
{
    auto const unit = [](Pair<Wide> const& v) { return (Wide(1) / length(v)) * v; };
    if (auto const* arc = std::get_if<profile::ArcPiece>(&shape))
        return unit(x - pair_of<Wide>(arc->centre));
    if (auto const* line = std::get_if<profile::LinePiece>(&shape))
        return unit(to_left(pair_of<Wide>(line->b) - pair_of<Wide>(line->a)));
    auto const& curve = std::get<profile::CurvePiece>(shape);
    return unit(to_left(Pair<Wide>{casteljau(numeric::bernstein_derivative(curve.x()), t),
                                   casteljau(numeric::bernstein_derivative(curve.y()), t)}));
}

/// The piece of a segment that has parameter @p t; null where a corner has it.
profile::ProfilePiece const* piece_at(profile::Profile const& tooth, int segment, double t)
{
    for (profile::ProfilePiece const& piece : tooth.pieces)
        if (piece.segment == segment && !piece.corner && t >= piece.t_begin && t <= piece.t_end)
            return &piece;
    return nullptr;
}

}  // namespace

double entry_of(StudyDrive const& drive, ReferenceCurve const& reference, int samples, int positions)
{
    // forward: turned copies of one tooth; reverse: each circular-spline tooth as it is seen
    constexpr int neighbours = 3;
    ToothPolygon const tooth(profile::polygon_of(drive.tooth, drive.height() * 0x1p-20));
    std::vector<MovingTooth> teeth;
    ReferenceMotion<double> const held(drive.given());
    double const half = drive.motion().half_lobe();
    if (drive.reverse())
        for (int number = -neighbours; number <= 1 + neighbours; ++number)
            teeth.emplace_back(tooth, ReferenceView<double>(held, number, drive.seat_radius), half, positions);
    else
        teeth.emplace_back(tooth, ReferenceView<double>(held), half, positions);
    auto const nearest_to = [&](Vec2 const& p) {
        end_if_stopped();
        double nearest = far_away;
        if (drive.reverse())
            for (MovingTooth const& each : teeth)
                nearest = std::min(nearest, each.nearest_to(p + Vec2(0, drive.geometry.pitch_line)));
        else
            for (int copy = -neighbours; copy <= neighbours; ++copy)
                nearest = std::min(nearest, teeth.front().nearest_to(turned_clockwise(p, -copy * drive.pitch)));
        return nearest - drive.offset;
    };
    double worst = 0;
    auto const& points = reference.points();
    std::size_t const a_patch = points.size() / reference.patches().size();
    for (int k = 1; k < samples; ++k) {
        std::size_t const index = points.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(samples);
        auto const patch = std::min(index / a_patch, reference.patches().size() - 1);
        bool const land = drive.pieces[static_cast<std::size_t>(reference.patches()[patch].stretch)].arc <
                          0;  // which nothing has to touch
        double const nearest = nearest_to(points[index]);
        worst = std::max(worst, land ? -nearest : std::abs(nearest));
    }
    return worst;
}

double residual_of(StudyDrive const& drive, Solution const& solution, std::size_t samples)
{
    std::vector<ReferenceView<Wide>> const views = drive.views<Wide>();
    std::size_t all = 0;
    for (BranchRecord const& branch : solution.branches)
        all += branch.u.size();
    std::size_t const stride = std::max<std::size_t>(1, all / samples);
    Wide worst = 0;
    std::size_t count = 0;
    for (BranchRecord const& branch : solution.branches) {
        if (branch.kind != "regular")
            continue;
        ReferenceView<Wide> const& view = views[drive.index_of(branch.tooth)];
        Wide const lifted =
            drive.reverse() ? Wide(drive.geometry.pitch_line) : Wide(0);  // branches count from the pitch line
        for (std::size_t i = 0; i < branch.u.size(); ++i) {
            if (count++ % stride != 0)
                continue;
            profile::ProfilePiece const* const piece = piece_at(drive.tooth, branch.segment, branch.t[i]);
            if (piece == nullptr)
                continue;
            MovingFrame<Wide> const place =
                view.at(drive.scene.solver.kinematics == Kinematics::exact ? branch.u[i] : branch.phi[i]);
            Pair<Wide> const p{branch.point[i].x() - place.origin.x, branch.point[i].y() + lifted - place.origin.y};
            Pair<Wide> const x{inner(p, place.along), inner(p, place.outward)};
            Wide const local = (Wide(branch.t[i]) - piece->t_begin) / (Wide(piece->t_end) - piece->t_begin);
            worst =
                std::max(worst, std::abs(inner(place.turned(normal_at(piece->shape, local, x)), place.velocity(x))));
        }
    }
    return static_cast<double>(worst);
}

}  // namespace hdconj::accuracy
