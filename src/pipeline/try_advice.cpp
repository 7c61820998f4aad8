// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conjugate/plane/solve_plane.hpp"
#include "hdconj/check.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "judgement/flank_ways.hpp"
#include "scene/changed_scene.hpp"

namespace hdconj {
namespace {

using Settings = std::vector<std::string>;

/// Whether the elastic cup of @p scene is the same with @p settings: they change its teeth above the pitch line alone.
bool keep_cup(Scene const& scene, Settings const& settings)
{
    return std::ranges::all_of(settings, [&](std::string const& setting) {
        return setting.starts_with(scene.given_profile().path + '.') || setting.starts_with("!");
    });
}

/// The settings of @p first, then those of @p then, which replace them for the same key.
Settings joined(Settings first, Settings const& then)
{
    for (std::string const& setting : then) {
        std::string const key = scene::key_of(setting);
        std::erase_if(first, [&](std::string const& each) { return scene::key_of(each) == key; });
        first.push_back(setting);
    }
    return first;
}

/// A changed drive.
struct Tried
{
    Settings settings;
    Notes notes;
};

/// The drive of @p given with @p settings, and with those that a refusal writes; nothing where that is no drive.
std::optional<Tried> drive_with(Solution const& given, Settings settings)
{
    constexpr double chord = 1e-4;  // modules; contacts hardly depend on how finely the outline is drawn
    constexpr int attempts = 2;
    for (int i = 0; i < attempts; ++i) {
        conjugate::SolvedPlane plane;
        Solution& out = plane.solution;
        out.scene = scene::changed_scene(given.scene, settings);
        out.scene.solver.tolerance = std::max(out.scene.solver.tolerance, chord * out.scene.drive.module);
        out.scene.circular_spline.automatic_backlash = false;  // it was found
        if (!scene::value_faults(out.scene).empty() || !check_scene(out.scene).empty())
            return std::nullopt;
        if (keep_cup(given.scene, settings))
            out.cup = given.cup;
        out.plan = make_plan(out.scene);
        drive::StageClock clock(out.plan, {});
        try {
            conjugate::solve_plane(plane, clock, std::nullopt);
            return Tried{std::move(settings), std::move(out.judgement)};
        } catch (NumericalError const& error) {
            if (!error.is_infeasible() || error.set().empty())
                return std::nullopt;
            settings = joined(std::move(settings), error.set());
        }
    }
    return std::nullopt;
}

Note const* find(Notes const& notes, NoteCode code)
{
    auto const found = std::ranges::find(notes, code, &Note::code);
    return found == notes.end() ? nullptr : &*found;
}

/// How far the figure of @p note lies outside the range that is usual for @p scene; 0: there is no note.
double beyond(Note const* note, Scene const& scene)
{
    if (note == nullptr)
        return 0;
    DesignRange const usual = design_limits(scene)[static_cast<std::size_t>(note->code)].usual;
    return std::max(usual.low - note->figure, note->figure - usual.high);
}

/// Whether @p after has a warning where @p before has none.
bool warns_anew(Notes const& before, Notes const& after)
{
    return std::ranges::any_of(after, [&](Note const& note) {
        Note const* const known = find(before, note.code);
        return note.severity == Severity::warning && (known == nullptr || known->severity != Severity::warning);
    });
}

/// Whether the advice of a note of @p code is a choice, or of the wire: not to be joined with that of others.
bool is_apart(NoteCode code)
{
    return code == NoteCode::tooth_difference || code == NoteCode::sharp_corner || code == NoteCode::narrow_space;
}

void write(Note& note, Settings const& settings)
{
    note.set = settings;
    note.advice = scene::in_words(settings);
}

/// Finds advice for one note after the other.
class AdviceSearch
{
  public:
    explicit AdviceSearch(Solution const& given) : given_(given), now_{{}, given.judgement} {}

    /// The first of @p ways, after what was advised before, that ends the note of @p code and brings no other; else the
    /// one that comes nearest; empty where none helps.
    [[nodiscard]] Settings best_of(NoteCode code, std::vector<Settings> const& ways)
    {
        constexpr double enough = 0.9;
        std::optional<Tried> best;
        double least = enough * beyond(find(given_.judgement, code), given_.scene);
        for (Settings const& way : ways) {
            Settings const settings = joined(now_.settings, way);
            auto tried = settings.empty() ? std::nullopt : drive_with(given_, settings);
            if (!tried || !keeps_advised(tried->notes) || warns_anew(given_.judgement, tried->notes))
                continue;
            double const off = beyond(find(tried->notes, code), given_.scene);
            bool const ends = off == 0 && all_known(tried->notes);
            if (ends || off < least) {
                least = off;
                best = std::move(tried);
            }
            if (ends)
                break;
        }
        if (!best)
            return {};
        now_ = std::move(*best);
        advised_.push_back(code);
        return now_.settings;
    }

    /// Adds the advice of @p note to what was advised before, with what the drive then needs beside. Where the advice
    /// so far ends the note already, the note gets that advice. @returns false where there is no such drive
    [[nodiscard]] bool keep(Note& note)
    {
        if (!now_.settings.empty() && find(now_.notes, note.code) == nullptr)
            write(note, now_.settings);
        Settings const settings = joined(now_.settings, note.set);
        if (settings != now_.settings) {
            auto tried = drive_with(given_, settings);
            if (!tried)
                return false;
            if (tried->settings != settings)
                write(note, tried->settings);
            now_ = std::move(*tried);
        }
        advised_.push_back(note.code);
        return true;
    }

  private:
    /// Whether no note that has its advice is worse in @p after than with that.
    [[nodiscard]] bool keeps_advised(Notes const& after) const
    {
        return std::ranges::all_of(advised_, [&](NoteCode code) {
            return beyond(find(after, code), given_.scene) <= beyond(find(now_.notes, code), given_.scene);
        });
    }

    [[nodiscard]] bool all_known(Notes const& after) const
    {
        return std::ranges::all_of(after,
                                   [&](Note const& note) { return find(given_.judgement, note.code) != nullptr; });
    }

    Solution const& given_;
    Tried now_;  ///< the drive with the advice so far
    std::vector<NoteCode> advised_;
};

}  // namespace

void try_advice(Solution& solution)
{
    Notes notes = solution.judgement;
    AdviceSearch search(solution);
    std::vector<Settings> const none{{}};
    std::vector<Note*> tried;
    for (Note& note : notes) {
        bool const of_flank = note.code == NoteCode::flank_contact || note.code == NoteCode::undercut;
        if (is_apart(note.code) || (!of_flank && search.keep(note)))
            continue;
        Settings const found = search.best_of(note.code, of_flank ? judgement::flank_ways(note.code, solution) : none);
        if (found.empty())
            continue;
        write(note, found);
        tried.push_back(&note);
    }
    for (Note* note : tried)  // what the last one advises is as good for those before
        write(*note, tried.back()->set);
    solution.judgement = std::move(notes);
}

}  // namespace hdconj
