// SPDX-License-Identifier: GPL-3.0-or-later
// The circular spline's tooth surface over the face width, by any of the ways it can be made.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "conjugate/matched_outline.hpp"
#include "drive/stage_clock.hpp"
#include "hdconj/solution.hpp"
#include "slice_motion.hpp"

namespace hdconj::surface {

/// Narrowest part of the module by which a tip circle that has to be widened stays clear of pointed teeth and of the
/// rim.
inline constexpr double least_land = 0.02;

/// Which surface.
struct SurfaceSpec
{
    ToothSurface surface = ToothSurface::tilted;
    TiltKind kind = TiltKind::radial;
    double tilt = 0;  ///< [rad]

    [[nodiscard]] bool is_drafted() const { return kind == TiltKind::draft && tilt != 0; }
    [[nodiscard]] bool is_tilted_radially() const { return kind == TiltKind::radial && tilt != 0; }
};

/// A tip circle of z = 0, and why it is wider than the drive's own.
struct TipCircle
{
    double radius = 0;  ///< [mm]
    std::string why;    ///< which slice asks for it and why, in words; empty for the drive's own
};

/// How finely a surface is sampled.
struct SurfaceSampling
{
    double chord = 0;                 ///< largest chord error [mm]
    int flank_intervals = 0;          ///< see matched_outline()
    bool keeps_chord_tilted = false;  ///< the chord error bounds the tilted outline; otherwise the upright one
};

/// A surface with the tip circle of nominal_tip(), and what a user should know of it.
struct NominalSurface
{
    conjugate::MatchedOutline outline;
    TipCircle tip;
    std::string note;  ///< see note_on_sections()
};

struct SliceJob;

/// Makes surfaces for the slices of one drive. It solves once what several surfaces need, and nothing before a surface
/// needs it: no answer depends on what was asked before.
class ToothSurfaceBuilder
{
  public:
    /// @param base  solved drive: its outline at z = 0
    /// @param z     places of the slices [mm], increasing
    ToothSurfaceBuilder(Solution const& base, profile::Profile const& tooth, wavegen::AnyWaveShape shape,
                        std::vector<double> z, int threads);
    /// The same drive with another side clearance or tip circle, as @p base has them: what does not depend on these is
    /// taken from @p other, which has to stay.
    ToothSurfaceBuilder(Solution const& base, ToothSurfaceBuilder& other);
    ~ToothSurfaceBuilder();
    ToothSurfaceBuilder(ToothSurfaceBuilder const&) = delete;
    ToothSurfaceBuilder& operator=(ToothSurfaceBuilder const&) = delete;

    [[nodiscard]] std::vector<double> const& z() const { return z_; }
    /// Motion of the teeth's sections by the plane of slice @p k: where coning.axial_shift is "mapped", of those parts
    /// of the wall that have moved into it.
    [[nodiscard]] SliceMotion const& motion(std::size_t k);
    /// Finds those of slices @p wanted, each once, or of the first @p count: whoever asks next has not to wait.
    void find_motions(std::vector<std::size_t> const& wanted);
    void find_motions(std::size_t count);

    /// The same for any other planes [mm].
    [[nodiscard]] std::vector<SliceMotion> motions_at(std::vector<double> const& planes);

    /// Whether motion() is that of the sections. Not so without an axial shift, in one plane, and where the sections
    /// have no series (section_displacements()): then it is that of the undeformed slice at the height of the plane.
    [[nodiscard]] bool follows_sections();

    /// What to say where the scene asks for the axial shift and follows_sections() is false; empty otherwise.
    [[nodiscard]] std::string note_on_sections();

    /// Motion of the wall's own slice at any height, wherever it has moved to along the axis.
    [[nodiscard]] SliceMotion motion_at(double z) const;

    /// Tip circle of z = 0 that leaves every slice a tip land and clears every slice's rim, by no less than least_land;
    /// the drive's own where that suffices.
    [[nodiscard]] TipCircle needed_tip(SurfaceSpec const& spec);
    /// Tip circle that each slice needs by itself; the drive's own where that suffices [mm].
    [[nodiscard]] std::vector<double> needed_by_slices(SurfaceSpec const& spec);

    /// Least tip circle [mm], before any tilt, that the flanks of slices with outlines of their own still meet when
    /// they are moved by @p distance into the material: by least_land outside of where the flexspline's roots come,
    /// moved as far, on the tooth's middle line, and outside of where their ends do, beside it. 0 for one outline for
    /// all slices, whose tip circle is the scene's affair.
    [[nodiscard]] double solvable_tip(SurfaceSpec const& spec, double distance);

    /// needed_tip() with a side clearance of @p distance [mm], where slices have outlines of their own: what `solve`
    /// takes for a scene that gives this side clearance. 0 for one outline for all slices.
    [[nodiscard]] double needed_tip_of_moved(SurfaceSpec const& spec, double distance);
    /// The radius at which the teeth of the outline at z = 0 would be pointed with a side clearance of @p distance
    /// [mm].
    [[nodiscard]] double pointed_radius_of_moved(double distance);

