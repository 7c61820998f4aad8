// SPDX-License-Identifier: GPL-3.0-or-later
// Whether teeth touch a reference and never enter it, by brute force.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "accuracy/reference/reference_contact.hpp"
#include "hdconj/base/stop.hpp"
#include "polyline_tree.hpp"
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
    PolylineTree sides_;
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

}  // namespace hdconj::accuracy
