// SPDX-License-Identifier: GPL-3.0-or-later
#include "tip_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "hdconj/numeric/least_between.hpp"
#include "moved_outline.hpp"

namespace hdconj::detail {
namespace {

double largest_between(std::vector<double> value, double safety = smooth_function)
{
    for (double& each : value)
        each = -each;
    return -least_between(value, safety);
}

/// How much more the planes of @p maker, and what lies between them, ask for than the slices of the scene.
double further_needed(SurfaceMaker& slices, SurfaceMaker& maker, SurfaceChoice const& choice, double distance)
{
    std::vector<double> const asked = slices.needed_by_slices(choice);
    double const known = std::max(*std::max_element(asked.begin(), asked.end()), slices.solvable_tip(choice, distance));
    double const most = std::max(largest_between(maker.needed_by_slices(choice)), maker.solvable_tip(choice, distance));
    return std::max(0.0, most - known);
}

/// The same of how far corners are lifted.
double further_lifted(FlankGrid const& slices, FlankGrid const& between, double distance)
{
    return std::max(0.0, largest_between(lifts_of_corners(between, distance)) - lift_of_corners(slices, distance));
}

}  // namespace

double clearing_tip_error(ContactBench const& bench, SurfaceChoice const& choice, SurfaceMaker& maker, PartFlanks const& between, Cleared const& cleared, double error, double given)
{
    Scene const& scene = bench.scene;
    // corners rise by less than they are moved, also those that the slices did not have to move
    double const follows = bench.tolerance.length + further_needed(bench.maker, maker, choice, scene.circular_spline.backlash_offset)
                           + further_lifted(cleared.flanks.grid, between.grid, cleared.offset) + error;
    double const pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    std::vector<double> meets;
    for (std::size_t k = 0; k < maker.z().size(); ++k)
    {
        double const meeting = meeting_radius(between.outline, k, std::max(cleared.offset, given) + error, pitch);
        double const needed = meeting + least_land * scene.drive.module - maker.z()[k] * std::tan(choice.tilt);
        meets.push_back(meeting > 0 ? std::max(needed, cleared.tip) : cleared.tip);
    }
    return std::max(follows, largest_between(meets, pointed_function) - cleared.tip);
}

}  // namespace hdconj::detail
