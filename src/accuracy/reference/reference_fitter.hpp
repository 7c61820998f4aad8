// SPDX-License-Identifier: GPL-3.0-or-later
// Chebyshev series in long double of curves in 50 digits; private to src/accuracy.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "fifty.hpp"
#include "reference_curve.hpp"
#include "reference_integral.hpp"
#include "reference_pair.hpp"

namespace hdconj::accuracy {

/// Fits Chebyshev series to a curve in 50 digits, cutting it in halves until they follow it.
class Fitter
{
  public:
    explicit Fitter(double size) : target_(size * 0x1p-56) {}

    std::vector<ReferencePatch> patches;
    double error = 0;

    void add(std::function<Pair<Fifty>(Fifty const&)> const& curve, int stretch)
    {
        fit(curve, Fifty(0), Fifty(1), stretch, 0);
    }

  private:
    static constexpr int nodes = 20;

    void fit(std::function<Pair<Fifty>(Fifty const&)> const& curve, Fifty const& from, Fifty const& to, int stretch,
             int depth)
    {
        std::array<Pair<Fifty>, nodes> value;
        Fifty const half = (to - from) / 2, middle = (from + to) / 2;
        for (int i = 0; i < nodes; ++i) {
            auto const k = static_cast<std::size_t>(i);
            value[k] = curve(middle + half * cosine(i));
        }
        ReferencePatch patch;
        patch.stretch = stretch;
        for (int j = 0; j < nodes; ++j) {
            Fifty x(0), y(0);
            for (int i = 0; i < nodes; ++i) {
                Fifty const& c = cosine_of_multiple(j * (2 * i + 1));
                x += value[static_cast<std::size_t>(i)].x * c;
                y += value[static_cast<std::size_t>(i)].y * c;
            }
            Fifty const factor = Fifty(j == 0 ? 1 : 2) / nodes;
            patch.x.push_back(static_cast<long double>(factor * x));
            patch.y.push_back(static_cast<long double>(factor * y));
        }
        double missed = 0;
        for (double const s : {-0.93, -0.41, 0.37, 0.88}) {
            Pair<Fifty> const truth = curve(middle + half * Fifty(s));
            Fifty const dx = truth.x - Fifty(chebyshev_sum<long double>(patch.x, s)),
                        dy = truth.y - Fifty(chebyshev_sum<long double>(patch.y, s));
            missed = std::max(missed, static_cast<double>(sqrt(dx * dx + dy * dy)));
        }
        constexpr int deepest = 16;
        if (missed > target_ && depth < deepest) {
            fit(curve, from, middle, stretch, depth + 1);
            fit(curve, middle, to, stretch, depth + 1);
            return;
        }
        error = std::max(error, missed);
        patches.push_back(std::move(patch));
    }

    /// cos(m pi / (2 nodes))
    static Fifty const& cosine_of_multiple(int m)
    {
        static std::vector<Fifty> const table = [] {
            std::vector<Fifty> all;
            for (int k = 0; k < 4 * nodes; ++k)
                all.push_back(cos(half_turn<Fifty>() * k / (2 * nodes)));
            return all;
        }();
        return table[static_cast<std::size_t>(m % (4 * nodes))];
    }
    static Fifty const& cosine(int i) { return cosine_of_multiple(2 * i + 1); }

    double target_;
};

}  // namespace hdconj::accuracy
