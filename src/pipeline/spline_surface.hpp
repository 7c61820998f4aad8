// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The circular spline's tooth surface over the face width, by any of the ways it can be made.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/conjugate/matched_outline.hpp"
#include "hdconj/pipeline/solution.hpp"
#include "slice_motion.hpp"

namespace hdconj::detail {

/// Narrowest part of the module by which a tip circle that has to be widened stays clear of pointed teeth and of the rim.
inline constexpr double least_land = 0.02;

/// Which surface.
struct SurfaceChoice
{
    std::string surface = "tilted";  ///< "tilted", "ruled" or "per-slice"
    std::string kind = "radial";     ///< of the tilt: "radial" or "draft"
    double tilt = 0;                 ///< [rad]
};

struct SliceJob;

/// Makes surfaces for the slices of one drive. What several surfaces need is solved once, and nothing before it is asked for.
class SurfaceMaker
{
  public:
    /// @param base  solved drive: its outline at z = 0
    /// @param z     places of the slices [mm], increasing
    SurfaceMaker(Solution const& base, Profile const& tooth, AnyWaveShape shape, std::vector<double> z, int threads);
    ~SurfaceMaker();
    SurfaceMaker(SurfaceMaker const&) = delete;
    SurfaceMaker& operator=(SurfaceMaker const&) = delete;

    [[nodiscard]] std::vector<double> const& z() const { return z_; }
    /// Motion of the teeth's sections by the plane of slice @p k: where coning.axial_shift is "mapped", of those parts of the wall that have moved into it.
    [[nodiscard]] SliceMotion const& motion(std::size_t k);
    /// Finds those of slices @p wanted, each once, or of the first @p count: whoever asks next has not to wait.
    void find_motions(std::vector<std::size_t> const& wanted);
    void find_motions(std::size_t count);

    /// The same for any other planes [mm].
    [[nodiscard]] std::vector<SliceMotion> motions_at(std::vector<double> const& planes);

    /// Whether motion() is that of the sections. Not so without an axial shift, in one plane, and where the sections have no series (section_displacements()):
    /// then it is that of the undeformed slice at the height of the plane.
    [[nodiscard]] bool follows_sections();

    /// What to say where the scene asks for the axial shift and follows_sections() is false; empty otherwise.
    [[nodiscard]] std::string note_on_sections();

    /// Motion of the wall's own slice at any height, wherever it has moved to along the axis.
    [[nodiscard]] SliceMotion motion_at(double z) const;

    /// Tip circle of z = 0 [mm] that leaves every slice a tip land and clears every slice's rim, by no less than least_land; the
    /// drive's own where that does. With fewer slices than all where the surface is made from its end planes.
    [[nodiscard]] double needed_tip(SurfaceChoice const& choice);
    /// What each slice asks for, by itself; the drive's own where that is enough for it.
    [[nodiscard]] std::vector<double> needed_by_slices(SurfaceChoice const& choice);

    /// Least tip circle [mm], before any tilt, that the flanks of slices with outlines of their own still meet when they are moved by @p distance into the material: by
    /// least_land outside of where the flexspline's roots come, moved as far, on the tooth's middle line, and outside of where their ends do, beside it. 0 for one outline for all slices, whose tip circle is the scene's affair.
    [[nodiscard]] double solvable_tip(SurfaceChoice const& choice, double distance);

    /// Tip circle of z = 0 [mm] that the surface is made with where nothing is asked to clear: the drive's own, widened only as far as the surface cannot be
    /// made without. One outline for all slices keeps it, however it is tilted, so that tilts of either kind begin at the same part; a draft widens it
    /// where the drafted flanks meet. Slices with outlines of their own need what needed_tip() says.
    [[nodiscard]] double own_tip(SurfaceChoice const& choice);

    /// Matched outlines of all slices, root clearance included (design 3.4).
    /// @param tip              radius of the tip circle at z = 0 [mm]
    /// @param flank_intervals  see matched_outline()
    [[nodiscard]] MatchedOutline operator()(SurfaceChoice const& choice, double tip, double chord, int flank_intervals);

    /// The same drive with twice as many intervals between its slices; kept.
    [[nodiscard]] SurfaceMaker& refined();

    /// Which slice asked for the widened tip circle and why, in words; empty where the drive's own is left.
    [[nodiscard]] std::string const& why_widened() const { return why_; }

  private:
    using Curves = std::vector<std::unique_ptr<SpaceCurve>>;
    /// Least tip circles of z = 0 that leave the slice a land, clear the rim there and leave a land between drafted flanks [mm].
    struct SliceNeed
    {
        double land = 0, rim = 0, draft = 0;
    };

    [[nodiscard]] double factor(double z) const;
    [[nodiscard]] double meeting_tip(double z, double tilt);
    [[nodiscard]] std::vector<SliceNeed> slice_needs(SurfaceChoice const& choice);
    void prepare(std::vector<std::size_t> const& wanted, bool middle_too = false);
    void prepare_middle();
    [[nodiscard]] SpaceCurve const& middle(double tip);
    [[nodiscard]] Curves solved(std::vector<std::size_t> const& wanted, double tip);
    [[nodiscard]] std::vector<std::size_t> own_slices(SurfaceChoice const& choice) const;
    void check_reach(SurfaceChoice const& choice, bool follows, double tip);
    [[nodiscard]] MatchedOutline tilted(SurfaceChoice const& choice, double tip, double chord, int flank_intervals);
    [[nodiscard]] MatchedOutline own(Curves const& curves, SurfaceChoice const& choice, double chord, int flank_intervals) const;
    [[nodiscard]] bool coned() const { return base_->scene.coning.has_value() && z_.size() > 1; }

    Solution const* base_;
    Profile const* tooth_;
    AnyWaveShape shape_;
    std::vector<double> z_;
    int threads_;
    Tolerance tolerance_;
    std::optional<std::vector<MaterialDisplacement>> sections_;
    bool sections_asked_ = false;
    std::vector<std::optional<SliceMotion>> motions_;
    std::vector<std::unique_ptr<SliceJob>> jobs_;
    std::vector<std::optional<double>> pointed_;
    std::unique_ptr<SliceJob> middle_job_;
    std::unique_ptr<SpaceCurve> middle_;
    std::optional<MatchedOutline> base_flank_;
    std::unique_ptr<SurfaceMaker> refined_;
    std::string why_;
};

}  // namespace hdconj::detail