    /// Tip circle of z = 0 with which the surface is made where nothing has to clear: the drive's own, widened only as
    /// far as the surface cannot exist without. One outline for all slices keeps it, however it is tilted, so that
    /// tilts of either kind begin at the same part; a draft widens it where the drafted flanks meet. Slices with
    /// outlines of their own take needed_tip().
    [[nodiscard]] TipCircle nominal_tip(SurfaceSpec const& spec);

    /// Matched outlines of all slices, tilt and root clearance included (design 3.4).
    /// @param tip    radius of the tip circle at z = 0 [mm]
    /// @param clock  runs the stages surface and, for a radial tilt, tilt; null: they are not timed
    /// @throws NumericalError with stage, place and cause where the surface cannot be made
    [[nodiscard]] conjugate::MatchedOutline outline(SurfaceSpec const& spec, double tip,
                                                    SurfaceSampling const& sampling,
                                                    drive::StageClock* clock = nullptr);

    /// The surface with its nominal tip circle.
    [[nodiscard]] NominalSurface nominal_surface(SurfaceSpec const& spec, SurfaceSampling const& sampling,
                                                 drive::StageClock& clock);

    /// The same drive with twice as many intervals between its slices; kept.
    [[nodiscard]] ToothSurfaceBuilder& refined();

  private:
    using Curves = std::vector<std::shared_ptr<conjugate::ToothSpaceBoundary const>>;
    /// Least tip circles of z = 0 that leave the slice a land, clear the rim there and leave a land between drafted
    /// flanks [mm].
    struct SliceNeed
    {
        double land = 0, rim = 0, draft = 0;
    };

    /// Whether slice @p k is slice k/2 of the builder that this one refines, which then makes it.
    [[nodiscard]] bool shares(std::size_t k);
    [[nodiscard]] double factor(double z) const;
    [[nodiscard]] double meeting_tip(double z, double tilt);
    [[nodiscard]] std::vector<SliceNeed> slice_needs(SurfaceSpec const& spec);
    void prepare(std::vector<std::size_t> const& wanted, bool middle_too = false);
    void prepare_middle();
    [[nodiscard]] ToothSurfaceBuilder& with_side_clearance(double distance);
    [[nodiscard]] conjugate::ToothSpaceBoundary const& middle(double tip);
    /// The same with what lies beyond the tip circle, down to a @p smaller one or as far as flanks and land reach: a
    /// boundary that moves out of the material is cut where it was not before.
    [[nodiscard]] std::shared_ptr<conjugate::ToothSpaceBoundary const> middle_beyond(double tip, double smaller);
    [[nodiscard]] Curves solved(std::vector<std::size_t> const& wanted, double tip);
    [[nodiscard]] std::vector<std::size_t> own_slices(SurfaceSpec const& spec) const;
    void check_reach(SurfaceSpec const& spec, double tip);
    [[nodiscard]] conjugate::MatchedOutline one_outline(SurfaceSpec const& spec, double tip, double chord,
                                                        int flank_intervals);
    [[nodiscard]] conjugate::MatchedOutline outline_by_slices(Curves const& curves, SurfaceSpec const& spec,
                                                              double chord, int flank_intervals) const;
    /// What @p match finds. @throws NumericalError that tells the cause where a slice has no flank
    [[nodiscard]] conjugate::MatchedOutline with_flanks(std::function<conjugate::MatchedOutline()> const& match) const;
    [[nodiscard]] bool coned() const { return base_->scene.coning.has_value() && z_.size() > 1; }
    /// Whether slices have conjugate outlines of their own.
    [[nodiscard]] bool follows_cone(SurfaceSpec const& spec) const
    {
        return coned() && spec.surface != ToothSurface::tilted;
    }

    Solution const* base_;
    profile::Profile const* tooth_;
    wavegen::AnyWaveShape shape_;
    std::vector<double> z_;
    int threads_;
    Tolerance tolerance_;
    std::optional<std::vector<wavegen::MaterialDisplacement>> sections_;
    bool sections_asked_ = false;
    std::vector<std::optional<SliceMotion>> motions_;
    std::vector<std::shared_ptr<SliceJob>> jobs_;
    std::unique_ptr<SliceJob> middle_job_;
    std::optional<conjugate::MatchedOutline> base_flank_;
    ToothSurfaceBuilder* coarse_ = nullptr;                 // whose refined() this is
    ToothSurfaceBuilder const* other_clearance_ = nullptr;  // of the same drive
    std::unique_ptr<ToothSurfaceBuilder> refined_;
    Solution moved_base_;  // without outlines, of moved_
    std::unique_ptr<ToothSurfaceBuilder> moved_;
};

}  // namespace hdconj::surface
