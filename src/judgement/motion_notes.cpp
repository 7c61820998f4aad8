// SPDX-License-Identifier: GPL-3.0-or-later
// Deformation, tooth numbers, and where flanks touch.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/check.hpp"
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

constexpr double near = 0.02;  // of the usual deformation: as good as that

/// Whether the flexspline's tooth can be made with that addendum and keeps its tip land.
bool has_tip_land(Scene scene, double addendum)
{
    scene.flexspline.profile.given.at("addendum").value = addendum;
    return check_scene(scene).empty() &&
           std::ranges::none_of(judge(scene), [](Note const& note) { return note.code == NoteCode::tip_land; });
}

/// What makes flanks touch longer; empty where nothing is known.
scene::Advice better_flank(Solution const& solution)
{
    Scene const& scene = solution.scene;
    scene::FamilyChoice const& tooth = scene.flexspline.profile;
    // Far from the usual deformation the corner of the tip cuts the flank away. Near it, the usual deformation may
    // shorten the contact.
    constexpr double far = 0.1;
    double const ratio = scene::deformation_ratio(scene.drive, solution.geometry.w0);
    bool const usual = scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth == scene.wave_generator.waves;
    scene::Advice advice;
    if (!usual || std::abs(ratio - 1) > far)
        advice = scene::usual_pair(scene, std::nullopt);
    scene::add_pressure_angle(scene, advice);
    constexpr double low = 0.85, high = 0.9;  // modules
    auto const addendum = tooth.number("addendum");
    if (double const higher = high * scene.drive.module;
        advice.set.empty() && addendum && *addendum < low * scene.drive.module && has_tip_land(scene, higher))
        advice.add(tooth.path + ".addendum", short_number(higher, 3));
    return advice;
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
    scene::Advice const better = better_flank(solution);
    note->advice = better.words.empty() ? "take another tooth, such as family = \"s-tooth\"" : "write " + better.words;
    note->set = better.set;
    return note;
}

std::optional<Note> undercut(Solution const& solution)
{
    FlankEngagement const& contact = solution.flank_contact;
    auto note = contact.used > 0 ? note_on(NoteCode::undercut, contact.lost / contact.used) : std::nullopt;
    if (!note)
        return note;
    note->place = "flank of the tooth space";
    note->cause = "a flank touches over " + short_number(to_deg(contact.used), 3) + " degrees, and " +
                  short_number(to_deg(contact.lost), 3) + " more up to a cusp are cut away by other contacts";
    Scene const& scene = solution.scene;
    scene::Advice const usual = scene::usual_pair(scene, std::nullopt);
    double const ratio = scene::deformation_ratio(scene.drive, solution.geometry.w0);
    bool const off = ratio > 1 + near, below = ratio < 1 - near;
    bool const has_arcs =
        scene.flexspline.profile.family == "double-circular-arc" || scene.flexspline.profile.family == "arc-chain";
    // far below it the usual deformation may cost contact: a part of the way is enough
    if ((off || below) && usual.words.empty())
        note->advice = "change the wave generator's shape, or ";
    else if (off)
        note->advice = "write " + usual.words + ", or ";
    else if (below)
        note->advice = "write a radial deformation between " + short_number(solution.geometry.w0) + " and " +
                       short_number(scene::usual_deformation(scene.drive)) + " mm, or ";
    note->advice += has_arcs ? "write a flank with a larger radius there" : "take a tooth of another family";
    if (off)
        note->set = usual.set;
    return note;
}

}  // namespace hdconj::judgement
