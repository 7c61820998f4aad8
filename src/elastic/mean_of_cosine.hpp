// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Harmonics as a contact of some width feels them.
#pragma once

#include <cmath>

namespace hdconj::elastic {

/// Mean of cos(n phi) over @p spread [rad] about phi = 0.
inline double mean_of_cosine(double n, double spread)
{
    double const half = n * spread / 2;
    return half == 0 ? 1 : std::sin(half) / half;
}

}  // namespace hdconj::elastic
