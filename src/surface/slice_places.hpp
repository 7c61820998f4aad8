// SPDX-License-Identifier: GPL-3.0-or-later
// Where the slices lie along the axis.
#pragma once

#include <cstddef>
#include <vector>

namespace hdconj::surface {

/// @p count places over the face width, both end planes among them, symmetric about z = 0 bit for bit; one slice lies
/// at 0.
[[nodiscard]] inline std::vector<double> slice_places(int count, double width)
{
    std::vector<double> z(static_cast<std::size_t>(count), 0.0);
    for (int k = 0; 2 * k + 1 < count; ++k) {
        // the ratio of the outermost is exactly one, so that they lie in the end planes
        double const place = width / 2 * (static_cast<double>(count - 1 - 2 * k) / (count - 1));
        z[static_cast<std::size_t>(k)] = -place;
        z[static_cast<std::size_t>(count - 1 - k)] = place;
    }
    return z;
}

}  // namespace hdconj::surface
