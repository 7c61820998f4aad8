// SPDX-License-Identifier: GPL-3.0-or-later
#include "tooth_surface.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "base/text.hpp"
#include "coning.hpp"
#include "conjugate/plane/conjugate_solver.hpp"
#include "drive/elastic_cup.hpp"
#include "hdconj/error.hpp"
#include "judgement/judgement.hpp"
#include "moved_outline.hpp"
#include "section_motion.hpp"
#include "slice_job.hpp"
#include "slice_places.hpp"

namespace hdconj::surface {
namespace {

std::vector<std::size_t> first_indices(std::size_t count)
{
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

}  // namespace

ToothSurfaceBuilder::ToothSurfaceBuilder(Solution const& base, profile::Profile const& tooth,
                                         wavegen::AnyWaveShape shape, std::vector<double> z, int threads)
    : base_(&base),
      tooth_(&tooth),
      shape_(std::move(shape)),
      z_(std::move(z)),
      threads_(threads),
      tolerance_{base.scene.solver.tolerance, base.geometry.r_m + base.geometry.w0 + tooth.pitch_line + tooth.addendum},
      motions_(z_.size()),
      jobs_(z_.size())
{
}

ToothSurfaceBuilder::ToothSurfaceBuilder(Solution const& base, ToothSurfaceBuilder& other)
    : ToothSurfaceBuilder(base, *other.tooth_, other.shape_, other.z_, other.threads_)
{
    (void)other.follows_sections();
    sections_ = other.sections_;
    sections_asked_ = true;
    motions_ = other.motions_;
    other_clearance_ = &other;
}

ToothSurfaceBuilder::~ToothSurfaceBuilder() = default;

conjugate::MatchedOutline ToothSurfaceBuilder::with_flanks(
    std::function<conjugate::MatchedOutline()> const& match) const
{
    try {
        return match();
    } catch (NumericalError const& error) {
        if (error.code() != ErrorCode::no_flank)
            throw;
        throw judgement::with_cause_of_no_flank(error, {base_->scene, base_->geometry, *tooth_, shape_}, *base_);
    }
}

double ToothSurfaceBuilder::factor(double z) const
{
    return base_->scene.coning ? coning_mode(*base_->scene.coning).factor(z) : 1.0;
}

bool ToothSurfaceBuilder::follows_sections()
{
    if (!sections_asked_) {
        sections_ = section_displacements(*base_, shape_, z_, threads_);
        sections_asked_ = true;
    }
    return sections_.has_value();
}

bool ToothSurfaceBuilder::shares(std::size_t k)
{
    return coarse_ != nullptr && k % 2 == 0 && coarse_->follows_sections() == follows_sections();
}

std::vector<SliceMotion> ToothSurfaceBuilder::motions_at(std::vector<double> const& planes)
{
    if (refined_ && planes == refined_->z_)
        return refined_->motions_at(planes);
    bool const own = planes == z_;
    auto const sections =
        own || !follows_sections() ? std::nullopt : section_displacements(*base_, shape_, planes, threads_);
    std::vector<SliceMotion> motions;
    for (std::size_t k = 0; k < planes.size(); ++k)
        in_slice(planes[k], [&] {
            motions.push_back(own        ? motion(k)
                              : sections ? slice_motion(base_->scene, *tooth_, (*sections)[k], base_->geometry.r_m)
                                         : motion_at(planes[k]));
        });
    return motions;
}

std::string ToothSurfaceBuilder::note_on_sections()
{
    if (!coned() || !base_->scene.maps_axial_shift() || follows_sections())
        return "";
    bool const first_order = base_->scene.solver.kinematics == Kinematics::first_order;
    return "outlines leave out the wall's axial shift, which " +
           std::string(first_order ? "first-order kinematics does not have"
                                   : "has no Fourier series for a wave generator whose shape has breaks") +
           "; gaps contain it";
}

SliceMotion const& ToothSurfaceBuilder::motion(std::size_t k)
{
    bool const section = follows_sections();
    if (shares(k))
        return coarse_->motion(k / 2);
    if (!motions_[k])
        in_slice(z_[k], [&] {
            motions_[k] =
                section ? slice_motion(base_->scene, *tooth_, (*sections_)[k], base_->geometry.r_m) : motion_at(z_[k]);
        });
    return *motions_[k];
}

SliceMotion ToothSurfaceBuilder::motion_at(double z) const
{
    if (base_->scene.coning && base_->cup)
        return slice_motion(base_->scene, *tooth_, drive::displacement_at(*base_->cup, z, base_->geometry.r_m),
                            base_->geometry.r_m);
    return slice_motion(base_->scene, *tooth_, shape_, factor(z), base_->geometry.r_m);
}

void ToothSurfaceBuilder::find_motions(std::vector<std::size_t> const& wanted)
{
    (void)follows_sections();
    (void)shares(0);
    constexpr std::size_t grain = 2;
    parallel_for(wanted.size(), threads_, grain, [&](std::size_t i) { (void)motion(wanted[i]); });
}

void ToothSurfaceBuilder::find_motions(std::size_t count)
{
    find_motions(first_indices(count));
}

/// The outline's own drive, at z = 0, and its branches.
void ToothSurfaceBuilder::prepare_middle()
{
    if (middle_job_)
        return;
    auto made = std::make_unique<SliceJob>(*base_, motion_at(0), threads_);
    made->find_branches(other_clearance_ != nullptr ? other_clearance_->middle_job_.get() : nullptr);
    middle_job_ = std::move(made);
}

/// Branches of the slices @p wanted.
/// @param middle_too  what middle() needs, beside them
void ToothSurfaceBuilder::prepare(std::vector<std::size_t> const& wanted, bool middle_too)
{
    find_motions(wanted);
    std::vector<std::size_t> shared;
    std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(shared), [&](std::size_t k) { return shares(k); });
    if (!shared.empty()) {
        std::vector<std::size_t> coarse;
        for (std::size_t const k : shared)
            coarse.push_back(k / 2);
        coarse_->prepare(coarse);
        for (std::size_t const k : shared)
            jobs_[k] = coarse_->jobs_[k / 2];
    }
    parallel_for(wanted.size() + (middle_too ? 1 : 0), threads_, 1, [&](std::size_t i) {
        if (i == wanted.size())
            return prepare_middle();
        std::size_t const k = wanted[i];
        if (jobs_[k])
            return;
        in_slice(z_[k], [&] {
            auto made = std::make_shared<SliceJob>(*base_, motion(k), 1);
            made->find_branches(other_clearance_ != nullptr ? other_clearance_->jobs_[k].get() : nullptr);
            jobs_[k] = std::move(made);
        });
    });
}

ToothSurfaceBuilder& ToothSurfaceBuilder::refined()
{
    if (!refined_) {
        refined_ = std::make_unique<ToothSurfaceBuilder>(
            *base_, *tooth_, shape_, slice_places(static_cast<int>(2 * z_.size() - 1), 2 * z_.back()), threads_);
        refined_->coarse_ = this;
    }
    return *refined_;
}

std::vector<std::size_t> ToothSurfaceBuilder::own_slices(SurfaceSpec const& spec) const
{
    if (spec.surface == ToothSurface::ruled)
        return {0, z_.size() - 1};
    return first_indices(z_.size());
}

conjugate::ToothSpaceBoundary const& ToothSurfaceBuilder::middle(double tip)
{
    prepare_middle();
    return *middle_job_->boundary(tip);
}

ToothSurfaceBuilder::Curves ToothSurfaceBuilder::solved(std::vector<std::size_t> const& wanted, double tip)
{
    prepare(wanted);
    Curves curves(wanted.size());
    parallel_for(wanted.size(), threads_, 1, [&](std::size_t i) {
        std::size_t const k = wanted[i];
        in_slice(z_[k], [&] { curves[i] = jobs_[k]->boundary(tip); });
    });
    return curves;
}

conjugate::MatchedOutline ToothSurfaceBuilder::outline(SurfaceSpec const& spec, double tip,
                                                       SurfaceSampling const& sampling, drive::StageClock* clock)
{
    auto const timed = [&](Stage stage, auto const& body) {
        if (clock != nullptr)
            clock->run(stage, body);
        else
            body();
    };
    conjugate::MatchedOutline outline;
    Curves curves;
    conjugate::MovedChord moved(sampling.chord);
    do {
        timed(Stage::surface, [&] {
            if (curves.empty()) {
                check_reach(spec, tip);
                curves = follows_cone(spec) ? solved(own_slices(spec), tip) : Curves{};
            }
            outline = with_flanks([&] {
                return curves.empty() ? one_outline(spec, tip, moved.asked(), sampling.flank_intervals)
                                      : outline_by_slices(curves, spec, moved.asked(), sampling.flank_intervals);
            });
            deepen_all(outline, base_->scene.circular_spline.root_clearance);
        });
        if (spec.is_tilted_radially())
            timed(Stage::tilt, [&] { move_radially(outline, z_, spec.tilt); });
    } while (spec.is_tilted_radially() && sampling.keeps_chord_tilted && moved.is_longer(outline.chord));
    return outline;
}

NominalSurface ToothSurfaceBuilder::nominal_surface(SurfaceSpec const& spec, SurfaceSampling const& sampling,
                                                    drive::StageClock& clock)
{
    clock.run(Stage::coning, [&] { find_motions(z_.size()); });
    TipCircle tip = nominal_tip(spec);
    conjugate::MatchedOutline made = outline(spec, tip.radius, sampling, &clock);
    return {std::move(made), std::move(tip), note_on_sections()};
}

conjugate::MatchedOutline ToothSurfaceBuilder::outline_by_slices(Curves const& curves, SurfaceSpec const& spec,
                                                                 double chord, int flank_intervals) const
{
    std::vector<conjugate::ToothSpaceBoundary const*> slices;
    for (auto const& curve : curves)
        slices.push_back(curve.get());
    conjugate::MatchedOutline outline =
        conjugate::matched_outline(slices, chord, flank_intervals, threads_, spec.surface == ToothSurface::ruled);
    if (spec.surface != ToothSurface::ruled)
        return outline;
    conjugate::MatchedOutline const ends = outline;
    outline.points.assign(z_.size(), ends.points.front());
    outline.normals.assign(z_.size(), ends.normals.front());
    outline.points.back() = ends.points.back();
    outline.normals.back() = ends.normals.back();
    for (std::size_t k = 1; k + 1 < z_.size(); ++k) {
        double const share = (z_[k] - z_.front()) / (z_.back() - z_.front());
        for (std::size_t i = 0; i < ends.points.front().size(); ++i) {
            outline.points[k][i] = (1 - share) * ends.points.front()[i] + share * ends.points.back()[i];
            outline.normals[k][i] =
                ((1 - share) * ends.normals.front()[i] + share * ends.normals.back()[i]).normalized();
        }
    }
    return outline;
}

}  // namespace hdconj::surface
