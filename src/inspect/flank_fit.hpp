// SPDX-License-Identifier: GPL-3.0-or-later
// The parabola of least squares through the deviations of one flank, and where the flank stands.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "placement.hpp"

namespace hdconj::inspect {

/// The points of one flank, as indices, and which flank it is.
struct FlankGroup
{
    std::size_t plane = 0;
    int tooth = 0;  ///< from 0
    bool right = false;
    std::vector<std::size_t> points;
};

/// The parabola a + b xi - c xi^2 through deviations against xi = 2 s/L - 1, -1 at the root end of the flank and 1 at
/// its tip end, in the order of rising arc length s.
struct FlankParabola
{
    std::vector<std::size_t> points;  ///< indices, in order
    std::vector<double> arc_length, deviation, remainder;
    Eigen::Vector3d coefficient = Eigen::Vector3d::Zero();  ///< a, b, -c
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();   ///< of the coefficients, for noise of variance 1
    Eigen::Vector3d by_turn = Eigen::Vector3d::Zero();      ///< their change with a turn of the part [mm/rad]
    Eigen::Matrix<double, 3, 2> by_shift = Eigen::Matrix<double, 3, 2>::Zero();  ///< with a shift, frame of the tooth
};

/// A flank turned to its own position, where a = 0.
struct FlankFit
{
    FlankGroup group;                 ///< its points without strays
    std::vector<std::size_t> strays;  ///< points that were left out
    FlankParabola parabola;           ///< after the turn
    double turn = 0;                  ///< beyond the placement, clockwise [rad]
    /// Change of turn, b and -c with the coefficients of the parabola before the turn.
    Eigen::Matrix3d by_coefficients = Eigen::Matrix3d::Zero();
    /// Of turn, b and -c, for noise of variance 1.
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Which share of a flank its points must span.
inline constexpr double least_cover = 0.5;
/// Fewest points of a flank: one more than the parabola has coefficients.
inline constexpr std::size_t fewest_points = 4;

/// The parabola through the points of @p group whose feet are on the flank; nothing where they are too few or span too
/// little of it.
[[nodiscard]] std::optional<FlankParabola> flank_parabola(PointReader const& read,
                                                          std::vector<PlanePoint> const& points,
                                                          FlankGroup const& group, Placement const& placement);

/// Turns the flank until the parabola is 0 at the middle. @returns nothing where the points are too few
[[nodiscard]] std::optional<FlankFit> flank_fit(PointReader const& read, std::vector<PlanePoint> const& points,
                                                FlankGroup group, Placement const& placement);

/// Sum of squares of the second differences of the remainders over their mean variance for noise of variance 1, and how
/// many there are: their ratio is the variance of the noise, whatever the smooth form of the flank. That variance is 6
/// less what the parabola has taken of it: a sixth with four even points, little with many.
struct NoiseSum
{
    double squares = 0;
    std::size_t differences = 0;
};
[[nodiscard]] NoiseSum noise_of(FlankParabola const& parabola);

}  // namespace hdconj::inspect
