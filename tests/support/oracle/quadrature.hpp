// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Gauss-Legendre quadrature, and the running integral of a periodic function that is smooth between given breaks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "number.hpp"

namespace oracle {

/// Nodes and weights of Gauss-Legendre quadrature on -1 ... 1.
template <class T>
struct GaussLegendre
{
    explicit GaussLegendre(int count)
    {
        using std::abs;
        using std::cos;
        for (int i = 0; i < count; ++i) {
            T x = cos(pi<T>() * (T(i) + T(3) / T(4)) / (T(count) + T(1) / T(2)));
            T slope{};
            for (int step = 0; step < 100; ++step) {
                T before(1), value = x;
                for (int k = 2; k <= count; ++k) {
                    T const next = (T(2 * k - 1) * x * value - T(k - 1) * before) / T(k);
                    before = value;
                    value = next;
                }
                slope = T(count) * (x * value - before) / (x * x - T(1));
                T const change = value / slope;
                x -= change;
                if (abs(change) <= T(4) * std::numeric_limits<T>::epsilon())
                    break;
            }
            node.push_back(x);
            weight.push_back(T(2) / ((T(1) - x * x) * slope * slope));
        }
    }
    std::vector<T> node, weight;
};

/// Integral from 0 of a function with this period. The panels are short enough for 14 nodes to reach 1e-18 on the
/// functions of a gear pair.
template <class T>
class RunningIntegral
{
  public:
    RunningIntegral() = default;
    /// @param breaks  in [-period/2, period/2], any order
    RunningIntegral(std::function<T(T const&)> f, T const& period, std::vector<T> breaks)
        : f_(std::move(f)), period_(period)
    {
        breaks.push_back(-period / T(2));
        breaks.push_back(T(0));
        breaks.push_back(period / T(2));
        std::sort(breaks.begin(), breaks.end());
        T const longest = period / T(48);
        cuts_.push_back(breaks.front());
        sums_.push_back(T(0));
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
            T const whole = breaks[i + 1] - breaks[i];
            if (!(whole > T(0)))
                continue;
            int const parts = 1 + static_cast<int>(whole / longest);
            for (int k = 1; k <= parts; ++k) {
                T const to = k == parts ? breaks[i + 1] : breaks[i] + whole * T(k) / T(parts);
                sums_.push_back(sums_.back() + over(cuts_.back(), to));
                cuts_.push_back(to);
            }
        }
        at_zero_ = from_start(T(0));
    }

    T total() const { return sums_.back(); }
    T operator()(T const& u) const
    {
        using std::floor;
        T const turns = floor(u / period_ + T(1) / T(2));
        return turns * total() + from_start(u - turns * period_) - at_zero_;
    }

  private:
    T over(T const& a, T const& b) const
    {
        static GaussLegendre<T> const rule(14);
        T const middle = (a + b) / T(2), half = (b - a) / T(2);
        T sum(0);
        for (std::size_t i = 0; i < rule.node.size(); ++i)
            sum += rule.weight[i] * f_(middle + half * rule.node[i]);
        return half * sum;
    }
    T from_start(T const& u) const
    {
        auto const after = std::upper_bound(cuts_.begin() + 1, cuts_.end() - 1, u);
        std::size_t const i = static_cast<std::size_t>(after - cuts_.begin()) - 1;
        return sums_[i] + over(cuts_[i], u);
    }

    std::function<T(T const&)> f_;
    T period_{};
    std::vector<T> cuts_, sums_;
    T at_zero_{};
};

}  // namespace oracle
