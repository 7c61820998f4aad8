// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest distance between a point and one moving tooth over a lobe of the wave generator.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "hdconj/distance/lowest_point.hpp"
#include "hdconj/distance/tooth_distance.hpp"
#include "hdconj/distance/tooth_lanes.hpp"
#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::distance {

/// Smallest distance and where it happens.
struct TurnMinimum
{
    double distance = std::numeric_limits<double>::infinity();  ///< [mm]
    double u = 0;                                               ///< parameter of the motion
    int copy = 0;                                               ///< which tooth
    std::size_t station = 0;                                    ///< nearest of the stations evaluated
};

/// Minimum over u in one wave of the signed distance from a fixed point to the tooth.
///
/// The distance changes no faster than the point moves in the tooth's frame. From a position where it is d, the next
/// one that can hold less than the best b is therefore (d - b)/speed away, and everything between is skipped. Around
/// positions that cannot be skipped, a change of sign of the derivative d' = -n.v is refined to the minimum.
///
/// Accuracy: some roundings of the coordinates at each minimum, u to half the digits. Positions are 1/384 of a wave
/// apart. If only the higher of two minima within one step is found, the error is at most the square of the step times
/// the curvature of the distance. Keeps pointers to @p tooth and @p motion.
template <motion::RelativeMotion Motion>
class ClearanceMarcher
{
  public:
    ClearanceMarcher(ToothDistance const& tooth, Motion const& motion, int positions)
        : tooth_(&tooth), motion_(&motion), step_(2 * motion.half_lobe() / positions)
    {
        for (int i = 0; i <= positions; ++i) {
            double const u = parameter(static_cast<std::size_t>(i));
            motion::MotionState const state = motion::state_of(motion, u);
            PlanarVelocity const& twist = state.rates.twist;
            poses_.push_back(state.pose);
            twists_.push_back(twist);
            fastest_turn_ = std::max(fastest_turn_, std::abs(twist.omega));
            fastest_shift_ = std::max(fastest_shift_, twist.q.norm());
        }
        // between stations the rates exceed the largest one seen by a second-order amount
        constexpr double margin = 1.01;
        fastest_turn_ *= margin;
        fastest_shift_ *= margin;
    }

    [[nodiscard]] std::size_t positions() const { return poses_.size(); }

    /// Looks at one station and keeps what is less than @p best, under the name @p copy.
    void look_at(Vec2 const& p, std::size_t station, int copy, TurnMinimum& best) const
    {
        (void)look(p, station, copy, best);
    }

    /// Searches the whole lobe for less than @p best.
    void operator()(Vec2 const& p, int copy, TurnMinimum& best) const
    {
        std::size_t last = 0;
        Station before{std::numeric_limits<double>::infinity(), 0, 0};
        for (std::size_t i = 0; i < poses_.size();) {
            Station const now = look(p, i, copy, best);
            bool const adjoining = i > 0 && last == i - 1;
            bool const dips = before.slope < 0 && now.slope > 0;
            if (adjoining && dips && lowest_between(before, now) < best.distance)
                refine(p, i, copy, before, now, best);
            last = i;
            before = now;
            i += skipped((now.distance - best.distance) / (now.speed * step_));
        }
    }

