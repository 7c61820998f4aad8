// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest distance between a point of one member and any tooth of the other over a full turn.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <span>

#include "hdconj/distance/clearance_marcher.hpp"
#include "hdconj/motion/inverse_motion.hpp"

namespace hdconj::distance {

/// Stations a lobe in which full turns are marched.
inline constexpr int turn_positions = 384;

/// min over u in a full turn and over all flexspline teeth of the signed distance from a point of the circular spline.
///
/// All teeth do the same motion one pitch apart, so one lobe of one tooth and the neighbours that reach the point are a
/// full turn.
template <motion::RelativeMotion Motion>
class FullTurnClearance
{
  public:
    /// @param lobe_pitches  pitches that the tooth moves along the circular spline in one lobe, (z_c - z_f)/n
    FullTurnClearance(profile::Profile const& profile, Motion const& motion, double pitch, int lobe_pitches,
                      int positions = turn_positions)
        : tooth_(profile),
          lanes_(tooth_lanes(profile)),
          march_(tooth_, motion, positions),
          pitch_(pitch),
          reach_((lobe_pitches + 1) / 2 + 1)
    {
    }
    FullTurnClearance(FullTurnClearance const&) = delete;
    FullTurnClearance& operator=(FullTurnClearance const&) = delete;

    [[nodiscard]] std::size_t positions() const { return march_.positions(); }

    /// Neighbouring points for which looking around for a first bound once is little: 0.1 ms and more of work.
    [[nodiscard]] std::size_t block() const { return lanes_ ? 64 : 16; }

    /// @param p     a point within one pitch of the y axis, circular-spline frame
    /// @param hint  result at a neighbouring point; saves looking around for a first bound
    /// @returns the minimum; `copy` is the tooth this many pitches clockwise
    [[nodiscard]] TurnMinimum operator()(Vec2 const& p, TurnMinimum const* hint = nullptr) const
    {
        TurnMinimum best;
        if (hint != nullptr)
            march_.look_at(turned_clockwise(p, -hint->copy * pitch_), hint->station, hint->copy, best);
        for (int copy = -reach_; copy <= reach_; ++copy)
            march_(copy == 0 ? p : turned_clockwise(p, -copy * pitch_), copy, best);
        return best;
    }

    /// The minimum at each of neighbouring @p points, into @p minima; on a tooth of arcs and lines several points at
    /// once.
    /// @param hint  result at a point next to the first
    void operator()(std::span<Vec2 const> points, TurnMinimum const* hint, std::span<TurnMinimum> minima) const
    {
        TurnMinimum around;
        if (hint == nullptr && !points.empty()) {
            // a first bound: marching without one looks at every station on the way to it
            constexpr std::size_t apart = 8;
            for (std::size_t station = 0; station < march_.positions(); station += apart)
                march_.look_at(points[0], station, 0, around);
            hint = &around;
        }
        std::size_t i = 0;
        for (; lanes_ && i < points.size(); i += lanes) {
            std::size_t const count = std::min(lanes, points.size() - i);
            std::array<TurnMinimum, lanes> const best = together(points.subspan(i, count), *hint);
            std::copy_n(best.begin(), count, minima.begin() + static_cast<std::ptrdiff_t>(i));
            hint = &minima[i + count - 1];
        }
        for (; i < points.size(); ++i) {
            minima[i] = (*this)(points[i], hint);
            hint = &minima[i];
        }
    }

  private:
    /// At most as many points as there are lanes; the last one fills the rest.
    [[nodiscard]] std::array<TurnMinimum, lanes> together(std::span<Vec2 const> points, TurnMinimum const& hint) const
    {
        std::array<Vec2, lanes> at;
        std::array<TurnMinimum, lanes> best;
        auto const place = [&](int copy) {
            for (std::size_t l = 0; l < lanes; ++l) {
                Vec2 const& p = points[std::min(l, points.size() - 1)];
                at[l] = copy == 0 ? p : turned_clockwise(p, -copy * pitch_);
            }
        };
        place(hint.copy);
        for (std::size_t l = 0; l < lanes; ++l)
            march_.look_at(at[l], hint.station, hint.copy, best[l]);
        for (int copy = -reach_; copy <= reach_; ++copy) {
            place(copy);
            march_(*lanes_, at, copy, best);
        }
        return best;
    }

    ToothDistance tooth_;
    std::optional<ToothLanes> lanes_;
    ClearanceMarcher<Motion> march_;
    double pitch_;
    int reach_;  ///< neighbours on either side: half the lobe's pitches, and one for the tooth's own width
};

/// Minimum over u in a full turn, and over all circular-spline teeth, of the signed distance from a point of the
/// flexspline tooth.
///
/// Each circular-spline tooth has a motion of its own in the flexspline tooth's frame. What one tooth does in the next
/// wave, another one does in this wave. So one wave of the teeth that can reach the flexspline tooth is a full turn.
template <motion::RelativeMotion Motion>
class ReverseFullTurnClearance
{
  public:
    /// @param profile       the circular-spline tooth
    /// @param motion        of the flexspline tooth
    /// @param radius        of the origin of the circular-spline tooth's frame
    /// @param lobe_pitches  (z_c - z_f)/n
    ReverseFullTurnClearance(profile::Profile const& profile, Motion const& motion, double pitch, double radius,
                             int lobe_pitches, int positions = turn_positions)
        : tooth_(profile), first_(-((lobe_pitches + 1) / 2))
    {
        // teeth that pass the flexspline tooth's centre line, and one more on either side
        for (int k = first_; k <= 1 - first_; ++k) {
            motions_.emplace_back(motion, motion::circular_spline_seat(k, pitch, radius));
            marches_.emplace_back(tooth_, motions_.back(), positions);
        }
    }
    ReverseFullTurnClearance(ReverseFullTurnClearance const&) = delete;
    ReverseFullTurnClearance& operator=(ReverseFullTurnClearance const&) = delete;

    [[nodiscard]] std::size_t positions() const { return marches_.front().positions(); }
    /// As of FullTurnClearance.
    [[nodiscard]] static std::size_t block() { return 16; }

    /// @param p     a point in the frame of the flexspline tooth
    /// @param hint  result at a neighbouring point
    /// @returns the minimum; `copy` is the number of the circular-spline tooth
    [[nodiscard]] TurnMinimum operator()(Vec2 const& p, TurnMinimum const* hint = nullptr) const
    {
        TurnMinimum best;
        if (hint != nullptr)
            marches_[static_cast<std::size_t>(hint->copy - first_)].look_at(p, hint->station, hint->copy, best);
        for (std::size_t i = 0; i < marches_.size(); ++i)
            marches_[i](p, first_ + static_cast<int>(i), best);
        return best;
    }

    /// The minimum at each of neighbouring @p points, into @p minima.
    void operator()(std::span<Vec2 const> points, TurnMinimum const* hint, std::span<TurnMinimum> minima) const
    {
        for (std::size_t i = 0; i < points.size(); ++i) {
            minima[i] = (*this)(points[i], hint);
            hint = &minima[i];
        }
    }

  private:
    ToothDistance tooth_;
    int first_;                                          ///< number of the first tooth
    std::deque<motion::InverseMotion<Motion>> motions_;  // the marches keep pointers to them
    std::deque<ClearanceMarcher<motion::InverseMotion<Motion>>> marches_;
};

}  // namespace hdconj::distance
