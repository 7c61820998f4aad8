// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law's left side: the smallest signed distance of a point of the circular-spline frame
/// to the tooth over a full turn, all teeth, by brute force.
///
/// After one lobe (2 pi / n) the motion repeats, moved by (z_c - z_f) / n pitches, and the teeth
/// follow one another by one pitch. So "all teeth, full turn" is one tooth over one lobe and copies
/// turned by whole pitches.
///
/// The scan finds every local minimum that can matter: between two scan positions the distance
/// changes by no more than the frame moves there, so that the smallest value belongs to the
/// neighbourhood of a local minimum of the scan not more than `slack` above its smallest value.
/// Each of these is scanned again more finely and refined by golden section.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "golden.hpp"
#include "motion.hpp"
#include "tooth.hpp"

namespace oracle {

class TouchScan
{
  public:
    explicit TouchScan(hdconj::Scene const& scene, std::size_t positions = 2400)
        : tooth(scene), motion(scene), fine_tooth_(scene), fine_motion_(scene)
    {
        half_ = motion.half_lobe();
        step_ = 2 * half_ / static_cast<double>(positions);
        for (std::size_t i = 0; i <= positions + 1; ++i)
            poses_.push_back(motion.pose(position(static_cast<double>(i))));
        // Largest motion of any point near the tooth in one step.
        double const wide = 1.5 * tooth.half_width, below = tooth.pitch_line - 1.5 * tooth.dedendum;
        double const above = tooth.top + 0.5 * tooth.addendum;
        for (std::size_t i = 0; i + 1 < poses_.size(); ++i)
            for (Point<double> const corner : {Point<double>{-wide, below}, Point<double>{wide, below},
                                               Point<double>{-wide, above}, Point<double>{wide, above}})
                slack_ = std::max(
                    slack_, length(poses_[i + 1].to_circular_spline(corner) - poses_[i].to_circular_spline(corner)));
        // Widest angle a tooth reaches from the y axis decides how many copies can come near.
        double reach = 0;
        for (auto const& pose : poses_)
            reach = std::max(reach, std::abs(std::atan2(pose.origin.x, pose.origin.y)));
        copies_ = static_cast<int>(std::ceil(reach / motion.pitch())) + 2;
        scratch_.resize(poses_.size());
    }

    /// Signed distance of @p p to the tooth at position @p s.
    double distance(Point<double> const& p, double s, int copy = 0) const
    {
        return tooth.distance(motion.pose(s).to_tooth(turned_clockwise(p, -copy * motion.pitch())));
    }

    /// The same in long double.
    long double fine_distance(Point<double> const& p, double s, int copy) const
    {
        using Fine = long double;
        Point<Fine> const turned = turned_clockwise(as<Fine>(p), -static_cast<Fine>(copy) * fine_motion_.pitch());
        return fine_tooth_.distance(fine_motion_.pose(static_cast<Fine>(s)).to_tooth(turned));
    }

    /// The smallest signed distance of @p p over all positions and teeth, the last step in long double.
    Touch nearest(Point<double> const& p)
    {
        double best = std::numeric_limits<double>::infinity();
        std::vector<Candidate> candidates;
        for (int copy = -copies_; copy <= copies_; ++copy)
            scan(turned_clockwise(p, -copy * motion.pitch()), copy, best, candidates);
        Touch touch;
        for (auto const& candidate : candidates)
            if (candidate.distance <= best + slack_)
                refine(p, candidate, touch);
        if (touch.distance < std::numeric_limits<double>::infinity())
            touch.distance = static_cast<double>(fine_distance(p, touch.s, touch.copy));
        return touch;
    }

    Tooth<double> tooth;
    Motion<double> motion;

  private:
    struct Candidate
    {
        std::size_t index;
        int copy;
        double distance;
    };

    double position(double index) const { return -half_ + step_ * index; }

    /// Positions at which the tooth cannot have come near since the one before are left out: in a step the distance
    /// changes by no more than the tooth moves.
    void scan(Point<double> const& p, int copy, double& best, std::vector<Candidate>& candidates)
    {
        double const infinity = std::numeric_limits<double>::infinity();
        std::size_t away = 0;
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            scratch_[i] = infinity;
            if (away > 0) {
                --away;
                continue;
            }
            auto const& pose = poses_[i];
            Point<double> const d = p - pose.origin;
            double const y = dot(d, pose.outward), x = std::abs(dot(d, pose.along));
            double const far = best + 2 * slack_;
            if (y - tooth.top > far || x - tooth.half_width > far)
                continue;
            scratch_[i] = tooth.distance({x, y});
            best = std::min(best, scratch_[i]);
            away = static_cast<std::size_t>(std::max(0.0, (scratch_[i] - best) / (2 * slack_) - 1));
        }
        for (std::size_t i = 1; i + 1 < scratch_.size(); ++i)
            if (scratch_[i] < infinity && scratch_[i] <= scratch_[i - 1] && scratch_[i] <= scratch_[i + 1])
                candidates.push_back({i, copy, scratch_[i]});
    }

    void refine(Point<double> const& p, Candidate const& candidate, Touch& touch) const
    {
        constexpr int parts = 24;
        Point<double> const turned = turned_clockwise(p, -candidate.copy * motion.pitch());
        auto const at = [&](double s) { return tooth.distance(motion.pose(s).to_tooth(turned)); };
        double const from = position(static_cast<double>(candidate.index) - 1), part = 2 * step_ / parts;
        std::array<double, parts + 1> value{};
        for (int i = 0; i <= parts; ++i)
            value[static_cast<std::size_t>(i)] = at(from + part * i);
        for (int i = 0; i <= parts; ++i) {
            auto const k = static_cast<std::size_t>(i);
            bool const low = (i == 0 || value[k] <= value[k - 1]) && (i == parts || value[k] <= value[k + 1]);
            if (!low || value[k] > touch.distance + slack_)
                continue;
            golden(at, from + part * (i - 1), from + part * (i + 1), candidate.copy, touch);
        }
    }

    Tooth<long double> fine_tooth_;
    Motion<long double> fine_motion_;
    std::vector<Pose<double>> poses_;
    std::vector<double> scratch_;
    double half_ = 0, step_ = 0, slack_ = 0;
    int copies_ = 3;
};

}  // namespace oracle
