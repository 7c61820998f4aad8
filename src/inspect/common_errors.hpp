// SPDX-License-Identifier: GPL-3.0-or-later
// Errors that all flanks of a side have in common, and what a placement could take up of them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "numeric/least_squares.hpp"
#include "placement.hpp"

namespace hdconj::inspect {

/// Thickness, and slope and crowning of either side, as unknowns beside a placement. A shift of adjacent teeth looks
/// much like these errors: a placement of least squares that does not know them takes them up (Frisch and Waugh 1933:
/// it is found from rows and deviations without what they explain). Slope and crowning are counted from the mean
/// deviation of their side, so that the turn lays the deviations in balance as it does without them.
///
/// Degenerate: of one side there is no thickness; where points span too little of the flanks there are no slopes and
/// crownings.
class CommonErrors
{
  public:
    /// Turn, rise and square of xi of the left flanks, then of the right ones: all patterns are sums of these.
    static constexpr int terms = 6;

    CommonErrors(std::vector<PointView> const& views, NominalPart const& part, CommonErrorsKnown known);

    /// @p columns without what the common errors explain of them.
    [[nodiscard]] Eigen::MatrixXd without(Eigen::MatrixXd const& columns) const;
    /// What they explain, as coefficients of the terms.
    [[nodiscard]] Eigen::MatrixXd explained(Eigen::MatrixXd const& columns) const;
    /// Arc along the reference circle by which @p deviations put right flanks clockwise, left ones the other way [mm].
    [[nodiscard]] double excess(Eigen::VectorXd const& deviations) const;

  private:
    Eigen::MatrixXd raw_;      ///< the terms at each point
    Eigen::MatrixXd mix_;      ///< patterns made of terms
    bool has_excess_ = false;  ///< whether the first pattern is the thickness
    std::optional<numeric::LeastSquares> fit_;
};

}  // namespace hdconj::inspect
