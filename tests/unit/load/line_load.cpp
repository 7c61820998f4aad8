// SPDX-License-Identifier: GPL-3.0-or-later
#include "load/study/line_load.hpp"

#include <cmath>
#include <vector>

#include "support/catch.hpp"

namespace hdconj::load {

TEST_CASE("the largest mean of a line load", "[load]")
{
    using Values = std::vector<double>;
    CHECK(largest_mean(Values{0.3}, Values{7}, 0.5) == 7);
    // shorter than the interval: the mean of all
    CHECK(largest_mean(Values{0, 0.2}, Values{1, 3}, 0.5) == Approx(2));
    // constant, and rising to an end: the last half, by hand
    CHECK(largest_mean(Values{-1, 0, 2}, Values{5, 5, 5}, 0.5) == Approx(5));
    CHECK(largest_mean(Values{0, 2}, Values{0, 8}, 0.5) == Approx(7));
    // a peak: equal values at both ends of the interval, 10 - 10 s left of it and 10 - 5 s' right of it, s = s'/2
    CHECK(largest_mean(Values{0, 1, 3}, Values{0, 10, 0}, 0.5) == Approx(10 - 0.5 * 10 * 0.5 / 3));
}

TEST_CASE("means over a width converge where the load at an end does not", "[load]")
{
    // q = 1/sqrt(z), singular at the end, as values of cells: their force is right
    auto const of = [](int cells) {
        std::vector<double> z, q;
        for (int k = 0; k < cells; ++k) {
            double const a = 2.0 * k / cells, b = 2.0 * (k + 1) / cells;
            z.push_back((a + b) / 2);
            q.push_back(2 * (std::sqrt(b) - std::sqrt(a)) / (b - a));
        }
        return std::pair{largest_mean(z, q, 0.5), q.front()};
    };
    auto const [coarse, coarse_end] = of(32);
    auto const [fine, fine_end] = of(128);
    CHECK(fine_end == Approx(2 * coarse_end).epsilon(1e-9));
    CHECK(fine == Approx(coarse).epsilon(0.15));
    CHECK(fine == Approx(2 * std::sqrt(0.5) / 0.5).epsilon(0.1));
}

TEST_CASE("the ends hold the integral of a load that is linear between slices", "[load]")
{
    using Values = std::vector<double>;
    // uneven slices, ends within the first interval, beyond it, and up to the middle; q = 3 + 2 z
    Values const z{0, 0.3, 1, 1.6, 2};
    for (double const width : {0.1, 0.5, 1.0, 5.0}) {
        CAPTURE(width);
        Values const shares = shares_at_ends(z, width);
        double force = 0;
        for (std::size_t k = 0; k < z.size(); ++k) {
            double const slice = 0.5 * ((k + 1 < z.size() ? z[k + 1] : z[k]) - (k > 0 ? z[k - 1] : z[k]));
            force += shares[k] * slice * (3 + 2 * z[k]);
        }
        double const e = std::min(width, 1.0);
        CHECK(force == Approx(3 * e + e * e + 3 * e + 4 - (2 - e) * (2 - e)));
    }
    CHECK(shares_at_ends(z, 5) == Values{1, 1, 1, 1, 1});
    CHECK(shares_at_ends(Values{0.4}, 0.5) == Values{0});
}

TEST_CASE("the largest value between two places", "[load]")
{
    using Values = std::vector<double>;
    Values const z{0, 1, 2, 4}, value{9, 5, 2, 8};
    CHECK(largest_between(z, value, 0, 4) == 9);
    CHECK(largest_between(z, value, 0.5, 3.5) == Approx(7));
    CHECK(largest_between(z, value, 0.5, 2) == Approx(7));
    CHECK(largest_between(z, value, 1, 3) == Approx(5));
    CHECK(largest_between(z, value, 0.25, 0.25) == Approx(8));
    CHECK(largest_between(Values{1}, Values{6}, 1, 1) == 6);
}

}  // namespace hdconj::load
