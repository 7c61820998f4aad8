// SPDX-License-Identifier: GPL-3.0-or-later
#include "nominal_part.hpp"

#include <algorithm>
#include <utility>

#include "clear_flanks.hpp"
#include "clearing_search.hpp"
#include "contact/study/contact_case.hpp"
#include "hdconj/error.hpp"

namespace hdconj::contact {

Cleared nominal_part(CaseSurface const& surface, double given, double tip)
{
    Cleared result;
    result.offset = given;
    result.tip = tip;
    for (int i = 0;; ++i) {
        result.outline = surface.outline(result.tip);
        reach(surface, result, given);
        double const with_land =
            given > 0 ? tip_with_land(surface, result.flanks.outline, given, result.tip) : result.tip;
        if (with_land == result.tip)
            return result;
        refuse_to_lift_for_ever(i, result.tip);
        result.tip = with_land;
    }
}

bool is_enough(ContactContext const& context, Cleared const& cleared)
{
    return given_clearance(context.scene) >= cleared.offset - clearing_accuracy(context.tolerance);
}

std::optional<Cleared> try_nominal_part(CaseSurface const& surface, SliceClearances const& clearances,
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
        bool const clears =
            clearances.worst(set, given, known ? made->at_given : minima) >= -clearing_accuracy(context.tolerance);
        return clears && clearance_for_assembly(surface, part, given, phases) == given ? std::optional(std::move(part))
                                                                                       : std::nullopt;
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        return std::nullopt;  // a part that cannot be made is not kept
    }
}

FlankSurface flank_surface(ContactContext const& context, surface::SurfaceSpec const& spec, bool clearing)
{
    CaseSurface const surface(context, spec);
    double const given = given_clearance(context.scene);
    bool const clears = context.scene.circular_spline.automatic_backlash || clearing;
    Cleared part = clears ? clear_flanks(surface, SliceClearances(context), given)
                          : nominal_part(surface, given, std::max(surface.nominal_tip_radius(), surface.needed_tip()));
    double const offset = std::max(given, part.offset);
    FlankGrid grid = moved_into_material(std::move(part.flanks.grid), offset);
    return {std::move(part.outline), std::move(grid), offset, part.tip};
}

}  // namespace hdconj::contact
