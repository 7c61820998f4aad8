// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of the circular spline against all teeth.
#pragma once

#include "contact/flank_grid.hpp"
#include "contact_context.hpp"
#include "hdconj/contact.hpp"

namespace hdconj::contact {

/// Everything about one surface. @p revolution angles beside the scene's own. @p errors: estimated too; of nothing else
/// a bit depends on that. @p map gets the gaps after take-up.
[[nodiscard]] ContactCase contact_case(ContactContext const& context, surface::SurfaceSpec const& spec, int revolution,
                                       bool errors, GapMap* map);

/// The flanks of one surface with the scene's side clearance, and its tip circle, as much wider as every slice's land
/// and rim ask for; "auto": with the least that clears, and the tip circle that goes with it.
struct FlankSurface
{
    conjugate::MatchedOutline outline;  ///< without side clearance
    FlankGrid grid;                     ///< with it
    double offset = 0;                  ///< [mm]
    double tip = 0;                     ///< [mm]
    double offset_error = 0;            ///< estimated, of a side clearance that was found [mm]; else 0
};
/// @param clearing  as for "auto", whatever the scene says
/// @param error     the error of the side clearance is estimated too
[[nodiscard]] FlankSurface flank_surface(ContactContext const& context, surface::SurfaceSpec const& spec,
                                         bool clearing = false, bool error = false);

/// flank_surface() of a scene that gives the side clearance @p clearance [mm].
[[nodiscard]] FlankSurface surface_with_clearance(ContactContext const& context, surface::SurfaceSpec const& spec,
                                                  double clearance);

/// The flanks that contact_case() computes with: the scene's where these clear over a full turn and at the scene's
/// angle of the wave generator, else those that do.
[[nodiscard]] FlankSurface used_surface(ContactContext const& context, surface::SurfaceSpec const& spec);

/// Whether a part has more side clearance than the scene gives; never with "auto".
/// @param offset  of the part [mm]
[[nodiscard]] inline bool is_side_clearance_increased(ContactContext const& context, double offset)
{
    return !context.scene.circular_spline.automatic_backlash &&
           offset > given_clearance(context.scene) + context.tolerance.length;
}

/// How much wider the tip circle of a part is than the scene gives; 0 within the tolerance, and with "auto" [mm].
/// @param tip  radius at z = 0 [mm]
[[nodiscard]] inline double tip_radius_increase(ContactContext const& context, double tip)
{
    double const wider = tip - context.geometry.circular_spline_inner_radius;
    return !context.scene.circular_spline.automatic_backlash && wider > context.tolerance.length ? wider : 0;
}

/// What a scene's surface needs so that no slice is entered over a full turn.
struct SideClearanceNeed
{
    double offset = 0;              ///< side clearance [mm]
    double tip = 0;                 ///< tip circle [mm]
    double nominal_tip_radius = 0;  ///< what it is without
    double error = 0;               ///< bound of the offset's: clearance_accuracy() over the least slope [mm]
};
[[nodiscard]] SideClearanceNeed side_clearance_need(Scene const& scene);

/// The share of this surface alone, without errors, for searches: ContactCase::state's, the same bits.
/// @throws NumericalError where contact_case() does, also where only the part as the scene gives it cannot be made
[[nodiscard]] double share_of(ContactContext const& context, surface::SurfaceSpec const& spec);

/// The least side clearance of this surface alone, for searches. @throws NumericalError where contact_case() does
[[nodiscard]] double least_side_clearance_of(ContactContext const& context, surface::SurfaceSpec const& spec);

}  // namespace hdconj::contact
