// SPDX-License-Identifier: GPL-3.0-or-later
#include "clear_flanks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "clearance_error.hpp"
#include "contact/gap_field.hpp"
#include "contact/study/contact_case.hpp"
#include "contact/study/contact_study_data.hpp"
#include "contact/study/place_teeth.hpp"
#include "contact/study/surface_choices.hpp"
#include "hdconj/error.hpp"
#include "made_flanks.hpp"
#include "side_clearance_search.hpp"

namespace hdconj::contact {
namespace {

/// Lifts the tip circle to where the flanks begin when they are moved by the offset with which they clear.
void lift_tip(CaseSurface const& surface, SliceClearances const& clearances, Cleared& cleared)
{
    ContactContext const& context = surface.context();
    constexpr double more = 1.25;
    constexpr int budget = 8;
    if (double const lift = lift_of_corners(cleared.flanks.grid, cleared.offset); lift > 0)
        cleared.lifted = LiftedTip{std::exchange(cleared.tip, cleared.tip + lift), cleared.offset};
    cleared.outline = surface.outline(cleared.tip);
    double further = std::max(cleared.reach, cleared.offset);
    for (int i = 0; i < budget; ++i) {
        reach(surface, cleared, further);
        context.clock.run(Stage::clearance, [&] {
            ClearanceSet const set = flank_set(cleared.flanks.grid, !has_mirrored_flanks(context));
            // the same flanks as before, a little less of them in slices whose corners rise less: the least is theirs
            if (std::abs(clearances.worst(set, cleared.offset, clearances(set, cleared.offset))) >
                clearance_accuracy(context.tolerance)) {
                TurnsOfSet at_zero{clearances(set, 0), {}};
                cleared.offset = least_offset(clearances, set, at_zero, context.tolerance);
            }
        });
        if (cleared.offset <= cleared.reach)
            return;
        further = surface.is_drafted() ? cleared.offset : more * cleared.offset;  // made with just this
    }
    throw NumericalError(ErrorCode::not_converged, "contact", "least side clearance",
                         "the flanks that are left at the tip circle need more side clearance each time it grows");
}

}  // namespace

double clearance_for_assembly(CaseSurface const& surface, GapsAtRest& rest, Cleared& cleared, double offset,
                              std::vector<double> const& phases)
{
    ContactContext const& context = surface.context();
    if (!context.scene.maps_axial_shift())
        return offset;
    auto const smallest_at = [&](double distance) {
        if (distance > cleared.reach)
            reach(surface, cleared, distance);
        FlankGrid const moved = moved_into_material(cleared.flanks.grid, distance);
        double smallest = std::numeric_limits<double>::infinity();
        for (double const phase : phases) {
            auto const places = context.places(context, phase);
            GapField const field(context.tooth, moved, *places, context.scene.drive.flexspline_teeth,
                                 context.scene.drive.circular_spline_teeth, phase, nullptr, lobes_of(context));
            smallest = std::min(smallest,
                                smallest_gap(field, *rest(context, moved, field, phase), 0, -1, context.threads).gap);
        }
        return smallest;
    };
    double const enough = clearance_accuracy(context.tolerance);
    if (smallest_at(offset) >= -enough)
        return offset;
    auto const raised = side_clearance_search(smallest_at, offset, enough);
    if (!raised)
        throw NumericalError(ErrorCode::not_converged, "contact", "side clearance",
                             "did not converge with the wall's axial shift",
                             "write axial_shift = \"none\" in [coning], or a larger "
                             "circular_spline.backlash_offset");
    return *raised;
}

Cleared clear_flanks(CaseSurface const& surface, SliceClearances const& clearances, double at_least)
{
    ContactContext const& context = surface.context();
    Cleared result;
    result.reach = at_least;
    result.tip = std::max(surface.needed_tip(), surface.needed_tip_of_moved(at_least));
    // where moved flanks meet the tip circle has to follow until a land is left
    auto const raise_tip = [&](auto const& outline, double distance) {
        double const tip = tip_with_land(surface, outline, distance, result.tip);
        return std::exchange(result.tip, tip) != tip;
    };
    for (int i = 0;; ++i) {
        result.outline = surface.outline(result.tip);
        result.flanks = part_flanks(surface, result.outline, result.tip, 0);
        context.clock.run(Stage::clearance, [&] {
            ClearanceSet const set = flank_set(result.flanks.grid, !has_mirrored_flanks(context));
            result.at_zero = {clearances(set, 0), {}};
            result.offset = least_offset(clearances, set, result.at_zero, context.tolerance);
        });
        if (!raise_tip(result.outline, std::max(result.offset, at_least)))
            break;
        refuse_to_lift_for_ever(i, result.tip);
    }
    if (result.offset > 0 || result.reach > 0)
        result.at_zero = {};  // of other flanks
    if (result.offset > 0)
        lift_tip(surface, clearances, result);
    else if (result.reach > 0)
        reach(surface, result, result.reach);
    // a given clearance has more of the surface reach the tip circle, whose land may be narrower there
    for (int i = 0; raise_tip(result.flanks, std::max(result.offset, at_least)); ++i) {
        refuse_to_lift_for_ever(i, result.tip);
        result.outline = surface.outline(result.tip);
        result.at_zero = {};
        reach(surface, result, result.reach);
    }
    return result;
}

void check_as_made(CaseSurface const& surface, Cleared const& cleared)
{
    double const tip = surface.nominal_tip_radius();
    if (tip != cleared.tip)
        (void)nominal_part(surface, given_clearance(surface.context().scene), tip);
}

double least_side_clearance_of(ContactContext const& context, surface::SurfaceSpec const& spec)
{
    CaseSurface const surface(context, spec);
    Cleared const cleared = clear_flanks(surface, SliceClearances(context), 0);
    check_as_made(surface, cleared);
    return cleared.offset;
}

SideClearanceNeed side_clearance_need(Scene const& scene)
{
    ContactStudyData data(scene, Verb::contact, {});
    CaseSurface const surface(*data.context, surface_choices(scene, {}).front());
    Cleared const cleared = clear_flanks(surface, SliceClearances(*data.context), 0);
    return {cleared.offset, cleared.tip, data.middle.geometry.circular_spline_inner_radius,
            error_of_least(data.context->tolerance, cleared.offset)};
}

Cleared nominal_part(CaseSurface const& surface, double given, double tip)
{
    Cleared result;
    result.offset = given;
    result.tip = std::max(tip, surface.needed_tip_of_moved(given));
    for (int i = 0;; ++i) {
        result.outline = surface.outline(result.tip);
        reach(surface, result, given);
        double const with_land = given > 0 ? tip_with_land(surface, result.flanks, given, result.tip) : result.tip;
        if (with_land == result.tip)
            return result;
        refuse_to_lift_for_ever(i, result.tip);
        result.tip = with_land;
    }
}

bool is_enough(ContactContext const& context, Cleared const& cleared)
{
    return given_clearance(context.scene) >= cleared.offset - clearance_accuracy(context.tolerance);
}

std::optional<Cleared> try_nominal_part(CaseSurface const& surface, SliceClearances const& clearances, GapsAtRest& rest,
                                        Cleared const& cleared, std::vector<double> const& phases, MadePart const* made)
{
    ContactContext const& context = surface.context();
    double const given = given_clearance(context.scene);
    // with a smaller tip circle there is more to clear, not less
    if (context.scene.circular_spline.automatic_backlash || !is_enough(context, cleared))
        return std::nullopt;
    double const own = surface.nominal_tip_radius(), needed = surface.needed_tip();
    if (std::max(own, needed) >= cleared.tip)
        return std::nullopt;
    try {
        bool const known = made != nullptr && own >= needed;
        Cleared part = known ? made->part : nominal_part(surface, given, std::max(own, needed));
        if (part.tip >= cleared.tip)
            return std::nullopt;
        ClearanceSet const set = flank_set(part.flanks.grid, !has_mirrored_flanks(context));
        TurnMinima minima;
        if (!known)
            context.clock.run(Stage::clearance, [&] { minima = clearances(set, given); });
        bool const clears = clearances.worst(set, given, known ? made->at_given.minima : minima) >=
                            -clearance_accuracy(context.tolerance);
        return clears && clearance_for_assembly(surface, rest, part, given, phases) == given
                   ? std::optional(std::move(part))
                   : std::nullopt;
    } catch (NumericalError const& error) {
        error.rethrow_unless_infeasible();
        return std::nullopt;  // a part that cannot be made is not kept
    }
}

namespace {

FlankSurface surface_of(CaseSurface const& surface, Cleared part, double given)
{
    double const offset = std::max(given, part.offset);
    FlankGrid grid = made_flanks(surface, part.flanks.grid, part.tip, offset);
    return {std::move(part.outline), std::move(grid), offset, part.tip};
}

}  // namespace

FlankSurface flank_surface(ContactContext const& context, surface::SurfaceSpec const& spec, bool clearing, bool error)
{
    double const given = given_clearance(context.scene);
    if (!context.scene.circular_spline.automatic_backlash && !clearing)
        return surface_with_clearance(context, spec, given);
    CaseSurface const surface(context, spec);
    SliceClearances const clearances(context);
    Cleared const cleared = clear_flanks(surface, clearances, given);
    FlankSurface result = surface_of(surface, cleared, given);
    if (error)  // of the larger of both
        result.offset_error =
            std::max(0.0, error_of_clearance(surface, clearances, cleared) - (result.offset - cleared.offset));
    return result;
}

FlankSurface surface_with_clearance(ContactContext const& context, surface::SurfaceSpec const& spec, double clearance)
{
    CaseSurface const surface(context, spec);
    double const tip = std::max(surface.nominal_tip_radius(), surface.needed_tip());
    return surface_of(surface, nominal_part(surface, clearance, tip), clearance);
}

}  // namespace hdconj::contact
