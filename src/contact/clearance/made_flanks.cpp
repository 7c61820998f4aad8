// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_flanks.hpp"

#include <memory>

#include "contact/study/contact_study_data.hpp"
#include "hdconj/error.hpp"

namespace hdconj::contact {

FlankGrid made_flanks(CaseSurface const& surface, FlankGrid const& bare, double tip, double side_clearance)
{
    ContactContext const& context = surface.context();
    if (!surface.is_ruled_on_cone() || side_clearance == 0 || surface.z().size() == 1)
        return moved_into_material(bare, side_clearance);
    try {
        // the cup stays with the study
        std::shared_ptr<elastic::BentCup const> const cup(std::shared_ptr<void>(), context.cup);
        conjugate::SolvedPlane const plane = plane_with_clearance(context.scene, side_clearance, tip, cup);
        surface::ToothSurfaceBuilder builder(plane.solution, surface.builder());
        int const points = context.request.flank_points;
        return flank_grid(builder.outline(surface.spec(), tip, {context.tolerance.length, points}), surface.z(),
                          points);
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        return moved_into_material(bare, side_clearance);
    }
}

}  // namespace hdconj::contact
