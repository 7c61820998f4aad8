// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "hdconj/axial/cone.hpp"
#include "hdconj/axial/coning.hpp"
#include "hdconj/axial/slice_places.hpp"
#include "hdconj/profile/builder.hpp"
#include "elastic_cup.hpp"
#include "job.hpp"
#include "section_motion.hpp"

namespace hdconj::detail {
/// One slice on its way to a boundary: a drive of its own without axial effects.
struct SliceJob
{
    SliceJob(Solution const& base, SliceMotion const& slice, int threads) : clock(out.plan, observer), motion(slice)
    {
        out.scene = base.scene;
        out.scene.coning.reset();
        out.scene.tilt.reset();
        out.scene.slices.reset();
        out.scene.contact.reset();
        out.plan = make_plan(out.scene);
        out.geometry = base.geometry;
        out.geometry.w0 = slice.amplitude;
        out.segment_names = base.segment_names;
        out.threads = threads;
        solve.emplace(out, *motion.tooth, motion.motion, clock);
    }
    SliceJob(SliceJob const&) = delete;
    SliceJob& operator=(SliceJob const&) = delete;

    Solution out;
    StageObserver observer;
    StageClock clock;
    SliceMotion motion;
    std::optional<SolveJob<ErasedMotion>> solve;
};

namespace {

/// A failure in one slice says which.
template<class Body>
void in_slice(double z, Body&& body)
{
    try
    {
        body();
    }
    catch (NumericalError const& error)
    {
        throw NumericalError("slices", "slice at z = " + short_number(z) + " mm", error.what());
    }
}

/// The bottom between the same two points in every slice, moved outward.
void deepen_all(MatchedOutline& outline, double clearance)
{
    if (!(clearance > 0))
        return;
    std::size_t const middle = outline.landmarks[2];
    std::vector<OutlineStretch> stretches;
    for (std::size_t k = 0; k < outline.points.size(); ++k)
    {
        Outline slice;
        slice.points = outline.points[k];
        slice.stretches = outline.stretches;
        deepen(slice, middle, clearance);
        if (k == 0)
            stretches = slice.stretches;
        bool const same = std::equal(stretches.begin(), stretches.end(), slice.stretches.begin(), slice.stretches.end(),
                                     [](OutlineStretch const& a, OutlineStretch const& b) { return a.first == b.first && a.last == b.last; });
        if (!same)
            throw NumericalError("root clearance", "slices", "the bottom of the tooth space is widest at different places of different slices; write root_clearance = 0");
        // the walls' ends have the normals of the points they were made from
        auto& normals = outline.normals[k];
        std::size_t const left = std::find_if(stretches.begin(), stretches.end(), [](auto const& s) { return s.kind == OutlineKind::root_wall; })->first;
        std::size_t const right = std::find_if(stretches.rbegin(), stretches.rend(), [](auto const& s) { return s.kind == OutlineKind::root_wall; })->last;
        normals.insert(normals.begin() + static_cast<std::ptrdiff_t>(right - 2), normals[right - 2]);
        normals.insert(normals.begin() + static_cast<std::ptrdiff_t>(left), normals[left]);
        outline.points[k] = std::move(slice.points);
    }
    outline.stretches = std::move(stretches);
    for (std::size_t i = 2; i < 5; ++i)
        outline.landmarks[i] += i == 2 ? 1 : 2;
}

constexpr char const* drafted_meet = "leaves a tip land between the drafted flanks";

}  // namespace

void move_radially(MatchedOutline& outline, std::vector<double> const& z, double tilt)
{
    for (std::size_t k = 0; k < z.size(); ++k)
    {
        double const distance = z[k] * std::tan(tilt);
        for (std::size_t i = 0; i < outline.points[k].size(); ++i)
        {
            outline.normals[k][i] = normal_moved_radially(outline.points[k][i], outline.normals[k][i], distance);
            outline.points[k][i] = moved_radially(outline.points[k][i], distance);
        }
    }
}

double meeting_radius(MatchedOutline const& outline, std::size_t k, double distance, double pitch)
{
    auto const angle_left = [&](std::size_t i) {
        Vec2 const p = outline.points[k][i] + distance * outline.normals[k][i];
        return 0.5 * pitch - std::abs(std::atan2(p.x(), p.y()));
    };
    double meeting = 0;
    // from the land corners down both flanks
    for (auto const& [from, to, step] : {std::tuple(outline.landmarks[4], outline.landmarks[3], -1), std::tuple(outline.landmarks[0], outline.landmarks[1], 1)})
    {
        for (std::size_t i = from; i != to; i += static_cast<std::size_t>(step))
        {
            if (angle_left(i) > 0)
                continue;
            std::size_t const next = i + static_cast<std::size_t>(step);
            Vec2 const p = outline.points[k][next] + distance * outline.normals[k][next];
            meeting = std::max(meeting, p.norm());
        }
    }
    return meeting;
}

SurfaceMaker::SurfaceMaker(Solution const& base, Profile const& tooth, AnyWaveShape shape, std::vector<double> z, int threads)
    : base_(&base), tooth_(&tooth), shape_(std::move(shape)), z_(std::move(z)), threads_(threads),
      tolerance_{base.scene.solver.tolerance, base.geometry.r_m + base.geometry.w0 + tooth.pitch_line + tooth.addendum}, motions_(z_.size()),
      jobs_(z_.size()), pointed_(z_.size())
{
}

SurfaceMaker::~SurfaceMaker() = default;

double SurfaceMaker::factor(double z) const
{
    return base_->scene.coning ? coning_mode(*base_->scene.coning).factor(z) : 1.0;
}

bool SurfaceMaker::follows_sections()
{
    if (!sections_asked_)
        sections_ = section_displacements(*base_, shape_, z_, threads_);
    sections_asked_ = true;
    return sections_.has_value();
}

std::vector<SliceMotion> SurfaceMaker::motions_at(std::vector<double> const& planes)
{
    bool const own = planes == z_;
    auto const sections = own || !follows_sections() ? std::nullopt : section_displacements(*base_, shape_, planes, threads_);
    std::vector<SliceMotion> motions;
    for (std::size_t k = 0; k < planes.size(); ++k)
        in_slice(planes[k], [&] {
            motions.push_back(own ? motion(k) : sections ? slice_motion(base_->scene, *tooth_, (*sections)[k], base_->geometry.r_m) : motion_at(planes[k]));
        });
    return motions;
}

std::string SurfaceMaker::note_on_sections()
{
    if (!coned() || base_->scene.coning->axial_shift != "mapped" || follows_sections())
        return "";
    bool const first_order = base_->scene.solver.kinematics == Kinematics::first_order;
    return "outlines are made for the wall's slices as if they stayed in their planes, since "
           + std::string(first_order ? "first-order kinematics knows no others" : "the wave generator's shape has breaks, and its sections no series")
           + "; the axial shift is in the gaps only";
}

SliceMotion const& SurfaceMaker::motion(std::size_t k)
{
    bool const section = follows_sections();
    if (!motions_[k])
        in_slice(z_[k], [&] {
            motions_[k] = section ? slice_motion(base_->scene, *tooth_, (*sections_)[k], base_->geometry.r_m) : motion_at(z_[k]);
        });
    return *motions_[k];
}

SliceMotion SurfaceMaker::motion_at(double z) const
{
    if (base_->scene.coning && base_->cup)
        return slice_motion(base_->scene, *tooth_, displacement_at(*base_->cup, z, base_->geometry.r_m), base_->geometry.r_m);
    return slice_motion(base_->scene, *tooth_, shape_, factor(z), base_->geometry.r_m);
}

/// Motions, branches and pointed radii of the slices @p wanted.
void SurfaceMaker::prepare(std::vector<std::size_t> const& wanted)
{
    for (std::size_t k : wanted)
        (void)motion(k);
    parallel_for(wanted.size(), threads_, 1, [&](std::size_t i) {
        std::size_t const k = wanted[i];
        if (jobs_[k])
            return;
        in_slice(z_[k], [&] {
            auto made = std::make_unique<SliceJob>(*base_, *motions_[k], 1);
            made->solve->find_branches_of_tooth();
            pointed_[k] = made->solve->pointed_radius();
            jobs_[k] = std::move(made);
        });
    });
}

SurfaceMaker& SurfaceMaker::refined()
{
    if (!refined_)
        refined_ = std::make_unique<SurfaceMaker>(*base_, *tooth_, shape_, slice_places(static_cast<int>(2 * z_.size() - 1), 2 * z_.back()), threads_);
    return *refined_;
}

std::vector<std::size_t> SurfaceMaker::own_slices(SurfaceChoice const& choice) const
{
    if (choice.surface == "ruled")
        return {0, z_.size() - 1};
    std::vector<std::size_t> all(z_.size());
    for (std::size_t k = 0; k < all.size(); ++k)
        all[k] = k;
    return all;
}

double SurfaceMaker::needed_tip(SurfaceChoice const& choice)
{
    PairGeometry const& g = base_->geometry;
    double tip = g.circular_spline_inner_radius;
    why_.clear();
    if (!coned() && choice.tilt == 0)
        return tip;
    double const least = least_land * base_->scene.drive.module;
    // every slice is entered by its own teeth, whatever the surface was made from
    std::vector<std::size_t> const all = own_slices({"per-slice", choice.kind, 0});
    if (coned())
        prepare(all);
    else
        prepare({0});
    auto const ask = [&](double radius, double z, std::string const& cause) {
        if (radius > tip)
        {
            tip = radius;
            why_ = "no smaller one " + cause + " in the slice z = " + short_number(z) + " mm";
        }
    };
    for (std::size_t k : all)
    {
        double const shift = z_[k] * std::tan(choice.tilt);
        std::size_t const own = coned() ? k : 0;
        // an outline of this slice's own is solved before it is moved, and needs its land there too
        bool const moved_outward = shift > 0 && coned() && choice.surface != "tilted";
        ask(*pointed_[own] + least - (moved_outward ? 0 : shift), z_[k], "leaves the circular spline a tip land");
        ask(g.r_m + motions_[own]->amplitude + g.pitch_line - g.dedendum + least - shift, z_[k], "clears the flexspline's rim");
        if (choice.kind == "draft")
            ask(meeting_tip(z_[k], choice.tilt), z_[k], drafted_meet);
    }
    return tip;
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

SpaceCurve const& SurfaceMaker::middle(double tip)
{
    if (middle_ && middle_->tip_radius() == tip)
        return *middle_;
    if (!middle_job_)
    {
        middle_job_ = std::make_unique<SliceJob>(*base_, motion_at(0), threads_);
        middle_job_->solve->find_branches_of_tooth();
    }
    middle_job_->out.geometry.circular_spline_inner_radius = tip;
    middle_job_->solve->find_boundary();
    middle_ = std::make_unique<SpaceCurve>(middle_job_->solve->curve(middle_job_->motion.owner));
    return *middle_;
}

SurfaceMaker::Curves SurfaceMaker::solved(std::vector<std::size_t> const& wanted, double tip)
{
    prepare(wanted);
    Curves curves(wanted.size());
    parallel_for(wanted.size(), threads_, 1, [&](std::size_t i) {
        std::size_t const k = wanted[i];
        in_slice(z_[k], [&] {
            jobs_[k]->out.geometry.circular_spline_inner_radius = tip;
            jobs_[k]->solve->find_boundary();
            curves[i] = std::make_unique<SpaceCurve>(jobs_[k]->solve->curve(jobs_[k]->motion.owner));
        });
    });
    return curves;
}

MatchedOutline SurfaceMaker::operator()(SurfaceChoice const& choice, double tip, double chord, int flank_intervals)
{
    bool const follows = coned() && choice.surface != "tilted";
    check_reach(choice, follows, tip);
    MatchedOutline outline = follows ? own(choice, tip, chord, flank_intervals) : tilted(choice, tip, chord, flank_intervals);
    deepen_all(outline, base_->scene.circular_spline.root_clearance);
    if (choice.tilt != 0 && choice.kind == "radial")
        move_radially(outline, z_, choice.tilt);
    return outline;
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

MatchedOutline SurfaceMaker::tilted(SurfaceChoice const& choice, double tip, double chord, int flank_intervals)
{
    SpaceCurve const& base = middle(tip);
    if (choice.tilt == 0 || choice.kind == "radial" || z_.size() == 1)
    {
        MatchedOutline outline = matched_outline({&base}, chord, flank_intervals, threads_);
        outline.points.resize(z_.size(), outline.points.front());
        outline.normals.resize(z_.size(), outline.normals.front());
        return outline;
    }
    std::vector<SpaceCurve> moved;
    std::vector<SpaceCurve const*> slices;
    moved.reserve(z_.size());
    for (double const z : z_)
        in_slice(z, [&] { moved.push_back(base.moved_along_normal(z * std::tan(choice.tilt), tolerance_)); });
    for (SpaceCurve const& curve : moved)
        slices.push_back(&curve);
    return matched_outline(slices, chord, flank_intervals, threads_);
}

MatchedOutline SurfaceMaker::own(SurfaceChoice const& choice, double tip, double chord, int flank_intervals)
{
    Curves const curves = solved(own_slices(choice), tip);
    std::vector<SpaceCurve const*> slices;
    for (auto const& curve : curves)
        slices.push_back(curve.get());
    MatchedOutline outline = matched_outline(slices, chord, flank_intervals, threads_);
    if (choice.surface != "ruled")
        return outline;
    MatchedOutline const ends = outline;
    outline.points.assign(z_.size(), ends.points.front());
    outline.normals.assign(z_.size(), ends.normals.front());
    outline.points.back() = ends.points.back();
    outline.normals.back() = ends.normals.back();
    for (std::size_t k = 1; k + 1 < z_.size(); ++k)
    {
        double const share = (z_[k] - z_.front()) / (z_.back() - z_.front());
        for (std::size_t i = 0; i < ends.points.front().size(); ++i)
        {
            outline.points[k][i] = (1 - share) * ends.points.front()[i] + share * ends.points.back()[i];
            outline.normals[k][i] = ((1 - share) * ends.normals.front()[i] + share * ends.normals.back()[i]).normalized();
        }
    }
    return outline;
}

}  // namespace hdconj::detail
