// SPDX-License-Identifier: GPL-3.0-or-later
// The toothed surface of the circular spline as a mesh.
#pragma once

#include <array>
#include <vector>

#include "hdconj/mesh_files.hpp"

namespace hdconj::io {

/// Landmarks of an outline with flanks: land corner, flank end, middle, flank end, land corner.
inline constexpr std::size_t landmark_count = 5;

/// Quadrilaterals with shared points.
struct Surface
{
    /// What a cell is of.
    enum Part : int
    {
        land = 0,
        left_flank = 1,
        root = 2,
        right_flank = 3
    };
    /// Where a point comes from.
    struct Origin
    {
        std::size_t space = 0;  ///< number of the tooth space, clockwise from the y axis
        std::size_t slice = 0;
        std::size_t index = 0;  ///< in the outline of the slice
    };

    std::vector<std::array<double, 3>> points;  ///< [mm]
    std::vector<std::array<int, 4>> quads;      ///< counter-clockwise as seen from outside the material
    std::vector<int> part;                      ///< of each quadrilateral
    std::vector<Origin> origin;                 ///< of each point
};

/// Two slices or more, or one and a width.
[[nodiscard]] bool has_surface(Solution const& solution);

/// One tooth space with all its points.
/// @throws InputError unless @ref has_surface
[[nodiscard]] Surface tooth_surface(Solution const& solution);

/// @throws InputError unless @ref has_surface
[[nodiscard]] Surface spline_surface(Solution const& solution, SurfaceOptions const& options);

/// Indices of outline points that are kept, ends and landmarks among them: between neighbours no slice's outline is
/// further than
/// @p tolerance [mm] from its chord.
[[nodiscard]] std::vector<std::size_t> kept_points(CircularSplineOutline const& spline, double tolerance);

}  // namespace hdconj::io
