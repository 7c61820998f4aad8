// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals of periodic functions by paths of their own, in any number type; private to src/accuracy.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "hdconj/error.hpp"
#include "reference_pair.hpp"

namespace hdconj::accuracy {

template <class T>
[[nodiscard]] T half_turn()
{
    static T const value = acos(T(-1));
    return value;
}

/// Chebyshev sum c_0 + c_1 T_1(x) + ... by Clenshaw's rule.
template <class T>
[[nodiscard]] T chebyshev_sum(std::vector<T> const& c, T const& x)
{
    T b1(0), b2(0);
    for (std::size_t k = c.size(); k-- > 1;) {
        T const b = T(2) * x * b1 - b2 + c[k];
        b2 = b1;
        b1 = b;
    }
    return x * b1 - b2 + c[0];
}

/// Integral from 0 of a function of period 2 pi/waves.
///
/// Without breaks: even and analytic all around; equal steps, whose sums converge geometrically, and the integrated
/// cosine sums of the same steps. With breaks: analytic between them; one Chebyshev series from break to break, with as
/// many terms as it takes. The program cuts panels of fixed degree instead. Accuracy: some roundings of T against the
/// largest value, or the scale where that is larger.
/// @throws NumericalError where either does not converge
template <class T>
class ReferenceIntegral
{
  public:
    ReferenceIntegral() = default;
    /// @param breaks  increasing, less than a period from first to last
    /// @param scale   of the terms that f is a difference of, and which it has the rounding of
    template <class F>
    ReferenceIntegral(F const& f, int waves, std::vector<T> const& breaks, T const& scale = T(0))
        : waves_(waves), period_(T(2) * half_turn<T>() / T(waves)), scale_(scale)
    {
        if (breaks.empty())
            expand(f);
        else
            cut(f, breaks);
    }

    [[nodiscard]] T mean() const { return mean_; }

    /// From 0 to @p u.
    [[nodiscard]] T operator()(T const& u) const
    {
        if (!panels_.empty())
            return from_first_break(u) - at_zero_;
        T const x = T(waves_) * u;
        T const twice = T(2) * cos(x);
        T b1(0), b2(0);
        for (std::size_t k = sines_.size(); k-- > 0;) {
            T const b = sines_[k] + twice * b1 - b2;
            b2 = b1;
            b1 = b;
        }
        return mean_ * u + b1 * sin(x);
    }

  private:
    struct Panel
    {
        T begin, half, before;  ///< before: integral from the first break to begin
        std::vector<T> c;       ///< of the integral from begin on
    };

    template <class F>
    void expand(F const& f)
    {
        T const eps = std::numeric_limits<T>::epsilon();
        constexpr std::size_t most = std::size_t{1} << 12;
        std::vector<T> values;
        T before(0), size = scale_;
        for (std::size_t n = 16;; n *= 2) {
            values.assign(n, T(0));
            T sum(0);
            for (std::size_t i = 0; i < n; ++i) {
                values[i] = f(period_ * T(static_cast<int>(i)) / T(static_cast<int>(n)));
                sum += values[i];
                size = std::max<T>(size, abs(values[i]));
            }
            mean_ = sum / T(static_cast<int>(n));
            if (abs(mean_ - before) <= T(16) * eps * size)
                break;
            if (n >= most)
                throw NumericalError(ErrorCode::not_converged, "reference", "neutral curve",
                                     "a function on it is not resolved");
            before = mean_;
        }
        std::size_t const n = values.size();
        T const points = T(static_cast<int>(n));
        std::vector<T> cosines(n);
        for (std::size_t i = 0; i < n; ++i)
            cosines[i] = cos(T(2) * half_turn<T>() * T(static_cast<int>(i)) / points);
        for (std::size_t k = 1; k < n / 2; ++k) {
            T sum(0);
            for (std::size_t i = 0; i < n; ++i)
                sum += values[i] * cosines[(k * i) % n];
            sines_.push_back(T(2) * sum / (points * T(static_cast<int>(k)) * T(waves_)));
        }
        while (!sines_.empty() && abs(sines_.back()) < eps * size / T(16))
            sines_.pop_back();
    }

