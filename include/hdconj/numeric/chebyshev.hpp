// SPDX-License-Identifier: GPL-3.0-or-later
// Chebyshev interpolation of fixed degree on an interval, with bounds read off the coefficients.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>

namespace hdconj::numeric {

/// Degree of the interpolants: with bisection of the interval, 16 resolves the smooth functions of a gear pair
/// to roundoff on a few pieces.
inline constexpr int chebyshev_degree = 16;
inline constexpr int chebyshev_nodes = chebyshev_degree + 1;
using ChebyshevVector = Eigen::Matrix<double, chebyshev_nodes, 1>;

/// Nodes cos(pi j / N), j = 0 ... N, on [-1, 1]; the first is +1.
[[nodiscard]] inline ChebyshevVector const& chebyshev_points()
{
    static ChebyshevVector const points = [] {
        ChebyshevVector x;
        for (int j = 0; j < chebyshev_nodes; ++j)
            x[j] = std::cos(std::numbers::pi * j / chebyshev_degree);
        x[chebyshev_degree / 2] = 0;
        return x;
    }();
    return points;
}

/// Coefficients of the interpolant sum_k c_k T_k from the values at chebyshev_points().
[[nodiscard]] inline ChebyshevVector chebyshev_coefficients(ChebyshevVector const& values)
{
    static Eigen::Matrix<double, chebyshev_nodes, chebyshev_nodes> const transform = [] {
        Eigen::Matrix<double, chebyshev_nodes, chebyshev_nodes> m;
        for (int k = 0; k < chebyshev_nodes; ++k) {
            for (int j = 0; j < chebyshev_nodes; ++j) {
                bool const end_j = j == 0 || j == chebyshev_degree;
                bool const end_k = k == 0 || k == chebyshev_degree;
                m(k, j) = (end_j ? 0.5 : 1.0) * (end_k ? 1.0 : 2.0) / chebyshev_degree *
                          std::cos(std::numbers::pi * k * j / chebyshev_degree);
            }
        }
        return m;
    }();
    return transform * values;
}

/// Coefficients of the derivative on [-1, 1] (degree N - 1; the last entry is 0).
[[nodiscard]] inline ChebyshevVector chebyshev_derivative(ChebyshevVector const& c)
{
    ChebyshevVector d = ChebyshevVector::Zero();
    d[chebyshev_degree - 1] = 2 * chebyshev_degree * c[chebyshev_degree];
    for (int k = chebyshev_degree - 2; k >= 0; --k)
        d[k] = d[k + 2] + 2 * (k + 1) * c[k + 1];
    d[0] /= 2;
    return d;
}

/// Value of the interpolant at @p x in [-1, 1], by Clenshaw's recurrence.
[[nodiscard]] inline double chebyshev_value(ChebyshevVector const& c, double x)
{
    double b1 = 0;
    double b2 = 0;
    for (int k = chebyshev_degree; k >= 1; --k) {
        double const b0 = c[k] + 2 * x * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return c[0] + x * b1 - b2;
}

/// sum_{k >= 1} |c_k|: the interpolant lies within this of c_0 on the whole interval.
[[nodiscard]] inline double chebyshev_spread(ChebyshevVector const& c)
{
    return c.tail<chebyshev_nodes - 1>().lpNorm<1>();
}

/// Size of the last three coefficients: an estimate of the interpolation error, right where the coefficients go on
/// falling.
[[nodiscard]] inline double chebyshev_tail(ChebyshevVector const& c)
{
    return c.tail<3>().lpNorm<1>();
}

}  // namespace hdconj::numeric
