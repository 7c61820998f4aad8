// SPDX-License-Identifier: GPL-3.0-or-later
// Deformation, tooth numbers, and where flanks touch.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/units.hpp"
#include "limits.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

/// Length of the flank of the solved member that a flank made, the lesser of both sides [mm].
double flank_length(Solution const& solution)
{
    bool const reverse = solution.scene.is_reverse();
    auto const& points = reverse ? solution.flexspline_outline : solution.circular_spline.outline.front();
    double left = 0, right = 0;
    for (OutlinePiece const& piece : reverse ? solution.flexspline_pieces : solution.circular_spline.pieces)
        for (std::size_t i = piece.first; piece.kind == "flank" && i < piece.last; ++i)
            (points[i].x() + points[i + 1].x() < 0 ? left : right) += (points[i + 1] - points[i]).norm();
    return std::min(left, right);
}

}  // namespace

std::optional<Note> deformation(UnsolvedPair const& pair)
{
    double const w0 = pair.geometry.w0;
    auto note = note_on(NoteCode::deformation, scene::deformation_ratio(pair.scene.drive, w0));
    if (!note)
        return note;
    note->place = "wave_generator";
    note->cause = scene::unusual_deformation(pair.scene.drive, w0).value_or("");
    scene::Advice const usual = scene::usual_pair(pair.scene, w0);
    note->advice = usual.words.empty() ? "change the wave generator's shape" : "write " + usual.words;
    note->set = usual.set;
    return note;
}

std::optional<Note> tooth_difference(UnsolvedPair const& pair)
{
    Drive const& drive = pair.scene.drive;
    int const waves = pair.scene.wave_generator.waves;
    int const more = drive.circular_spline_teeth - drive.flexspline_teeth;
    auto note = note_on(NoteCode::tooth_difference, static_cast<double>(more) / waves);
    if (!note)
        return note;
    note->place = "drive";
    note->cause = "each wave moves the flexspline by " + std::to_string(more / waves) +
                  " teeth of the circular spline, usually by one";
    std::string const key = "drive.circular_spline_teeth", usual = std::to_string(drive.flexspline_teeth + waves);
    note->advice = "write " + key + " = " + usual + " and a radial deformation of " +
                   short_number(drive.module * waves / 2) + ", if a larger ratio will do";
    return note;
}

std::optional<Note> flank_contact(Solution const& solution)
{
    Drive const& drive = solution.scene.drive;
    double const angle = solution.flank_contact.angle;
    double const teeth = drive.flexspline_teeth * angle / (2 * std::numbers::pi);
    auto note = note_on(NoteCode::flank_contact, teeth);
    if (!note)
        return note;
    note->place = "tooth space";
    note->cause = angle > 0 ? "a flank touches over " + short_number(to_deg(angle), 3) + " degrees and " +
                                  short_number(flank_length(solution), 3) + " mm, which is " + short_number(teeth, 3) +
                                  " teeth at a time"
                            : "no flank touches: corners and tip lands alone make the tooth space";
    note->advice = solution.scene.given_profile().family == "s-tooth"
                       ? "take another tooth"
                       : "take another tooth, such as family = \"s-tooth\"";
    return note;
}

std::optional<Note> undercut(Solution const& solution)
{
    FlankEngagement const& contact = solution.flank_contact;
    auto note = contact.used > 0 ? note_on(NoteCode::undercut, contact.lost / contact.used) : std::nullopt;
    if (!note)
        return note;
    note->place = "flank of the tooth space";
    note->cause = "a flank touches over " + short_number(to_deg(contact.used), 3) + " degrees and loses " +
                  short_number(to_deg(contact.lost), 3) + " degrees to undercut, where its contact ends in a cusp";
    std::string const& family = solution.scene.given_profile().family;
    note->advice = family == "double-circular-arc" || family == "arc-chain" ? "write a flank with a larger radius there"
                                                                            : "take a tooth of another family";
    return note;
}

}  // namespace hdconj::judgement
