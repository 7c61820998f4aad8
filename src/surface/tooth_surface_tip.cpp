// SPDX-License-Identifier: GPL-3.0-or-later
// The tip circle that a surface needs, and whether the teeth still reach it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/error.hpp"
#include "moved_outline.hpp"
#include "slice_job.hpp"
#include "tooth_surface.hpp"

namespace hdconj::surface {
namespace {

constexpr char const* drafted_meet = "leaves no tip land between the drafted flanks";

/// Largest radius that an end of the flanks reaches, moved by @p distance along its normal, where the neutral curve
/// moves by w = amplitude cos n u about r_m [mm]. An end stands x beside the tooth's middle, which is highest at u = 0;
/// a little aside of that the tooth leans towards it, by n amplitude sin(n u)/r, and lifts it by amplitude (n x/r)^2/2
/// more than the neutral curve has come down. Third order in amplitude/r left out.
double foot_radius(profile::Profile const& tooth, double distance, double r_m, double amplitude, int waves)
{
    double highest = 0;
    for (profile::PieceEnd const& end :
         {profile::start_of(tooth.pieces.front().shape), profile::end_of(tooth.pieces.back().shape)}) {
        Vec2 const foot = end.point + distance * end.normal;
        double const leaning = waves * foot.x() / r_m;
        highest =
            std::max(highest, std::hypot(foot.x(), r_m + amplitude + foot.y()) + amplitude * leaning * leaning / 2);
    }
    return highest;
}

/// Widens @p tip to @p radius where that is larger. @param cause  what a smaller one does in the slice at @p z
void widen(TipCircle& tip, double radius, char const* cause, double z)
{
    if (radius > tip.radius)
        tip = {radius, fmt::format("a smaller one {} in the slice z = {} mm", cause, short_number(z))};
}

/// The higher end of the flanks above the neutral curve, moved by @p distance along their normals [mm].
double foot_height(profile::Profile const& tooth, double distance)
{
    profile::PieceEnd const left = profile::start_of(tooth.pieces.front().shape),
                            right = profile::end_of(tooth.pieces.back().shape);
    return std::max(left.point.y() + distance * left.normal.y(), right.point.y() + distance * right.normal.y());
}

}  // namespace

TipCircle ToothSurfaceBuilder::needed_tip(SurfaceSpec const& spec)
{
    TipCircle tip{base_->geometry.circular_spline_inner_radius, ""};
    if (!coned() && spec.tilt == 0)
        return tip;
    std::vector<SliceNeed> const needs = slice_needs(spec);
    for (std::size_t k = 0; k < needs.size(); ++k) {
        widen(tip, needs[k].land, "leaves the circular spline no tip land", z_[k]);
        widen(tip, needs[k].rim, "cuts into the flexspline's rim", z_[k]);
        widen(tip, needs[k].draft, drafted_meet, z_[k]);
    }
    double const solved = solvable_tip(spec, base_->scene.circular_spline.backlash_offset);
    return solved > tip.radius
               ? TipCircle{solved, "a smaller one is not reached by all flanks with their side clearance"}
               : tip;
}

std::vector<double> ToothSurfaceBuilder::needed_by_slices(SurfaceSpec const& spec)
{
    double const own = base_->geometry.circular_spline_inner_radius;
    if (!coned() && spec.tilt == 0)
        return std::vector<double>(z_.size(), own);
    std::vector<double> tips;
    for (SliceNeed const& each : slice_needs(spec))
        tips.push_back(std::max({own, each.land, each.rim, each.draft}));
    return tips;
}

/// What each slice asks of the tip circle of z = 0; every slice is entered by its own teeth, whatever the surface was
/// made from.
std::vector<ToothSurfaceBuilder::SliceNeed> ToothSurfaceBuilder::slice_needs(SurfaceSpec const& spec)
{
    PairGeometry const& g = base_->geometry;
    double const least = least_land * base_->scene.drive.module;
    std::vector<std::size_t> const all = own_slices({ToothSurface::per_slice, spec.kind, 0});
    if (coned())
        prepare(all, spec.surface == ToothSurface::tilted);
    else
        prepare({0});
    parallel_for(coned() ? all.size() : 1, threads_, 1, [&](std::size_t k) {
        if (!jobs_[k]->pointed)
            in_slice(z_[k],
                     [&] { jobs_[k]->pointed = jobs_[k]->solve->pointed_radius(g.circular_spline_inner_radius); });
    });
    std::vector<SliceNeed> needs;
    for (std::size_t const k : all) {
        double const shift = z_[k] * std::tan(spec.tilt);
        std::size_t const own = coned() ? k : 0;
        // an outline of this slice's own is solved before it is moved, and needs its land there too, clear of the rim
        bool const moved_outward = shift > 0 && follows_cone(spec);
        double const gained = moved_outward ? 0 : shift;
        needs.push_back({*jobs_[own]->pointed + least - gained,
                         g.r_m + motion(own).amplitude + g.pitch_line - g.dedendum + least - gained,
                         spec.kind == TiltKind::draft ? meeting_tip(z_[k], spec.tilt) : 0});
    }
    return needs;
}

double ToothSurfaceBuilder::solvable_tip(SurfaceSpec const& spec, double distance)
{
    if (!follows_cone(spec))
        return 0;
    double amplitude = 0;
    for (std::size_t const k : own_slices(spec))
        amplitude = std::max(amplitude, motion(k).amplitude);
    PairGeometry const& g = base_->geometry;
    double const least = least_land * base_->scene.drive.module;
    constexpr double above = 0.25;  // of the least land: flanks have to cross the tip circle
    return std::max(
        g.r_m + amplitude + foot_height(*tooth_, distance) + least,
        foot_radius(*tooth_, distance, g.r_m, amplitude, base_->scene.wave_generator.waves) + above * least);
}

/// The same drive with a side clearance of @p distance, of which no outline is made; the last is kept.
ToothSurfaceBuilder& ToothSurfaceBuilder::with_side_clearance(double distance)
{
    if (distance == base_->scene.circular_spline.backlash_offset)
        return *this;
    if (moved_ && moved_base_.scene.circular_spline.backlash_offset == distance)
        return *moved_;
    moved_.reset();
    moved_base_.scene = base_->scene;
    moved_base_.scene.circular_spline.backlash_offset = distance;
    moved_base_.geometry = base_->geometry;
    moved_base_.cup = base_->cup;
    moved_base_.flank_contact = base_->flank_contact;
    moved_base_.segment_names = base_->segment_names;
    moved_ = std::make_unique<ToothSurfaceBuilder>(moved_base_, *this);
    return *moved_;
}

double ToothSurfaceBuilder::needed_tip_of_moved(SurfaceSpec const& spec, double distance)
{
    return follows_cone(spec) ? with_side_clearance(distance).needed_tip(spec).radius : 0;
}

double ToothSurfaceBuilder::pointed_radius_of_moved(double distance)
{
    ToothSurfaceBuilder& moved = with_side_clearance(distance);
    prepare_middle();
    moved.prepare_middle();
    return moved.middle_job_->solve->pointed_radius(base_->geometry.circular_spline_inner_radius);
}

TipCircle ToothSurfaceBuilder::nominal_tip(SurfaceSpec const& spec)
{
    if (follows_cone(spec))
        return needed_tip(spec);
    TipCircle tip{base_->geometry.circular_spline_inner_radius, ""};
    for (std::size_t k = 0; spec.is_drafted() && k < z_.size(); ++k)
        widen(tip, meeting_tip(z_[k], spec.tilt), drafted_meet, z_[k]);
    return tip;
}

/// The tip circle of z = 0 that leaves a land at @p z where a draft makes the flanks meet; 0 where they do not.
double ToothSurfaceBuilder::meeting_tip(double z, double tilt)
{
    if (!base_flank_)
        base_flank_ = with_flanks([&] {
            return conjugate::matched_outline({&middle(base_->geometry.circular_spline_inner_radius)},
                                              tolerance_.length, 0, threads_);
        });
    double const shift = z * std::tan(tilt);
    double const meeting =
        meeting_radius(*base_flank_, 0, shift, 2 * std::numbers::pi / base_->scene.drive.circular_spline_teeth);
    return meeting > 0 ? meeting + least_land * base_->scene.drive.module - shift : 0;
}

/// A tip circle that was widened until no tooth reaches it leaves no flank.
void ToothSurfaceBuilder::check_reach(SurfaceSpec const& spec, double tip)
{
    bool const follows = follows_cone(spec);
    PairGeometry const& g = base_->geometry;
    double const crest = g.r_m + g.pitch_line + g.addendum;
    std::vector<std::size_t> const slices = follows ? own_slices(spec) : std::vector<std::size_t>{z_.size() / 2};
    for (std::size_t k : slices) {
        double const reach = crest + (follows ? motion(k).amplitude : g.w0);
        if (tip < reach)
            continue;
        std::string const why = needed_tip(spec).why;
        throw NumericalError(
            ErrorCode::no_outline, "slices", follows ? "slice at z = " + short_number(z_[k]) + " mm" : "tip circle",
            "a tip circle of " + short_number(tip) + " mm would be needed" + (why.empty() ? "" : " (" + why + ")") +
                ", but the flexspline's tips reach " + short_number(reach) + " mm only",
            "write a smaller tilt, side clearance or circular_spline.width");
    }
}

}  // namespace hdconj::surface
