// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/text.hpp"
#include "evaluation.hpp"
#include "file/listed_faults.hpp"
#include "hdconj/error.hpp"

namespace hdconj::inspect {

namespace {

/// Heights of both faces of the teeth; none where the scene does not say them.
std::optional<std::array<double, 2>> faces_of(Scene const& scene, bool space)
{
    if (auto const& width = scene.circular_spline.width; space && width)
        return std::array{-*width / 2, *width / 2};
    if (space || !scene.flexspline.cup)
        return std::nullopt;
    Cup const& cup = *scene.flexspline.cup;
    double const end = cup.length - cup.front_land, begin = end - cup.tooth_width;
    bool const placed = scene.coning && scene.coning->bottom_to_middle;
    double const middle = placed ? *scene.coning->bottom_to_middle : (begin + end) / 2;
    return std::array{begin - middle, end - middle};
}

}  // namespace

void refuse_planes_outside(std::vector<double> const& z, Scene const& scene, PointFile const& measured,
                           InspectOptions const& options)
{
    bool const space = options.part == InspectedPart::circular_spline;
    auto const faces = faces_of(scene, space);
    if (!faces)
        return;
    std::string const place = fmt::format("{} between z = {} and {} mm",
                                          space ? "the circular spline stands" : "the teeth of the flexspline stand",
                                          short_number(faces->front()), short_number(faces->back()));
    file::ListedFaults faults(measured.file);
    for (double const each : z) {
        if (each >= faces->front() - plane_thickness && each <= faces->back() + plane_thickness)
            continue;
        auto const point = std::ranges::find(measured.points, each, &PartPoint::z);
        bool const of_file = !options.plane && point != measured.points.end();
        faults.add({of_file ? "z" : "--plane", of_file ? point->line : 0, short_number(each), place,
                    "measure within this width, z = 0 in the middle of the bearing", of_file ? measured.file : ""});
    }
    faults.refuse();
}

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
