// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Flanks and wave generator as one problem of contacts; private to src/load.
#pragma once

#include <optional>

#include "hdconj/elastic/complementarity.hpp"
#include "hdconj/load/equilibrium.hpp"

namespace hdconj::detail {

/// How many flank contacts take part: none without torque.
[[nodiscard]] std::size_t flanks_of(LinearGaps const& gaps, std::optional<double> torque);

/// Contacts of the flanks, then of the bearing in the order of bearing_nodes(); with a torque its border and total.
/// @throws NumericalError when no flank can carry the torque
[[nodiscard]] Complementarity contact_problem(ElasticDrive const& drive, LinearGaps const& gaps, std::optional<double> torque, int threads);

}  // namespace hdconj::detail
