// SPDX-License-Identifier: GPL-3.0-or-later
// The concept behind every motion model: flexspline tooth relative to the circular spline.
#pragma once

#include <concepts>
#include <span>

#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::motion {

/// Velocity of the tooth in its own frame and its derivative with respect to the motion's parameter.
struct MotionRates
{
    PlanarVelocity twist;   ///< theta', q = R^T P'
    PlanarVelocity change;  ///< d/du of theta' and of the components of q

    /// Sizes of the terms that these are summed from: a rate is right to some roundings of its size. q is the
    /// difference of two lengths near r_m, so its size is r_m.
    double omega_size = 1;
    double q_size = 1;
    double omega_change_size = 1;
    double q_change_size = 1;

    /// Size of the terms of the velocity of a point, and of its change.
    [[nodiscard]] double velocity_size(Vec2 const& x) const { return omega_size * x.norm() + q_size; }
    [[nodiscard]] double velocity_change_size(Vec2 const& x) const
    {
        return omega_change_size * x.norm() + q_change_size;
    }
};

/// Where the tooth is and how it moves.
struct MotionState
{
    Pose pose;
    MotionRates rates;
};

/// The tooth's polar angle u and undeformed angle phi [rad].
struct ToothAngles
{
    double u;
    double phi;
};

/// A one-parameter motion of the flexspline tooth in the circular-spline frame. The parameter is u for the exact model
/// and phi for the others; one wave is (-pi/n, pi/n] in either. PlanarVelocity and pose are continuous, and analytic
/// between breaks(). At a break `change` is that of the side of larger u. symmetric(): the pose at -u is the mirror
/// image of that at u.
template <class M>
concept RelativeMotion = requires(M const& m, double u)
{
    {
        m.pose(u)
        } -> std::same_as<Pose>;
    {
        m.rates(u)
        } -> std::same_as<MotionRates>;
    {
        m.angles(u)
        } -> std::same_as<ToothAngles>;
    {
        m.half_lobe()
        } -> std::convertible_to<double>;
    {
        m.breaks()
        } -> std::convertible_to<std::span<double const>>;
    {
        m.symmetric()
        } -> std::convertible_to<bool>;
};

/// pose() and rates() of @p motion at once, with the same bits; at the price of little more than one where the motion
/// has a state() of its own.
template <RelativeMotion Motion>
[[nodiscard]] MotionState state_of(Motion const& motion, double u)
{
    if constexpr (requires {
                      {
                          motion.state(u)
                          } -> std::same_as<MotionState>;
                  })
        return motion.state(u);
    else
        return {motion.pose(u), motion.rates(u)};
}

}  // namespace hdconj::motion