    /// cos(m pi/(2 n)), m = 0 ... 4 n - 1.
    [[nodiscard]] static std::vector<T> cosines_of(int n)
    {
        std::vector<T> cosine(4 * static_cast<std::size_t>(n));
        for (std::size_t m = 0; m < cosine.size(); ++m)
            cosine[m] = cos(half_turn<T>() * T(static_cast<int>(m)) / T(2 * n));
        return cosine;
    }

    template <class F>
    void cut(F const& f, std::vector<T> const& breaks)
    {
        constexpr int fewest = 16;
        int nodes = fewest;
        std::vector<T> cosine = cosines_of(nodes);
        T total(0);
        for (std::size_t i = 0; i < breaks.size(); ++i) {
            T const end = i + 1 < breaks.size() ? breaks[i + 1] : T(breaks.front() + period_);
            panels_.push_back(panel(f, breaks[i], end, total, nodes, cosine));
            total += chebyshev_sum(panels_.back().c, T(1));
        }
        mean_ = total / period_;
        at_zero_ = from_first_break(T(0));
    }

    /// @param n  nodes to begin with; raised to what it took, with their cosines
    template <class F>
    [[nodiscard]] Panel panel(F const& f, T const& begin, T const& end, T const& before, int& n,
                              std::vector<T>& cosine) const
    {
        T const eps = std::numeric_limits<T>::epsilon();
        T const half = (end - begin) / T(2), middle = (begin + end) / T(2);
        constexpr int most = 512;
        for (;;) {
            auto const count = static_cast<std::size_t>(n);
            std::vector<T> value(count), a(count);
            T size = scale_;
            for (std::size_t i = 0; i < count; ++i) {
                value[i] = f(middle + half * cosine[2 * i + 1]);
                size = std::max<T>(size, abs(value[i]));
            }
            auto const coefficient = [&](std::size_t j) {
                T sum(0);
                for (std::size_t i = 0; i < count; ++i)
                    sum += value[i] * cosine[j * (2 * i + 1) % (4 * count)];
                return T(T(j == 0 ? 1 : 2) * sum / T(n));
            };
            if (abs(coefficient(count - 1)) > T(16) * eps * size || abs(coefficient(count - 2)) > T(16) * eps * size) {
                if (n >= most)
                    throw NumericalError(ErrorCode::not_converged, "reference", "neutral curve",
                                         "a function between two breaks of the wave generator is not resolved");
                n *= 2;
                cosine = cosines_of(n);
                continue;
            }
            for (std::size_t j = 0; j < count; ++j)
                a[j] = coefficient(j);
            // the integral of T_k is T_{k+1}/(2(k+1)) - T_{k-1}/(2(k-1)), of T_0 it is T_1
            Panel made{begin, half, before, std::vector<T>(count, T(0))};
            T at_begin(0);
            for (std::size_t k = 1; k < count; ++k) {
                T const next = k + 1 < count ? a[k + 1] : T(0);
                made.c[k] = half * ((k == 1 ? T(2) : T(1)) * a[k - 1] - next) / T(2 * static_cast<int>(k));
                at_begin += k % 2 == 0 ? made.c[k] : T(-made.c[k]);
            }
            made.c[0] = -at_begin;
            while (made.c.size() > 2 && abs(made.c.back()) < eps * size * half / T(16))
                made.c.pop_back();
            return made;
        }
    }

    [[nodiscard]] T from_first_break(T const& u) const
    {
        T const turns = floor((u - panels_.front().begin) / period_);
        T const at = u - turns * period_;
        auto const after = std::upper_bound(panels_.begin(), panels_.end(), at,
                                            [](T const& x, Panel const& p) { return x < p.begin; });
        Panel const& p = after == panels_.begin() ? panels_.front() : *(after - 1);
        return turns * mean_ * period_ + p.before + chebyshev_sum(p.c, T((at - p.begin) / p.half - T(1)));
    }

    int waves_ = 1;
    T period_{};
    T scale_{};
    T mean_{};
    std::vector<T> sines_;
    std::vector<Panel> panels_;
    T at_zero_{};
};

}  // namespace hdconj::accuracy
