// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `wedm`: from a scene to the moves of a wire, in the two face planes of the workpiece.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/base/vec2.hpp"
#include "hdconj/error.hpp"
#include "hdconj/plan.hpp"
#include "hdconj/solution.hpp"

namespace hdconj {

/// How the machine holds the wire. Lengths in mm.
struct WireMachine
{
    double thickness = 0;    ///< T: lower face z = 0, upper face z = T
    double lower_guide = 0;  ///< h_l: lower guide point below the lower face
    double upper_guide = 0;  ///< h_u: upper guide point above the upper face
    /// H, distance of the guide points.
    [[nodiscard]] double guide_distance() const { return lower_guide + thickness + upper_guide; }
};

/// A closed contour in both faces, point k of one paired with point k of the other: between them the surface is a
/// straight line.
struct PairedContour
{
    std::vector<Vec2> lower;        ///< (n) z = 0 [mm]; first point not repeated
    std::vector<Vec2> upper;        ///< (n) z = T
    std::vector<std::size_t> sync;  ///< marks for CAM: land corners and flank ends of every tooth space, increasing
};

/// What a move is for.
enum class WireTag
{
    thread,   ///< at the start hole, wire vertical
    lead_in,  ///< straight from the start hole to the contour
    contour,
    stop,     ///< contour, reached just before the slug drops: the machine may stop here
    overlap,  ///< beyond the point where the contour closes
    lead_out
};

/// End of one straight move, wire centre in both faces.
struct WireMove
{
    Vec2 lower = Vec2::Zero();       ///< face z = 0 [mm]
    Vec2 upper = Vec2::Zero();       ///< face z = T [mm]
    WireTag tag = WireTag::contour;  ///< what the move is for
    int tooth = -1;                  ///< tooth space 0 ... z_c - 1; -1 where none
};

/// One pass around the contour.
struct WirePass
{
    int number = 1;               ///< 1 for the first pass
    double offset = 0;            ///< wire centre to nominal contour, square to the wire: wire radius + spark gap +
                                  ///< stock [mm]
    double stock = 0;             ///< left for later passes [mm]
    bool reversed = false;        ///< runs against the first pass: void on the right
    std::vector<WireMove> moves;  ///< the first one is the start hole, or a place in the open beside an external part
};

/// Material that a pass cannot reach.
struct Residual
{
    int pass = 1;               ///< number of the pass
    int tooth = 0;              ///< tooth space
    Vec2 where = Vec2::Zero();  ///< nominal point, lower or upper face [mm]
    bool upper = false;         ///< whether the point is of the upper face
    double height = 0;          ///< distance of the nominal point from the cut, less the stock [mm]
    bool meshing = false;       ///< in a zone that meshes (a flank), not in the root
};

/// Smallest and largest distance of a contour's points from the axis [mm]: tip and root of a toothed ring, root and tip
/// of a gear.
struct FaceRadii
{
    double inner = 0;  ///< smallest distance [mm]
    double outer = 0;  ///< largest distance [mm]
};

/// A pass in numbers.
struct PassFigures
{
    std::size_t blocks = 0;     ///< moves after the start hole
    double length = 0;          ///< of the path in the lower face [mm]
    double shortest = 0;        ///< block, in either face [mm]
    double residual = 0;        ///< highest material left; 0: no more than its error [mm]
    double residual_error = 0;  ///< of that [mm]
    std::size_t residuals = 0;  ///< places
};

/// The face whose contour is wider.
enum class LargerFace
{
    lower,   ///< z = 0
    upper,   ///< z = T
    neither  ///< both are the same
};

/// What a shop wants to know before it cuts. Lengths in mm, angles in rad. The first block is what measured() finds in
/// the program; the second what the checks found when it was made, 0 in a program that was not.
struct WireFigures
{
    FaceRadii lower;         ///< of the face z = 0
    FaceRadii upper;         ///< of the face z = T
    double face_shift = 0;   ///< largest distance of matched points of the nominal faces: T tan(tilt) of a radial tilt
    double least_shift = 0;  ///< smallest
    double guide_shift = 0;  ///< largest distance of the guides of any move, seen along the axis: H tan(tilt)
    double tilt = 0;         ///< largest angle of the wire from the axis in any move [rad]
    double ellipse = 0;    ///< r (1/cos tilt - 1), r with the spark gap: a wire that leans cuts an ellipse in the plane
                           ///< of a face, this much longer along its lean; the passes allow for it
    double travel = 0;     ///< largest |x| or |y| of a guide from the start hole
    double uv_travel = 0;  ///< largest |x| or |y| of the upper guide from the lower one
    std::vector<PassFigures> passes;  ///< each pass in numbers
    double residual = 0;              ///< highest material that the last pass leaves
    double meshing_residual = 0;      ///< the same on flanks only

