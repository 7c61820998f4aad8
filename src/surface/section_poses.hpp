// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth poses in planes across a coned cup whose wall has moved along the axis too.
#pragma once

#include <functional>
#include <vector>

#include "coning.hpp"
#include "hdconj/motion/any_motion.hpp"

namespace hdconj::surface {

/// The section of one tooth by planes z = const.
///
/// Through the plane at z passes the part of the tooth that lies at z - u_z(phi) when undeformed: its amplitude is f(z
/// - u_z), and what the wall does from one phi to the next has a part from f too. Position: that of the slice with this
/// amplitude. Direction: the normal of the section curve, which is the projection of the wall's own normal; it differs
/// from the slice's by the angle between dP/dphi with and without df/dphi. Between slices the wall is straight along z,
/// so v(phi, z), and with it the tooth's skew, follows from the amplitude.
///
/// Poses are interpolated in the amplitude between Chebyshev nodes, to the power `nodes`: analytic and nearly linear,
/// so that 8 nodes are right to roundoff (1e-13 mm on type-50 over its width). With u_z = 0 this is the slice itself.
/// Where motions are told by another coordinate along the axis, such as the height of an elastic wall, that takes the
/// place of the amplitude.
class SectionPoses
{
  public:
    /// A motion for the slice of any amplitude.
    using MotionOf = std::function<motion::AnyMotion(double factor)>;
    static constexpr int nodes = 8;

    /// @param low, high  amplitude factors met [1]
    /// @param motion_of  motion of a factor; what it refers to must outlive this
    /// @param count      nodes: more where motions are less smooth along the axis
    SectionPoses(double low, double high, double tooth_ratio, MotionOf const& motion_of, int count = nodes);

    /// Pose of the tooth at @p phi where the amplitude is @p factor and changes by @p factor_slope per rad of phi.
    /// @param parameter_at  the motion's parameter for phi
    [[nodiscard]] Pose operator()(double phi, double factor, double factor_slope) const;

  private:
    struct Sample
    {
        double theta;
        Vec2 origin;
        Vec2 tangent;  ///< dP/dphi in the fixed frame, along the axes of the circular-spline frame
    };
    [[nodiscard]] Sample sample(motion::AnyMotion const& motion, double phi) const;

    double ratio_;
    std::vector<double> factor_;
    std::vector<motion::AnyMotion> motion_;
};

}  // namespace hdconj::surface
