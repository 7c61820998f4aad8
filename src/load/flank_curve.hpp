// SPDX-License-Identifier: GPL-3.0-or-later
// A curve through the points of a flank.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::load {

/// The tangent at a point between two chords.
enum class FlankTangents
{
    parabola,  ///< through it and its neighbours
    /// The same, weighted by the turns beside it (Akima, J. ACM 17, 1970): a stretch that does not bend stays straight
    /// beside one that does, where parabolas make a dip of some nanometres.
    straighter
};

/// Cubic Hermite stretches between neighbouring points, with tangents from the points alone (normals of a ruled or
/// tilted grid belong to the surface before the tilt). Where chords turn more than a flank does there is an edge, and
/// stretches end along their chords. The parameter is the way along the chords.
class FlankCurve
{
  public:
    struct Place
    {
        std::size_t stretch;
        double share;  ///< 0 ... 1
    };

    FlankCurve() = default;

    explicit FlankCurve(std::vector<Vec2> const& point, FlankTangents tangents = FlankTangents::parabola)
        : point_(point)
    {
        constexpr double aligned = 0.995;  // cosine of 6 degrees
        for (auto* column : {&begin_, &end_})
            column->reserve(point.size());
        arc_length_.reserve(point.size());
        arc_length_.push_back(0);
        for (std::size_t i = 0; i + 1 < point.size(); ++i) {
            double const length = (point[i + 1] - point[i]).norm();
            arc_length_.push_back(arc_length_.back() + length);
            longest_ = std::max(longest_, length);
        }
        std::vector<Vec2> direction(arc_length_.size() - 1, Vec2::Zero());
        for (std::size_t i = 0; i < direction.size(); ++i) {
            if (length(i) > 0)
                direction[i] = (point[i + 1] - point[i]) / length(i);
            begin_.push_back(length(i) * direction[i]);
            end_.push_back(begin_.back());
        }
        auto const turn = [&](std::size_t i) { return std::abs(cross(direction[i - 1], direction[i])); };
        // where a neighbour goes on, both end along the tangent they share
        for (std::size_t i = 1; i < direction.size(); ++i)
            if (direction[i - 1].dot(direction[i]) >= aligned) {
                double before = length(i), after = length(i - 1);
                if (tangents == FlankTangents::straighter) {
                    constexpr double even = 1e-3;  // of the turn here, where neither side bends
                    before *= turn(std::min(i + 1, direction.size() - 1)) + even * turn(i);
                    after *= turn(std::max<std::size_t>(i - 1, 1)) + even * turn(i);
                }
                Vec2 const sum = before * direction[i - 1] + after * direction[i];
                Vec2 const tangent = (sum.squaredNorm() > 0 ? sum : direction[i]).normalized();
                end_[i - 1] = length(i - 1) * tangent;
                begin_[i] = length(i) * tangent;
            }
        while (first_ + 1 < begin_.size() && !(length(first_) > 0))
            ++first_;
        last_ = begin_.size() - 1;
        while (last_ > first_ && !(length(last_) > 0))
            --last_;
    }

    [[nodiscard]] std::vector<Vec2> const& points() const { return point_; }
    [[nodiscard]] std::vector<double> const& arc_length() const { return arc_length_; }
    [[nodiscard]] double length(std::size_t stretch) const { return arc_length_[stretch + 1] - arc_length_[stretch]; }
    [[nodiscard]] double longest() const { return longest_; }
    [[nodiscard]] std::size_t first() const { return first_; }  ///< stretch with a length
    [[nodiscard]] std::size_t last() const { return last_; }
    [[nodiscard]] double arc_length_at(Place const& at) const
    {
        return arc_length_[at.stretch] + at.share * length(at.stretch);
    }

    [[nodiscard]] Place place(double arc_length) const
    {
        auto const above = std::upper_bound(arc_length_.begin(), arc_length_.end(), arc_length);
        auto const i = std::clamp(
            static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - arc_length_.begin(), 1)) - 1, first_, last_);
        return {i, length(i) > 0 ? std::clamp((arc_length - arc_length_[i]) / length(i), 0.0, 1.0) : 0.0};
    }

    [[nodiscard]] Vec2 point(Place const& at) const
    {
        double const t = at.share, s = 1 - t;
        // Bernstein form: the end points come out exactly
        Vec2 const& a = point_[at.stretch];
        Vec2 const& b = point_[at.stretch + 1];
        return s * s * (s + 3 * t) * a + t * t * (t + 3 * s) * b + s * s * t * begin_[at.stretch] -
               t * t * s * end_[at.stretch];
    }

    /// Unit.
    [[nodiscard]] Vec2 tangent(Place const& at) const
    {
        double const t = at.share, s = 1 - t;
        Vec2 const chord = point_[at.stretch + 1] - point_[at.stretch];
        return (6 * s * t * chord + s * (s - 2 * t) * begin_[at.stretch] + t * (t - 2 * s) * end_[at.stretch])
            .normalized();
    }

  private:
    std::vector<Vec2> point_;
    std::vector<Vec2> begin_, end_;  ///< derivatives by the share
    std::vector<double> arc_length_;
    double longest_ = 0;
    std::size_t first_ = 0, last_ = 0;
};

}  // namespace hdconj::load
