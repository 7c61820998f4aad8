// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Displacement of a whole body of revolution under unit loads on its stations, to be combined for any loads.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "harmonic_field.hpp"
#include "influence.hpp"

namespace hdconj::elastic {

/// Amplitudes of all unknowns [mm] under a unit load [N/rad] on each station, harmonic by harmonic.
///
/// Influence and fields of the same stations follow by products, without another factorisation. Memory: unknowns x
/// stations x harmonics doubles (type-50 under load: 10 MB).
struct UnitFields
{
    std::vector<int> harmonics;
    std::vector<Eigen::MatrixXd> moved;  ///< one for each harmonic, unknowns x stations
};

/// One factorisation for each of @p harmonics, spread over @p threads. Same bits for any number of them.
/// @throws NumericalError as HarmonicSolver does
[[nodiscard]] UnitFields unit_fields(FourierSolid const& solid, Supports const& supports,
                                     std::vector<Station> const& stations, std::vector<int> const& harmonics,
                                     int threads = 1);

/// Compliance between @p stations, those that @p unit was made for: the same bits as influence() of the solid.
[[nodiscard]] Influence influence(FourierSolid const& solid, UnitFields const& unit,
                                  std::vector<Station> const& stations, int threads = 1);

/// The field under loads of the stations, rows: stations, columns: harmonics, as harmonic_field() takes them; equal to
/// it but for rounding.
[[nodiscard]] HarmonicField harmonic_field(UnitFields const& unit, Eigen::MatrixXd const& even,
                                           Eigen::MatrixXd const& odd, int threads = 1);

}  // namespace hdconj::elastic
