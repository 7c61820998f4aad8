// SPDX-License-Identifier: GPL-3.0-or-later
// The tip circle that a surface needs, and whether the teeth still reach it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hdconj/numeric/error.hpp"
#include "hdconj/profile/builder.hpp"
#include "moved_outline.hpp"
#include "spline_surface.hpp"

namespace hdconj::detail {
namespace {

constexpr char const* drafted_meet = "leaves a tip land between the drafted flanks";

/// Largest radius that an end of the flanks reaches, moved by @p distance along its normal, where the neutral curve moves by w = amplitude cos n u about r_m [mm].
/// An end stands x beside the tooth's middle, which is highest at u = 0; a little aside of that the tooth leans towards it, by n amplitude sin(n u)/r, and lifts it by
/// amplitude (n x/r)^2/2 more than the neutral curve has come down. Third order in amplitude/r left out.
double foot_radius(Profile const& tooth, double distance, double r_m, double amplitude, int waves)
{
    double highest = 0;
    for (PieceEnd const& end : {start_of(tooth.pieces.front().shape), end_of(tooth.pieces.back().shape)})
    {
        Vec2 const foot = end.point + distance * end.normal;
        double const leaning = waves * foot.x() / r_m;
        highest = std::max(highest, std::hypot(foot.x(), r_m + amplitude + foot.y()) + amplitude * leaning * leaning / 2);
    }
    return highest;
}

/// The higher end of the flanks above the neutral curve, moved by @p distance along their normals [mm].
double foot_height(Profile const& tooth, double distance)
{
    PieceEnd const left = start_of(tooth.pieces.front().shape), right = end_of(tooth.pieces.back().shape);
    return std::max(left.point.y() + distance * left.normal.y(), right.point.y() + distance * right.normal.y());
}

}  // namespace

double SurfaceMaker::needed_tip(SurfaceChoice const& choice)
{
    double tip = base_->geometry.circular_spline_inner_radius;
    why_.clear();
    if (!coned() && choice.tilt == 0)
        return tip;
    std::vector<SliceNeed> const needs = slice_needs(choice);
    for (std::size_t k = 0; k < needs.size(); ++k)
    {
        auto const ask = [&](double radius, std::string const& cause) {
            if (radius > tip)
            {
                tip = radius;
                why_ = "no smaller one " + cause + " in the slice z = " + short_number(z_[k]) + " mm";
            }
        };
        ask(needs[k].land, "leaves the circular spline a tip land");
        ask(needs[k].rim, "clears the flexspline's rim");
        ask(needs[k].draft, drafted_meet);
    }
    if (double const solved = solvable_tip(choice, base_->scene.circular_spline.backlash_offset); solved > tip)
    {
        tip = solved;
        why_ = "no smaller one is met by all flanks with their side clearance";
    }
    return tip;
}

std::vector<double> SurfaceMaker::needed_by_slices(SurfaceChoice const& choice)
{
    double const own = base_->geometry.circular_spline_inner_radius;
    if (!coned() && choice.tilt == 0)
        return std::vector<double>(z_.size(), own);
    std::vector<double> tips;
    for (SliceNeed const& each : slice_needs(choice))
        tips.push_back(std::max({own, each.land, each.rim, each.draft}));
    return tips;
}

/// What each slice asks of the tip circle of z = 0; every slice is entered by its own teeth, whatever the surface was made from.
std::vector<SurfaceMaker::SliceNeed> SurfaceMaker::slice_needs(SurfaceChoice const& choice)
{
    PairGeometry const& g = base_->geometry;
    double const least = least_land * base_->scene.drive.module;
    std::vector<std::size_t> const all = own_slices({"per-slice", choice.kind, 0});
    if (coned())
        prepare(all, choice.surface == "tilted");
    else
        prepare({0});
    std::vector<SliceNeed> needs;
    for (std::size_t const k : all)
    {
        double const shift = z_[k] * std::tan(choice.tilt);
        std::size_t const own = coned() ? k : 0;
        // an outline of this slice's own is solved before it is moved, and needs its land there too, clear of the rim
        bool const moved_outward = shift > 0 && coned() && choice.surface != "tilted";
        double const gained = moved_outward ? 0 : shift;
        needs.push_back({*pointed_[own] + least - gained, g.r_m + motions_[own]->amplitude + g.pitch_line - g.dedendum + least - gained,
                         choice.kind == "draft" ? meeting_tip(z_[k], choice.tilt) : 0});
    }
    return needs;
}

double SurfaceMaker::solvable_tip(SurfaceChoice const& choice, double distance)
{
    if (!coned() || choice.surface == "tilted")
        return 0;
    double amplitude = 0;
    for (std::size_t const k : own_slices(choice))
        amplitude = std::max(amplitude, motion(k).amplitude);
    PairGeometry const& g = base_->geometry;
    double const least = least_land * base_->scene.drive.module;
    constexpr double above = 0.25;   // of the least land: flanks have to cross the tip circle
    return std::max(g.r_m + amplitude + foot_height(*tooth_, distance) + least, foot_radius(*tooth_, distance, g.r_m, amplitude, base_->scene.wave_generator.waves) + above * least);
}

double SurfaceMaker::own_tip(SurfaceChoice const& choice)
{
    if (coned() && choice.surface != "tilted")
        return needed_tip(choice);
    double tip = base_->geometry.circular_spline_inner_radius;
    why_.clear();
    for (std::size_t k = 0; choice.tilt != 0 && choice.kind == "draft" && k < z_.size(); ++k)
    {
        double const meeting = meeting_tip(z_[k], choice.tilt);
        if (meeting > tip)
        {
            tip = meeting;
            why_ = "no smaller one " + std::string(drafted_meet) + " in the slice z = " + short_number(z_[k]) + " mm";
        }
    }
    return tip;
}

/// The tip circle of z = 0 that leaves a land at @p z where a draft makes the flanks meet; 0 where they do not.
double SurfaceMaker::meeting_tip(double z, double tilt)
{
    if (!base_flank_)
        base_flank_ = matched_outline({&middle(base_->geometry.circular_spline_inner_radius)}, tolerance_.length, 0, threads_);
    double const shift = z * std::tan(tilt);
    double const meeting = meeting_radius(*base_flank_, 0, shift, 2 * std::numbers::pi / base_->scene.drive.circular_spline_teeth);
    return meeting > 0 ? meeting + least_land * base_->scene.drive.module - shift : 0;
}

/// A tip circle that was widened until no tooth reaches it leaves no flank.
void SurfaceMaker::check_reach(SurfaceChoice const& choice, bool follows, double tip)
{
    PairGeometry const& g = base_->geometry;
    double const crest = g.r_m + g.pitch_line + g.addendum;
    std::vector<std::size_t> const slices = follows ? own_slices(choice) : std::vector<std::size_t>{z_.size() / 2};
    for (std::size_t k : slices)
    {
        double const reach = crest + (follows ? motion(k).amplitude : g.w0);
        if (tip < reach)
            continue;
        throw NumericalError("slices", follows ? "slice at z = " + short_number(z_[k]) + " mm" : "tip circle",
                             "a tip circle of " + short_number(tip) + " mm would be needed" + (why_.empty() ? "" : " (" + why_ + ")") + ", but the flexspline's tips reach "
                                 + short_number(reach) + " mm only; write a smaller tilt, side clearance or circular_spline.width");
    }
}

}  // namespace hdconj::detail
