// SPDX-License-Identifier: GPL-3.0-or-later
// Orders of a periodic function from its values.
#pragma once

#include <vector>

namespace hdconj::running {

/// One harmonic: amplitude cos(k x - phase), x from 0 to 2 pi over the period.
struct Harmonic
{
    int order = 0;
    double amplitude = 0;
    double phase = 0;  ///< [rad]
};

/// The harmonics 1 ... @p highest of a function by least squares over its values: with a constant,
/// f(x) = a_0 + sum(a_k cos(k x) + b_k sin(k x)). Even points give the discrete Fourier transform; uneven ones none of
/// the aliases that the transform would show. Domain: more than 2 @p highest points. Accuracy: roundings times the
/// condition of the points, which is near 1 where they are nearly even.
/// @param x  places of the values [rad]
[[nodiscard]] std::vector<Harmonic> harmonics(std::vector<double> const& x, std::vector<double> const& values,
                                              int highest);

}  // namespace hdconj::running
