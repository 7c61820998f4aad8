// SPDX-License-Identifier: GPL-3.0-or-later
// The stretch of the neutral curve on which flanks touch, at equal steps, and the curve that closes it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "completion.hpp"
#include "hdconj/wanted_curve.hpp"

namespace hdconj::cam {

/// Steps of half a wave.
inline constexpr std::size_t half_wave_rows = 180;

/// The curve where flanks touch, and how it begins.
struct Mesh
{
    MeshBegin begin;
    MarchedCurve curve;     ///< its points are rows
    std::size_t first = 0;  ///< number of the first of them

    [[nodiscard]] std::size_t last() const { return first + curve.points.size() - 1; }
};

/// Angle of a row from the major axis [rad].
[[nodiscard]] double row_angle(std::size_t row, int waves);

/// Follows the flanks from where they begin to touch to where they part.
/// @throws NumericalError where they touch on a few rows only, with the angle at which they stop
[[nodiscard]] Mesh mesh_of(FlankPair const& pair, CurveRule const& rule, int waves, double major, double tolerance);

/// The same from where they begin. @throws as mesh_of
[[nodiscard]] Mesh mesh_from(MeshBegin const& begin, FlankPair const& pair, CurveRule const& rule, int waves,
                             double tolerance);

/// Why the flanks part behind @p last: which end of a flank the contact has reached.
[[nodiscard]] std::string why_parted(FlankPair const& pair, MeshPoint const& last);

/// How far a closed curve follows the mesh, and how it goes on.
struct MeshClosing
{
    std::size_t last = 0;  ///< row at which it leaves the flanks
    EvenPolynomial rest;   ///< from there to the minor axis; none where the flanks touch up to it
};

/// The longest part of the mesh that a curve of bounded curvature closes: nowhere is the change of curvature more than
/// most_bending times major (n^2 - 1)/r_m^2, and nowhere is the curve hollow.
/// @throws NumericalError where there is none, with the angle at which the flanks would part
[[nodiscard]] MeshClosing closing_of(FlankPair const& pair, CurveRule const& rule, int waves, double major,
                                     Mesh const& mesh);

/// Half a wave: the mesh up to where it is left, the beginning before it and the rest after it. Errors are zero where
/// flanks touch, and not a number elsewhere.
[[nodiscard]] std::vector<WantedCurveRow> closed_rows(Mesh const& mesh, MeshClosing const& closing, int waves);

}  // namespace hdconj::cam
