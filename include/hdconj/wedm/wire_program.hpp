// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a wire is to do, in the two face planes of the workpiece: the list that every post writes in its own dialect. Plain data.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hdconj/geometry/vec2.hpp"

namespace hdconj {

/// How the machine holds the wire. Lengths in mm.
struct WireMachine
{
    double thickness = 0;     ///< T: lower face z = 0, upper face z = T
    double lower_guide = 0;   ///< h_l: lower guide point below the lower face
    double upper_guide = 0;   ///< h_u: upper guide point above the upper face
    [[nodiscard]] double guide_distance() const { return lower_guide + thickness + upper_guide; }
};

/// A closed contour in both faces, point k of one paired with point k of the other: between them the surface is a straight line.
struct PairedContour
{
    std::vector<Vec2> lower;        ///< (n) z = 0 [mm]; first point not repeated
    std::vector<Vec2> upper;        ///< (n) z = T
    std::vector<std::size_t> sync;  ///< indices of the marks that CAM synchronises on: land corners and flank ends of every tooth space, increasing
};

/// What a move is for.
enum class WireTag
{
    thread,    ///< at the start hole, wire vertical
    lead_in,   ///< straight from the start hole to the contour
    contour,
    stop,      ///< contour, reached just before the slug drops: the machine may stop here
    overlap,   ///< beyond the point where the contour closes
    lead_out
};

/// End of one straight move, wire centre in both faces.
struct WireMove
{
    Vec2 lower = Vec2::Zero();
    Vec2 upper = Vec2::Zero();
    WireTag tag = WireTag::contour;
    int tooth = -1;  ///< tooth space 0 ... z_c - 1; -1 where none
};

/// One pass around the contour.
struct WirePass
{
    int number = 1;
    double offset = 0;        ///< wire centre to nominal contour: wire radius + spark gap + stock [mm]
    double stock = 0;         ///< left for later passes [mm]
    bool reversed = false;    ///< runs against the first pass: void on the right
    std::vector<WireMove> moves;  ///< the first one is the start hole, or a place in the open beside an external part
};

/// Material that a pass cannot reach.
struct Residual
{
    int pass = 1;
    int tooth = 0;
    Vec2 where = Vec2::Zero();  ///< nominal point, lower or upper face [mm]
    bool upper = false;
    double height = 0;          ///< distance of the nominal point from the cut, less the stock [mm]
    bool meshing = false;       ///< in a zone that meshes (a flank), not in the root
};

/// Smallest and largest distance of a contour's points from the axis [mm]: tip and root of a toothed ring, root and tip of a gear.
struct FaceRadii
{
    double inner = 0, outer = 0;
};

/// A pass in numbers.
struct PassFigures
{
    std::size_t blocks = 0;    ///< moves after the start hole
    double length = 0;         ///< of the path in the lower face [mm]
    double shortest = 0;       ///< block, in either face [mm]
    double residual = 0;       ///< highest material left [mm]
    std::size_t residuals = 0; ///< places
};

/// What a shop wants to know before it cuts. Lengths in mm, angles in rad. The first block is what measured() finds in the program; the second what the
/// checks found when it was made, 0 in a program that was not.
struct WireFigures
{
    FaceRadii lower, upper;
    double face_shift = 0;                 ///< largest distance of matched points of the nominal faces: T tan(tilt) of a radial tilt
    double least_shift = 0;                ///< smallest
    double guide_shift = 0;                ///< largest distance of the guides of any move, seen along the axis: H tan(tilt)
    double tilt = 0;                       ///< largest angle of the wire from the axis in any move [rad]
    double ellipse = 0;                    ///< r (1/cos tilt - 1): a wire that leans cuts an ellipse in the plane of a face, this much wider; neglected
    double travel = 0;                     ///< largest |x| or |y| of a guide from the start hole
    double uv_travel = 0;                  ///< largest |x| or |y| of the upper guide from the lower one
    std::vector<PassFigures> passes;
    double residual = 0;                   ///< highest material that the last pass leaves
    double meshing_residual = 0;           ///< the same on flanks only

    double face_error = 0;                 ///< largest distance of the cut from the nominal faces, residuals apart, all passes
    double guide_chord = 0;                ///< chord error at the guides; in the faces it is part of face_error
    double middle_error = 0;               ///< of the cut from the true sections between the faces, residuals apart, all passes
    double ruling_error = 0;               ///< of straight lines between the faces from the true sections: that of the surface itself
    double normal_angle = 0;               ///< largest angle between matched edges of the faces [rad]
    double constant_taper_error = 0;       ///< what a machine's constant taper (G51) would be wrong by on the flanks of the upper face
    double constant_taper_spread = 0;      ///< estimated error of that, from how it differs between neighbouring points; that of the contours comes on top, twice

    /// "lower", "upper" or "same": the face whose contour is wider.
    [[nodiscard]] std::string larger_face() const
    {
        double const change = upper.inner + upper.outer - lower.inner - lower.outer;
        bool const same = upper.inner == lower.inner && upper.outer == lower.outer;
        return same ? "same" : change < 0 ? "lower" : "upper";
    }
};

/// Which part of the work one clamping does.
struct WireSetUp
{
    int number = 1;       ///< 1 ... of
    int of = 1;           ///< more than 1: no path closes
    int first = 0;        ///< space that is cut first, and
    int spaces = 0;       ///< how many from there on, clockwise; only where there are several set-ups
    bool turned = false;  ///< the part is turned by half a turn on its mandrel: coordinates are the machine's, numbers of spaces the part's
};

/// All passes of one part in one set-up.
struct WireProgram
{
    std::string name;             ///< of the part, ASCII
    WireMachine machine;
    PairedContour nominal;
    std::vector<WirePass> passes;
    std::vector<Residual> residuals;
    double wire_diameter = 0;
    double spark_gap = 0;
    int decimals = 4;             ///< of every rounded output
    double tolerance = 0;         ///< of the surface that is cut [mm]
    double contour_error = 0;     ///< of the nominal contours against the true ones: what they were solved to, and what a side clearance "auto" was found to [mm]
    double cup_error = 0;         ///< of the displacement of the sections that an elastic cup bends, an estimate in none of the others; 0: none, or not known from an outline alone [mm]
    double start_hole_radius = 0; ///< [mm]
    int teeth = 0;                ///< tooth spaces around
    bool external = false;        ///< teeth outside; the void is left of contour and passes, so that they go counter-clockwise inside and clockwise outside
    WireSetUp set_up;
    std::string surface;          ///< "tilted", "ruled", "per-slice"; empty: both faces are the same
    std::string tilt_kind;        ///< "radial" or "draft"; empty: not tilted
    WireFigures figures;
    std::vector<std::string> warnings;  ///< no failures, but a shop should read them

    /// Whether the wire goes all around in this set-up.
    [[nodiscard]] bool closed() const { return set_up.of == 1; }
    /// Tooth spaces that it cuts.
    [[nodiscard]] int spaces() const { return closed() ? teeth : set_up.spaces; }
};

/// The clampings of one part, in order; one for a part that is cut all around.
using WireSetUps = std::vector<WireProgram>;

/// The figures of @p program, its first block measured anew.
[[nodiscard]] WireFigures measured(WireProgram const& program);

/// The same program for a part that is turned by half a turn.
[[nodiscard]] WireProgram turned_half(WireProgram program);

}  // namespace hdconj
