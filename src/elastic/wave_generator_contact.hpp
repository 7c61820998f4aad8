// SPDX-License-Identifier: GPL-3.0-or-later
// Contact of the cup with its wave generator.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

#include "bearing.hpp"
#include "influence.hpp"
#include "numeric/complementarity.hpp"

namespace hdconj::elastic {

/// Displacements of stations as literal Fourier series, sum_k cosine(a, k) cos(k n phi) + sine(a, k) sin(k n phi) [mm],
/// of every direction. Rows: stations, columns: harmonics.
struct DisplacementSeries
{
    int waves = 2;
    Eigen::MatrixXd cosine;
    Eigen::MatrixXd sine;

    [[nodiscard]] double at(std::size_t station, double phi) const;
};

/// Unilateral contact over the bearing's width, without friction, of first order in the displacements.
struct WaveGeneratorContact
{
    std::vector<double> phi;  ///< of the points: half a lobe with both ends for an even shape, or a whole one [rad]
    std::vector<double> z;    ///< of the points [mm]
    Eigen::MatrixXd force;    ///< [N] at (phi, z) of the wall, outward
    Eigen::MatrixXd gap;      ///< [mm]
    /// Loads of the cup [N/rad] as series in phi: rows z, columns harmonics.
    Eigen::MatrixXd load_cosine;
    Eigen::MatrixXd load_sine;
    DisplacementSeries displacement;  ///< of the stations asked for
    double total_force = 0;           ///< sum of all forces between bearing and cup, all round [N]
    /// Line of balls between cam and outer ring; empty for a rigid bearing. Where a ball carries no force, the ring
    /// stands off the cam.
    std::vector<double> ball_phi;    ///< [rad], in the same part of the ring as `phi`
    std::vector<double> ball_force;  ///< of the part of the line that a point stands for [N]
    std::vector<double> ball_gap;    ///< [mm]
    int iterations = 0;
    double residual = 0;
    numeric::ContactMethod method = numeric::ContactMethod::active_set;
    std::shared_ptr<UnitFields const> unit;  ///< of the circles, and of the stations behind them
};

/// Solves for the contact.
/// @param cup       meshed with elements of contact_mesh_size, or finer
/// @param cam       its samples are the angles of the points
/// @param across    circles over the bearing's width
/// @param stations  where displacements are asked for
/// Accuracy: pressures at the edges of the bearing grow without limit on finer grids; their sum and the displacements
/// converge. 48 angles and 13 circles give the coning of type-50 to 0.5 %.
/// @throws NumericalError for a bearing that reaches beyond the straight wall, and as solve_complementarity does
[[nodiscard]] WaveGeneratorContact solve_wave_generator(FourierSolid const& cup, double inner_radius,
                                                        Bearing const& bearing, CamSeries const& cam, int across,
                                                        std::vector<Station> const& stations, int threads = 1);

}  // namespace hdconj::elastic
