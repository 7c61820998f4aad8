// SPDX-License-Identifier: GPL-3.0-or-later
// Radial deformation and tip circle by computation.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sheet.hpp"

namespace hdconj::design {

/// A cup bent by its wave generator, where the sheet has one; null: none, or not known yet.
using SharedCup = std::shared_ptr<elastic::BentCup const>;

/// The mesh of a drive: what was tried, and what is taken.
struct MeshChoice
{
    std::vector<MeshTrial> trials;
    std::vector<SharedCup> cups;      ///< of the trials
    std::optional<std::size_t> best;  ///< nothing: none of them works
    std::vector<DesignRow> rows;      ///< of the best: wave generator, tip circle, and what they depend on
};

/// Tries radial deformations of 0.8 to 1.2 times m (z_c - z_f)/2, each with the least tip circle that leaves a land as
/// wide as asked and tips that part. With a torque all of that holds for the section of the bent cup.
/// @param sheet      teeth and body
/// @param least_tip  no tip circle is smaller [mm]
/// @param cups       of an earlier search with this body; empty: none is known
[[nodiscard]] MeshChoice search_mesh(Sheet const& sheet, DesignWishes const& wishes, double least_tip,
                                     std::vector<SharedCup> cups = {});

/// Whether there is a mesh.
struct MeshAnswer
{
    bool found = false;
    bool wall_stress = false;  ///< not found, and a thinner wall would be stressed less
};

/// Whether search_mesh() finds one, without looking for the best: the usual deformations first, until one works.
[[nodiscard]] MeshAnswer any_mesh(Sheet const& sheet, DesignWishes const& wishes);

/// The least bending stress of the ring with which there is a mesh, where any stress is allowed; nothing where there is
/// none [MPa].
[[nodiscard]] std::optional<double> least_bending(Sheet const& sheet, DesignWishes wishes);

/// Why the trial of @p failed that is nearest to the usual deformation is refused.
[[nodiscard]] std::string usual_refusal(MeshChoice const& failed);

/// Of a solved pair: tip land [modules], teeth in flank contact, angle lost by undercut over angle used.
struct MeshFigures
{
    explicit MeshFigures(Solution const& solution);
    double land, flank_contact, lost;
};

/// The rows of the wave generator at the deformation ratio @p ratio with the tip circle @p tip_radius.
[[nodiscard]] std::vector<DesignRow> mesh_rows(Sheet const& sheet, DesignWishes const& wishes, double ratio,
                                               double tip_radius);

}  // namespace hdconj::design