    /// Searches the whole wave for less than each of @p best, for neighbouring points at once. The points share the
    /// positions that any of them needs; what is found is evaluated again point by point where it matters.
    void operator()(ToothLanes const& tooth, std::array<Vec2, lanes> const& p, int copy,
                    std::array<TurnMinimum, lanes>& best) const
    {
        Lanes x, y, distance, slope;
        double spread = 0;
        for (std::size_t l = 0; l < lanes; ++l) {
            x[l] = p[l].x();
            y[l] = p[l].y();
            spread = std::max(spread, (p[l] - p[0]).norm());
        }
        std::array<Station, lanes> before{};
        std::size_t last = poses_.size();  // none yet
        for (std::size_t i = 0; i < poses_.size();) {
            Vec2 const at = poses_[i].inverse(p[0]);
            double const speed = fastest_shift_ + fastest_turn_ * (at.norm() + spread);
            double const bound = tooth_->lower_bound(at) - spread;
            double highest = best[0].distance;
            for (TurnMinimum const& minimum : best)
                highest = std::max(highest, minimum.distance);
            if (bound > highest + speed * step_) {
                last = poses_.size();
                i += skipped((bound - highest) / (speed * step_));
                continue;
            }
            tooth(poses_[i], twists_[i], x, y, distance, slope);
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t l = 0; l < lanes; ++l) {
                Station const now{distance[l], slope[l], speed};
                if (now.distance < best[l].distance)
                    (void)look(p[l], i, copy, best[l]);
                bool const dips = i > 0 && last == i - 1 && before[l].slope < 0 && now.slope > 0;
                if (dips && lowest_between(before[l], now) < best[l].distance)
                    refine(p[l], i, copy, before[l], now, best[l]);
                nearest = std::min(nearest, now.distance - best[l].distance);
                before[l] = now;
            }
            last = i;
            i += skipped(nearest / (speed * step_));
        }
    }

  private:
    struct Station
    {
        double distance;
        double slope;
        double speed;  ///< no faster anywhere near
    };

    /// Lower bound of a dip between two adjoining positions. It follows from the point's speed, and, where there is one
    /// dip, from twice the steeper of the slopes at its two sides.
    [[nodiscard]] double lowest_between(Station const& before, Station const& now) const
    {
        double const steepest = std::min(now.speed, 2 * std::max(-before.slope, now.slope));
        return std::min(before.distance, now.distance) - steepest * step_;
    }

    /// Stations to go on where @p safe steps hold nothing: landing one station short keeps the two sides of a dip
    /// adjoining.
    [[nodiscard]] std::size_t skipped(double safe) const
    {
        return safe > 2 ? static_cast<std::size_t>(std::min(safe - 1, static_cast<double>(poses_.size()))) : 1;
    }

    [[nodiscard]] double parameter(std::size_t i) const
    {
        return -motion_->half_lobe() + step_ * static_cast<double>(i);
    }

    /// Distance at station @p i; where it is far, a lower bound with no slope.
    [[nodiscard]] Station look(Vec2 const& p, std::size_t i, int copy, TurnMinimum& best) const
    {
        Vec2 const x = poses_[i].inverse(p);
        double const speed = fastest_shift_ + fastest_turn_ * x.norm();
        double const bound = tooth_->lower_bound(x);
        if (bound > best.distance + speed * step_)
            return {bound, 0, speed};
        NearestPoint const foot = (*tooth_)(x);
        if (foot.distance < best.distance)
            best = {foot.distance, parameter(i), copy, i};
        return {foot.distance, -foot.normal.dot(twists_[i](x)), speed};
    }

    void refine(Vec2 const& p, std::size_t i, int copy, Station const& before, Station const& now,
                TurnMinimum& best) const
    {
        auto const look = [&](double u) {
            motion::MotionState const state = motion::state_of(*motion_, u);
            Vec2 const x = state.pose.inverse(p);
            NearestPoint const foot = (*tooth_)(x);
            if (foot.distance < best.distance)
                best = {foot.distance, u, copy, i};
            return BracketEnd{u, foot.distance, -foot.normal.dot(state.rates.twist(x))};
        };
        minimise_bracketed(look, {parameter(i - 1), before.distance, before.slope},
                           {parameter(i), now.distance, now.slope}, unit_roundoff * p.norm());
    }

    ToothDistance const* tooth_;
    Motion const* motion_;
    double step_;
    double fastest_turn_ = 0;
    double fastest_shift_ = 0;
    std::vector<Pose> poses_;
    std::vector<PlanarVelocity> twists_;
};

}  // namespace hdconj::distance
