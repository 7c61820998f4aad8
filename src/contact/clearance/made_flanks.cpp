// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_flanks.hpp"

#include <memory>
#include <utility>

#include "contact/study/contact_study_data.hpp"
#include "hdconj/error.hpp"

namespace hdconj::contact {

std::optional<FlankGrid> solved_flanks(CaseSurface const& surface, double tip, double side_clearance)
{
    ContactContext const& context = surface.context();
    try {
        // the cup stays with the study
        std::shared_ptr<elastic::BentCup const> const cup(std::shared_ptr<void>(), context.cup);
        conjugate::SolvedPlane const plane = plane_with_clearance(context.scene, side_clearance, tip, cup);
        surface::ToothSurfaceBuilder builder(plane.solution, surface.builder());
        int const points = context.request.flank_points;
        FlankGrid grid =
            flank_grid(builder.outline(surface.spec(), tip, {context.tolerance.length, points}), surface.z(), points);
        grid.included_clearance = side_clearance;
        return grid;
    } catch (NumericalError const& error) {
        if (!error.is_infeasible())
            throw;
        return std::nullopt;
    }
}

FlankGrid made_flanks(CaseSurface const& surface, FlankGrid const& bare, double tip, double side_clearance)
{
    bool const solved =
        surface.is_made_with_clearance() && side_clearance != 0 && bare.included_clearance != side_clearance;
    std::optional<FlankGrid> grid = solved ? solved_flanks(surface, tip, side_clearance) : std::nullopt;
    return grid ? *std::move(grid) : moved_into_material(bare, side_clearance);
}

}  // namespace hdconj::contact
