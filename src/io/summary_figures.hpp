// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The figures of a solution that every summary shows; private to src/io.
#pragma once

#include <string>
#include <vector>

#include "hdconj/pipeline/solution.hpp"

namespace hdconj {

/// One scalar with the name it has in the HDF5 and JSON summaries. Names end in the unit: _mm, _um, _deg, _s.
struct Figure
{
    std::string key;
    double value = 0;
};

/// Degrees per radian.
inline constexpr double degree_per_radian = 57.295779513082320877;
/// An angle [rad] in degrees: where a decimal number of at most 15 digits is this very angle, as a scene's or an option's 1.15 is, that number, without
/// the roundings of there and back; else the product.
[[nodiscard]] double degrees_of(double angle);
/// Micrometres per millimetre.
inline constexpr double um_per_mm = 1000;

/// Geometry, clearance (where it was checked) and error estimates, in the order printed.
[[nodiscard]] std::vector<Figure> figures(Solution const& solution);

/// Derived dimensions.
[[nodiscard]] std::vector<Figure> geometry_figures(Solution const& solution);

/// Result of the check over a full turn; empty where it was not made.
[[nodiscard]] std::vector<Figure> clearance_figures(Solution const& solution);

[[nodiscard]] std::vector<Figure> error_figures(Solution const& solution);

/// The member whose tooth the scene gives: "flexspline" or "circular spline".
[[nodiscard]] std::string given_member(Solution const& solution);

/// Sum of the stages [s].
[[nodiscard]] double total_seconds(Solution const& solution);

/// Land of the circular spline between two tooth spaces, along the tip circle [mm].
[[nodiscard]] double land_width(PairGeometry const& geometry);

/// Largest of an error of the zones' ends; 0 without zones.
[[nodiscard]] double largest(std::vector<ConjugateZone> const& zones, double ConjugateZone::*error);

/// Points of the outline of one slice.
[[nodiscard]] std::size_t outline_points(Solution const& solution);

}  // namespace hdconj
