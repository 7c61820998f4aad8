// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which contacts an equilibrium begins with; private to src/load.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/elastic/complementarity.hpp"
#include "hdconj/load/equilibrium.hpp"

namespace hdconj::detail {

/// Contacts to begin with, and the points of the line of balls that stand off.
struct Start
{
    std::vector<int> contacts;
    std::vector<bool> off;
};

/// @param guess  equilibrium of a like problem: contacts that were closed there; null: of the same problem with fewer places
/// @param flanks  contacts of the problem that are not the bearing's
[[nodiscard]] Start equilibrium_start(ElasticDrive const& drive, LinearGaps const& gaps, Complementarity const& problem, std::size_t flanks, Equilibrium const* guess, int threads);

}  // namespace hdconj::detail
