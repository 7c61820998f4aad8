// SPDX-License-Identifier: GPL-3.0-or-later
// The wall under the teeth, by the stress in the cup.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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
/// allows. What the cone of the cup needs to be clear is left out.
[[nodiscard]] MeshedSheet mesh_with_wall(DesignWishes const& wishes);

/// The least bending stress of the ring with which mesh_with_wall() would find a mesh, that of the thinnest wall which
/// has one; nothing where no steel helps [MPa].
[[nodiscard]] std::optional<double> least_bending_with_wall(DesignWishes const& wishes);

/// Whether mesh_with_wall() finds a mesh.
[[nodiscard]] bool has_mesh_with_wall(DesignWishes const& wishes);

/// Stress of the cup with the dimensions of @p made under the torque of @p wishes, and what its cone needs.
/// @param errors  whether the error of the grid is estimated
[[nodiscard]] WallTrial stress_of(MeshedSheet const& made, DesignWishes const& wishes, bool errors);

/// Whether @p a is a better wall than @p b: one with a result, whose teeth are clear, with less stress.
[[nodiscard]] bool is_better(WallTrial const& a, WallTrial const& b);

/// Tries the walls of some wishes under one torque after another. No torque changes the meshes, which are made once.
class WallSearch
{
  public:
    WallSearch(DesignWishes wishes, Talk talk) : wishes_(std::move(wishes)), talk_(std::move(talk)) {}

    /// mesh_with_wall(), and with a torque the first wall with which the stress of study_load() keeps the safety, and
    /// the side clearance and tip circle leave the coned cup clear. Where no wall does, the one with the least stress
    /// comes last, of those that are clear if any is.
    [[nodiscard]] MeshedSheet best(bool errors);

    /// The largest torque of two digits that a wall stands, after all were refused under the last torque, without
    /// errors; nothing where none is found.
    [[nodiscard]] std::optional<double> most_torque();

  private:
    [[nodiscard]] MeshedSheet loaded(double wall, bool errors);

    DesignWishes wishes_;
    Talk talk_;
    std::optional<MeshedSheet> as_wished_;
    std::map<double, MeshedSheet> clear_;  // by wall
};

/// Adds a row with the root clearance that the coned cup needs. The bottom of the space is made for the tips in the
/// middle of the face width, and the cone lifts those at one end further out.
void add_root_clearance(MeshedSheet& made);

}  // namespace hdconj::design
