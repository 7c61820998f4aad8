// SPDX-License-Identifier: GPL-3.0-or-later
// Units of figures: what a number counts in HDF5, in JSON and in the printed summary.
#pragma once

#include <string>

#include "hdconj/units.hpp"

namespace hdconj::figures {

/// An angle [rad] in degrees: where a decimal number of at most 15 digits is this very angle, as a scene's or an
/// option's 1.15 is, that number, without the roundings of there and back; else the product.
[[nodiscard]] double degrees_of(double angle);

struct Unit
{
    char const* stored;           ///< of the number in HDF5
    char const* key;              ///< end of the key in JSON; empty: a pure number
    char const* text;             ///< in the printed summary
    double shown_per_stored = 1;  ///< from the number in HDF5 to that in JSON and text
    bool is_given = false;        ///< an angle that a user may have given in degrees

    [[nodiscard]] double shown(double value) const { return is_given ? degrees_of(value) : value * shown_per_stored; }
    /// An error, which no user has given.
    [[nodiscard]] double shown_error(double error) const { return error * shown_per_stored; }
    /// What a key in JSON ends in, "_mm".
    [[nodiscard]] std::string suffix() const { return *key == '\0' ? "" : std::string("_") + key; }
    /// What the name of an attribute in HDF5 ends in, "_Nmm".
    [[nodiscard]] std::string attribute_suffix() const;
};

namespace unit {

// The same in HDF5 and JSON.
inline constexpr Unit one{"1", "", ""};
inline constexpr Unit mm{"mm", "mm", "mm"};
inline constexpr Unit mm2{"mm^2", "mm2", "mm^2"};
inline constexpr Unit second{"s", "s", "s"};
inline constexpr Unit newton{"N", "N", "N"};
inline constexpr Unit newton_per_mm{"N/mm", "N_per_mm", "N/mm"};
inline constexpr Unit newton_per_mm_to_3_2{"N/mm^(3/2)", "N_per_mm3_2", "N/mm^1.5"};
inline constexpr Unit megapascal{"MPa", "MPa", "MPa"};
inline constexpr Unit megabyte{"MB", "mb", "MB"};
inline constexpr Unit mm_per_rad{"mm/rad", "mm_per_rad", "mm/rad"};
// Others in JSON.
inline constexpr Unit um{"mm", "um", "um", per_um};
inline constexpr Unit degree{"rad", "deg", "deg", per_deg};
/// Of an angle that a user may have given in degrees.
inline constexpr Unit given_degree{"rad", "deg", "deg", per_deg, true};
inline constexpr Unit arcmin{"rad", "arcmin", "arcmin", per_arcmin};
inline constexpr Unit newton_metre{"N mm", "Nm", "N m", per_newton_metre};
inline constexpr Unit newton_metre_per_rad{"N mm/rad", "Nm_per_rad", "N m/rad", per_newton_metre};
inline constexpr Unit newton_metre_per_degree{"N mm/rad", "Nm_per_deg", "N m/deg", per_newton_metre_per_deg};
// In the text only.
inline constexpr Unit percent{"1", "", "%", per_percent};
inline constexpr Unit millisecond{"s", "", "ms", per_ms};

}  // namespace unit

}  // namespace hdconj::figures
