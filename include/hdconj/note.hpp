// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the program thinks of a design: notes on figures that leave their usual range.
#pragma once

#include <string>
#include <vector>

#include "hdconj/scene_words.hpp"

namespace hdconj {

/// What a note is about. design_limits() states the limits of each.
enum class NoteCode
{
    deformation,       ///< radial deformation against m (z_c - z_f)/2
    tooth_difference,  ///< teeth of the circular spline that a wave moves the flexspline by
    flank_contact,     ///< teeth of a lobe that touch with a flank at the same time
    land,              ///< tip land of the circular spline
    tip_land,          ///< tip land of the flexspline
    undercut,          ///< angle that a flank loses by undercut
    sharp_corner,      ///< corner that no wire cuts
    narrow_space,      ///< tooth space that the wire does not enter
    wall_stress,       ///< bending stress of the ring
    late_mesh,         ///< where along the lobe a tooth leaves the circular spline's tip circle
    backlash,          ///< teeth that press on both flanks without torque
    teeth_end          ///< a circular spline that reaches beyond the teeth of the assembled cup
};

/// How grave a note is.
enum class Severity
{
    information,  ///< outside the usual range
    warning       ///< outside the accepted range: the drive will hardly do what it should
};

/// Words of NoteCode.
template <>
inline constexpr std::array<std::string_view, 12> words_of<NoteCode>{
    "deformation",  "tooth-difference", "flank-contact", "land",      "tip-land", "undercut",
    "sharp-corner", "narrow-space",     "wall-stress",   "late-mesh", "backlash", "teeth-end"};
/// Words of Severity.
template <>
inline constexpr std::array<std::string_view, 2> words_of<Severity>{"information", "warning"};

/// A figure of the design outside its range.
struct Note
{
    NoteCode code = NoteCode::deformation;      ///< what it is about
    Severity severity = Severity::information;  ///< how grave it is
    double figure = 0;                          ///< what was found
    double limit = 0;                           ///< end of the range that it leaves
    std::string unit;                           ///< of both; "1" for a pure number
    std::string place;                          ///< of the drive
    std::string cause;                          ///< what was found, in words
    std::string advice;                         ///< what to write, in words
    std::vector<std::string> set;               ///< the same as arguments of --set; may be empty
};

/// Notes in the order of NoteCode.
using Notes = std::vector<Note>;

/// Number of warnings among @p notes.
[[nodiscard]] inline std::size_t warnings_of(Notes const& notes)
{
    return static_cast<std::size_t>(
        std::count_if(notes.begin(), notes.end(), [](Note const& note) { return note.severity == Severity::warning; }));
}

/// What a user reads: a headline and a line for each note; empty without notes.
[[nodiscard]] std::string describe(Notes const& notes);

}  // namespace hdconj
