// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law of the reverse problem: the smallest signed distance of a point of the flexspline tooth to any
/// tooth of the circular spline over a full turn, by brute force.
///
/// Nothing here is turned round: the point is carried into the circular spline by the flexspline tooth's own pose and
/// measured there against the given tooth, which stands on the pitch line's circle and points inward. The scan and the
/// slack are those of TouchScan, the teeth are all that come near.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "motion.hpp"
#include "tooth.hpp"
#include "touch.hpp"

namespace oracle {

/// The scene as if its given tooth stood on the flexspline: the oracle's tooth and motion read it from there.
inline hdconj::Scene turned_round(hdconj::Scene scene)
{
    scene.flexspline.profile = *scene.circular_spline.profile;
    scene.flexspline.inner_radius = scene.flexspline.inner_radius.value_or(
        scene.drive.module * scene.drive.flexspline_teeth / 2 - *scene.flexspline.dedendum - scene.flexspline.wall);
    return scene;
}

template <class T>
class GivenTeeth
{
  public:
    explicit GivenTeeth(hdconj::Scene const& scene) : tooth(turned_round(scene)), motion(turned_round(scene))
    {
        auto const& flexspline = scene.flexspline;
        pitch_line = T(flexspline.wall) / T(2) + T(*flexspline.dedendum) + T(flexspline.neutral_offset);
        auto const& given_tip = scene.circular_spline.inner_radius;
        pitch_radius = given_tip ? T(*given_tip) + tooth.addendum : motion.r_m + pitch_line + motion.w0;
    }

    /// Distance of @p p (frame of the flexspline tooth, y from its pitch line) to tooth @p k at position @p s.
    T distance(Pose<T> const& pose, Point<T> const& p, int k) const
    {
        Point<T> const there = pose.to_circular_spline({p.x, p.y + pitch_line});
        Point<T> const upright = turned_clockwise(there, -(T(k) - T(1) / T(2)) * motion.pitch());
        return tooth.distance_from_pitch_line({-upright.x, pitch_radius - upright.y});
    }

    Tooth<T> tooth;
    Motion<T> motion;
    T pitch_line{}, pitch_radius{};
};

class ReverseTouchScan
{
  public:
    explicit ReverseTouchScan(hdconj::Scene const& scene, std::size_t positions = 1600) : teeth(scene), fine_(scene)
    {
        half_ = teeth.motion.half_lobe();
        step_ = 2 * half_ / static_cast<double>(positions);
        for (std::size_t i = 0; i <= positions + 1; ++i)
            poses_.push_back(teeth.motion.pose(position(static_cast<double>(i))));
        double const wide = 1.5 * teeth.motion.pitch() * teeth.pitch_radius / 2;
        double const high = teeth.pitch_line + 1.5 * *scene.flexspline.addendum;
        double const low = teeth.pitch_line - 1.5 * *scene.flexspline.dedendum;
        for (std::size_t i = 0; i + 1 < poses_.size(); ++i)
            for (Point<double> const corner : {Point<double>{-wide, low}, Point<double>{wide, low},
                                               Point<double>{-wide, high}, Point<double>{wide, high}})
                slack_ = std::max(
                    slack_, length(poses_[i + 1].to_circular_spline(corner) - poses_[i].to_circular_spline(corner)));
        reach_ = 2 + teeth.motion.pitches_per_turn / (2 * teeth.motion.waves);
        scratch_.resize(poses_.size());
    }

    /// The smallest signed distance of @p p over all positions and teeth, the last step in long double.
    Touch nearest(Point<double> const& p)
    {
        struct Candidate
        {
            std::size_t index;
            int k;
            double distance;
        };
        double best = std::numeric_limits<double>::infinity();
        std::vector<Candidate> candidates;
        for (int k = -reach_; k <= 1 + reach_; ++k) {
            for (std::size_t i = 0; i < poses_.size(); ++i) {
                scratch_[i] = teeth.distance(poses_[i], p, k);
                best = std::min(best, scratch_[i]);
            }
            for (std::size_t i = 1; i + 1 < scratch_.size(); ++i)
                if (scratch_[i] <= scratch_[i - 1] && scratch_[i] <= scratch_[i + 1])
                    candidates.push_back({i, k, scratch_[i]});
        }
        Touch touch;
        for (auto const& candidate : candidates) {
            if (candidate.distance > best + slack_)
                continue;
            constexpr int parts = 24;
            double const from = position(static_cast<double>(candidate.index) - 1), part = 2 * step_ / parts;
            auto const at = [&](double s) { return teeth.distance(teeth.motion.pose(s), p, candidate.k); };
            std::array<double, parts + 1> value{};
            for (int i = 0; i <= parts; ++i)
                value[static_cast<std::size_t>(i)] = at(from + part * i);
            for (int i = 0; i <= parts; ++i) {
                auto const j = static_cast<std::size_t>(i);
                bool const low = (i == 0 || value[j] <= value[j - 1]) && (i == parts || value[j] <= value[j + 1]);
                if (low && value[j] <= touch.distance + slack_)
                    golden(at, from + part * (i - 1), from + part * (i + 1), candidate.k, touch);
            }
        }
        using Fine = long double;
        touch.distance =
            static_cast<double>(fine_.distance(fine_.motion.pose(static_cast<Fine>(touch.s)), as<Fine>(p), touch.copy));
        return touch;
    }

    GivenTeeth<double> teeth;

  private:
    double position(double index) const { return -half_ + step_ * index; }

    GivenTeeth<long double> fine_;
    std::vector<Pose<double>> poses_;
    std::vector<double> scratch_;
    double half_ = 0, step_ = 0, slack_ = 0;
    int reach_ = 3;
};

}  // namespace oracle
