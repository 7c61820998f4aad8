// SPDX-License-Identifier: GPL-3.0-or-later
// Displacements of a supported solid of revolution at one Fourier harmonic.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
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
    ~HarmonicSolver();

    [[nodiscard]] int harmonic() const { return harmonic_; }
    /// Changes to another harmonic, with the order of elimination that is known where the same unknowns are fixed.
    void factorise(int harmonic);
    /// Amplitudes [mm] of all unknowns, a column for each column of loads [N/rad]; fixed ones stay 0.
    [[nodiscard]] Eigen::MatrixXd operator()(Eigen::MatrixXd const& loads) const;
    /// Amplitudes of all unknowns without loads where the fixed ones have the displacements @p given; its other rows
    /// are ignored.
    [[nodiscard]] Eigen::MatrixXd moved(Eigen::MatrixXd const& given) const;
    /// Force [N/rad] on the unknown @p at under each column of displacements, without that of a spring: the load, or
    /// the reaction of a fixed one.
    [[nodiscard]] Eigen::RowVectorXd force_on(Eigen::Index at, Eigen::MatrixXd const& displacements) const;

  private:
    struct Elimination;
    FourierSolid const* solid_;
    Supports supports_;
    int harmonic_ = 0;
    Eigen::SparseMatrix<double> stiffness_;  ///< of all unknowns, without springs
    std::unique_ptr<Elimination> elimination_;
};

/// Calls @p use with the solver of each of @p harmonics and its index. Each thread has one, so that the order of
/// elimination is found once for all of its harmonics.
/// @throws NumericalError as HarmonicSolver does
void for_each_harmonic(FourierSolid const& solid, Supports const& supports, std::vector<int> const& harmonics,
                       int threads, std::function<void(std::size_t, HarmonicSolver const&)> const& use);

}  // namespace hdconj::elastic
