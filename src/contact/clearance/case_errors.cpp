// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "clearance_error.hpp"
#include "contact/parallel_trim.hpp"
#include "numeric/least_between.hpp"
#include "ruled_deviation.hpp"
#include "side_clearance_search.hpp"
#include "surface/moved_outline.hpp"

namespace hdconj::contact {
namespace {

/// The planes in which errors are estimated: those of the scene, or more.
struct ErrorPlanes
{
    CaseSurface const& surface;
    SliceClearances const& clearances;  ///< of the part as made
    conjugate::MatchedOutline const& outline;
    FlankGrid const& grid;
    PartFlanks const& cleared;          ///< flanks of the cleared surface
    TurnsOfSet const* flank = nullptr;  ///< of the flanks as made with the scene's side clearance, where known
    TurnsOfSet const* root = nullptr;   ///< around the bottom
};

/// Smallest distances of the scene's slices, which @p result holds, and how far those of the planes, and of what lies
/// between them (between_places()), fall below; around the bottom between its points too. With the accuracy to which a
/// place between two points is known.
/// @param unseen  further error of the flanks [mm]
/// @param anew    whether planes between the slices have corners of their own
void write_clearance_errors(ErrorPlanes const& planes, double given, double unseen, bool anew, ContactCase& result)
{
    ContactContext const& context = planes.surface.context();
    double const enough = clearance_accuracy(context.tolerance), chord = context.tolerance.length;
    bool const both = !(context.tooth.mirror_symmetric && planes.clearances.motion(0).symmetric());
    ClearanceSet const bottom = root_set(planes.outline, given, context.tolerance);
    std::vector<double> const flank =
        lowest_of(turns_of(planes.clearances, flank_set(planes.grid, both), given, planes.flank), false);
    std::vector<double> const root = lowest_of(turns_of(planes.clearances, bottom, 0, planes.root), true);
    auto const over = [](double told, double low) { return std::max(0.0, told - low); };
    std::vector<SliceClearance>& slices = result.slices;
    double least_root = std::numeric_limits<double>::infinity();
    std::size_t const stride = slices.size() > 1 ? (flank.size() - 1) / (slices.size() - 1) : 1;
    for (std::size_t k = 0; k < slices.size(); ++k) {
        // a ruled surface is exact in its end planes; between them its lines join places that are known to the chords
        bool const joined = planes.surface.is_ruled_on_cone() && k > 0 && k + 1 < slices.size();
        std::size_t const plane = std::min(k * stride, flank.size() - 1);
        SliceClearance& slice = slices[k];
        slice.flank_error = over(slice.flank.clearance, flank[plane]) + enough + unseen + (joined ? chord : 0);
        slice.root_error = over(slice.root.clearance, root[plane]) + (enough + bottom.known) + (joined ? chord : 0);
        least_root = std::min(least_root, slice.root.clearance);
    }
    result.clearance_error = over(result.closest_flank().clearance, numeric::least_between(flank)) + enough + unseen +
                             (anew ? overlap_at_ends(planes.grid, given, flank) : 0);
    result.root_clearance_error = over(least_root, numeric::least_between(root)) + enough + bottom.known;
}

double largest_between(std::vector<double> value, double safety = numeric::smooth_function)
{
    for (double& each : value)
        each = -each;
    return -numeric::least_between(value, safety);
}

/// The same of a value that may jump between two planes, where another corner decides. Of a jump its higher side may be
/// larger than in the plane beside it by what it grows over one step, and a quarter of that.
double largest_with_jumps(std::vector<double> const& value)
{
    constexpr double sharp = 8, growth = 1.25;
    auto const n = static_cast<std::ptrdiff_t>(value.size());
    auto const at = [&](std::ptrdiff_t k) { return value[static_cast<std::size_t>(k)]; };
    auto const step = [&](std::ptrdiff_t k) { return k >= 0 && k + 1 < n ? std::abs(at(k + 1) - at(k)) : 0.0; };
    auto const jumps = [&](std::ptrdiff_t k) {
        return step(k) > sharp * std::max({step(k - 2), step(k - 1), step(k + 1), step(k + 2)});
    };
    double largest = std::ranges::max(value);
    for (std::ptrdiff_t first = 0, last = 0; first < n; first = last = last + 1) {
        while (last + 1 < n && !jumps(last))
            ++last;
        if (last - first > 1)
            largest = std::max(largest, largest_between({value.begin() + first, value.begin() + last + 1}));
        if (last > first && last + 1 < n)
            largest = std::max(largest, at(last) + growth * (at(last) - at(last - 1)));
        if (last > first && first > 0)
            largest = std::max(largest, at(first) + growth * (at(first) - at(first + 1)));
    }
    return largest;
}

/// How much wider a tip circle the planes of @p finer, and what lies between them, need than the slices of the scene.
double further_needed(CaseSurface const& surface, CaseSurface const& finer, double distance)
{
    std::vector<double> const needed = surface.needed_by_slices();
    double const found = std::max(*std::max_element(needed.begin(), needed.end()), surface.solvable_tip(distance));
    double const most = std::max(largest_with_jumps(finer.needed_by_slices()), finer.solvable_tip(distance));
    return std::max(0.0, most - found);
}

/// The same of how far corners are lifted: off the final tip circle, where the flanks of @p between end, and off the
/// one before it was widened.
double further_lifted(CaseSurface const& finer, PartFlanks const& between, Cleared const& cleared)
{
    double const further = largest_with_jumps(lifts_of_corners(between.grid, cleared.offset)) -
                           lift_of_corners(cleared.flanks.grid, cleared.offset);
    if (!cleared.lifted)
        return std::max(0.0, further);
    auto const [narrow, by] = *cleared.lifted;
    FlankGrid const before = part_flanks(finer, finer.outline(narrow), narrow, 0).grid;
    return std::max({0.0, further, narrow + largest_with_jumps(lifts_of_corners(before, by)) - cleared.tip});
}

/// Estimated error of the tip circle of @p cleared as that of the whole width [mm], at least the tolerance.
///
/// It is what the slices ask for before they are moved (land, rim, draft), lifted with the corners of the moved flanks,
/// and no smaller than where these meet; how much larger each may be between planes says least_between().
/// @param finer    the surface in all slices of the scene or in more planes
/// @param between  flanks of the cleared surface there, with its tip circle
/// @param error    estimated error of the side clearance, cleared.offset [mm]
/// @param given    least side clearance that the land was asked for with [mm]
double least_tip_radius_error(CaseSurface const& surface, CaseSurface const& finer, PartFlanks const& between,
                              Cleared const& cleared, double error, double given)
{
    ContactContext const& context = surface.context();
    Scene const& scene = context.scene;
    // corners rise by less than they are moved, also those that the slices did not have to move
    double const follows = context.tolerance.length +
                           further_needed(surface, finer, scene.circular_spline.backlash_offset) +
                           further_lifted(finer, between, cleared) + error;
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

/// How far a ruled surface deviates, told in the slices of the scene: they are all planes, or every so many.
void write_deviation(ErrorPlanes const& planes, Surfaces const& made, bool errors, ContactCase& result)
{
    std::size_t const slices = made.flanks.grid.slices();
    if (!planes.surface.is_ruled_on_cone() || slices < 2)
        return;
    std::vector<double> low = ruled_deviations(planes.surface, planes.cleared, made.cleared.tip);
    for (std::size_t k = 0; k < low.size(); k += (low.size() - 1) / (slices - 1))
        result.ruled_deviation = std::max(result.ruled_deviation, low[k]);
    if (!errors)
        return;
    for (double& each : low)
        each = -each;
    // the distance is pointed where it is largest; an outline is known to its chords
    result.ruled_deviation_error = -numeric::least_between(low, numeric::pointed_function) - result.ruled_deviation +
                                   planes.surface.context().tolerance.length;
}

void write_errors_in(ErrorPlanes const& planes, CaseSurface const& in_slices, Surfaces const& made, ContactCase& result)
{
    ContactContext const& context = planes.surface.context();
    write_clearance_errors(planes, made.given,
                           unseen_length(made.flanks.grid, made.given) + chords_of(planes.surface, made.cleared),
                           has_planes_solved_anew(planes.surface, made.cleared), result);
    // with the same tip circle and side clearance the cleared surface is the one that was made
    bool const same = made.cleared.tip == made.tip && made.cleared.offset == made.given;
    result.least_side_clearance_error = found_clearance_error(planes.surface, planes.clearances, planes.cleared.grid,
                                                              made.cleared, same ? planes.flank : nullptr);
    ClearanceSet const root = root_set(planes.outline, made.given, context.tolerance);
    result.least_root_clearance_error =
        least_clearance_error(context, planes.clearances, root, result.least_root_clearance, true,
                              turns_of(planes.clearances, root, result.least_root_clearance,
                                       result.least_root_clearance == 0 ? planes.root : nullptr));
    result.least_tip_radius_error = least_tip_radius_error(in_slices, planes.surface, planes.cleared, made.cleared,
                                                           result.least_side_clearance_error, made.given);
    write_deviation(planes, made, true, result);
}

}  // namespace

void write_errors(CaseSurface const& surface, SliceClearances const& clearances, Surfaces const& made, bool errors,
                  ContactCase& result)
{
    if (!errors && !surface.is_ruled_on_cone())
        return;
    auto const write = [&](ErrorPlanes const& planes) {
        if (errors)
            write_errors_in(planes, surface, made, result);
        else
            write_deviation(planes, made, false, result);
    };
    if (has_enough_planes(surface))
        return write(
            {surface, clearances, made.outline, made.flanks.grid, made.cleared.flanks, &made.flank, &made.root});
    CaseSurface const finer = in_enough_planes(surface);
    std::optional<SliceClearances> anew;
    if (errors)  // a deviation needs none
        anew.emplace(surface.context(), finer.builder());
    conjugate::MatchedOutline const outline = finer.outline(made.tip);
    double const tip = made.cleared.tip, least = result.least_side_clearance, most = std::max(made.given, least);
    bool const per_clearance = surface.is_drafted();  // is made with each side clearance
    PartFlanks const flanks = part_flanks(finer, outline, made.tip, per_clearance ? made.given : most);
    bool const same = tip == made.tip && (!per_clearance || made.given == least);
    write({finer, errors ? *anew : clearances, outline, flanks.grid,
           same ? flanks : part_flanks(finer, finer.outline(tip), tip, per_clearance ? least : most)});
}

}  // namespace hdconj::contact
