// SPDX-License-Identifier: GPL-3.0-or-later
// Registration: turn and shift of the measured part, and what noise does to that of least largest deviation.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "flank_fit.hpp"

namespace hdconj::inspect {

/// The points that a registration uses.
struct Registered
{
    PointReader const& read;
    std::vector<PlanePoint> points;
    Registration registration;
    int threads;
    std::string file{};  ///< of the points
};

/// The unknowns of a registration: turn times reference radius, shift in x, shift in y. All in mm.
inline constexpr int most_unknowns = 3;

/// Number of unknowns: 0, 1 or 3.
[[nodiscard]] int unknowns_of(Registration registration);

/// Rows d(deviation)/d(unknown) of @p views, the first unknowns_of() columns.
[[nodiscard]] Eigen::MatrixXd jacobian(std::vector<PointView> const& views, Placement const& placement,
                                       NominalPart const& part, int unknowns);

/// Moves by a step of the unknowns.
[[nodiscard]] Placement moved(Placement placement, Eigen::VectorXd const& step, NominalPart const& part);

/// The turn within half a pitch from which registration starts: where the sum of squared deviations, cut at a quarter
/// pitch, is least. 0, the file's own axes, where another turn is not much better and for the datum.
[[nodiscard]] double near_turn(Registered const& what);

/// The placement at which the sum of squared deviations is least, of least squares with CommonErrors as further
/// unknowns; or for the minimum zone the largest size of a deviation. Gauss-Newton steps from near_turn() go on until
/// they are roundings; which points are on a flank is settled in the first of them.
/// @throws InputError where the points do not fix the unknowns, or stay farther from the flanks than those of any part
/// of the drive; NumericalError where the steps do not end
[[nodiscard]] Placement registered(Registered const& what);

/// The placement of least largest deviation, from a near one: a sequence of linear programs, each solved by
/// chebyshev_step(). A step that does not lower the largest deviation is halved.
[[nodiscard]] Placement minimum_zone(Registered const& what, Placement near);

/// The step that makes the largest |d + J step| least, by the dual simplex method. Domain: rows J of full column rank.
[[nodiscard]] Eigen::VectorXd chebyshev_step(Eigen::MatrixXd const& rows, Eigen::VectorXd const& deviations);

/// Error of the unknowns of a minimum zone: turn times reference radius, shift in x and y. All in mm.
struct ZoneError
{
    Eigen::Vector3d half_width = Eigen::Vector3d::Zero();  ///< of the 95 % interval
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Few points determine a minimum zone, and which ones depends on the noise: no formula of linear errors holds. So the
/// fit is repeated for a part without noise whose deviations are @p smooth, each time with other noise of the standard
/// deviation @p noise (a parametric bootstrap). The half widths are the 95th percentiles of the sizes of its errors.
///
/// Accuracy: of synthetic rings such intervals held 92 to 98 of 100 true placements, the least where one flank in a
/// hundred is far from the others. Work: some 3000 passes over the points.
/// @param rows    d(deviation)/d(unknown) of each point, of full rank
/// @param smooth  an estimate of the deviations without noise [mm]
/// @param noise   [mm]
[[nodiscard]] ZoneError zone_error(Eigen::MatrixXd const& rows, Eigen::VectorXd const& smooth, double noise,
                                   int threads);

/// The deviations without noise, as far as the flanks tell: what a parabola leaves is noise to the share that the noise
/// has in it.
/// @param points  that are wanted, with their @p views
/// @param noise   standard deviation of a point [mm]
[[nodiscard]] Eigen::VectorXd without_noise(std::vector<std::size_t> const& points, std::vector<PointView> const& views,
                                            std::vector<FlankFit> const& fits, double noise);

}  // namespace hdconj::inspect
