// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials on [0, 1] in Bernstein form: stable evaluation, products and subdivision.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace hdconj::numeric {

/// Largest degree that the fixed work arrays hold; a profile curve of degree d needs 2 d - 1.
inline constexpr int bernstein_max_degree = 23;
using BernsteinWork = std::array<double, bernstein_max_degree + 1>;

/// Pascal's triangle, exact: n over k for k <= n <= bernstein_max_degree.
inline constexpr auto binomials = [] {
    std::array<BernsteinWork, bernstein_max_degree + 1> rows{};
    for (std::size_t n = 0; n < rows.size(); ++n) {
        rows[n][0] = 1;
        for (std::size_t k = 1; k <= n; ++k)
            rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
    }
    return rows;
}();

/// Value at @p t of degree n = size - 1 <= bernstein_max_degree: sum_k binomial(n, k) c_k t^k (1 - t)^(n - k) by
/// Horner's scheme in 1 - t. All terms keep their sign on [0, 1], so that rounding moves the coefficients by at most
/// some 4 n roundoffs of themselves, as de Casteljau's scheme does in n/2 times the work.
[[nodiscard]] inline double bernstein_value(std::span<double const> c, double t)
{
    std::size_t const n = c.size() - 1;
    double const rest = 1 - t;
    double value = c[0], power = 1;
    for (std::size_t k = 1; k <= n; ++k) {
        power *= t;
        value = value * rest + binomials[n][k] * power * c[k];
    }
    return value;
}

/// Derivative with respect to t, degree one less.
[[nodiscard]] inline std::vector<double> bernstein_derivative(std::span<double const> c)
{
    if (c.size() < 2)
        return {0.0};
    std::vector<double> d(c.size() - 1);
    for (std::size_t i = 0; i < d.size(); ++i)
        d[i] = static_cast<double>(d.size()) * (c[i + 1] - c[i]);
    return d;
}

/// Product; degrees add, to at most bernstein_max_degree.
[[nodiscard]] inline std::vector<double> bernstein_product(std::span<double const> a, std::span<double const> b)
{
    std::size_t const m = a.size() - 1;
    std::size_t const n = b.size() - 1;
    std::vector<double> p(m + n + 1, 0.0);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            p[i + j] += binomials[m][i] * a[i] * binomials[n][j] * b[j];
    for (std::size_t k = 0; k < p.size(); ++k)
        p[k] /= binomials[m + n][k];
    return p;
}

/// The same polynomial written with a higher degree.
[[nodiscard]] inline std::vector<double> bernstein_raised(std::span<double const> c, std::size_t degree)
{
    std::vector<double> raised(c.begin(), c.end());
    while (raised.size() < degree + 1) {
        double const n = static_cast<double>(raised.size());
        std::vector<double> next(raised.size() + 1);
        next.front() = raised.front();
        next.back() = raised.back();
        for (std::size_t i = 1; i < raised.size(); ++i) {
            double const share = static_cast<double>(i) / n;
            next[i] = share * raised[i - 1] + (1 - share) * raised[i];
        }
        raised = std::move(next);
    }
    return raised;
}

/// Splits at t: left half overwrites @p c, right half goes to @p right.
inline void bernstein_split(std::span<double> c, std::span<double> right, double t)
{
    std::size_t const n = c.size() - 1;
    right[n] = c[n];
    for (std::size_t r = 1; r <= n; ++r) {
        for (std::size_t i = n; i >= r; --i)
            c[i] = c[i - 1] + t * (c[i] - c[i - 1]);
        right[n - r] = c[n];
    }
}

}  // namespace hdconj::numeric
