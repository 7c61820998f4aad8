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

}  // namespace hdconj
