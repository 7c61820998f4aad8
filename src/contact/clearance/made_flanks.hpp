// SPDX-License-Identifier: GPL-3.0-or-later
// Flanks with their side clearance, as the part is made.
#pragma once

#include <optional>

#include "contact/flank_grid.hpp"
#include "contact/study/case_surface.hpp"

namespace hdconj::contact {

/// The flanks of outlines that are made with a side clearance, as those of the result file are; nothing where they
/// cannot be made.
/// @param tip             radius of the tip circle at z = 0 [mm]
/// @param side_clearance  [mm], above 0
[[nodiscard]] std::optional<FlankGrid> solved_flanks(CaseSurface const& surface, double tip, double side_clearance);

/// The flanks @p bare with a side clearance: moved_into_material(), but those of a ruled surface with coning lie on the
/// straight lines that join the outlines of its end planes, which are moved before they are joined. Slices between that
/// are moved along their own normals give another surface: other points of the ends are joined, and where the normals
/// of the ends differ a line is moved by less than the side clearance. Slices with a draft are made with theirs too,
/// see FlankGrid::included_clearance. Where the outline cannot be made with that side clearance the slices are moved
/// all the same.
/// @param tip             radius of the tip circle at z = 0 [mm]
/// @param side_clearance  [mm]
[[nodiscard]] FlankGrid made_flanks(CaseSurface const& surface, FlankGrid const& bare, double tip,
                                    double side_clearance);

}  // namespace hdconj::contact
