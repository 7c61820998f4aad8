// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The smallest distance found so far, and its refinement by golden section.
#pragma once

#include <cmath>
#include <limits>

namespace oracle {

/// Smallest distance and where.
struct Touch
{
    double distance = std::numeric_limits<double>::infinity();
    double s = 0;  ///< position
    int copy = 0;  ///< tooth turned clockwise by this many pitches
};

/// Takes the smallest value of @p f on (a, b), where it has one minimum, if it is below @p touch.
template <class F>
void golden(F const& f, double a, double b, int copy, Touch& touch)
{
    double const ratio = (std::sqrt(5.0) - 1) / 2;
    double c = b - ratio * (b - a), d = a + ratio * (b - a), fc = f(c), fd = f(d);
    for (int step = 0; step < 90 && b - a > 1e-15; ++step) {
        if (fc < fd) {
            b = d;
            d = c;
            fd = fc;
            c = b - ratio * (b - a);
            fc = f(c);
        } else {
            a = c;
            c = d;
            fc = fd;
            d = a + ratio * (b - a);
            fd = f(d);
        }
    }
    if (fc < touch.distance)
        touch = {fc, c, copy};
    if (fd < touch.distance)
        touch = {fd, d, copy};
}

}  // namespace oracle
