// SPDX-License-Identifier: GPL-3.0-or-later
// A drive on one grid, assembled: the cup on its wave generator, no tooth in contact.
#pragma once

#include <optional>
#include <vector>

#include "contact/flank_grid.hpp"
#include "hdconj/load.hpp"
#include "load/model/load_model.hpp"
#include "load_problem.hpp"

namespace hdconj::load {

/// The cup on its wave generator without any tooth in contact.
[[nodiscard]] LoadedDrive assembly(contact::ContactContext const& context, ElasticDrive const& drive);

/// A model with its assembly.
struct AssembledDrive
{
    LoadGrid grid;
    LoadModel model;
    LoadedDrive unloaded;
};

/// The drive with every second slice, flank point, circle of the bearing and half of the harmonics, on a mesh with two
/// elements across the wall. Nothing for fewer than three slices, and where the coarse grid has no solution.
[[nodiscard]] std::optional<AssembledDrive> coarse_drive(contact::ContactContext const& context);

/// The slices @p slices of a grid, with every second of its points and the last.
[[nodiscard]] contact::FlankGrid coarsened(contact::FlankGrid const& grid, std::vector<std::size_t> const& slices);

/// Figures of the cup as it is assembled, with an error of the stress only.
[[nodiscard]] AssembledCup assembled_cup(contact::ContactContext const& context, AssembledDrive const& drive);

}  // namespace hdconj::load
