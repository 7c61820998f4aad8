// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One surface of the circular spline under torque.
#pragma once

#include <functional>
#include <vector>

#include "contact_bench.hpp"
#include "contact_case.hpp"
#include "hdconj/load/elastic_drive.hpp"
#include "hdconj/pipeline/load_study.hpp"

namespace hdconj::detail {

/// The cup on its wave generator without any tooth in contact.
struct Assembly
{
    Equilibrium state;
    Eigen::MatrixXd forces;  ///< on the cup's stations
};
[[nodiscard]] Assembly assembly(ContactBench const& bench, ElasticDrive const& drive);

/// Everything about one surface.
/// @param torques   in the order of loading [N mm]
/// @param on_play   told when the play is known, before any torque
/// @param on_state  told after each torque
/// @param rated     gets the forces on the cup at the largest torque
[[nodiscard]] LoadCase load_case(ContactBench const& bench, ElasticDrive const& drive, Assembly const& start, SurfaceChoice const& choice,
                                 std::vector<double> const& torques, std::function<void(LoadCase const&)> const& on_play, std::function<void()> const& on_state, Eigen::MatrixXd& rated);

}  // namespace hdconj::detail
