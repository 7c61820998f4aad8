// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `contact`: how much flank touches, and what the circular spline's surface and tilt do to it.
/// All lengths in mm, all angles in rad.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/error.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/units.hpp"

namespace hdconj {

/// Gaps of all flanks of the circular spline at one position, plain data.
///
/// A gap is the signed distance from a point of a circular-spline flank to the nearest flexspline tooth, in the plane
/// of the slice. It is negative where the point is inside the tooth.
struct GapMap
{
    /// Side of a tooth space, second index of the map.
    enum Flank : int
    {
        left = 0,  ///< x < 0 in the frame of the tooth space
        right = 1  ///< x > 0: the flank that the flexspline touches when it is turned clockwise
    };

    std::vector<double> z;        ///< (k) slices [mm]
    std::vector<double> station;  ///< (p) fraction of the flank's arc length, 0 at the land corner
    std::vector<double> angle;    ///< (s) centre line of the tooth space, clockwise from the major axis [rad], within
                                  ///< half a pitch of -pi ... pi, increasing
    std::vector<double> gap;      ///< (s,2,k,p) [mm]

    /// Place of a point in `gap`.
    [[nodiscard]] std::size_t index(std::size_t space, int flank, std::size_t slice, std::size_t point) const
    {
        return ((space * 2 + static_cast<std::size_t>(flank)) * z.size() + slice) * station.size() + point;
    }
    /// The gap at a point [mm].
    [[nodiscard]] double at(std::size_t space, int flank, std::size_t slice, std::size_t point) const
    {
        return gap[index(space, flank, slice, point)];
    }
};

/// Where the teeth come closest, or enter deepest, over a full turn of the wave generator.
struct Closest
{
    double clearance = 0;       ///< negative: the tooth enters by this much [mm]
    Vec2 where = Vec2::Zero();  ///< on the circular spline, frame of the tooth space [mm]
    double phi = 0;             ///< undeformed angle of the tooth [rad]
};

/// One slice over a full turn, the flexspline's section at the same place against it (design 3.4).
struct SliceClearance
{
    double z = 0;            ///< [mm]
    double amplitude = 0;    ///< radial deformation w0(z) of this slice [mm]
    Closest flank;           ///< between land corner and flank end, both sides
    Closest root;            ///< around the bottom of the space, with the scene's side clearance
    double flank_error = 0;  ///< estimated, of this slice's smallest distance for itself, as `root_error` [mm]
    double root_error = 0;   ///< the same of the smallest distance at the root [mm]
};

/// Contact at one angle of the wave generator. The circular spline is turned to first contact, while wave generator and
/// flexspline are held. If the cup is turned in place of the circular spline, the angle is z_c/z_f times as large
/// (docs/explanation/theory.md).
struct ContactState
{
    double wave_generator =
        0;  ///< angle of the wave generator from a tooth space, in the frame of the circular spline [rad]
    double turn_to_contact = 0;          ///< turn of the circular spline to first contact, counter-clockwise: teeth go
                                         ///< clockwise in its spaces [rad]; negative: it had to be turned back
    double reverse_turn_to_contact = 0;  ///< the same for the other flanks, clockwise [rad]
    double turn_to_contact_error = 0;    ///< estimated: what may enter between slices, and of a side clearance that was
                                         ///< looked for its own error [rad]
    double reverse_turn_to_contact_error = 0;  ///< the same of reverse_turn_to_contact [rad]
    double contact_area = 0;                   ///< [mm^2] of the flanks on the driving side with gap <= contact_gap
    double contact_area_error = 0;  ///< estimated: what half as many points, fewer planes and the clearance's own error
                                    ///< change, and patches that no plane meets, added up [mm^2]
    double contact_fraction = 0;    ///< of the area of all flanks on that side, 0 ... 1
    double contact_fraction_error = 0;  ///< estimated: from those of both areas
    double fraction_error_along = 0;    ///< the part of it that the number of points along the flanks leaves open
    double flank_area =
        0;  ///< [mm^2] of all flanks on the driving side, of the part: from its tip circle on, side clearance included
    double flank_area_error =
        0;          ///< estimated: what fewer planes change, chords in place of arcs, and where the flanks end [mm^2]
    int teeth = 0;  ///< tooth spaces with any contact on the driving side
    int teeth_least = 0;            ///< tooth spaces that are in contact whatever the errors
    int teeth_most = 0;             ///< tooth spaces that may be in contact within the errors
    double smallest_gap = 0;        ///< before turning, either side [mm]
    double smallest_gap_error = 0;  ///< estimated, as for turn_to_contact_error [mm]
    int smallest_space = 0;         ///< tooth space where it is
    double smallest_z = 0;          ///< and slice [mm]
    /// Where it may lie as well: from the first to the last plane with a gap as small within its error, and on to the
    /// planes beside them [mm].
    double smallest_z_from = 0;
    double smallest_z_to = 0;  ///< upper end of that interval [mm]
    int smallest_spaces = 0;   ///< tooth spaces with such a gap
    /// Backlash, the angle in which the circular spline can be turned; negative: teeth press on both flanks.
    [[nodiscard]] double backlash() const { return turn_to_contact + reverse_turn_to_contact; }
    /// Estimated error of the backlash: the sum of both errors.
    [[nodiscard]] double backlash_error() const { return turn_to_contact_error + reverse_turn_to_contact_error; }
};

/// The smallest gap of each flank in each slice: a GapMap without the places along the flank.
struct SmallestGaps
{
    std::vector<double> angle;  ///< (s) as GapMap::angle
    std::vector<double> gap;    ///< (s,2,k) [mm]
};

/// One surface of the circular spline: a row of the table.
struct ContactCase
{
    ToothSurface surface = ToothSurface::tilted;  ///< kind of the surface
    std::optional<TiltKind> kind;                 ///< nothing where there is no tilt
    double tilt = 0;                              ///< [rad]
    double backlash_offset = 0;                   ///< side clearance that the contact is computed with [mm]
    bool side_clearance_increased = false;  ///< it is more than the scene gives, because with that the teeth enter the
                                            ///< flanks; never where the scene says "auto"
    double tip = 0;  ///< and tip circle at z = 0: where nothing enters the flanks then the scene's, as much wider as
                     ///< every slice's land and rim ask for; else least_tip_radius [mm]
    std::vector<SliceClearance> slices;  ///< with the side clearance of the scene; "auto": with none
    double least_side_clearance = 0;     ///< least side clearance that leaves no interference on the flanks over a full
                                         ///< turn, with least_tip_radius [mm]
    double least_tip_radius = 0;  ///< tip circle at z = 0 that goes with it: every slice has a tip land and clears the
                                  ///< rim, and the flanks left by the scene's begin on it when they are moved [mm]
    double least_root_clearance = 0;  ///< least root clearance without interference, beside the scene's [mm]
    double backlash_of_least_side_clearance = 0;  ///< backlash of the least side clearance alone [rad]
    ContactState state;  ///< at the scene's angle of the wave generator; of a revolution the one with the smallest
                         ///< contact fraction
    std::vector<ContactState> revolution;  ///< one per angle asked for; empty without --revolution
    SmallestGaps gaps;                     ///< at `state`, after the turn to first contact
    double ruled_deviation = 0;            ///< "ruled": largest distance from the slices' own conjugate outlines [mm]
    /// Estimated errors, of the slices as those of the whole width (docs/explanation/theory.md).
    double clearance_error = 0;                         ///< of closest_flank() [mm]
    double root_clearance_error = 0;                    ///< of the smallest root clearance of all slices [mm]
    double least_side_clearance_error = 0;              ///< [mm]
    double least_tip_radius_error = 0;                  ///< [mm]
    double least_root_clearance_error = 0;              ///< [mm]
    double backlash_of_least_side_clearance_error = 0;  ///< [rad]
    double ruled_deviation_error = 0;                   ///< [mm]
    /// Where closest_flank() may lie as well: as ContactState::smallest_z_from [mm].
    double closest_z_from = 0;
    double closest_z_to = 0;  ///< upper end of that interval [mm]
    double seconds = 0;       ///< wall time [s]

