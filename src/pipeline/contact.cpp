// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact.hpp"

#include "hdconj/check.hpp"

#include <algorithm>
#include <array>

#include "contact/clearance/side_clearance_search.hpp"
#include "contact/study/best_tilt.hpp"
#include "contact/study/contact_case.hpp"
#include "contact/study/contact_study_data.hpp"
#include "contact/study/surface_choices.hpp"
#include "hdconj/scene/reading.hpp"
#include "part_of_case.hpp"

namespace hdconj {
namespace {

using contact::ContactContext;
using contact::or_else;
using surface::SurfaceSpec;

constexpr double searches_worth = 20;  // cases, for the progress bar

/// The scene with the effects that options ask for, so that its plan names them.
Scene with_options(Scene scene, ContactOptions const& options)
{
    bool const tilts =
        std::any_of(options.tilts.begin(), options.tilts.end(), [](double tilt) { return tilt != 0; }) || options.best;
    if (tilts && !scene.tilt)
        scene.tilt = Tilt{options.tilts.empty() ? 0.0 : options.tilts.front(),
                          options.kinds.empty() ? TiltKind::radial : options.kinds.front(), 0};
    if (contact::is_axial(scene, options) && !scene.slices)
        scene.slices =
            Slices{standard_slices, options.surfaces.empty() ? ToothSurface::tilted : options.surfaces.front(), 0};
    return scene;
}

/// What a search for a tilt is for.
struct Goal
{
    TiltGoal what;
    bool largest;
    double (*value)(ContactContext const& context, SurfaceSpec const& spec);
};

/// The best tilt of one kind.
BestTilt searched(ContactContext const& context, ContactOptions const& options, TiltKind kind, Goal const& goal,
                  std::function<void()> const& on_tilt)
{
    BestTilt best = contact::best_tilt(goal.what, kind, options, goal.largest, [&](double tilt) {
        on_tilt();
        return goal.value(context, SurfaceSpec{ToothSurface::tilted, kind, tilt});
    });
    ContactCase const found =
        contact::contact_case(context, {ToothSurface::tilted, kind, best.tilt}, 0, options.errors, nullptr);
    best.value_error = goal.largest ? found.state.contact_fraction_error : found.least_side_clearance_error;
    return best;
}

/// Tells how much of the work is done: a surface is a step, a search counts as many.
class StepProgress
{
  public:
    StepProgress(Progress const& progress, std::size_t surfaces, std::size_t searches)
        : progress_(progress), steps_(static_cast<double>(surfaces) + searches_worth * static_cast<double>(searches))
    {
    }
    void begin(std::string const& what, double steps)
    {
        if (progress_)
            progress_(what, done_ / steps_);
        done_ += steps;
    }

  private:
    Progress const& progress_;
    double steps_;
    double done_ = 0;
};

/// Why cases of a study are missing.
struct MissingCases
{
    std::vector<std::string> reasons;
    std::optional<NumericalError> first_failure;
};

SmallestGaps smallest_gaps(GapMap const& map)
{
    SmallestGaps smallest{map.angle, {}};
    for (auto at = map.gap.begin(); at != map.gap.end(); at += static_cast<std::ptrdiff_t>(map.station.size()))
        smallest.gap.push_back(*std::min_element(at, at + static_cast<std::ptrdiff_t>(map.station.size())));
    return smallest;
}

/// @throws NumericalError where the case, or its part if it is the one to write, cannot be made
void add_case(ContactStudy& study, contact::ContactStudyData& data, SurfaceSpec const& spec, int revolution)
{
    GapMap map;
    ContactCase found = contact::contact_case(*data.context, spec, revolution, study.estimated, &map);
    found.gaps = smallest_gaps(map);
    if (study.cases.empty() || found.state.contact_fraction > study.cases[study.written_case].state.contact_fraction) {
        study.solution = pipeline::solution_with_part(data, {spec, found.tip, found.backlash_offset});
        study.written_case = study.cases.size();
        study.map = std::move(map);
    }
    study.cases.push_back(std::move(found));
}

/// The cases that scene and options list, without those that cannot be made.
MissingCases add_cases(ContactStudy& study, contact::ContactStudyData& data, std::vector<SurfaceSpec> const& wanted,
                       int revolution, StepProgress& progress)
{
    MissingCases missing;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        progress.begin("surface " + std::to_string(i + 1) + " of " + std::to_string(wanted.size()), 1);
        try {
            add_case(study, data, wanted[i], revolution);
        } catch (NumericalError const& error) {
            missing.reasons.push_back(contact::no_row(wanted[i], error.what()));
            if (!missing.first_failure)
                missing.first_failure.emplace(error);
        }
    }
    return missing;
}

/// Completes the solution of a study with what is not of the shown case.
void complete_solution(ContactStudy& study, contact::ContactStudyData& data, Scene const& scene,
                       std::vector<std::string> const& missing)
{
    study.solution.scene = scene;
    study.solution.plan = data.plan;
    std::vector<std::string>& notes = study.solution.notes;
    if (std::string const note = data.maker->note_on_sections(); !note.empty())
        notes.push_back(note);
    notes.insert(notes.end(), missing.begin(), missing.end());
    std::vector<StageTime> const times = data.clock.times();
    study.solution.timing.insert(study.solution.timing.end(), times.begin(), times.end());
}

}  // namespace

ContactStudy study_contact(Scene const& scene, ContactOptions const& options, StageObserver const& on_stage,
                           Progress const& progress)
{
    throw_if_any(scene::value_faults(scene));
    Faults faults;
    for (Faults const& more : {check_scene(scene), check_contact(scene, options)})
        faults.insert(faults.end(), more.begin(), more.end());
    throw_if_any(faults);
    contact::ContactStudyData data(with_options(scene, options), Verb::contact, on_stage);
    ContactContext const& context = *data.context;
    std::vector<SurfaceSpec> const wanted = contact::surface_choices(scene, options);
    std::vector<TiltKind> const kinds =
        options.best ? contact::or_else(options.kinds, scene.tilt ? scene.tilt->kind : TiltKind::radial)
                     : std::vector<TiltKind>{};
    std::array const goals{Goal{TiltGoal::contact_area, true, contact::share_of},
                           Goal{TiltGoal::least_side_clearance, false, contact::least_side_clearance_of}};
    StepProgress steps(progress, wanted.size(), goals.size() * kinds.size());
    ContactStudy study;
    study.estimated = options.errors;
    study.contact_gap = context.request.gap;
    study.pitch_radius = scene.drive.module * scene.drive.flexspline_teeth / 2;
    MissingCases missing = add_cases(study, data, wanted, options.revolution, steps);
    std::vector<std::string> const impossible = contact::impossible_choices(options);
    missing.reasons.insert(missing.reasons.begin(), impossible.begin(), impossible.end());
    // an end of the interval that is searched need not make a surface
    if (!options.best) {
        if (study.cases.empty())
            throw NumericalError(*missing.first_failure);
        study.missing = missing.reasons;
    }
    for (TiltKind const kind : kinds)
        for (Goal const& goal : goals)
            study.best.push_back(searched(context, options, kind, goal, [&] { steps.begin("best tilt", 0.5); }));
    // none of the tilts that were listed: the row of the best
    if (study.cases.empty()) {
        BestTilt const& best = study.best.front();
        add_case(study, data, {ToothSurface::tilted, best.kind, best.tilt}, options.revolution);
    }
    complete_solution(study, data, scene, missing.reasons);
    return study;
}

}  // namespace hdconj
