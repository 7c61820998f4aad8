// SPDX-License-Identifier: GPL-3.0-or-later
// Displacements and stresses in a whole body of revolution under loads on its stations.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

#include "influence.hpp"

namespace hdconj::elastic {

/// Amplitudes of all unknowns; rows: unknowns of the solid, columns: harmonics.
///
/// `even` goes with (u_r, u_z, u_t) = (U cos, W cos, V sin) n phi, `odd` with (U sin, W sin, -V cos) n phi.
struct HarmonicField
{
    std::vector<int> harmonics;
    Eigen::MatrixXd even;  ///< [mm]
    Eigen::MatrixXd odd;
};

/// Stress components in the order rr, zz, tt, rz, rt, zt [MPa].
using Stress = Eigen::Matrix<double, 6, 1>;

/// The field under loads of the stations of @p unit [N/rad], rows: stations, columns: harmonics, in the same two
/// families: a radial or axial load p cos n phi + q sin n phi has even = p, odd = q; a tangential one p sin n phi + q
/// cos n phi has even = p, odd = -q.
[[nodiscard]] HarmonicField harmonic_field(UnitFields const& unit, Eigen::MatrixXd const& even,
                                           Eigen::MatrixXd const& odd, int threads = 1);

/// Amplitudes U, W, V (rows) of each harmonic (columns) at a place: first those of `even`, then those of `odd`.
struct PointAmplitudes
{
    Eigen::Matrix3Xd even;
    Eigen::Matrix3Xd odd;
};

[[nodiscard]] PointAmplitudes amplitudes_at(SectionMesh const& mesh, HarmonicField const& field,
                                            SectionPoint const& place);

/// @p count even angles of one of @p sectors sectors [rad].
[[nodiscard]] std::vector<double> even_angles(int count, int sectors);

/// (u_r, u_z, u_t) [mm] at the angles of @p waves (columns).
[[nodiscard]] Eigen::Matrix3Xd displacements_at(SectionMesh const& mesh, HarmonicField const& field,
                                                SectionPoint const& place, HarmonicWaves const& waves);

/// (u_r, u_z, u_t) [mm].
[[nodiscard]] Eigen::Vector3d displacement_at(SectionMesh const& mesh, HarmonicField const& field,
                                              SectionPoint const& place, double phi);

/// The same at a node of the section.
[[nodiscard]] Eigen::Vector3d node_displacement(HarmonicField const& field, int node, double phi);

/// Equivalent stress of von Mises [MPa].
[[nodiscard]] double von_mises(Stress const& stress);

/// Equivalent stress at @p places (xi, eta) in each element and at the angles @p phi: rows places within elements,
/// columns angles. The components are bilinear through the reduced Gauss points, so that a wall of one element has its
/// bending stress on the surface: between one, two and four elements across the wall of type-50 it differs by 0.05 %.
[[nodiscard]] Eigen::MatrixXd recovered_stress(SectionMesh const& mesh, HarmonicField const& field,
                                               std::vector<Vec2> const& places, std::vector<double> const& phi,
                                               int threads = 1);

/// The largest equivalent stress of a body and where it is.
struct StressPeak
{
    double stress = 0;     ///< [MPa]
    SectionPoint place{};  ///< on a side of an element
    double phi = 0;        ///< [rad]
};

/// Heights between which a ring stands on the inner surface, and where its edges stop to raise the stress [mm].
struct Seat
{
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool covers(double z) const { return z > low && z < high; }
};

/// Largest of recovered_stress() on the surfaces of wall and layer of teeth, at the Gauss points along them.
/// @param seat  here the inner surface does not count: under an edge that presses on it stress grows without limit
///              with finer elements, while on the outer surface, opposite to it, it converges
[[nodiscard]] StressPeak stress_peak(SectionMesh const& mesh, HarmonicField const& field,
                                     std::vector<double> const& phi, Seat const& seat = {}, int threads = 1);

}  // namespace hdconj::elastic
