// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `solve` computes: plain data, all lengths in mm, all angles in rad.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/note.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/scene.hpp"

namespace hdconj {

/// Derived dimensions of the pair.
struct PairGeometry
{
    double r_m = 0;         ///< radius of the undeformed neutral curve
    double r_0 = 0;         ///< base radius of the deformed one, rho = r_0 + w(u): what w is counted from, by family in
                            ///< docs/reference/wave-generators.md; linear models: r_m
    double w0 = 0;          ///< largest radial deformation
    double pitch_line = 0;  ///< height of the tooth's pitch line above the neutral curve
    double addendum = 0;    ///< h_a
    double dedendum = 0;    ///< h_f
    double flexspline_inner_radius = 0;       ///< [mm], of the undeformed cup under the teeth
    double circular_spline_inner_radius = 0;  ///< [mm], tip circle
    double land_half_angle = 0;               ///< half the tip land of the circular spline [rad]
    double space_depth = 0;                   ///< radial depth of the tooth space from the tip circle
    double ratio = 0;                         ///< -z_f / (z_c - z_f), circular spline held
};

/// One sampled branch of the meshing condition (HDF5 /envelope/branch_###).
/// Points are in the frame of the outline that is solved for: the circular spline's; in the reverse problem that of the
/// flexspline tooth, y from the pitch line.
struct BranchRecord
{
    std::string kind;          ///< "regular" or "corner"
    int segment = 0;           ///< index into Solution::segment_names; for a corner the segment before it
    std::string segment_name;  ///< name of that segment
    std::string begins;        ///< "segment end", "double root", "cusp", "range end"
    std::string ends;          ///< where it ends, in the same words
    bool on_boundary = false;  ///< any part of it belongs to the circular spline
    std::vector<double> u;     ///< (n) polar angle on the neutral curve
    std::vector<double> phi;   ///< (n) undeformed angle of the tooth
    std::vector<double> t;     ///< (n) profile parameter, 0 ... 1 along the segment
    std::vector<Vec2> point;   ///< (n,2)
    int tooth = 0;  ///< reverse problem: number of the circular-spline tooth, 0 left of the flexspline's, 1 right
};

/// A conjugate zone: a piece of a branch on which t(u) is monotone and the envelope is outer or inner.
struct ConjugateZone
{
    int segment = 0;           ///< index into Solution::segment_names
    std::string segment_name;  ///< name of that segment
    std::string kind;          ///< "regular" or "corner"
    std::size_t branch = 0;    ///< index into Solution::branches
    double u_begin = 0;        ///< polar angle on the neutral curve where it begins [rad]
    double u_end = 0;          ///< and where it ends [rad]
    double phi_begin = 0;      ///< undeformed angle of the tooth where it begins [rad]
    double phi_end = 0;        ///< and where it ends [rad]
    double t_begin = 0;        ///< profile parameter where it begins, 0 ... 1 along the segment
    double t_end = 0;          ///< and where it ends
    double phi_error = 0;      ///< of phi_begin and phi_end, the larger, by rounding
    double t_error = 0;        ///< of t_begin and t_end likewise; 0 at the segment's ends
    bool outer = false;        ///< locally the given tooth touches from outside the solved member
    bool on_boundary = false;  ///< some of it bounds the member that is solved for
};

/// A piece of the final outline and where it comes from.
struct OutlinePiece
{
    std::string kind;          ///< "land", "flank", "corner", "bottom" (by the tip land), "root wall", "root"
    std::string segment_name;  ///< profile segment that made it; empty for land and root wall
    std::size_t first = 0;     ///< index of the first point
    std::size_t last = 0;      ///< index of the last point
};

/// The circular spline's toothed boundary, one pitch, all slices.
struct CircularSplineOutline
{
    std::vector<double> z;                   ///< (k)
    std::vector<std::vector<Vec2>> outline;  ///< (k,n,2), mid-land to mid-land, increasing x
    std::vector<int> landmarks;              ///< (l) indices: land corners, flank ends, middle of the space
    std::vector<OutlinePiece> pieces;        ///< of each slice
};

/// Where the flanks of a tooth touch: contacts that bound the member that is solved for, without those of corners and
/// tip lands.
struct FlankEngagement
{
    double angle = 0;  ///< polar angle over which one flank of a tooth touches, the lesser of both flanks [rad]
    double used = 0;   ///< the same of the flank that loses more by undercut, in proportion to what it keeps [rad]
    double lost = 0;   ///< polar angle over which that flank, in contacts that reach a cusp, is cut away [rad]
};

/// The finished pair over a full turn of the wave generator.
struct PairCheck
{
    double smallest_clearance = 0;  ///< min over outline points and positions; negative: interference
    Vec2 where = Vec2::Zero();      ///< frame of the outline that is solved for
    double at_phi = 0;              ///< tooth position where it happens
    std::size_t points = 0;         ///< outline points checked
    std::size_t positions = 0;      ///< tooth positions per point before refinement
};

/// Estimated errors of the written data.
struct ErrorEstimate
{
    double chord = 0;        ///< outline polygon against the true curve [mm]
    double point = 0;        ///< written points against the true curve [mm]
    double arc_length = 0;   ///< closed length of the neutral curve, relative
    double r_0 = 0;          ///< of PairGeometry::r_0 [mm]
    double space_depth = 0;  ///< of PairGeometry::space_depth [mm]
    double land = 0;         ///< of the land's length along the tip circle [mm]
    double clearance = 0;  ///< of PairCheck::smallest_clearance as the least of the points and positions evaluated [mm]
    double side_clearance =
        0;           ///< of the one that "auto" found: in `clearance` and `land`, in no other; 0: as given [mm]
    double cup = 0;  ///< of the sections' displacement, by the grid of cup and bearing: in none of the others; 0: no
                     ///< cup; NaN: not asked for [mm]
    /// The larger of the errors of chords and of points [mm].
    [[nodiscard]] double largest() const { return chord > point ? chord : point; }
};

/// A place where the number of roots of the meshing condition is not known: a branch that is not among the branches may
/// exist there.
struct UndecidedPlace
{
    std::string segment_name;  ///< of the profile
    double t = 0;              ///< profile parameter, 0 ... 1 along the segment
    double u = 0;              ///< [rad]
    double u_width = 0;        ///< of the interval about u that such a branch would live in [rad]
    double reach = 0;  ///< how far it could stand out of the known branches, along the normal [mm]; below the tolerance
    std::string what;  ///< what is not decided, in words
};

/// Whether all roots of the meshing condition are proved to be found.
struct RootCertificate
{
    std::vector<UndecidedPlace> undecided;  ///< empty: all roots are proved to be found
    /// Whether no place is undecided.
    [[nodiscard]] bool certified() const { return undecided.empty(); }
};

/// Wall time of a stage.
struct StageTime
{
    std::string stage;   ///< name of the stage
    double seconds = 0;  ///< wall time [s]
};

/// Work done, independent of the clock.
struct WorkCount
{
    std::size_t envelope_points = 0;    ///< contacts evaluated
    std::size_t roots_isolated = 0;     ///< roots found by isolation
    std::size_t arrangement_edges = 0;  ///< segments given to the planar arrangement
};

namespace elastic {
class BentCup;
}

/// Result of solve().
struct Solution
{
    Scene scene;                                  ///< that was solved
    Plan plan;                                    ///< that was run
    PairGeometry geometry;                        ///< derived dimensions
    std::shared_ptr<elastic::BentCup const> cup;  ///< the cup on its bearing; null without an elastic one
    std::vector<std::string> segment_names;       ///< of the given tooth, in order
    std::vector<Vec2> flexspline_outline;         ///< (n,2) one tooth in its own frame, y from the pitch line
    std::vector<OutlinePiece> flexspline_pieces;  ///< reverse problem: where it comes from; else empty
    std::vector<Vec2> neutral_curve;              ///< (n,2) fixed frame, closed, first point not repeated
    std::vector<BranchRecord> branches;           ///< of the meshing condition
    std::vector<ConjugateZone> zones;             ///< conjugate zones of these branches
    RootCertificate certificate;                  ///< whether all branches are found
    CircularSplineOutline circular_spline;        ///< in the reverse problem as given
    std::vector<std::vector<Vec2>> tooth_family;  ///< given teeth in the frame of the branches, one polyline per
                                                  ///< position; for pictures, may be empty
    FlankEngagement flank_contact;                ///< where flanks touch
    Notes judgement;                              ///< figures of the design outside their usual range, at z = 0
    std::optional<PairCheck> check;               ///< of the finished pair; absent where the plan has no such stage
    ErrorEstimate error;                          ///< estimated errors of the outline
    WorkCount work;                               ///< done
    std::vector<std::string> notes;  ///< what was changed so that the scene could be solved, in words; mostly empty
    int threads = 1;                 ///< that were used
    std::vector<StageTime> timing;   ///< in the order in which the stages ran
};

}  // namespace hdconj
