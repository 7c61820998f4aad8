// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/pipeline/contact.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "best_tilt.hpp"
#include "clearing_search.hpp"
#include "contact_case.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/profile/builder.hpp"
#include "hdconj/scene/schema.hpp"
#include "outline_records.hpp"
#include "owned_bench.hpp"
#include "spread.hpp"
#include "surface_choices.hpp"

namespace hdconj {
namespace {

using detail::ContactBench;
using detail::or_else;
using detail::SurfaceChoice;
using detail::SurfaceMaker;

constexpr double searches_worth = 20;      // cases, for the progress bar

bool axial(Scene const& scene, ContactOptions const& options)
{
    return scene.coning || scene.tilt || scene.slices || !options.tilts.empty() || !options.surfaces.empty() || options.best;
}

}  // namespace

Faults check_contact(Scene const& scene, ContactOptions const& options)
{
    Faults faults;
    if (scene.is_reverse())
        faults.push_back({"circular_spline.profile", scene.circular_spline.profile->line, "", "contact needs the flexspline's tooth, but the circular spline's is given",
                          "give [flexspline.profile]; `hdconj solve` finds the tooth that this circular spline needs"});
    if (!scene.circular_spline.width)
        faults.push_back({"circular_spline.width", 0, "", "this key is missing: contact is an area, and needs the face width",
                          "write width = 7.0, a length in mm, in [circular_spline]"});
    double const steepest = bounds::largest_tilt_deg * rad_per_deg;
    for (double const tilt : options.tilts)
    {
        if (!std::isfinite(tilt))
            faults.push_back({"--tilt", 0, short_number(tilt), "not a finite number", "write angles in degrees such as 0,0.1,0.2"});
        else if (!(std::abs(tilt) < steepest))
            faults.push_back({"--tilt", 0, short_number(tilt / rad_per_deg), "teeth are not tilted by 45 degrees or more", "write angles in degrees such as 0,0.1,0.2"});
    }
    std::vector<std::string> const surfaces = or_else(options.surfaces, scene.slices ? scene.slices->surface : "tilted");
    std::vector<std::string> const kinds = or_else(options.kinds, scene.tilt ? scene.tilt->kind : "radial");
    bool const draft = std::find(kinds.begin(), kinds.end(), "draft") != kinds.end();
    bool const tilted = std::find(surfaces.begin(), surfaces.end(), "tilted") != surfaces.end();
    if (draft && !tilted)
    {
        bool const by_kind = !options.kinds.empty();
        faults.push_back({by_kind ? "--kind" : "--surface", 0, by_kind ? "draft" : surfaces.front(),
                          "a draft needs one outline to offset, but surface \"" + surfaces.front() + "\" has an outline for each slice",
                          "write --kind radial, or --surface tilted"});
    }
    if (options.best && !tilted)
        faults.push_back({"--best", 0, "", "the search is for the tilt of surface \"tilted\", but surface \"" + surfaces.front() + "\" is asked for",
                          "write --surface tilted, or list tilts with --tilt"});
    if (options.best && !(options.best_to > options.best_from))
        faults.push_back({"--best", 0, "", "the interval of tilts to search is empty", "write --tilt FROM,TO with FROM below TO"});
    return faults;
}

namespace {

/// The scene with the effects that options ask for, so that its plan names them.
Scene with_options(Scene scene, ContactOptions const& options)
{
    bool const tilts = std::any_of(options.tilts.begin(), options.tilts.end(), [](double tilt) { return tilt != 0; }) || options.best;
    if (tilts && !scene.tilt)
        scene.tilt = Tilt{options.tilts.empty() ? 0.0 : options.tilts.front(), options.kinds.empty() ? "radial" : options.kinds.front(), 0};
    if (axial(scene, options) && !scene.slices)
        scene.slices = Slices{standard_slices, options.surfaces.empty() ? "tilted" : options.surfaces.front(), 0};
    return scene;
}

/// The part that a case describes: its surface in all slices with this side clearance, as `solve` makes it.
void write_part(Solution& out, detail::OwnedBench& owned, SurfaceChoice const& choice, double tip, double side_clearance)
{
    CircularSplineOutline& spline = out.circular_spline;
    std::vector<double> const& z = owned.maker->z();
    double const chord = owned.scene.solver.tolerance;
    MatchedOutline outline;
    if (side_clearance == 0)
    {
        if (z.size() == 1)
            return;
        outline = (*owned.maker)(choice, tip, chord, 0);
    }
    else
    {
        Scene scene = detail::middle_scene(owned.scene);
        scene.circular_spline.backlash_offset = side_clearance;
        scene.circular_spline.inner_radius = tip;
        Solution base = solve(scene);
        if (z.size() == 1)
        {
            spline = base.circular_spline;
            out.error.chord = base.error.chord;
            out.error.point = base.error.point;
            return;
        }
        base.scene.coning = owned.scene.coning;
        SurfaceMaker maker(base, owned.tooth, owned.shape, z, owned.threads);
        outline = maker(choice, tip, chord, 0);
    }
    spline.z = z;
    spline.outline = outline.points;
    spline.landmarks.assign(outline.landmarks.begin(), outline.landmarks.end());
    Outline common;
    common.stretches = outline.stretches;
    spline.pieces = detail::piece_records(common, owned.tooth);
    detail::take_errors(out, outline, choice.surface);
}

/// What a search for a tilt is for.
struct Goal
{
    char const* what;
    bool largest;
    double (*value)(ContactBench const& bench, SurfaceChoice const& choice, bool as_made);
};

/// The best tilt of one kind. Rarely it can be made with the wider tip circle alone: only then is every one asked for both.
BestTilt searched(ContactBench const& bench, ContactOptions const& options, std::string const& kind, Goal const& goal, std::function<void()> const& on_tilt)
{
    for (bool as_made = false;; as_made = true)
    {
        BestTilt best = detail::best_tilt(goal.what, kind, options, goal.largest, [&](double tilt) {
            on_tilt();
            return goal.value(bench, SurfaceChoice{"tilted", kind, tilt}, as_made);
        });
        try
        {
            ContactCase const found = detail::contact_case(bench, {"tilted", kind, best.tilt}, 0, nullptr);
            best.value_error = goal.largest ? found.state.share_error : found.clearing_offset_error;
            return best;
        }
        catch (NumericalError const&)
        {
            if (as_made)
                throw;
        }
    }
}

}  // namespace

ContactStudy contact(Scene const& scene, ContactOptions const& options, StageObserver const& on_stage, Progress const& progress)
{
    Faults faults;
    for (Faults const& more : {check_scene(scene), check_contact(scene, options)})
        faults.insert(faults.end(), more.begin(), more.end());
    if (!faults.empty())
        throw InputError(faults);
    Scene const asked = with_options(scene, options);
    detail::OwnedBench owned(asked, asked.slices ? asked.slices->count : 1, make_plan(asked, Verb::contact), on_stage);
    ContactBench const& bench = *owned.bench;
    std::vector<SurfaceChoice> const wanted = detail::surface_choices(scene, options);
    std::vector<std::string> const kinds = options.best ? or_else(options.kinds, scene.tilt ? scene.tilt->kind : "radial") : std::vector<std::string>{};
    double const steps = static_cast<double>(wanted.size()) + 2 * searches_worth * static_cast<double>(kinds.size());
    double done = 0;
    auto const say = [&](std::string const& what, double weight) {
        if (progress)
            progress(what, done / steps);
        done += weight;
    };
    ContactStudy study;
    study.contact_gap = bench.request.gap;
    study.pitch_radius = scene.drive.module * scene.drive.flexspline_teeth / 2;
    std::vector<SurfaceChoice> made;
    std::vector<std::string> left_out;
    std::optional<NumericalError> first;
    auto const add = [&](SurfaceChoice const& choice) {
        GapMap map;
        ContactCase found = detail::contact_case(bench, choice, options.revolution, &map);
        if (study.cases.empty() || found.state.share > study.cases[study.shown].state.share)
        {
            study.shown = study.cases.size();
            study.map = std::move(map);
        }
        study.cases.push_back(std::move(found));
        made.push_back(choice);
    };
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
        say("surface " + std::to_string(i + 1) + " of " + std::to_string(wanted.size()), 1);
        try
        {
            add(wanted[i]);
        }
        catch (NumericalError const& error)
        {
            left_out.push_back(detail::no_row(wanted[i], error.what()));
            if (!first)
                first.emplace(error);
        }
    }
    // an end of the interval that is searched need not make a surface
    if (!options.best)
    {
        if (study.cases.empty())
            throw NumericalError(*first);
        study.missing = left_out;
    }
    for (std::string const& kind : kinds)
        for (Goal const& goal : {Goal{"area", true, detail::share_of}, Goal{"clearing offset", false, detail::clearing_offset_of}})
            study.best.push_back(searched(bench, options, kind, goal, [&] { say("best tilt", 0.5); }));
    // none of the tilts that were listed: the row of the best
    if (study.cases.empty())
        add({"tilted", study.best.front().kind, study.best.front().tilt});
    SurfaceChoice const& shown = made[study.shown];
    study.solution = owned.middle;
    study.solution.scene = scene;
    study.solution.plan = owned.plan;
    if (std::string const note = bench.maker.note_on_sections(); !note.empty())
        study.solution.notes.push_back(note);
    study.solution.notes.insert(study.solution.notes.end(), left_out.begin(), left_out.end());
    ContactCase const& best_share = study.cases[study.shown];
    try
    {
        write_part(study.solution, owned, shown, best_share.tip, best_share.backlash_offset);
        study.side_clearance = best_share.backlash_offset;
    }
    catch (NumericalError const& error)
    {
        if (best_share.backlash_offset == 0)
            throw;
        write_part(study.solution, owned, shown, best_share.tip, 0);
        study.solution.notes.push_back("the written outline is without the side clearance of " + short_number(best_share.backlash_offset) + " mm, with which it cannot be made: " + error.what());
    }
    std::vector<StageTime> const times = owned.clock.times();
    study.solution.timing.insert(study.solution.timing.end(), times.begin(), times.end());
    return study;
}

namespace detail {

ClearingNeed clearing_need(Scene const& scene)
{
    StageObserver const nobody;   // the bench keeps a reference
    OwnedBench owned(scene, scene.slices ? scene.slices->count : 1, make_plan(scene, Verb::contact), nobody);
    SurfaceChoice const choice = surface_choices(scene, {}).front();
    ContactCase const found = clearing_case(*owned.bench, choice);
    return {found.clearing_offset, found.clearing_tip, owned.middle.geometry.circular_spline_inner_radius,
            found.clearing_offset > 0 ? clearing_accuracy(owned.bench->tolerance) / flattest_clearing : 0};
}

}  // namespace detail

}  // namespace hdconj
