// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How much wider the clearing tip circle may have to be between the slices it was found in.
#pragma once

#include "part_tip.hpp"

namespace hdconj::contact {

/// Estimated error of the tip circle of @p cleared as that of the whole width [mm], at least the tolerance.
///
/// The tip circle is what the slices ask for before they are moved (land, rim, draft), lifted with the corners of the
/// moved flanks, and no smaller than where these meet. Each is the largest of one value per plane: how much larger it
/// may be between planes says least_between().
/// @param finer    the surface in all slices of the scene or in more planes
/// @param between  flanks of the cleared surface there, with its tip circle
/// @param error    estimated error of the side clearance, cleared.offset [mm]
/// @param given    least side clearance that the land was asked for with [mm]
[[nodiscard]] double clearing_tip_error(CaseSurface const& surface, CaseSurface const& finer, PartFlanks const& between,
                                        Cleared const& cleared, double error, double given);

}  // namespace hdconj::contact
