// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "hdconj/error.hpp"
#include "made_flanks.hpp"
#include "surface/moved_outline.hpp"

namespace hdconj::contact {
namespace {

/// What the moved flanks of a slice leave of the way down to its tip circle [mm].
struct Missing
{
    double radial = 0;
    double length = 0;  ///< along the flank
};

Missing missing(FlankGrid const& grid, std::size_t k, double distance)
{
    Missing most;
    for (std::size_t f = 0; f < 2; ++f) {
        double const tip = grid.tip.empty() ? grid.point[f][k].front().norm() : grid.tip[k];
        Vec2 const& normal = grid.normal[f][k].front();
        Vec2 const corner = grid.point[f][k].front() + (distance - grid.included_clearance) * normal;
        double const radial = corner.norm() - tip, slope = std::abs(cross(corner, normal)) / corner.norm();
        if (!(radial > 0))
            continue;
        most.radial = std::max(most.radial, radial);
        most.length = std::max(most.length, radial / slope);
    }
    return most;
}

/// The most of all slices.
Missing missing(FlankGrid const& grid, double distance)
{
    Missing most;
    for (std::size_t k = 0; k < grid.slices(); ++k) {
        Missing const slice = missing(grid, k, distance);
        most = {std::max(most.radial, slice.radial), std::max(most.length, slice.length)};
    }
    return most;
}

}  // namespace

PartFlanks part_flanks(CaseSurface const& surface, conjugate::MatchedOutline const& at_tip, double tip, double distance)
{
    auto const grid_of = [&](conjugate::MatchedOutline const& outline) {
        FlankGrid grid = flank_grid(outline, surface.z(), surface.context().request.flank_points);
        grid.shift = surface.radial_shifts();
        return grid;
    };
    PartFlanks made{at_tip, grid_of(at_tip)};
    if (!(distance > 0))
        return made;
    std::vector<double> tips;
    for (auto const& slice : at_tip.points)
        tips.push_back(slice[at_tip.landmarks[4]].norm());
    made.grid.tip = tips;
    constexpr int budget = 6;
    double beyond = 0, step = 1.25;  // a little more than is missing, since the normal turns
    Missing left = missing(made.grid, distance);
    for (int i = 0; i < budget && left.radial > 0; ++i) {
        try {
            conjugate::MatchedOutline further = surface.outline(tip - (beyond + step * left.radial));
            beyond += step * left.radial;
            made.grid = grid_of(further);
            made.grid.tip = tips;
            made.outline = std::move(further);
            left = missing(made.grid, distance);
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();
            step *= 0.5;  // as far as there is a surface: see unseen_length()
        }
    }
    if (!surface.is_drafted())
        return made;
    if (std::optional<FlankGrid> solved = solved_flanks(surface, tip, distance)) {
        made.grid = *std::move(solved);
        made.grid.tip = tips;
    }
    return made;
}

double lift_of_corners(FlankGrid const& grid, double distance)
{
    return missing(grid, distance).radial;
}

std::vector<double> lifts_of_corners(FlankGrid const& grid, double distance)
{
    std::vector<double> lifts;
    for (std::size_t k = 0; k < grid.slices(); ++k)
        lifts.push_back(missing(grid, k, distance).radial);
    return lifts;
}

double unseen_length(FlankGrid const& grid, double distance)
{
    return missing(grid, distance).length;
}

double tip_with_land(CaseSurface const& surface, conjugate::MatchedOutline const& outline, double distance, double tip)
{
    Drive const& drive = surface.context().scene.drive;
    double const pitch = 2 * std::numbers::pi / drive.circular_spline_teeth;
    double const least = surface::least_land * drive.module;
    for (std::size_t k = 0; k < surface.z().size(); ++k)
        if (double const meeting = surface::meeting_radius(outline, k, distance, pitch); meeting > 0)
            tip = std::max(tip, meeting + least - surface.tip_shift(k));
    return std::max(tip, surface.solvable_tip(distance));
}

double tip_with_land(CaseSurface const& surface, PartFlanks const& flanks, double distance, double tip)
{
    double const seen = tip_with_land(surface, flanks.outline, distance, tip);
    if (!(unseen_length(flanks.grid, distance) > 0))
        return seen;
    double const pointed = surface.pointed_radius_of_moved(distance);
    double const with_land = pointed + surface::least_land * surface.context().scene.drive.module;
    return std::max({seen, pointed < seen ? 0 : with_land, surface.needed_tip_of_moved(distance)});
}

void refuse_to_lift_for_ever(int round, double tip)
{
    constexpr int budget = 12;
    if (round + 1 == budget)
        throw NumericalError(ErrorCode::not_converged, "contact", "tip circle",
                             "side clearance and tip circle did not converge, at a tip circle of " + short_number(tip) +
                                 " mm: the teeth become too short for this tilt");
}

void reach(CaseSurface const& surface, Cleared& cleared, double distance)
{
    cleared.reach = distance;
    cleared.flanks = part_flanks(surface, cleared.outline, cleared.tip, distance);
}

}  // namespace hdconj::contact
