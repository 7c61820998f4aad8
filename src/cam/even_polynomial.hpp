// SPDX-License-Identifier: GPL-3.0-or-later
// The displacement about an axis of symmetry.
#pragma once

#include <vector>

namespace hdconj::cam {

/// Even polynomial: the displacement about an axis of symmetry, on which its third derivative may jump.
struct EvenPolynomial
{
    double scale = 1;                  ///< of the angle [rad]
    std::vector<double> coefficients;  ///< of (x/scale)^(2 j) [mm]
    double cubic = 0;                  ///< of |x/scale|^3 [mm]

    /// Value and slope at @p x from the axis.
    struct Value
    {
        double value = 0, slope = 0, bend = 0;
    };
    [[nodiscard]] Value operator()(double x) const;
    /// Adds @p factor times @p other, which has the same scale.
    void add(double factor, EvenPolynomial const& other);
};

}  // namespace hdconj::cam
