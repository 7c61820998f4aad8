// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Polynomials on [0, 1] in Bernstein form: stable evaluation, and roots counted by sign variations.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/numeric/tolerance.hpp"

namespace hdconj {

/// Largest degree that the fixed work arrays hold; a profile curve of degree d needs 2 d - 1.
inline constexpr int bernstein_max_degree = 23;
using BernsteinWork = std::array<double, bernstein_max_degree + 1>;

/// Value at @p t by de Casteljau's scheme; degree = size - 1 <= bernstein_max_degree.
[[nodiscard]] inline double bernstein_value(std::span<double const> c, double t)
{
    BernsteinWork w{};
    std::copy(c.begin(), c.end(), w.begin());
    for (std::size_t r = c.size() - 1; r > 0; --r)
        for (std::size_t i = 0; i < r; ++i)
            w[i] += t * (w[i + 1] - w[i]);
    return w[0];
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

/// Product; degrees add.
[[nodiscard]] inline std::vector<double> bernstein_product(std::span<double const> a, std::span<double const> b)
{
    auto const binomial = [](std::size_t n, std::size_t k) {
        double value = 1;
        for (std::size_t i = 0; i < k; ++i)
            value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
        return value;
    };
    std::size_t const m = a.size() - 1;
    std::size_t const n = b.size() - 1;
    std::vector<double> p(m + n + 1, 0.0);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            p[i + j] += binomial(m, i) * a[i] * binomial(n, j) * b[j];
    for (std::size_t k = 0; k < p.size(); ++k)
        p[k] /= binomial(m + n, k);
    return p;
}

/// The same polynomial written with a higher degree.
[[nodiscard]] inline std::vector<double> bernstein_raised(std::span<double const> c, std::size_t degree)
{
    std::vector<double> raised(c.begin(), c.end());
    while (raised.size() < degree + 1)
    {
        double const n = static_cast<double>(raised.size());
        std::vector<double> next(raised.size() + 1);
        next.front() = raised.front();
        next.back() = raised.back();
        for (std::size_t i = 1; i < raised.size(); ++i)
        {
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
    for (std::size_t r = 1; r <= n; ++r)
    {
        for (std::size_t i = n; i >= r; --i)
            c[i] = c[i - 1] + t * (c[i] - c[i - 1]);
        right[n - r] = c[n];
    }
}

/// Roots of a Bernstein polynomial on [0, 1], at most its degree of them.
struct BernsteinRoots
{
    std::array<double, bernstein_max_degree + 1> t{};
    std::array<double, bernstein_max_degree + 1> width{};  ///< 0: simple; else a near-double root of that width
    int count = 0;
};

namespace detail {

inline void bernstein_isolate(std::span<double const> whole, BernsteinWork const& work, double a, double b,
                              double noise, BernsteinRoots& out)
{
    std::size_t const size = whole.size();
    int variations = 0;
    int sign = 0;
    double largest = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
        largest = std::max(largest, std::abs(work[i]));
        if (std::abs(work[i]) <= noise)
            continue;
        int const s = work[i] > 0 ? 1 : -1;
        variations += sign != 0 && s != sign;
        sign = s;
    }
    bool const sure_ends = std::abs(work[0]) > noise && std::abs(work[size - 1]) > noise;
    if (variations == 0 && sure_ends)
        return;
    if (out.count >= bernstein_max_degree)
        return;
    auto const record = [&](double t, double width) {
        out.t[static_cast<std::size_t>(out.count)] = t;
        out.width[static_cast<std::size_t>(out.count)] = width;
        ++out.count;
    };
    if (variations == 1 && sure_ends)
    {
        auto const f = [&](double t) { return bernstein_value(whole, t); };
        double const fa = f(a);
        double const fb = f(b);
        if ((fa < 0) != (fb < 0))
            return record(bracketed_root(f, a, b, fa, fb).x, 0);
    }
    constexpr double smallest = 0x1p-40;
    if (b - a <= smallest || largest <= noise)
    {
        // the piece is zero to roundoff: a simple root on its border is decided by the signs of the neighbours,
        // which appear as an end below noise there as well; only one of the two sides records it
        if (out.count > 0 && out.t[static_cast<std::size_t>(out.count - 1)] >= a - (b - a))
            return;
        return record(0.5 * (a + b), b - a);
    }
    if (variations == 0 && !sure_ends)
    {
        bool const left = std::abs(work[0]) <= noise;
        bool const right = std::abs(work[size - 1]) <= noise;
        bool inner = false;
        for (std::size_t i = 1; i + 1 < size; ++i)
            inner = inner || std::abs(work[i]) <= noise;
        if (!inner && left != right)
            return record(left ? a : b, 0);
    }
    BernsteinWork low = work;
    BernsteinWork high{};
    constexpr double cut = 0.4951;
    bernstein_split({low.data(), size}, {high.data(), size}, cut);
    double const middle = a + cut * (b - a);
    bernstein_isolate(whole, low, a, middle, noise, out);
    bernstein_isolate(whole, high, middle, b, noise, out);
}

}  // namespace detail

/// All roots in [0, 1], increasing.
///
/// By the variation-diminishing property no sign change among the coefficients means no root and one means exactly one;
/// otherwise the interval is cut. Coefficients below @p noise count as zero. A root at 0 or 1 to roundoff is reported there.
/// Accuracy: simple roots to the last bits; a pair closer than 2^-40 comes out as one root with its width.
[[nodiscard]] inline BernsteinRoots bernstein_roots(std::span<double const> c, double noise)
{
    BernsteinRoots roots;
    BernsteinWork work{};
    std::copy(c.begin(), c.end(), work.begin());
    detail::bernstein_isolate(c, work, 0, 1, noise, roots);
    // a root on a cut may be reported from both sides
    int kept = 0;
    for (int i = 0; i < roots.count; ++i)
    {
        auto const now = static_cast<std::size_t>(i);
        if (kept > 0)
        {
            auto const last = static_cast<std::size_t>(kept - 1);
            constexpr double same = 0x1p-39;
            if (roots.t[now] - roots.t[last] <= same)
                continue;
        }
        roots.t[static_cast<std::size_t>(kept)] = roots.t[now];
        roots.width[static_cast<std::size_t>(kept)] = roots.width[now];
        ++kept;
    }
    roots.count = kept;
    return roots;
}

}  // namespace hdconj
