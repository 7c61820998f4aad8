// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The elastic cup on its wave generator with teeth that may touch: everything but the teeth's surfaces.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "hdconj/elastic/ball_line.hpp"
#include "hdconj/load/flank_contacts.hpp"
#include "hdconj/load/hertz.hpp"
#include "hdconj/load/ring_response.hpp"
#include "hdconj/load/tooth_bending.hpp"

namespace hdconj {

/// Stations of the cup in the order of ElasticDrive::response.
struct DriveStations
{
    std::size_t bearing = 0;  ///< heights at which the wave generator presses: radial stations 0 ... bearing - 1
    std::size_t slices = 0;   ///< then for every slice: radial, tangential, axial, turn, a block each

    [[nodiscard]] std::size_t radial(std::size_t slice) const { return bearing + slice; }
    [[nodiscard]] std::size_t tangential(std::size_t slice) const { return bearing + slices + slice; }
    [[nodiscard]] std::size_t axial(std::size_t slice) const { return bearing + 2 * slices + slice; }
    [[nodiscard]] std::size_t turn(std::size_t slice) const { return bearing + 3 * slices + slice; }
    [[nodiscard]] std::size_t count() const { return bearing + 4 * slices; }
};

/// Plain data of the model. Angles on an even grid over one sector: tooth i stands at grid angle i steps_per_tooth.
struct ElasticDrive
{
    DriveStations stations;
    PointResponse response;                   ///< of the cup
    std::optional<PointResponse> outer_ring;  ///< of the bearing's outer ring, `bearing` radial stations, outward; absent: a rigid cam
    std::optional<BallLine> balls;            ///< between cam and outer ring, for the contacts in the order of `bearing_steps`, heights within them; with `outer_ring`
    int steps_per_tooth = 1;
    std::vector<int> bearing_steps;           ///< grid angles at which the wave generator may press
    Eigen::MatrixXd needed;                   ///< (bearing, bearing_steps) how far the unloaded wave generator stands out [mm]
    double phase = 0;                         ///< angle of the grid's first point [rad]
    int flexspline_teeth = 0;
    std::vector<double> slice_width;          ///< (slices) face width that a slice stands for [mm]
    Elasticity flexspline, circular_spline;
    double contact_depth = 0;                 ///< of the Hertz approach: half a tooth [mm]
    ToothBending bending;
    std::optional<Eigen::MatrixXd> between_balls = std::nullopt;  ///< with single balls: what the ring gives way by between them, contacts as of `balls` [mm/N]
    double ball_arc = 0;                      ///< of the ring's inner circle that a point of a line of balls stands for [mm]; 0: single balls, or none
    std::vector<double> bearing_z = {};       ///< (bearing) above the middle of the bearing [mm]
    std::vector<double> slice_z = {};         ///< (slices) above the middle of the bearing [mm]

    Eigen::MatrixXd bearing_compliance = {};  ///< between the bearing's contacts, heights within `bearing_steps`: bearing_compliance() [mm/N]

    [[nodiscard]] LineContact line_contact(FlankContact const& c) const;
};

/// What cup, outer ring and the ring between its balls give way by at the contacts of the bearing, one under a force of 1 N on another: symmetric. It is the same at every torque.
[[nodiscard]] Eigen::MatrixXd bearing_compliance(ElasticDrive const& drive, int threads);

/// What flank contacts give way by in themselves, beside the cup: Hertz and bending of the tooth, as secants at given forces.
struct LocalCompliance
{
    std::vector<double> own;  ///< of each contact [mm/N]
    /// Contacts of one flank and slice give way under each other: as strips on one half-plane, and by bending of the tooth that they stand on.
    struct Coupling
    {
        std::size_t first, second;
        double compliance;  ///< [mm/N]
    };
    std::vector<Coupling> couplings;

    /// What each contact gives way by under @p force [mm].
    [[nodiscard]] std::vector<double> operator()(std::vector<double> const& force) const;
};

/// @param force  of each contact, at which the secants are taken; where there is none, that of a line load of 1 N/mm
[[nodiscard]] LocalCompliance local_compliance(ElasticDrive const& drive, std::vector<FlankContact> const& contacts, std::vector<double> const& force);

/// Forces in equilibrium at one torque, for gaps that are linear in them.
struct Equilibrium
{
    std::vector<double> flank;     ///< force of each contact [N]
    Eigen::MatrixXd bearing;       ///< (bearing, bearing_steps) [N]
    std::vector<double> balls;     ///< force of each point of the line of balls [N]
    double turn = 0;               ///< of the flexspline against the circular spline [rad]
    double stiffness = 0;          ///< dT/dturn with the closed contacts, whole ring [N mm/rad]; 0 without torque
    int steps = 0;                 ///< of the active set
    double complementarity = 0;    ///< relative residual
};

/// What gaps are linear about: the shape in which they were looked at.
struct LinearGaps
{
    std::vector<FlankContact> contacts;
    std::vector<double> displacement;  ///< of the tooth along the normal in that shape, as the model has it [mm]
    LocalCompliance compliance;
    double turn = 0;                   ///< of the flexspline in that shape [rad]
};

/// Forces that leave no gap negative and press only where there is none:
///
///   flank:   g = gap + c.u - c.u(f) - lever (turn - turn_0) + compliance(f) >= 0,  f >= 0,  f g = 0
///   bearing: g = u_cup(f) + u_ring(f) - needed >= 0, likewise, and balls push or the ring stands off them,
///   torque:  sectors sum(lever f) = torque.
///
/// @param torque  on the whole ring [N mm]; absent: teeth do not press at all, and the turn stays
/// @param guess   equilibrium of a like problem, whose bearing forces are a start; null: none
/// Domain: `bearing_compliance` is there.
/// @throws NumericalError when no such forces are found, or no flank can carry the torque
[[nodiscard]] Equilibrium equilibrium(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque, Equilibrium const* guess, int threads);

/// Forces as they act on the cup's stations: (stations, grid) [N].
[[nodiscard]] Eigen::MatrixXd forces_on_cup(ElasticDrive const& drive, std::vector<FlankContact> const& contacts, Equilibrium const& state);

/// Displacement series of all stations under these forces, as PointResponse::series gives it.
[[nodiscard]] std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces, int threads = 1);

/// Value of a series of `drive` at an angle, and its derivative.
struct SeriesValue
{
    double value = 0, slope = 0;
};
[[nodiscard]] SeriesValue series_at(ElasticDrive const& drive, std::vector<double> const& series, double phi);

/// cos and sin of all harmonics of `drive` at an angle, for several series there.
struct SeriesPlace
{
    SeriesPlace(ElasticDrive const& drive, double phi);

    [[nodiscard]] SeriesValue operator()(std::vector<double> const& series) const;

  private:
    struct Wave
    {
        double n, cosine, sine;
    };
    std::vector<Wave> waves_;
};

}  // namespace hdconj
