// SPDX-License-Identifier: GPL-3.0-or-later
// A surface in the slices of a scene, and between them.
#pragma once

#include <cstddef>
#include <map>

#include "case_surface.hpp"
#include "contact/flank_grid.hpp"

namespace hdconj::contact {

/// A cleared surface between its slices: for an area integral that slices of a scene's number are too few for.
class RefinedFlanks
{
  public:
    /// @param bare  without side clearance
    /// @param grid  with the side clearance @p offset; both outlive this
    RefinedFlanks(CaseSurface const& surface, FlankGrid const& bare, FlankGrid const& grid, double tip, double offset)
        : surface_(surface), bare_(bare), grid_(grid), tip_(tip), offset_(offset)
    {
    }

    /// How many intervals to make of one between slices where @p spaces of all are looked at: as many as keep the work
    /// below that of a map.
    [[nodiscard]] int parts(std::size_t spaces) const;

    /// The flanks in planes between the slices too, @p parts to each interval.
    [[nodiscard]] FlankGrid const& operator()(int parts);

    /// Whether planes between slices have outlines of their own.
    [[nodiscard]] bool solved_anew() const { return surface_.is_solved_per_plane(); }

  private:
    [[nodiscard]] FlankGrid made(int parts) const;

    CaseSurface surface_;
    FlankGrid const& bare_;
    FlankGrid const& grid_;
    double tip_;
    double offset_;
    std::map<int, FlankGrid> kept_;
};

}  // namespace hdconj::contact
