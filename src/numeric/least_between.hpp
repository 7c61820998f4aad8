// SPDX-License-Identifier: GPL-3.0-or-later
// How low a smooth function may fall between evenly spaced places where it is known.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace hdconj::numeric {

/// One interval between two neighbouring places.
struct BetweenPlaces
{
    double least = 0;      ///< estimated lower bound of the function there
    double curvature = 0;  ///< second difference that it was estimated with
};

/// How many times the second difference that is met counts where a function is smooth, and where it may have points:
/// that of a V is four times less in its middle than that of the parabola as deep.
inline constexpr double smooth_function = 2, pointed_function = 4;

/// The parabola through both ends of each interval, its second difference @p safety times the largest that is met at
/// either end, and its least value there.
///
/// With h the distance, D the difference of the ends and c the second difference: f(t) = f_0 + D t - c t (1 - t)/2,
/// least at t = 1/2 - D/c where |D| < c/2, by (c/2 - |D|)^2/(2 c) below the lower end; elsewhere at an end. Second
/// differences count without their sign, since the function may bend the other way beside. An estimate, and no bound
/// for a function that does more between places than at them. Fewer than three places show no second difference: the
/// lower end stands for what is between. @returns one entry less than there are values
[[nodiscard]] inline std::vector<BetweenPlaces> between_places(std::vector<double> const& value,
                                                               double safety = smooth_function)
{
    std::size_t const n = value.size();
    std::vector<BetweenPlaces> result;
    auto const bend = [&](std::size_t i) {
        return i == 0 || i + 1 >= n ? 0.0 : std::abs(value[i - 1] - 2 * value[i] + value[i + 1]);
    };
    for (std::size_t i = 0; i + 1 < n; ++i) {
        double const c = safety * std::max(bend(i), bend(i + 1));
        double const rise = std::abs(value[i + 1] - value[i]);
        double const fall = std::max(0.0, c / 2 - rise);
        result.push_back({std::min(value[i], value[i + 1]) - (fall > 0 ? fall * fall / (2 * c) : 0), c});
    }
    return result;
}

/// The least of all places and between them; infinite without any.
[[nodiscard]] inline double least_between(std::vector<double> const& value, double safety = smooth_function)
{
    double least = std::numeric_limits<double>::infinity();
    for (double const each : value)
        least = std::min(least, each);
    for (BetweenPlaces const& each : between_places(value, safety))
        least = std::min(least, each.least);
    return least;
}

}  // namespace hdconj::numeric
