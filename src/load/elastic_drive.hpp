// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic cup on its wave generator with teeth that may touch: everything but the teeth's surfaces.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "elastic/ball_line.hpp"
#include "flank_contacts.hpp"
#include "hertz.hpp"
#include "ring_response.hpp"
#include "tooth_bending.hpp"

namespace hdconj::load {

/// Order of the stations of the cup in ElasticDrive::response: first the heights of the bearing, then four blocks with
/// one station for each slice, radial, tangential, axial and turn.
struct DriveStations
{
    std::size_t bearing = 0;  ///< heights at which the wave generator presses radially
    std::size_t slices = 0;

    [[nodiscard]] std::size_t radial(std::size_t slice) const { return bearing + slice; }
    [[nodiscard]] std::size_t tangential(std::size_t slice) const { return bearing + slices + slice; }
    [[nodiscard]] std::size_t axial(std::size_t slice) const { return bearing + 2 * slices + slice; }
    [[nodiscard]] std::size_t turn(std::size_t slice) const { return bearing + 3 * slices + slice; }
    [[nodiscard]] std::size_t count() const { return bearing + 4 * slices; }
};

/// The elastic model. Angles are on an even grid over one sector: tooth i stands at grid angle i steps_per_tooth.
struct ElasticDrive
{
    DriveStations stations;
    std::shared_ptr<PointResponse const> response;  ///< of the cup
    /// Of the outer ring of the bearing: `bearing` radial stations, outward. Absent: a rigid cam.
    std::optional<PointResponse> outer_ring = std::nullopt;
    /// Between cam and outer ring, for the contacts heights within `bearing_steps`. Present with `outer_ring`.
    std::optional<elastic::BallLine> balls = std::nullopt;
    int steps_per_tooth = 1;
    std::vector<int> bearing_steps = {};  ///< grid angles at which the wave generator may press
    Eigen::MatrixXd needed = {};  ///< (bearing, bearing_steps) how far the unloaded wave generator stands out [mm]
    double phase = 0;             ///< angle of the first grid point [rad]
    int flexspline_teeth = 0;
    std::vector<double> slice_width;  ///< (slices) face width that a slice stands for [mm]
    elastic::Elasticity flexspline, circular_spline;
    double contact_depth = 0;  ///< at which the Hertz approach is taken: half a tooth [mm]
    ToothBending bending;
    /// Single balls: compliance of the ring between them, for the same contacts [mm/N].
    std::optional<Eigen::MatrixXd> between_balls = std::nullopt;
    /// Arc of the inner circle of the ring that a point of a line of balls stands for [mm]; 0: single balls, or none.
    double ball_arc = 0;
    std::vector<double> bearing_z = {};  ///< (bearing) above the middle of the bearing [mm]
    std::vector<double> slice_z = {};    ///< (slices) above the middle of the bearing [mm]
    /// Value of bearing_compliance(), which no torque changes [mm/N].
    std::shared_ptr<Eigen::MatrixXd const> bearing_compliance = nullptr;
    double flow_pressure = std::numeric_limits<double>::infinity();  ///< of flanks [MPa]; infinite: they stay elastic

    [[nodiscard]] LineContact line_contact(FlankContact const& c) const
    {
        return {flexspline, circular_spline, c.curvature, contact_depth, flow_pressure};
    }
};

/// Compliance between the contacts of the bearing, heights within angles, of cup, outer ring and the ring between its
/// balls: displacement at one contact under 1 N at another [mm/N]. Symmetric.
/// @throws NumericalError where it is not a number
[[nodiscard]] std::shared_ptr<Eigen::MatrixXd const> bearing_compliance(ElasticDrive const& drive, int threads);

/// A flank contact as components at the stations of the cup.
struct Footing
{
    int at;                  ///< grid angle of the tooth
    std::size_t station[3];  ///< radial, tangential and turn of the slice
    double share[3];         ///< component of a unit force along the normal at each
};
[[nodiscard]] Footing footing(ElasticDrive const& drive, FlankContact const& c);

/// A place at which the wave generator may press.
struct BearingNode
{
    std::size_t height;  ///< index into ElasticDrive::bearing_z
    std::size_t angle;   ///< index into ElasticDrive::bearing_steps
    int at;              ///< grid angle
};
/// All of them, heights within angles.
[[nodiscard]] std::vector<BearingNode> bearing_nodes(ElasticDrive const& drive);

/// Displacement series of all stations under these forces, as PointResponse::series gives it.
[[nodiscard]] std::vector<std::vector<double>> displacements(ElasticDrive const& drive, Eigen::MatrixXd const& forces,
                                                             int threads = 1);

/// Value and derivative of a series of an elastic drive at an angle.
struct SeriesValue
{
    double value = 0, slope = 0;
};
[[nodiscard]] SeriesValue series_at(ElasticDrive const& drive, std::vector<double> const& series, double phi);

/// Cosine and sine of all harmonics of an elastic drive at an angle, to evaluate several series there. They follow by
/// adding angles, with an error of k roundings of the k-th.
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

}  // namespace hdconj::load
