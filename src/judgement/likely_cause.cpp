// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
#include "checks.hpp"
#include "judgement.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

/// Whether @p note asks for a smaller radial deformation, with which the tips of a given circular spline would overlap
/// the flexspline's even more.
bool makes_tips_overlap(Note const& note)
{
    return note.code == NoteCode::deformation && note.figure > 1 && value_in(note.set, addendum_key);
}

/// What is far from usual in @p pair, which ended with @p error, and can be written otherwise: causes in words, and the
/// advice.
std::pair<std::string, scene::Advice> likely_cause(NumericalError const& error, UnsolvedPair const& pair)
{
    // of a space that would be too flat no tip circle is known that leaves a land
    bool const any_tip_circle = error.code() != ErrorCode::no_land || !error.set().empty();
    std::string cause;
    scene::Advice advice;
    bool deformed = false;
    for (Note const& note : notes_on(pair)) {
        bool const far = note.severity == Severity::warning || note.code == NoteCode::deformation;
        bool const has_remedy = !note.set.empty() || note.code == NoteCode::late_mesh;
        if (!far || !has_remedy || makes_tips_overlap(note) || note.code == NoteCode::wall_stress)
            continue;  // stress spoils no geometry
        // tip circle and stress come with the deformation
        bool const said = !note.set.empty() && std::ranges::find(advice.set, note.set.front()) != advice.set.end();
        if (said || (note.code == NoteCode::late_mesh && (deformed || !any_tip_circle)))
            continue;
        deformed = deformed || note.code == NoteCode::deformation;
        cause += note.cause + "; ";
        advice.words += (advice.words.empty() ? "" : "; ") + note.advice;
        advice.set.insert(advice.set.end(), note.set.begin(), note.set.end());
    }
    return {cause, advice};
}

/// Where @p advice and @p error both write an addendum for the radial deformation of the pair, leaves the smaller one
/// in
/// @p advice. @returns whether both write one
bool merge_addenda(NumericalError const& error, scene::Advice& advice)
{
    auto const first = value_in(error.set(), addendum_key), second = value_in(advice.set, addendum_key);
    if (!first || !second || value_in(advice.set, deformation_key))
        return false;
    if (std::stod(*first) < std::stod(*second))
        rewrite_value(addendum_key, *first, advice.words, advice.set);
    return true;
}

/// What @p error advises, and the usual radial deformation where that of @p pair is another and the error has found no
/// remedy by computing. A larger one leaves less land.
scene::Advice with_deformation(NumericalError const& error, UnsolvedPair const& pair)
{
    constexpr double near = 0.02;  // ratios as near as that are no cause
    double const off = scene::deformation_ratio(pair.scene.drive, pair.geometry.w0) - 1;
    if (!error.set().empty() || std::abs(off) < near || (error.code() == ErrorCode::no_land && off < 0))
        return {error.remedy(), error.set()};
    scene::Advice usual = scene::usual_pair(pair.scene, std::nullopt);
    if (usual.set.empty())
        return {error.remedy(), error.set()};
    usual.words = error.remedy() + (error.remedy().empty() ? "write " : ", or write ") + usual.words;
    return usual;
}

}  // namespace

NumericalError with_likely_cause(NumericalError const& error, UnsolvedPair const& pair)
{
    // contacts that rounding does not tell apart are no matter of the drive's sizes: with others they may be no clearer
    bool const of_rounding = error.code() == ErrorCode::not_converged && error.stage() == "envelope";
    if (!error.is_infeasible() || of_rounding)
        return error;
    auto [cause, advice] = likely_cause(error, pair);
    if (cause.empty())
        advice = with_deformation(error, pair);
    else {
        cause = "likely because " + cause;
        raise_tip_circle(pair, error.set(), advice.words, advice.set);
        bool const clears = value_in(error.set(), "circular_spline.backlash_offset=").has_value();
        if (clears)  // any other tip circle or deformation is helped by that
            advice.set.push_back(error.set().front());
        if (advice.set.empty())
            advice.set = error.set();
        if (!error.remedy().empty() && !merge_addenda(error, advice))
            advice.words += (clears ? "; " : "; or ") + error.remedy();
    }
    scene::Advice flank;
    scene::add_pressure_angle(pair.scene, flank);
    if (!flank.set.empty()) {
        advice.words += (advice.words.empty() ? "" : "; ") + ("to let the flanks touch, write " + flank.words);
        advice.set.push_back(flank.set.front());
    }
    return {error.code(), error.stage(), error.place(), cause + error.cause(), advice.words, advice.set};
}

NumericalError with_cause_of_no_flank(NumericalError const& error, UnsolvedPair const& pair, Solution const& middle)
{
    auto const note = middle.flank_contact.angle > 0 ? std::nullopt : flank_contact(middle);
    if (!note)
        return with_likely_cause(error, pair);
    scene::Advice angle;
    scene::add_pressure_angle(pair.scene, angle);
    return with_likely_cause({error.code(), error.stage(), error.place(), error.cause() + "; at z = 0 no flank touches",
                              angle.set.empty() ? note->advice : ""},
                             pair);
}

}  // namespace hdconj::judgement
