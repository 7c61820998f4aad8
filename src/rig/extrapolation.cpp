// SPDX-License-Identifier: GPL-3.0-or-later
#include "extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hdconj::rig {

std::vector<Estimate> means_of(std::vector<ByDegree> const& branches)
{
    std::vector<Estimate> means;
    std::size_t const degrees = branches.empty() ? 0 : std::ranges::min(branches, {}, &ByDegree::size).size();
    for (std::size_t i = 0; i < degrees; ++i) {
        std::vector<Found> values;
        for (ByDegree const& branch : branches)
            values.push_back(branch[i]);
        means.push_back(mean_of(values));
    }
    return means;
}

Estimate extrapolated(std::vector<Estimate> const& by_degree)
{
    Estimate const &line = by_degree.front(), &parabola = by_degree.back();
    constexpr double by_chance = 1.5, clear = 3;  // standard errors
    constexpr double least_ratio = 2;             // of both errors, over distances from 1 to 6 and less
    double const of_parabola = std::max(parabola.error, least_ratio * line.error);
    double const variance = of_parabola * of_parabola - line.error * line.error;
    double const square = std::pow(parabola.value - line.value, 2);
    double const beyond_noise = std::sqrt(std::max(0.0, square - by_chance * by_chance * variance));
    bool const straight = square <= clear * clear * variance;
    Estimate result = straight ? line : parabola;
    result.error = std::hypot(result.error, (straight ? 2 : 1) * beyond_noise);
    return result;
}

}  // namespace hdconj::rig
