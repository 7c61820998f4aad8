// SPDX-License-Identifier: GPL-3.0-or-later
// Notes on a pair before it is solved and after, and the likely cause of a failure.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::judgement {

/// A pair before it is solved.
struct UnsolvedPair
{
    Scene const& scene;
    PairGeometry const& geometry;
    profile::Profile const& tooth;  ///< that is given
    wavegen::AnyWaveShape const& shape;
};

/// What dimensions alone say.
[[nodiscard]] Notes notes_on(UnsolvedPair const& pair);

/// What the solved pair says beside that, in one plane. The room wedm judges what a wire leaves.
[[nodiscard]] Notes notes_on(Solution const& solution);

/// Teeth that press on both flanks.
/// @param turn            between first contacts of both flanks [rad]
/// @param side_clearance  that it goes with [mm]
/// @param where           position of the wave generator, in words; may be empty
[[nodiscard]] std::optional<Note> backlash(Scene const& scene, double turn, double side_clearance,
                                           std::string const& where);

/// Tips that interfere along a radius when the drive is assembled.
/// @param turn       between first contacts, below 0 [rad]
/// @param depth      of the interference [mm]
/// @param least_tip  tip circle with which the tips pass [mm]
[[nodiscard]] std::optional<Note> tip_interference(double turn, double depth, double least_tip);

/// A circular spline whose front end has no tooth beside it, since the cup pulls its open end towards the bottom.
/// @param front  face of the flexspline's teeth at the major axis, on the assembled cup, above z = 0 [mm]
/// Domain: a scene with the width of the circular spline.
[[nodiscard]] std::optional<Note> teeth_end(Scene const& scene, double front);

/// Puts @p note, or nothing, in the place of what @p notes say with @p code.
void replace_note(Notes& notes, NoteCode code, std::optional<Note> const& note);

/// Puts what judge() says of late mesh in @p scene in the place of what @p notes say of it.
void judge_late_mesh_again(Notes& notes, Scene const& scene);

/// The narrowest width of a tooth space of @p solution for the wire of @p scene, in the place of what @p notes say of
/// it.
void judge_narrow_space_again(Notes& notes, Scene const& scene, Solution const& solution);

/// Ends of what arguments of --set write, for value_in() and rewrite_value().
inline constexpr char const *tip_circle_key = "circular_spline.inner_radius=", *addendum_key = "flexspline.addendum=",
                            *deformation_key = ".radial_deformation=";

/// What @p set, arguments of --set, writes for the key that ends with @p key; nothing where it does not write it.
[[nodiscard]] std::optional<std::string> value_in(std::vector<std::string> const& set, std::string const& key);

/// Where @p set writes the key that ends with @p key, it writes @p value from now on, and so do @p words.
void rewrite_value(std::string const& key, std::string const& value, std::string& words, std::vector<std::string>& set);

/// Where several of @p notes on @p pair write the tip circle, each writes the largest of them, as raise_tip_circle()
/// takes it over.
void agree_on_tip_circle(UnsolvedPair const& pair, Notes& notes);

/// Where @p set writes a smaller tip circle than @p wanted does, that of @p wanted takes its place there and in @p
/// words. Where @p set alone writes the radial deformation too, @p wanted is for that of @p pair: it is taken over as
/// far beyond the usual tip circle as it is there. Where @p wanted alone writes it, @p set stays.
void raise_tip_circle(UnsolvedPair const& pair, std::vector<std::string> const& wanted, std::string& words,
                      std::vector<std::string>& set);

/// @p error, which solving @p pair ended with, and first of all what is far from usual in the pair and can be written
/// otherwise. Contacts that were not told apart are left as they are: no change of the pair is known to help.
[[nodiscard]] NumericalError with_likely_cause(NumericalError const& error, UnsolvedPair const& pair);

/// The same of a surface of @p pair of which a slice has no flank. Where no flank touches in the plane z = 0 either,
/// which is @p middle, it advises what lets one touch there.
[[nodiscard]] NumericalError with_cause_of_no_flank(NumericalError const& error, UnsolvedPair const& pair,
                                                    Solution const& middle);

}  // namespace hdconj::judgement
