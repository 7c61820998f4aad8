// SPDX-License-Identifier: GPL-3.0-or-later
// The active set that an equilibrium starts from; private to src/load.
#pragma once

#include <vector>

#include "equilibrium.hpp"
#include "numeric/complementarity.hpp"

namespace hdconj::load {

/// A first guess of the active set.
struct Start
{
    std::vector<int> contacts;  ///< that are closed
    std::vector<double> balls;  ///< forces of the points of the line of balls; empty: unknown
};

/// @param flanks  number of contacts of the problem that are not the bearing's; they come first
/// @param guess   equilibrium of a similar problem, whose closed contacts are taken; null: those of the same problem
/// with fewer places
[[nodiscard]] Start equilibrium_start(ElasticDrive const& drive, LinearGaps const& gaps,
                                      numeric::Complementarity const& problem, std::size_t flanks,
                                      Equilibrium const* guess, int threads);

}  // namespace hdconj::load
