// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The wave generator of an elastic drive.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "contact/study/contact_context.hpp"
#include "elastic/ball_line.hpp"
#include "elastic/bearing.hpp"
#include "elastic/influence.hpp"
#include "load/ring_response.hpp"
#include "ring_grid.hpp"

namespace hdconj::load {

/// The scene's bearing with the places where it presses on the cup.
struct PlacedBearing
{
    elastic::Bearing bearing;
    std::vector<double> circles;           ///< heights of its contacts above the cup's bottom [mm]
    double spread;                         ///< angle over which one of its forces acts: a step of the grid [rad]
    std::optional<double> ball_stiffness;  ///< of a single ball without its ring [N/mm]
};

[[nodiscard]] PlacedBearing placed_bearing(contact::ContactContext const& context, int circles, RingGrid const& around);

/// The compliance matrices of @p influence, harmonic by harmonic.
[[nodiscard]] std::vector<HarmonicResponse> responses(elastic::Influence const& influence);

/// The wave generator's part of an ElasticDrive; members as there.
struct BearingModel
{
    std::vector<int> bearing_steps;
    Eigen::MatrixXd needed;
    std::optional<PointResponse> outer_ring;
    std::optional<elastic::BallLine> balls;
    std::optional<Eigen::MatrixXd> between_balls;
    double ball_arc = 0;
};

/// @param phase    ElasticDrive::phase
/// @param highest  harmonic
[[nodiscard]] BearingModel bearing_model(PlacedBearing const& placed, contact::ContactContext const& context,
                                         RingGrid const& around, double phase, int highest);

}  // namespace hdconj::load
