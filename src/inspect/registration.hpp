// SPDX-License-Identifier: GPL-3.0-or-later
// Registration: turn and shift of the measured part.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "placement.hpp"

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

}  // namespace hdconj::inspect
