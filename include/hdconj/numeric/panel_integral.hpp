// SPDX-License-Identifier: GPL-3.0-or-later
// The integral of a periodic function that is analytic only between given breaks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/numeric/chebyshev.hpp"

namespace hdconj::numeric {

/// Integral of f as Chebyshev series on panels.
///
/// One period is cut at the breaks and bisected further. A panel is fine enough when its interpolant of degree 16 has a
/// tail below some roundings of the largest |f|. It is also left when the tail no longer falls with the panel's length,
/// which is the rounding error of f itself. Accuracy: relative_error() against the largest |f|; `resolved()` says
/// whether every panel is fine enough.
class PanelIntegral
{
  public:
    /// @param breaks  in (-period/2, period/2], increasing, at least one
    template <class F>
    PanelIntegral(F&& f, double period, std::span<double const> breaks) : period_(period)
    {
        for (std::size_t i = 0; i < breaks.size(); ++i) {
            double const end = i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + period;
            // the end belongs to the panel after it
            add(f, breaks[i], end, end - unit_roundoff * period, std::numeric_limits<double>::infinity());
        }
        total_ = panels_.back().before + panels_.back().mean_times_length;
        at_zero_ = from_first_break(0);
    }

    [[nodiscard]] double mean() const { return total_ / period_; }
    [[nodiscard]] bool resolved() const { return resolved_; }
    [[nodiscard]] double relative_error() const { return worst_tail_ / largest_; }

    /// Integral from 0 to @p u.
    [[nodiscard]] double integral(double u) const { return from_first_break(u) - at_zero_; }

  private:
    static constexpr double smallest_share = 0x1p-20;

    /// The antiderivative on [begin, begin + 2 half] is before + half * sum c_k T_k(x), zero at x = -1.
    struct Panel
    {
        double begin, half, before, mean_times_length;
        std::array<double, chebyshev_nodes + 1> c;
    };

    template <class F>
    void add(F& f, double a, double b, double last_inside, double tail_before)
    {
        double const half = 0.5 * (b - a);
        ChebyshevVector values;
        for (int j = 0; j < chebyshev_nodes; ++j)
            values[j] = f(std::min(a + half * (1 + chebyshev_points()[j]), last_inside));
        ChebyshevVector const c = chebyshev_coefficients(values);
        largest_ = std::max(largest_, values.cwiseAbs().maxCoeff());
        double const tail = chebyshev_tail(c);
        constexpr double roundings = 16 * unit_roundoff;
        constexpr double noisiest = 0x1p-30;
        bool const noise_reached = tail > tail_before / 4 && tail <= noisiest * largest_;
        bool const fine = tail <= roundings * largest_ || noise_reached;
        bool const divisible = b - a > period_ * smallest_share;
        if (!fine && divisible) {
            add(f, a, a + half, std::min(a + half, last_inside), tail);
            add(f, a + half, b, last_inside, tail);
            return;
        }
        resolved_ = resolved_ && fine;
        worst_tail_ = std::max(worst_tail_, tail);
        append(a, half, c);
    }

    void append(double a, double half, ChebyshevVector const& c)
    {
        Panel p{a, half, panels_.empty() ? 0 : panels_.back().before + panels_.back().mean_times_length, 0, {}};
        auto const coefficient = [&](int k) { return k < chebyshev_nodes ? c[k] : 0.0; };
        // integral of T_k: T_{k+1}/(2(k+1)) - T_{k-1}/(2(k-1)), T_0 -> T_1
        for (int k = 1; k <= chebyshev_nodes; ++k) {
            double const lower = k == 1 ? 2 * coefficient(0) : coefficient(k - 1);
            p.c[static_cast<std::size_t>(k)] = (lower - coefficient(k + 1)) / (2 * k);
        }
        double at_start = 0;
        double at_end = 0;
        for (int k = chebyshev_nodes; k >= 1; --k) {
            at_end += p.c[static_cast<std::size_t>(k)];
            at_start += (k % 2 == 0 ? 1 : -1) * p.c[static_cast<std::size_t>(k)];
        }
        p.c[0] = -at_start;
        p.mean_times_length = half * (at_end - at_start);
        panels_.push_back(p);
    }

    [[nodiscard]] double from_first_break(double u) const
    {
        double const first = panels_.front().begin;
        double const turns = std::floor((u - first) / period_);
        double const v = turns == 0 ? u : u - turns * period_;
        auto const after = std::upper_bound(panels_.begin() + 1, panels_.end(), v,
                                            [](double x, Panel const& p) { return x < p.begin; });
        Panel const& p = *(after - 1);
        double const x = (v - p.begin) / p.half - 1;
        double b1 = 0;
        double b2 = 0;
        for (std::size_t k = chebyshev_nodes; k >= 1; --k) {
            double const b = p.c[k] + 2 * x * b1 - b2;
            b2 = b1;
            b1 = b;
        }
        return turns * total_ + (p.before + p.half * (p.c[0] + x * b1 - b2));
    }

    double period_;
    double total_ = 0;
    double at_zero_ = 0;
    double largest_ = 0;
    double worst_tail_ = 0;
    bool resolved_ = true;
    std::vector<Panel> panels_;
};

}  // namespace hdconj::numeric
