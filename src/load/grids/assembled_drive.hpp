// SPDX-License-Identifier: GPL-3.0-or-later
// A drive on one grid, assembled: the cup on its wave generator, no tooth in contact.
#pragma once

#include <vector>

#include "contact/flank_grid.hpp"
#include "hdconj/load.hpp"
#include "load/model/load_model.hpp"
#include "load/study/load_problem.hpp"

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

/// The drive on grids that are each half as fine as the one before: every second slice, flank point and circle of the
/// bearing, and half of the harmonics, on a mesh with two elements across the wall. Fewer than @p most where a grid
/// would have fewer than two slices, or a coarse grid has no solution.
[[nodiscard]] std::vector<AssembledDrive> coarser_drives(contact::ContactContext const& context, std::size_t most);

/// Every second slice of a grid and every second of its points, with the last ones.
[[nodiscard]] contact::FlankGrid coarsened(contact::FlankGrid const& grid);

/// Figures of the cup as it is assembled, with an error of the stress only.
[[nodiscard]] AssembledCup assembled_cup(contact::ContactContext const& context, AssembledDrive const& drive);

}  // namespace hdconj::load
