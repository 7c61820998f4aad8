// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads a torque-twist curve that a test rig has logged: CSV with a header that names columns and units.
///
///     angle [arcmin], torque [N m]           current [A], position [counts]
///     0.0, 0.0                               0.000, 0
///     3.4, 2.0                               0.168, 113
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include "hdconj/pipeline/measured.hpp"
#include "hdconj/scene/fault.hpp"

namespace hdconj {

/// A larger file is refused before it is read. [bytes]
inline constexpr std::size_t largest_measured_file = std::size_t{64} << 20;
/// The fit looks at all pairs of a branch's samples: a second or two for this many.
inline constexpr std::size_t most_samples = 100000;

/// What the user says about the rig; units as typed.
struct RigOptions
{
    std::optional<double> torque_constant;  ///< [N m/A]
    std::optional<double> counts_per_turn;
    std::optional<double> ratio;
    std::optional<double> efficiency;
};

struct MeasuredReading
{
    MeasuredCurve curve;  ///< of no use where there are faults
    Faults faults;        ///< all of them: of the options, the header, the rows, with line and column
};

/// Reads the columns "torque" or "current", and "angle" or "position"; others are left alone. Between the fields stands what the header has:
/// semicolon, tab or comma. A line that begins with '#' is a comment. Units stand in brackets: torque [N m, N mm, mN m], current [A, mA],
/// angle [deg, arcmin, arcsec, rad, mrad], position [counts].
/// Torque = torque constant x current x |ratio| x efficiency, angle = 2 pi counts / (counts per turn x |ratio|).
/// @param scene_ratio  of the drive, where @p rig says none
[[nodiscard]] MeasuredReading examine_measured(std::filesystem::path const& file, RigOptions const& rig, double scene_ratio);

}  // namespace hdconj
