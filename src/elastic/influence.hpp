// SPDX-License-Identifier: GPL-3.0-or-later
// Influence of point forces on the displacements of an elastic body of revolution, as a sum over harmonics.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

#include "harmonic_solver.hpp"

namespace hdconj::elastic {

/// A component at a circle of the body: where forces act and displacements are asked for.
/// A point inside an element's side or area takes its share of the element's nodes by their shape functions, loads and
/// displacements alike.
struct Station
{
    SectionPoint place;
    Direction direction = Direction::radial;
};

/// Station on the straight wall at height @p z [mm], at @p depth of the wall: 0 inner surface, 0.5 middle, 1 outer
/// surface.
[[nodiscard]] inline Station wall_station(SectionMesh const& mesh, double z, double depth, Direction direction)
{
    return {wall_point(mesh, z, depth), direction};
}

/// The harmonics 0, @p waves, 2 @p waves, ... up to @p highest. Domain: waves >= 1.
[[nodiscard]] std::vector<int> harmonics_of(int waves, int highest);

/// cos and sin of all harmonics (rows) at some angles [rad] (columns).
struct HarmonicWaves
{
    HarmonicWaves(std::vector<int> const& harmonics, std::vector<double> const& phi, int threads = 1);

    Eigen::MatrixXd cosine, sine;
};

/// The loads that one force stands for.
struct Repetition
{
    int waves = 1;          ///< the force acts at phi + 2 pi k/waves, k = 0 ... waves - 1: only multiples of it respond
    bool mirrored = false;  ///< and at -phi with its tangential component reversed; on the mirror plane both act
};

/// A component of a point of the body.
struct InfluencePoint
{
    std::size_t station = 0;
    double phi = 0;  ///< [rad]
};

/// Compliance of a body between stations.
///
/// compliance[i](a, b), symmetric, is the amplitude [mm] at station a in harmonic harmonics[i] under a load of unit
/// amplitude [N/rad] at station b, in the convention u_r = U cos n phi, u_z = W cos n phi, u_t = V sin n phi, loads
/// likewise. A line load given in N per mm of arc at the radius R of its station is R times as large in N/rad.
///
/// A force of 1 N at phi' is delta(phi - phi') = 1/(2 pi) + sum_n cos(n (phi - phi'))/pi [N/rad]. With Delta = phi -
/// phi' it moves station a at phi by sum_n c_n compliance(a, b) h(n Delta), c_0 = 1/(2 pi), c_n = 1/pi, where h is
///
///   a radial, axial   b radial, axial   cos        a tangential   b radial, axial    sin
///   a tangential      b tangential      cos        a radial, axial   b tangential   -sin
///
/// so that the influence of (b, phi') on (a, phi) is that of (a, phi) on (b, phi') (Betti). The sum is taken over the
/// given harmonics; for a point under its own force it grows without limit with their number, as log n.
class Influence
{
  public:
    /// @param compliance  one symmetric matrix for each harmonic
    Influence(std::vector<Direction> directions, std::vector<int> harmonics, std::vector<Eigen::MatrixXd> compliance);

    [[nodiscard]] std::size_t stations() const { return directions_.size(); }
    [[nodiscard]] std::vector<int> const& harmonics() const { return harmonics_; }
    [[nodiscard]] Direction direction(std::size_t station) const { return directions_[station]; }
    /// Matrix of the i-th harmonic.
    [[nodiscard]] Eigen::MatrixXd const& compliance(std::size_t i) const { return compliance_[i]; }

    /// Displacement of @p at [mm] under 1 N at each place that @p load stands for.
    [[nodiscard]] double operator()(InfluencePoint const& at, InfluencePoint const& load,
                                    Repetition const& repetition = {}) const;

    /// The same for all pairs: symmetric matrix, points x points. Same bits for any number of threads.
    [[nodiscard]] Eigen::MatrixXd matrix(std::vector<InfluencePoint> const& points, Repetition const& repetition = {},
                                         int threads = 1) const;
    /// Rows: places of displacements, columns: loads.
    [[nodiscard]] Eigen::MatrixXd matrix(std::vector<InfluencePoint> const& at,
                                         std::vector<InfluencePoint> const& loads, Repetition const& repetition = {},
                                         int threads = 1) const;

  private:
    std::vector<Direction> directions_;
    std::vector<int> harmonics_;
    std::vector<Eigen::MatrixXd> compliance_;
};

/// Amplitudes of all unknowns [mm] under a unit load [N/rad] on each station, harmonic by harmonic: influence and
/// fields of the same stations follow by products. Memory: unknowns x stations x harmonics doubles (type-50 under load:
/// 10 MB).
struct UnitFields
{
    std::vector<int> harmonics;
    std::vector<Eigen::MatrixXd> moved;  ///< one for each harmonic, unknowns x stations
};

/// One factorisation for each of @p harmonics, spread over @p threads, unless keep_elastic_bodies() has them. Same bits
/// for any number of threads.
/// @throws NumericalError as HarmonicSolver does
[[nodiscard]] std::shared_ptr<UnitFields const> unit_fields(FourierSolid const& solid, Supports const& supports,
                                                            std::vector<Station> const& stations,
                                                            std::vector<int> const& harmonics, int threads = 1);

/// Compliance between @p stations, those that @p unit was made for.
[[nodiscard]] Influence influence_of_fields(FourierSolid const& solid, UnitFields const& unit,
                                            std::vector<Station> const& stations, int threads = 1);
/// The same with unit_fields() of its own.
[[nodiscard]] Influence influence(FourierSolid const& solid, Supports const& supports,
                                  std::vector<Station> const& stations, std::vector<int> const& harmonics,
                                  int threads = 1);

/// Shares of the unknowns in each station: unknowns x stations; loads = shares x amplitudes, displacements = shares^T x
/// unknowns.
[[nodiscard]] Eigen::MatrixXd station_shares(FourierSolid const& solid, std::vector<Station> const& stations);

}  // namespace hdconj::elastic
