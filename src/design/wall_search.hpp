// SPDX-License-Identifier: GPL-3.0-or-later
// The wall under the teeth, by the stress in the cup.
#pragma once

#include <functional>
#include <string>

#include "mesh_search.hpp"

namespace hdconj::design {

/// Receives a line of text on what is being computed; may be empty.
using Talk = std::function<void(std::string const&)>;

/// Dimensions of the wishes, with the wall @p wall over the pitch diameter.
[[nodiscard]] Sheet sheet_of(DesignWishes const& wishes, double wall, ConeNeed const& cone = {});

/// Dimensions with a mesh, and the walls that were tried under torque.
struct MeshedSheet
{
    Sheet sheet;
    MeshChoice mesh;
    std::vector<WallTrial> walls;  ///< the last one is that of the sheet; empty without a torque

    /// Whether mesh and wall meet the wishes.
    [[nodiscard]] bool works() const { return mesh.best && (walls.empty() || walls.back().refusal.empty()); }
    /// All rows with those of the mesh.
    [[nodiscard]] std::vector<DesignRow> rows() const;
};

/// The wall nearest to type-50's 0.014 d_r in the range of the rule with which there is a mesh whose bending the safety
/// allows. A torque is left out, and with it the cone of the cup.
[[nodiscard]] MeshedSheet mesh_with_wall(DesignWishes const& wishes);

/// Whether mesh_with_wall() finds a mesh.
[[nodiscard]] bool has_mesh_with_wall(DesignWishes const& wishes);

/// The same, and with a torque the stress of study_load() keeps the safety, with a side clearance, a tip circle and a
/// root clearance that leave the coned cup clear. Where no wall does, the one with the least stress comes last.
[[nodiscard]] MeshedSheet mesh_under_torque(DesignWishes const& wishes, Talk const& talk);

/// Stress of the cup with the dimensions of @p made under the torque of the wishes, and what its cone needs.
[[nodiscard]] WallTrial stress_of(MeshedSheet const& made, DesignWishes const& wishes);

}  // namespace hdconj::design