    double face_error = 0;    ///< largest distance of the cut from the nominal faces, residuals apart, all passes
    double guide_chord = 0;   ///< chord error at the guides; in the faces it is part of face_error
    double middle_error = 0;  ///< of the cut from the true sections between the faces, residuals apart, all passes;
                              ///< NaN: not checked, the outline has no slice between its ends
    double ruling_error = 0;  ///< of straight lines between the faces from the true sections: that of the surface
                              ///< itself; NaN as well
    double normal_angle = 0;  ///< largest angle between matched edges of the faces [rad]
    double constant_taper_error = 0;   ///< what a machine's constant taper (G51) would be wrong by on the walls of the
                                       ///< upper face; NaN: not determined, such a taper cuts the flanks away
    double constant_taper_spread = 0;  ///< estimated error of that, from how it differs between neighbouring points;
                                       ///< that of the contours comes on top, twice

    /// By the radii of both.
    [[nodiscard]] LargerFace larger_face() const
    {
        double const change = upper.inner + upper.outer - lower.inner - lower.outer;
        bool const same = upper.inner == lower.inner && upper.outer == lower.outer;
        return same ? LargerFace::neither : change < 0 ? LargerFace::lower : LargerFace::upper;
    }
};

/// Which part of the work one clamping does.
struct WireSetUp
{
    int number = 1;       ///< 1 ... of
    int of = 1;           ///< more than 1: no path closes
    int first = 0;        ///< space that is cut first, and
    int spaces = 0;       ///< how many from there on, clockwise; only where there are several set-ups
    bool turned = false;  ///< the part is turned by half a turn on its mandrel: coordinates are the machine's, numbers
                          ///< of spaces the part's
};

/// All passes of one part in one set-up.
struct WireProgram
{
    std::string name;                 ///< of the part, ASCII
    WireMachine machine;              ///< how the wire is held
    PairedContour nominal;            ///< contour of the part
    std::vector<WirePass> passes;     ///< in the order in which they are cut
    std::vector<Residual> residuals;  ///< places that a pass cannot reach
    double wire_diameter = 0;         ///< [mm]
    double spark_gap = 0;             ///< [mm]
    int decimals = 4;                 ///< of every rounded output
    double tolerance = 0;             ///< of the surface that is cut [mm]
    double contour_error = 0;   ///< of the points of the nominal contours against the true ones: what they were solved
                                ///< to, and what a side clearance "auto" was found to; lines between points are up to
                                ///< `tolerance` further off [mm]
    double residual_error = 0;  ///< of the heights of residuals; where there are none, no more than this is left [mm]
    double cup_error = 0;  ///< of the displacement of the sections that an elastic cup bends, an estimate in none of
                           ///< the others; 0: none [mm]
    WireStop stop = WireStop::always;     ///< word of the moves with the tag `stop`
    double start_hole_radius = 0;         ///< [mm]
    int teeth = 0;                        ///< tooth spaces around
    bool external = false;                ///< teeth outside; the void is left of contour and passes, so that they go
                                          ///< counter-clockwise inside and clockwise outside
    WireSetUp set_up;                     ///< this clamping
    std::optional<ToothSurface> surface;  ///< nothing where both faces are the same
    std::optional<TiltKind> tilt_kind;    ///< nothing where the teeth are not tilted
    WireFigures figures;                  ///< what a shop wants to know
    Notes judgement;                      ///< of the design, as far as it is known
    std::vector<std::string> notes;       ///< what the contour has in place of the scene's numbers, as solve tells it
    std::vector<std::string> warnings;    ///< no failures, but a shop should read them
    std::vector<std::string> left_out;    ///< dialects that nobody named and that cannot hold the program, and why

