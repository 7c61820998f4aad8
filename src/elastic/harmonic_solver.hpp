// SPDX-License-Identifier: GPL-3.0-or-later
// Displacements of a supported solid of revolution at one Fourier harmonic.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <vector>

#include "fourier_solid.hpp"

namespace hdconj::elastic {

/// A spring from one component of a node to the ground, or a fixed component.
struct Support
{
    int node = 0;
    Direction direction = Direction::radial;
    double stiffness = -1;                                ///< [N/mm per rad]; below 0: fixed
    int last_harmonic = std::numeric_limits<int>::max();  ///< what only stops a rigid motion must not hold n = 2 and up
};

/// Supports of a body beside its clamped nodes.
/// For n = 0 the tangential displacement is uncoupled from the others. A body that can turn, shift (n = 0, 1) or tilt
/// (n = 1) as a whole has no solution there.
using Supports = std::vector<Support>;

/// One harmonic of a supported body, factorised.
class HarmonicSolver
{
  public:
    /// @throws NumericalError where the body can move as a whole
    HarmonicSolver(FourierSolid const& solid, Supports const& supports, int harmonic);

    [[nodiscard]] int harmonic() const { return harmonic_; }
    /// Amplitudes [mm] of all unknowns, a column for each column of loads [N/rad]; fixed ones stay 0.
    [[nodiscard]] Eigen::MatrixXd operator()(Eigen::MatrixXd const& loads) const;
    /// Amplitudes of all unknowns without loads where the fixed ones have the displacements @p given; its other rows
    /// are ignored.
    [[nodiscard]] Eigen::MatrixXd moved(Eigen::MatrixXd const& given) const;
    /// Forces [N/rad] of these displacements without those of springs: loads, and reactions at fixed unknowns.
    [[nodiscard]] Eigen::MatrixXd forces(Eigen::MatrixXd const& displacements) const;

  private:
    struct Factors;
    int harmonic_;
    std::shared_ptr<Factors const> factors_;
};

}  // namespace hdconj::elastic
