// SPDX-License-Identifier: GPL-3.0-or-later
// One surface of a study: everything that the steps of a case ask of it.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "contact_context.hpp"

namespace hdconj::contact {

/// A tooth surface in the planes of a builder. Only here a case knows how the surface is made and tilted.
class CaseSurface
{
  public:
    /// In the slices of the scene.
    CaseSurface(ContactContext const& context, surface::SurfaceSpec const& spec)
        : CaseSurface(context, spec, context.maker)
    {
    }

    [[nodiscard]] ContactContext const& context() const { return *context_; }
    [[nodiscard]] surface::SurfaceSpec const& spec() const { return spec_; }
    /// Motions and planes.
    [[nodiscard]] surface::ToothSurfaceBuilder& builder() const { return *builder_; }
    [[nodiscard]] std::vector<double> const& z() const { return builder_->z(); }

    /// Outlines with enough points for a map over the flanks. @param tip  radius of the tip circle at z = 0 [mm]
    [[nodiscard]] conjugate::MatchedOutline outline(double tip) const
    {
        return builder_->outline(spec_, tip, {context_->tolerance.length, context_->request.flank_points},
                                 &context_->clock);
    }
    /// The conjugate outlines of the same planes, each made for itself, without tilt.
    [[nodiscard]] conjugate::MatchedOutline conjugate_outlines(double tip) const
    {
        return builder_->outline({ToothSurface::per_slice, TiltKind::radial, 0}, tip, {context_->tolerance.length});
    }

    /// Tip circles of z = 0, see ToothSurfaceBuilder [mm].
    [[nodiscard]] double nominal_tip_radius() const { return builder_->nominal_tip(spec_).radius; }
    [[nodiscard]] double needed_tip() const { return builder_->needed_tip(spec_).radius; }
    [[nodiscard]] double solvable_tip(double distance) const { return builder_->solvable_tip(spec_, distance); }
    [[nodiscard]] double needed_tip_of_moved(double distance) const
    {
        return builder_->needed_tip_of_moved(spec_, distance);
    }
    [[nodiscard]] double pointed_radius_of_moved(double distance) const
    {
        return builder_->pointed_radius_of_moved(distance);
    }
    [[nodiscard]] std::vector<double> needed_by_slices() const { return builder_->needed_by_slices(spec_); }

    /// How far a tilt moves the tip circle of plane @p k outward [mm].
    [[nodiscard]] double tip_shift(std::size_t k) const { return z()[k] * std::tan(spec_.tilt); }
    /// (k) How far a radial tilt has moved each plane outward [mm]; empty without one.
    [[nodiscard]] std::vector<double> radial_shifts() const
    {
        std::vector<double> shifts;
        for (std::size_t k = 0; k < z().size() && spec_.is_tilted_radially(); ++k)
            shifts.push_back(tip_shift(k));
        return shifts;
    }

    /// Whether all planes have the same outline and the same motion.
    [[nodiscard]] bool is_alike() const { return z().size() == 1 || (!context_->scene.coning && spec_.tilt == 0); }
    /// Whether each plane has a conjugate outline of its own.
    [[nodiscard]] bool is_solved_per_plane() const
    {
        return spec_.surface == ToothSurface::per_slice && context_->scene.coning;
    }
    /// Whether each plane has the same outline, moved along its normals by a different amount. Where moved branches
    /// cross, and the flank ends, is another place in each plane.
    [[nodiscard]] bool is_drafted() const { return spec_.is_drafted(); }
    [[nodiscard]] bool is_ruled() const { return spec_.surface == ToothSurface::ruled; }
    /// Whether straight lines join the conjugate outlines of two end planes that differ.
    [[nodiscard]] bool is_ruled_on_cone() const { return is_ruled() && context_->scene.coning; }
    /// Whether its flanks with a side clearance are not those without it, moved along the normals of each plane.
    [[nodiscard]] bool is_made_with_clearance() const { return (is_ruled_on_cone() || is_drafted()) && z().size() > 1; }

    /// The same surface with twice as many intervals between its planes.
    [[nodiscard]] CaseSurface refined() const { return {*context_, spec_, builder_->refined()}; }

  private:
    CaseSurface(ContactContext const& context, surface::SurfaceSpec const& spec, surface::ToothSurfaceBuilder& builder)
        : context_(&context), spec_(spec), builder_(&builder)
    {
    }

    ContactContext const* context_;
    surface::SurfaceSpec spec_;
    surface::ToothSurfaceBuilder* builder_;
};

}  // namespace hdconj::contact
