// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Flanks and wave generator as one problem of contacts; private to src/load.
#pragma once

#include <optional>

#include "equilibrium.hpp"
#include "numeric/complementarity.hpp"

namespace hdconj::load {

/// Number of flank contacts in the problem: none without torque.
[[nodiscard]] std::size_t flanks_of(LinearGaps const& gaps, std::optional<double> torque);

/// The complementarity problem of the contacts: those of the flanks, then those of the bearing in the order of
/// bearing_nodes(). A torque adds its equation as border and total.
/// @throws NumericalError when no flank can carry the torque
[[nodiscard]] numeric::Complementarity contact_problem(ElasticDrive const& drive, LinearGaps const& gaps,
                                                       std::optional<double> torque, int threads);

}  // namespace hdconj::load
