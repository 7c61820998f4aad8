// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic solid of revolution under loads that vary round the axis, one Fourier harmonic at a time.
#pragma once

#include <Eigen/SparseCore>

#include <array>
#include <vector>

#include "section_point.hpp"

namespace hdconj::elastic {

/// Component of a displacement or force, and its place among the three of a node.
enum class Direction
{
    radial = 0,     ///< U, positive outward
    axial = 1,      ///< W, positive towards the open end
    tangential = 2  ///< V, positive towards increasing phi
};

/// Number of the unknown that is a component of a node.
[[nodiscard]] inline Eigen::Index unknown_of(int node, Direction direction)
{
    return 3 * static_cast<Eigen::Index>(node) + static_cast<Eigen::Index>(direction);
}

/// Gauss points of an element in each direction.
enum class Quadrature
{
    reduced = 2,  ///< no locking of thin walls
    full = 3
};

/// Strain of one point of a section: B0 + n B1 turns the 24 amplitudes of an element into those of
/// e_rr, e_zz, e_tt, g_rz (cos n phi) and g_rt, g_zt (sin n phi).
struct StrainMatrices
{
    Eigen::Matrix<double, 6, 24> at_rest;
    Eigen::Matrix<double, 6, 24> per_harmonic;
    double jacobian = 0;  ///< area of the section per (xi, eta) [mm^2]
    double radius = 0;    ///< [mm]
};

/// With u_r = U cos n phi, u_z = W cos n phi, u_t = V sin n phi:
///
///   e_rr = U,r   e_zz = W,z   e_tt = (U + n V)/r   g_rz = U,z + W,r   g_rt = V,r - (n U + V)/r   g_zt = V,z - n W/r
///
/// (Zienkiewicz and Taylor, semi-analytical finite elements.) The other half of a general field, (sin, sin, -cos), has
/// the same matrices.
[[nodiscard]] StrainMatrices strain_matrices(SectionMesh const& mesh, SectionPoint const& point);

/// Stiffness per harmonic, K_n = integral of B_n^T D B_n r dr dz = K_0 + n K_1 + n^2 K_2: the factor pi of the integral
/// over phi (2 pi for n = 0) is left out, and with it a load is an amplitude [N/rad]. Unknowns as unknown_of() says.
class FourierSolid
{
  public:
    /// @throws NumericalError for an element that is turned inside out
    explicit FourierSolid(SectionMesh mesh, Quadrature quadrature = Quadrature::reduced);

    [[nodiscard]] SectionMesh const& mesh() const { return mesh_; }
    [[nodiscard]] Quadrature quadrature() const { return quadrature_; }
    [[nodiscard]] Eigen::Index unknowns() const { return static_cast<Eigen::Index>(3 * mesh_.nodes.size()); }
    [[nodiscard]] Eigen::SparseMatrix<double> stiffness(int harmonic) const;
    /// All unknowns in an order that keeps Cholesky factors sparse (minimum degree), for every harmonic.
    [[nodiscard]] std::vector<int> const& elimination() const { return elimination_; }

  private:
    SectionMesh mesh_;
    Quadrature quadrature_;
    Eigen::SparseMatrix<double> pattern_;   ///< of every harmonic's stiffness
    std::array<Eigen::VectorXd, 3> power_;  ///< of n: K_0, K_1, K_2, the pattern's values
    std::vector<int> elimination_;
};

}  // namespace hdconj::elastic
