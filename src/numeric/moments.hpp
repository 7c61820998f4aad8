// SPDX-License-Identifier: GPL-3.0-or-later
// First and second moments of paired samples.
#pragma once

#include <cstddef>
#include <vector>

namespace hdconj::numeric {

/// Means, and sums of squares and products about them. The line of least squares through the samples passes through
/// the means with the slope xy/xx.
struct Moments
{
    double mean_x = 0, mean_y = 0;
    double xx = 0, xy = 0, yy = 0;
};

/// Domain: as many @p y as @p x.
[[nodiscard]] inline Moments moments(std::vector<double> const& x, std::vector<double> const& y)
{
    double const n = static_cast<double>(x.size());
    Moments m;
    for (std::size_t i = 0; i < x.size(); ++i) {
        m.mean_x += x[i] / n;
        m.mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        m.xx += (x[i] - m.mean_x) * (x[i] - m.mean_x);
        m.xy += (x[i] - m.mean_x) * (y[i] - m.mean_y);
        m.yy += (y[i] - m.mean_y) * (y[i] - m.mean_y);
    }
    return m;
}

}  // namespace hdconj::numeric
