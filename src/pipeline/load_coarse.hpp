// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The same drive on a grid half as fine: what figures are worth.
#pragma once

#include <cstddef>
#include <optional>

#include "hdconj/contact/flank_grid.hpp"
#include "load_case.hpp"
#include "load_model.hpp"

namespace hdconj::detail {

/// Model and assembly with every second slice, flank point, circle of the bearing and half of the harmonics, on a mesh with two elements across the wall: one that differs in what it
/// cannot show.
struct CoarseDrive
{
    LoadGrid grid;
    LoadModel model;
    Assembly start;
};

/// None for fewer than three slices, whose influence no coarser grid shows, and where the coarse grid has no solution.
[[nodiscard]] std::optional<CoarseDrive> coarse_drive(ContactBench const& bench);

/// Some slices of a grid, and every second of its points and the last.
[[nodiscard]] FlankGrid thinned(FlankGrid const& grid, std::vector<std::size_t> const& slices);

/// Estimated error over the distance from a grid half as fine: two grids, first order, safety 3 of Roache's index (J. Fluids Eng. 116, 1994), and a third more since what the grids
/// differ in and what their meshes do may cancel in part (seen: by a tenth of the estimate).
/// Below nine slices the coarse grid has fewer than five and is no longer in step with the fine one: three times as much.
[[nodiscard]] inline double grid_safety(std::size_t slices)
{
    constexpr double two_grids = 4;
    constexpr std::size_t in_step = 9;
    return slices < in_step ? two_grids * 3 : two_grids;
}

/// @p safety times the distance of each figure that is a number, the distance of those that count, and zero elsewhere. Stiffness, shares, largest force and pressure hang together by the
/// contacts that are closed: relative to their size, none gets less than the median of them. Of the forces of the bearing none
/// gets less than the worst of them.
[[nodiscard]] LoadedState error_between(LoadedState const& a, LoadedState const& b, double safety);

/// By how much the equivalent stress at the corners of the element at the peak differs from the peak, which is that of a Gauss point inside [MPa].
[[nodiscard]] double stress_at_corners(LoadModel const& model, HarmonicField const& field, StressPeak const& peak);

}  // namespace hdconj::detail
