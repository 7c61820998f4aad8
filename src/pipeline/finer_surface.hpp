// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A surface in the slices of a scene, and between them.
#pragma once

#include <cstddef>
#include <map>

#include "contact_bench.hpp"
#include "hdconj/contact/flank_grid.hpp"

namespace hdconj::detail {

/// One flank stands for both.
[[nodiscard]] inline bool is_symmetric(ContactBench const& bench)
{
    return bench.tooth.mirror_symmetric && bench.maker.motion(0).motion.symmetric();
}

/// The surface with enough points for a map over its flanks, in the slices of @p maker.
[[nodiscard]] MatchedOutline surface_of(ContactBench const& bench, SurfaceMaker& maker, SurfaceChoice const& choice, double tip);
/// In the slices of the scene.
[[nodiscard]] MatchedOutline surface_of(ContactBench const& bench, SurfaceChoice const& choice, double tip);

/// A cleared surface between its slices: for an area integral that slices of a scene's number are too few for.
class FinerSurface
{
  public:
    /// @param bare  without side clearance
    /// @param grid  with the side clearance @p offset; both outlive this
    FinerSurface(ContactBench const& bench, SurfaceChoice const& choice, FlankGrid const& bare, FlankGrid const& grid, double tip, double offset)
        : bench_(bench), choice_(choice), bare_(bare), grid_(grid), tip_(tip), offset_(offset)
    {
    }

    /// How many intervals to make of one between slices where @p spaces of all are looked at: as many as keep the work below that of a map.
    [[nodiscard]] int parts(std::size_t spaces) const;

    /// The flanks in planes between the slices too, @p parts to each interval.
    [[nodiscard]] FlankGrid const& operator()(int parts);

    /// Whether planes between slices have outlines of their own.
    [[nodiscard]] bool solved_anew() const { return choice_.surface == "per-slice" && bench_.scene.coning; }

  private:
    [[nodiscard]] FlankGrid made(int parts) const;

    ContactBench const& bench_;
    SurfaceChoice choice_;
    FlankGrid const& bare_;
    FlankGrid const& grid_;
    double tip_;
    double offset_;
    std::map<int, FlankGrid> known_;
};

}  // namespace hdconj::detail
