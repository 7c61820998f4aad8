// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One surface of the circular spline under torque.
#pragma once

#include <functional>
#include <vector>

#include "contact_bench.hpp"
#include "contact_case.hpp"
#include "hdconj/load/equilibrium.hpp"
#include "hdconj/pipeline/load_study.hpp"

namespace hdconj::detail {

/// The cup on its wave generator without any tooth in contact.
struct Assembly
{
    Equilibrium state;
    Eigen::MatrixXd forces;  ///< on the cup's stations
};
[[nodiscard]] Assembly assembly(ContactBench const& bench, ElasticDrive const& drive);

struct CoarseDrive;

/// What is told, and forces on the cup's stations at the largest torque.
struct CaseReport
{
    std::function<void(LoadCase const&)> on_play;  ///< when the play is known, before any torque
    std::function<void()> on_state;                ///< after each torque
    Eigen::MatrixXd rated;
    Eigen::MatrixXd coarse;                        ///< on the coarse grid; empty: there is none
};

/// Everything about one surface.
/// @param coarse   what errors are estimated with; null: they are not
/// @param torques  in the order of loading [N mm]
[[nodiscard]] LoadCase load_case(ContactBench const& bench, ElasticDrive const& drive, Assembly const& start, CoarseDrive const* coarse, SurfaceChoice const& choice,
                                 std::vector<double> const& torques, CaseReport& report);

}  // namespace hdconj::detail
