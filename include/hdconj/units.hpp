// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Units. The library computes in mm, N, rad and seconds; every other unit appears at its edges only.
#pragma once

#include <numbers>

namespace hdconj {

/// @name Units in those of the library: `x * deg` is an angle of x degrees in rad, `angle / deg` that angle in degrees.
/// @{
inline constexpr double deg = std::numbers::pi / 180;  ///< [rad]
inline constexpr double arcmin = deg / 60;             ///< [rad]
inline constexpr double arcsec = deg / 3600;           ///< [rad]
inline constexpr double um = 1e-3;                     ///< [mm]
inline constexpr double newton_metre = 1000;           ///< [N mm]
inline constexpr double rpm = std::numbers::pi / 30;   ///< [rad/s]
/// @}

/// @name Reciprocals, for output: `angle * per_deg` is an angle in degrees.
/// A product with a reciprocal and a quotient may differ in the last bit, so that a printed quantity keeps to one.
/// @{
inline constexpr double per_deg = 180 / std::numbers::pi;  ///< degrees in a radian
inline constexpr double per_arcmin = per_deg * 60;         ///< minutes of arc in a radian
inline constexpr double per_um = 1000;                     ///< micrometres in a millimetre
inline constexpr double per_newton_metre = 1e-3;           ///< N m in a N mm
inline constexpr double per_newton_metre_per_deg = per_newton_metre * std::numbers::pi / 180;  ///< from N mm/rad
inline constexpr double per_percent = 100;                                                     ///< from a fraction
inline constexpr double per_ms = 1000;  ///< milliseconds in a second
/// @}

/// An angle given in degrees, in rad: pi multiplies before 180 divides. Exact multiples of 180 degrees become multiples
/// of std::numbers::pi.
[[nodiscard]] constexpr double from_deg(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

/// An angle [rad] in degrees: 180 multiplies before pi divides.
[[nodiscard]] constexpr double to_deg(double angle)
{
    return angle * 180 / std::numbers::pi;
}

}  // namespace hdconj
