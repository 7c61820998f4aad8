// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "evaluation.hpp"
#include "hdconj/error.hpp"

namespace hdconj::inspect {

std::vector<double> planes_of(PointFile const& measured, InspectOptions const& options)
{
    if (!measured.has_z)
        return {options.plane.value_or(0)};
    std::vector<double> heights;
    for (PartPoint const& point : measured.points)
        heights.push_back(point.z);
    std::sort(heights.begin(), heights.end());
    std::vector<double> planes;
    for (std::size_t first = 0; first < heights.size();) {
        std::size_t last = first;
        while (last + 1 < heights.size() && heights[last + 1] - heights[last] <= plane_thickness)
            ++last;
        planes.push_back(heights[first + (last - first) / 2]);
        first = last + 1;
    }
    if (!options.plane)
        return planes;
    auto const chosen = std::find_if(planes.begin(), planes.end(),
                                     [&](double z) { return std::abs(z - *options.plane) <= plane_thickness; });
    if (chosen != planes.end())
        return {*chosen};
    std::string known;
    for (double const z : planes)
        known += (known.empty() ? "" : ", ") + short_number(z);
    throw InputError(Fault{"--plane", 0, short_number(*options.plane),
                           "the file has no points there; it has planes at " + known + " mm", "write one of them"});
}

}  // namespace hdconj::inspect
