// SPDX-License-Identifier: GPL-3.0-or-later
#include "tip_error.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <vector>

#include "numeric/least_between.hpp"
#include "surface/moved_outline.hpp"

namespace hdconj::contact {
namespace {

double largest_between(std::vector<double> value, double safety = numeric::smooth_function)
{
    for (double& each : value)
        each = -each;
    return -numeric::least_between(value, safety);
}

/// How much wider a tip circle the planes of @p finer, and what lies between them, need than the slices of the scene.
double further_needed(CaseSurface const& surface, CaseSurface const& finer, double distance)
{
    std::vector<double> const needed = surface.needed_by_slices();
    double const found = std::max(*std::max_element(needed.begin(), needed.end()), surface.solvable_tip(distance));
    double const most = std::max(largest_between(finer.needed_by_slices()), finer.solvable_tip(distance));
    return std::max(0.0, most - found);
}

/// The same of how far corners are lifted.
double further_lifted(FlankGrid const& slices, FlankGrid const& between, double distance)
{
    return std::max(0.0, largest_between(lifts_of_corners(between, distance)) - lift_of_corners(slices, distance));
}

}  // namespace

double clearing_tip_error(CaseSurface const& surface, CaseSurface const& finer, PartFlanks const& between,
                          Cleared const& cleared, double error, double given)
{
    ContactContext const& context = surface.context();
    Scene const& scene = context.scene;
    // corners rise by less than they are moved, also those that the slices did not have to move
    double const follows = context.tolerance.length +
                           further_needed(surface, finer, scene.circular_spline.backlash_offset) +
                           further_lifted(cleared.flanks.grid, between.grid, cleared.offset) + error;
    double const pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    std::vector<double> meets;
    for (std::size_t k = 0; k < finer.z().size(); ++k) {
        double const meeting =
            surface::meeting_radius(between.outline, k, std::max(cleared.offset, given) + error, pitch);
        double const needed = meeting + surface::least_land * scene.drive.module - finer.tip_shift(k);
        meets.push_back(meeting > 0 ? std::max(needed, cleared.tip) : cleared.tip);
    }
    return std::max(follows, largest_between(meets, numeric::pointed_function) - cleared.tip);
}

}  // namespace hdconj::contact
