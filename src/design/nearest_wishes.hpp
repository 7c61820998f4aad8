// SPDX-License-Identifier: GPL-3.0-or-later
// What can be asked for where the wishes cannot be met.
#pragma once

#include "mesh_search.hpp"

namespace hdconj::design {

/// Dimensions of the wishes, with the wall @p wall over the pitch diameter.
[[nodiscard]] Sheet sheet_of(DesignWishes const& wishes, double wall);

/// Dimensions with a mesh.
struct MeshedSheet
{
    Sheet sheet;
    MeshChoice mesh;
};

/// The thickest wall of the rule's range, from type-50's down, with which there is a mesh.
[[nodiscard]] MeshedSheet mesh_with_wall(DesignWishes const& wishes);

/// Each wish that stands in the way alone, with the nearest that works; all together where none does.
/// @param failed  the search without a result
[[nodiscard]] Faults nearest_wishes(DesignWishes const& wishes, MeshChoice const& failed);

/// Adds what was computed with the scene: lands, flank contact.
void add_mesh_figures(Design& design, MeshTrial const& taken);

}  // namespace hdconj::design
