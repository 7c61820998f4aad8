// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerance: a length together with the size of the thing it is a tolerance of.
#pragma once

#include <limits>

namespace hdconj {

/// Double-precision unit roundoff, 2^-53.
inline constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

/// Relative rounding of a figure that is computed from dimensions, such as a ratio of two of them: hundreds of times
/// what its operations make, and far below any dimension's tolerance.
inline constexpr double figure_roundoff = 0x1p13 * unit_roundoff;

/// How far a computed length may be from the true one.
///
/// Every absolute threshold in the program is derived from one of these, so that a drive scaled by s gives
/// the result scaled by s.
struct Tolerance
{
    double length;  ///< accepted error [mm]
    double scale;   ///< largest coordinate that enters the computation [mm]

    /// Error of a point after some tens of roundings at this scale [mm].
    [[nodiscard]] double roundoff() const { return 64 * unit_roundoff * scale; }

    /// Points closer than this are one point: far above roundoff, far below any tolerance that can be asked for.
    [[nodiscard]] double coincidence() const { return 1024 * roundoff(); }
};

}  // namespace hdconj