    /// Whether the wire goes all around in this set-up.
    [[nodiscard]] bool closed() const { return set_up.of == 1; }
    /// Tooth spaces that it cuts.
    [[nodiscard]] int spaces() const { return closed() ? teeth : set_up.spaces; }
};

/// The clampings of one part, in order; one for a part that is cut all around.
using WireSetUps = std::vector<WireProgram>;

/// The figures of @p program, its first block measured anew.
[[nodiscard]] WireFigures measured(WireProgram const& program);

/// Whether both faces are the same, contour and wire, bit for bit.
[[nodiscard]] bool is_untilted(WireProgram const& program);

/// The same program for a part that is turned by half a turn.
[[nodiscard]] WireProgram turned_half(WireProgram program);

/// Faults between [wedm] and the drive, and a missing [wedm]. Such faults are a wire wider than a pitch, a workpiece
/// thinner than the toothing, a tilt that the machine cannot make. Reading a scene leaves them out, so that other verbs
/// do not refuse a drive for its wire.
[[nodiscard]] Faults check_wedm(Scene const& scene);

/// The scene whose solution has the toothing that is cut. Where its ends differ it has slices over the face width b, a
/// middle one among them; for "per-slice" as many as @p scene, at least 3. Without a face width that is the workpiece's
/// thickness T.
[[nodiscard]] Scene wire_scene(Scene const& scene);

/// Solves wire_scene(scene) and makes the program of all passes, checked (checks.hpp).
///
/// The lower face z = 0 of the workpiece is at -T/2 of the drive, the upper one at +T/2. Where T is the face width b
/// the faces are the first and the last slice; those of a thicker workpiece go on along the straight rulings that join
/// these, so that the toothing is the same. Each pass is
/// the parallel of both faces in their planes at wire_diameter/2 + spark_gap + stock, measured square to the wire, so
/// that the ellipse which a leaning wire cuts in a face touches the contour; thinned to `tolerance`. All spaces are
/// turned copies of one; every pass begins on a tip land.
/// @throws InputError     faults of the scene, or more residual material than residual_limit
/// @throws NumericalError the drive cannot be solved, or a check failed: all failures in one message
[[nodiscard]] WireProgram wire_program(Scene const& scene, StageObserver const& on_stage = {});

/// The same with the circular spline of @p solution, its slices from -b/2 to +b/2. Errors, notes and judgement are
/// those of @p solution too; what they say of the wire is judged anew for that of @p scene.
/// @param scene     with [wedm]; its drive is that of @p solution
/// @param solution  as StoredOutline has it
/// @throws InputError also where the slices are not those of the face width
[[nodiscard]] WireProgram wire_program(Scene const& scene, Solution const& solution);

/// What a ring that was solved before has in place of the one that is cut, in words: side clearance, tip circle, tilt,
/// bent cup, and how far its ends are off the contour [um]. Lengths closer than the contour's error are the same. Where
/// the side clearance is known, also which keys of the scene give that ring. Empty where both are the same.
/// @param ring            the other one, its slices within the thickness of the workpiece
/// @param side_clearance  that @p ring includes [mm]; nothing: not known
/// @param cone            of the elastic cup that @p ring was made for; nothing: of none
/// @param scene           that @p cut was made of
/// @param cut             what the wire cuts
[[nodiscard]] std::string other_ring(CircularSplineOutline const& ring, std::optional<double> side_clearance,
                                     std::optional<Coning> const& cone, Scene const& scene, WireProgram const& cut);

/// What keeps the ring of @p scene from being clear of the teeth, with what to write: its teeth lean, or the cup cones
/// and one outline is cut for all sections, and there is no side clearance. Only `contact` finds how deep they enter.
/// Empty: nothing is known.
[[nodiscard]] std::string missing_side_clearance(Scene const& scene);

/// All set-ups of the part that [wedm] names: the circular spline has one.
///
/// A wire around the flexspline would cut what holds it. The flexspline is therefore cut in two set-ups of half the
/// teeth each, one more in the first where their number is odd. Between them the part is turned by half a turn on its
/// mandrel. Both begin and end in the middle of a tip land, outside the blank; the path goes on for `overlap` beyond
/// that. Checks and errors are those of wire_program, for each.
[[nodiscard]] WireSetUps wire_set_ups(Scene const& scene, StageObserver const& on_stage = {});

}  // namespace hdconj
