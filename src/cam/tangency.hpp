// SPDX-License-Identifier: GPL-3.0-or-later
// Where the flanks of two given teeth touch: the inclination of the flexspline's tooth at a given place.
#pragma once

#include <optional>
#include <vector>

#include "flank.hpp"
#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::cam {

/// The place of the flexspline tooth's origin, rho (sin gamma, cos gamma) from the axis. It is told from the point (0,
/// r_m), and so are all points of the circular spline here: rounding is then that of the displacement, some thousand
/// times smaller than that of the radius. An error at the major axis grows by as much towards the end of the mesh.
struct ToothOrigin
{
    double r_m = 0;    ///< [mm]
    double w = 0;      ///< rho - r_m [mm]
    double gamma = 0;  ///< [rad]

    [[nodiscard]] double rho() const { return r_m + w; }
    [[nodiscard]] Vec2 point() const
    {
        double const half = std::sin(gamma / 2);
        return {rho() * std::sin(gamma), w - 2 * rho() * half * half};
    }
};

/// Frame of the circular-spline tooth that is the right wall of the space about the y axis, from (0, r_m).
/// @param angle   of the tooth's middle, half a pitch [rad]
/// @param height  radius of its frame's origin less r_m [mm]
[[nodiscard]] Pose right_wall(double angle, double r_m, double height);

/// A tangency of the two flanks.
struct Tangency
{
    FlankPlace inner;  ///< on the flexspline's right flank
    FlankPlace outer;  ///< on the right wall of the circular spline's space
    double theta = 0;  ///< turn of the tooth's frame at which they touch [rad]
    double lever = 0;  ///< how fast they approach each other as theta grows [mm]
};

/// Right flank of the flexspline tooth against the right wall of a tooth space of the circular spline.
///
/// Flanks A(s) in the frame of the tooth and B(t) in that of the circular spline touch where
///   R(theta) A + P = B,   T_A . N_B = 0
/// with the unit tangent T_A in the frame of the circular spline and the normal N_B: three equations for s, t and
/// theta. With the origin P given this is the condition g(rho, gamma, theta) = 0 of docs/explanation/theory.md.
/// Newton's method with the curvatures of both flanks solves them. Accuracy: some roundings of rho over the lever.
class FlankPair
{
  public:
    /// @param seat    right_wall()
    /// @param offset  the flexspline's flank is moved outward by it along its normal, to see what an error does [mm]
    FlankPair(Flank inner, Flank outer, Pose const& seat, double offset = 0);

    /// The tangency near @p seed; none where the search ends beyond the end of a flank, or where the flanks cross.
    [[nodiscard]] std::optional<Tangency> refined(Tangency const& seed, ToothOrigin const& origin) const;

    /// All tangencies that samples of both flanks show near @p theta, smallest theta first.
    [[nodiscard]] std::vector<Tangency> tangencies(ToothOrigin const& origin, double theta) const;

    /// Point of the wall from (0, r_m).
    [[nodiscard]] Vec2 wall_point(FlankPlace const& place) const { return seat_(outer_.at(place).point); }

    /// The same pair with the flexspline's flank moved by @p offset.
    [[nodiscard]] FlankPair moved(double offset) const { return {inner_, outer_, seat_, offset}; }

    [[nodiscard]] Flank const& inner() const { return inner_; }
    [[nodiscard]] Flank const& outer() const { return outer_; }
    [[nodiscard]] double offset() const { return offset_; }

  private:
    struct Sample
    {
        FlankPlace place;
        Vec2 point, normal;
    };
    /// The sample of the wall nearest to @p p. @param guess  one of them, perhaps near
    [[nodiscard]] Sample const& nearest(Vec2 const& p, Sample const& guess) const;

    Flank inner_, outer_;
    Pose seat_;
    double offset_;
    std::vector<Sample> inner_samples_;  ///< in the frame of the tooth
    std::vector<Sample> outer_samples_;  ///< in the frame of the circular spline
    double outer_spacing_ = 0;           ///< largest distance of neighbours among them
};

}  // namespace hdconj::cam