    /// Deepest interference of any slice's flanks; clearance where there is none.
    [[nodiscard]] Closest const& closest_flank() const;
    /// The slice in which it is; there is at least one slice.
    [[nodiscard]] SliceClearance const& closest_slice() const;
};

/// What a search for the best tilt looks for.
enum class TiltGoal
{
    contact_area,         ///< the largest
    least_side_clearance  ///< the smallest
};

/// The tilt of largest contact area, or of smallest least side clearance.
struct BestTilt
{
    TiltGoal goal = TiltGoal::contact_area;  ///< what is best
    TiltKind kind = TiltKind::radial;        ///< of the tilt
    double tilt = 0;                         ///< [rad]
    double tolerance = 0;                    ///< of the tilt [rad]
    double value = 0;                        ///< contact fraction, or side clearance [mm]
    double value_error = 0;                  ///< estimated error of the value at that tilt
    bool on_bound = false;                   ///< the best lies at an end of the interval that was searched
    double from = 0;                         ///< lower end of that interval [rad]
    double to = 0;                           ///< upper end [rad]
    double possible_from = 0;                ///< least tilt tried there at which a surface can be made [rad]
    double possible_to = 0;                  ///< largest such tilt [rad]
    int refused = 0;                         ///< tilts tried there at which no surface can be made
    std::string refusal{};                   ///< why not the last of them; empty where none was refused
};

/// Result of study_contact().
struct ContactStudy
{
    Solution solution;  ///< of the scene, its circular spline with the surface and slices of cases[written_case]
    std::vector<ContactCase> cases;    ///< in the order asked for, without those that are missing
    std::vector<std::string> missing;  ///< cases that could not be made, each with the reason; also in solution.notes
    std::vector<BestTilt> best;        ///< with --best
    std::size_t written_case = 0;      ///< case that map and solution are of
    bool estimated = true;    ///< false: errors were not asked for. All of them are 0 then and mean nothing, as
                              ///< do the intervals and tooth spaces that follow from them
    GapMap map;               ///< of that case at its state, after the turn to first contact
    double contact_gap = 0;   ///< [mm]
    double pitch_radius = 0;  ///< m z_f/2, at which backlash is given as a length [mm]
};

inline SliceClearance const& ContactCase::closest_slice() const
{
    std::size_t worst = 0;
    for (std::size_t k = 1; k < slices.size(); ++k)
        if (slices[k].flank.clearance < slices[worst].flank.clearance)
            worst = k;
    return slices[worst];
}

inline Closest const& ContactCase::closest_flank() const
{
    return closest_slice().flank;
}

/// What is asked beside the scene. Empty lists: as the scene says.
struct ContactOptions
{
    std::vector<double> tilts;           ///< [rad]
    std::vector<ToothSurface> surfaces;  ///< ways to make the tooth surface
    std::vector<TiltKind> kinds;         ///< kinds of tilt
    bool best = false;                   ///< look for the best tilt of each kind
    double best_from = 0;                ///< interval of tilts that is searched [rad]
    double best_to = from_deg(2);        ///< [rad]
    int revolution = 0;                  ///< angles of the wave generator over a revolution; 0: the scene's only
    bool errors = true;                  ///< false: the same figures to the last bit, without estimated errors
};

/// Told how much of the long work is done, 0 ... 1.
using Progress = std::function<void(std::string const& what, double share)>;

/// Slices that effects along the axis are looked at with where the scene has no [slices].
inline constexpr int standard_slices = 17;

/// What is wrong with the options by themselves.
[[nodiscard]] Faults check_options(ContactOptions const& options);

/// The options, and scene and options against each other.
[[nodiscard]] Faults check_contact(Scene const& scene, ContactOptions const& options);

/// Clearances, least side clearances, backlash and contact areas of every combination of surface, kind and tilt.
///
/// Gaps are distances in the planes of the slices, from exact points of the circular spline to exact teeth. With
/// [coning] and axial_shift = "mapped" the teeth in a plane are those parts of the cup that have moved into it. This
/// holds for gaps and for full turns; ToothSurfaceBuilder::follows_sections() names the exceptions. Every number of
/// threads gives the same bits. A case that cannot be made leaves the others as they are and is named in
/// ContactStudy::missing.
/// @throws InputError for a scene or options that cannot be computed; NumericalError with stage, place and cause where
/// no case can be made
[[nodiscard]] ContactStudy study_contact(Scene const& scene, ContactOptions const& options = {},
                                         StageObserver const& on_stage = {}, Progress const& progress = {});

/// Poses of the flexspline's teeth on the wave generator, without load, in the planes @p z. Frame of the drive: the
/// major axis is y, angles run clockwise; a pose turns the frame of a tooth, whose origin is on the neutral curve and
/// whose y is normal to it, into that frame. The circular spline that meshes there has a tooth space on y.
///
/// Tooth i stands at the undeformed angle 2 pi (i + @p pitches)/z_f. With a fraction of a pitch this is a place between
/// two teeth, whose frame says where the neutral curve is there. Models of the motion as for study_contact(). Accuracy:
/// that of the neutral curve.
/// @param scene    of a sound drive
/// @param z        increasing, even and symmetric about 0, as slices are [mm]
/// @param pitches  -1/2 ... 1/2
/// @return tooth by tooth from 0 on, plane by plane: (z_f, planes)
/// @throws InputError, NumericalError as study_contact()
[[nodiscard]] std::vector<Pose> flexspline_poses(Scene const& scene, std::vector<double> const& z, double pitches);

}  // namespace hdconj
