// SPDX-License-Identifier: GPL-3.0-or-later
// The reverse view: a circular-spline tooth as it moves in the frame of the flexspline tooth.
#pragma once

#include <cmath>
#include <span>
#include <utility>

#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::motion {

/// Frame of circular-spline tooth @p k in the circular-spline frame. Tooth k stands (k - 1/2) pitches clockwise of the
/// y axis, so that 0 and 1 are the walls of the space there. Its origin is at @p radius from the axis, y towards the
/// axis: turned clockwise by that angle and pi.
[[nodiscard]] inline Pose circular_spline_seat(int k, double pitch, double radius)
{
    double const angle = (k - 0.5) * pitch;
    double const s = std::sin(angle);
    double const c = std::cos(angle);
    return {-c, -s, {radius * s, radius * c}};
}

/// A body that rests in the circular-spline frame at `seat` (x -> G x + b_0), seen from the flexspline tooth. That
/// tooth's motion is p = R x + P with velocity v(x) = omega right_of(x) + q in its own frame:
///
///   pose   A = R^T G,  b = R^T (b_0 - P)
///   twist  -omega,  -A^T v(b)
///   change -omega',  -A^T v'(b),   v'(x) = omega' right_of(x) + q'
///
/// The last line has no further terms: those from A' and b' = -v(b) cancel. After one wave, P and R are those of before
/// turned by (z_c - z_f)/n pitches. So tooth k does in the next wave what tooth k - (z_c - z_f)/n does in this one.
/// Choose the seat near the tooth: b is then of the tooth's size. Accuracy: that of the motion's own P, some roundings
/// of its radius.
template <RelativeMotion Motion>
class InverseMotion
{
  public:
    InverseMotion(Motion motion, Pose const& seat) : motion_(std::move(motion)), seat_(seat) {}

    [[nodiscard]] double half_lobe() const { return motion_.half_lobe(); }
    [[nodiscard]] std::span<double const> breaks() const { return motion_.breaks(); }
    /// One body alone is not its own mirror image; the bodies k and 1 - k are each other's where the motion is
    /// symmetric.
    [[nodiscard]] static bool symmetric() { return false; }
    [[nodiscard]] ToothAngles angles(double u) const { return motion_.angles(u); }

    [[nodiscard]] Pose pose(double u) const
    {
        Pose const tooth = motion_.pose(u);
        return {seat_.cosine * tooth.cosine + seat_.sine * tooth.sine,
                seat_.sine * tooth.cosine - seat_.cosine * tooth.sine, tooth.inverse(seat_.origin)};
    }

    [[nodiscard]] MotionRates rates(double u) const
    {
        MotionRates const tooth = motion_.rates(u);
        Pose const here = pose(u);
        Vec2 const b = here.origin;
        double const omega = std::abs(tooth.twist.omega);
        double const omega_change = std::abs(tooth.change.omega);
        // b is the difference of two lengths of this size
        double const lever = b.norm() + 2 * seat_.origin.norm();
        return {{-tooth.twist.omega, -here.rotate_back(tooth.twist(b))},
                {-tooth.change.omega, -here.rotate_back(tooth.change(b))},
                tooth.omega_size,
                tooth.velocity_size(b) + omega * lever,
                tooth.omega_change_size,
                tooth.velocity_change_size(b) + omega_change * lever};
    }

  private:
    Motion motion_;
    Pose seat_;
};

}  // namespace hdconj::motion
