// SPDX-License-Identifier: GPL-3.0-or-later
#include "even_polynomial.hpp"

#include <algorithm>
#include <cstddef>

namespace hdconj::cam {

EvenPolynomial::Value EvenPolynomial::operator()(double x) const
{
    double const s = x / scale;
    Value sum;
    for (std::size_t j = coefficients.size(); j-- > 0;) {
        // Horner in s^2 for value, d/d(s^2) and its derivative
        sum.bend = sum.bend * s * s + sum.slope;
        sum.slope = sum.slope * s * s + sum.value;
        sum.value = sum.value * s * s + coefficients[j];
    }
    double const first = sum.slope, second = 2 * sum.bend;
    return {sum.value + cubic * s * s * s, (2 * s * first + 3 * cubic * s * s) / scale,
            (2 * first + 4 * s * s * second + 6 * cubic * s) / (scale * scale)};
}

void EvenPolynomial::add(double factor, EvenPolynomial const& other)
{
    coefficients.resize(std::max(coefficients.size(), other.coefficients.size()));
    for (std::size_t j = 0; j < other.coefficients.size(); ++j)
        coefficients[j] += factor * other.coefficients[j];
    cubic += factor * other.cubic;
}

}  // namespace hdconj::cam
