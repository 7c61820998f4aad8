// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The smallest distance between a point of the circular spline and any flexspline tooth over a full turn.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "hdconj/contact/tooth_distance.hpp"
#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/numeric/bracketed_root.hpp"

namespace hdconj {

/// Smallest distance and where it happens.
struct TurnMinimum
{
    double distance = std::numeric_limits<double>::infinity();  ///< [mm]
    double u = 0;        ///< parameter of the motion
    int copy = 0;        ///< the tooth this many pitches clockwise
};

/// min over u in a full turn and over all teeth of the signed distance from a point to the tooth.
///
/// All teeth do the same motion one pitch apart, so one lobe of one tooth and the neighbours that reach the point are a full turn.
/// The distance is looked at in `positions` places of the lobe; each local minimum that the speed of the tooth could bring
/// below the smallest value seen is refined to the zero of its derivative, d' = -n.v.
/// Accuracy: roundoff of the coordinates at each minimum; a minimum is missed only if the distance has two within one step of the lobe.
template<RelativeMotion Motion>
class FullTurnClearance
{
  public:
    /// @param lobe_pitches  pitches that the tooth moves along the circular spline in one lobe, (z_c - z_f)/n
    FullTurnClearance(Profile const& profile, Motion const& motion, double pitch, int lobe_pitches, int positions = 384)
        : tooth_(profile), motion_(motion), pitch_(pitch), reach_((lobe_pitches + 1) / 2 + 1), step_(2 * motion.half_lobe() / positions)
    {
        for (int i = 0; i <= positions; ++i)
        {
            double const u = -motion.half_lobe() + step_ * i;
            poses_.push_back(motion.pose(u));
            twists_.push_back(motion.rates(u).twist);
        }
        near_ = (profile.addendum + profile.dedendum) / 8;
    }

    [[nodiscard]] std::size_t positions() const { return poses_.size(); }

    /// @param p  a point within one pitch of the y axis, circular-spline frame
    [[nodiscard]] TurnMinimum operator()(Vec2 const& p) const
    {
        TurnMinimum best;
        for (int copy = -reach_; copy <= reach_; ++copy)
            look(turned_clockwise(p, -copy * pitch_), copy, best);
        return best;
    }

  private:
    void look(Vec2 const& p, int copy, TurnMinimum& best) const
    {
        double before = std::numeric_limits<double>::infinity();
        double now = coarse(p, 0);
        for (std::size_t i = 0; i < poses_.size(); ++i)
        {
            double const after = i + 1 < poses_.size() ? coarse(p, i + 1) : std::numeric_limits<double>::infinity();
            if (now <= before && now <= after && now < near_)
            {
                if (now < best.distance)
                    best = {now, parameter(i), copy};
                double const speed = twists_[i](poses_[i].inverse(p)).norm();
                // twice the mean-value bound, for the change of speed over the step
                if (now - 2 * speed * step_ < best.distance)
                    refine(p, i, copy, best);
            }
            before = now;
            now = after;
        }
    }

    [[nodiscard]] double parameter(std::size_t i) const { return -motion_.half_lobe() + step_ * static_cast<double>(i); }

    /// Distance, or a lower bound of it where that is far.
    [[nodiscard]] double coarse(Vec2 const& p, std::size_t i) const
    {
        Vec2 const x = poses_[i].inverse(p);
        double const bound = tooth_.lower_bound(x);
        return bound > near_ ? bound : tooth_(x).distance;
    }

    void refine(Vec2 const& p, std::size_t i, int copy, TurnMinimum& best) const
    {
        auto const slope = [&](double u) {
            Vec2 const x = motion_.pose(u).inverse(p);
            NearestPoint const foot = tooth_(x);
            if (foot.distance < best.distance)
                best = {foot.distance, u, copy};
            return -foot.normal.dot(motion_.rates(u).twist(x));
        };
        double const a = parameter(i == 0 ? 0 : i - 1);
        double const b = parameter(std::min(i + 1, poses_.size() - 1));
        double const fa = slope(a);
        double const fb = slope(b);
        if (fa < 0 && fb > 0)
            (void)bracketed_root(slope, a, b, fa, fb);
        else
            (void)slope(0.5 * (a + b));
    }

    ToothDistance tooth_;
    Motion const& motion_;
    double pitch_;
    int reach_;  ///< neighbours on either side: half the lobe's pitches, and one for the tooth's own width
    double step_;
    double near_ = 0;
    std::vector<Pose> poses_;
    std::vector<Twist> twists_;
};

}  // namespace hdconj
