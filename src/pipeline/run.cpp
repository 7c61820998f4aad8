// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "contact/study/surface_choices.hpp"
#include "hdconj/error.hpp"
#include "hdconj/running.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/units.hpp"
#include "judgement/judgement.hpp"
#include "load/grids/grid_error.hpp"
#include "load/model/ring_errors.hpp"
#include "load/study/load_case.hpp"
#include "load/study/loaded_scene.hpp"
#include "part_of_case.hpp"
#include "running/losses.hpp"
#include "running/planned_sequences.hpp"
#include "running/run_scene.hpp"
#include "running/sequence_errors.hpp"
#include "running/sequences.hpp"

namespace hdconj {
namespace {

using running::SequenceObserver;

/// Tells how many of all positions are done.
class PositionProgress
{
  public:
    PositionProgress(Progress progress, std::size_t all) : progress_(std::move(progress)), all_(all) {}
    void step()
    {
        ++done_;
        if (progress_)
            progress_("run", std::min(1.0, static_cast<double>(done_) / static_cast<double>(all_)));
    }

  private:
    Progress progress_;
    std::size_t all_, done_ = 0;
};

/// The least turn between first contacts of both flanks, and where it was found.
struct LeastPlay
{
    double width = 0;    ///< not above 0 [rad]
    double pitches = 0;  ///< that the wave generator has turned

    /// @returns the turn to the first contact of the working side
    double enter(load::Play const& play, double at)
    {
        if (double const here = load::width_of(play); here < width) {
            width = here;
            pitches = at;
        }
        return play.right;
    }
    void judge(Scene const& scene, RunStudy& study) const
    {
        if (auto const note = judgement::backlash(
                scene, width, study.backlash_offset,
                " when the wave generator has turned by " + short_number(pitches) + " tooth pitches"))
            study.solution.judgement.push_back(*note);
    }
};

/// Enters how the teeth of the circular spline are made, and that part.
void enter_part(contact::ContactStudyData& data, surface::SurfaceSpec const& spec, double tip, double offset,
                RunStudy& study)
{
    study.backlash_offset = offset;
    study.tip = tip;
    study.side_clearance_increased = contact::is_side_clearance_increased(*data.context, offset);
    study.tip_radius_increase = contact::tip_radius_increase(*data.context, tip);
    study.solution = pipeline::solution_with_part(data, {spec, tip, offset});
}

/// Adds the errors of what lies between positions at whole pitches.
/// @param compute  the sequence of a plan
template <class Compute>
void add_errors_between(RunSequence& sequence, running::SpanPlan const& plan, running::RunTask const& task,
                        SequenceObserver const& observer, Compute compute)
{
    RunSequence const between = compute(running::places_between(plan));
    running::add_places_between(sequence, between, plan, task.motion);
    if (between.positions.size() < between.planned && observer.is_stopped())
        observer.on_missing("stopped before the errors between the positions were known");
}

/// First contacts in the shape that the scene prescribes. The flanks are as exact as the solver's tolerance.
void run_prescribed(contact::ContactStudyData& data, running::RunTask const& task, RunOptions const& options,
                    SequenceObserver const& observer, surface::SurfaceSpec const& spec, RunStudy& study)
{
    contact::ContactContext const& context = *data.context;
    contact::FlankSurface const surface = contact::used_surface(context, spec);
    enter_part(data, spec, surface.tip, surface.offset, study);
    LeastPlay least;
    auto const turn_at = [&](double pitches) {
        return least.enter(running::first_contact(context, surface.grid, task.motion, pitches), pitches);
    };
    double const angle = 2 * context.tolerance.length / context.geometry.r_m;
    for (auto const& [plan, under_torque] : running::planned_sequences(context.scene, task)) {
        RunSequence sequence = running::first_contacts(plan, task.motion, turn_at, observer);
        running::add_shape_error(sequence, angle);
        if (plan.span != RunSpan::tooth_pitch) {
            bool const known = options.errors && !observer.is_stopped();
            if (known)
                add_errors_between(sequence, plan, task, observer, [&](running::SpanPlan const& between) {
                    return running::first_contacts(between, task.motion, turn_at, observer.silent());
                });
            else if (options.errors && sequence.positions.size() == sequence.planned)
                observer.on_missing("stopped before the errors were known");
            sequence.estimated = sequence.estimated && known;
        }
        if (!sequence.positions.empty())
            study.sequences.push_back(std::move(sequence));
    }
    least.judge(context.scene, study);
}

/// The same drive on the grid asked for and, where there is one, on the coarse grid.
struct GridPair
{
    running::TurningDrive const& fine;
    running::TurningDrive const* coarse;  ///< null: none
    double safety;                        ///< of the difference of both in losses
    /// The same of sequences, whose difference is taken at its largest: a quarter. Of type-50 at 5 to 33 slices, with
    /// one outline and with one for each slice, the error so found was at least twice the distance from the finest.
    [[nodiscard]] double safety_of_sequences() const { return safety / 4; }
};

/// A sequence with its errors. That until both rings meet is too long for a second grid: it has those of the turn of
/// the wave generator that was computed before it.
void run_elastic_sequence(running::PlannedSequence const& planned, GridPair const& drives, running::RunTask const& task,
                          SequenceObserver const& observer, LeastPlay& least, RunStudy& study)
{
    auto const sequence_of = [&](running::SpanPlan const& plan, running::TurningDrive const& drive,
                                 SequenceObserver const& told, LeastPlay& found) {
        return planned.under_torque
                   ? running::balanced(plan, drive, task.motion, task.torque, told)
                   : running::first_contacts(
                         plan, task.motion,
                         [&](double pitches) { return found.enter(drive.first_contact(pitches), pitches); }, told);
    };
    running::SpanPlan const& plan = planned.plan;
    RunSequence sequence = sequence_of(plan, drives.fine, observer, least);
    if (sequence.positions.empty())
        return;
    LeastPlay unused;
    bool const asked = drives.coarse != nullptr;
    if (asked && observer.is_stopped()) {
        if (sequence.positions.size() == sequence.planned)
            observer.on_missing("stopped before the errors were known");
    } else if (asked) {
        if (plan.span != RunSpan::output_turn) {
            RunSequence const coarse = sequence_of(plan, *drives.coarse, observer.silent(), unused);
            running::add_grid_error(sequence, coarse, drives.safety_of_sequences());
            if (coarse.positions.size() < sequence.positions.size() && observer.is_stopped())
                observer.on_missing("stopped before the errors of all positions were known");
        }
        for (RunSequence const& each : study.sequences)
            if (plan.span == RunSpan::output_turn && each.span == RunSpan::input_turn && each.torque == 0)
                running::add_error_of(sequence, each);
        if (plan.span != RunSpan::tooth_pitch)
            add_errors_between(sequence, plan, task, observer, [&](running::SpanPlan const& between) {
                return sequence_of(between, drives.fine, observer.silent(), least);
            });
    }
    study.sequences.push_back(std::move(sequence));
}

/// Everything of an elastic drive.
void run_elastic(contact::ContactStudyData& data, running::RunTask const& task, RunOptions const& options,
                 SequenceObserver const& observer, surface::SurfaceSpec const& spec, RunStudy& study)
{
    contact::ContactContext const& context = *data.context;
    load::LoadGrid const grid = load::load_grid(context);
    load::LoadModel model = data.clock.value_of(Stage::influence, [&] { return load::load_model(context, grid); });
    load::AssembledDrive const fine = data.clock.value_of(Stage::assembly, [&] {
        load::LoadedDrive unloaded = load::assembly(context, model.drive);
        return load::AssembledDrive{grid, std::move(model), std::move(unloaded)};
    });
    load::SurfaceWithPlay const assembled = load::surface_with_play(context, fine, spec);
    enter_part(data, spec, assembled.surface.tip, assembled.surface.offset, study);
    contact::FlankGrid const& flanks = assembled.surface.grid;
    double const middle = load::middle_of(assembled.play);
    running::TurningDrive const drive(context, fine, flanks, task.motion, middle);
    // The losses are single figures, in which two grids may agree by chance.
    std::size_t const coarser_grids = context.scene.friction ? 2 : 1;
    std::vector<load::AssembledDrive> const coarse = load::coarser_drives(context, options.errors ? coarser_grids : 0);
    std::vector<contact::FlankGrid> coarse_flanks;
    coarse_flanks.reserve(coarse.size());  // the drives refer to them
    std::vector<running::TurningDrive> coarse_drives;
    for (load::AssembledDrive const& each : coarse) {
        coarse_flanks.push_back(load::coarsened(coarse_flanks.empty() ? flanks : coarse_flanks.back()));
        coarse_drives.emplace_back(context, each, coarse_flanks.back(), task.motion, middle);
    }
    GridPair const drives{drive, coarse_drives.empty() ? nullptr : &coarse_drives.front(),
                          load::grid_safety(flanks.slices())};
    LeastPlay least;
    data.clock.run(Stage::run, [&] {
        for (running::PlannedSequence const& each : running::planned_sequences(context.scene, task))
            run_elastic_sequence(each, drives, task, observer, least, study);
        if (!context.scene.friction)
            return;
        bool const balanced =
            std::ranges::any_of(study.sequences, [](RunSequence const& each) { return each.torque > 0; });
        if (!balanced && !observer.is_stopped())
            return observer.on_missing(
                fmt::format("no losses: no position has a result at {:g} N m", task.torque * per_newton_metre));
        running::LossModel const losses{
            *context.scene.friction, task.motion,
            running::bearing_diameter(context.scene, context.geometry.flexspline_inner_radius)};
        running::LossRuns const runs = running::loss_runs(losses, drive, task, observer);
        if (runs.asked.empty())
            return;
        std::vector<running::LossRuns> others;
        for (running::TurningDrive const& each : coarse_drives)
            others.push_back(running::loss_runs_like(runs, each, task, observer));
        study.losses = running::run_losses(losses, task, runs, others, drives.safety);
    });
    least.judge(context.scene, study);
}

/// Positions of all sequences, on both grids and between whole pitches.
std::size_t positions_of(Scene const& scene, running::RunTask const& task, bool errors)
{
    bool const coarse = task.torque > 0 && errors;
    std::size_t all = scene.friction ? (coarse ? 3 : 1) * running::loss_positions : 0;
    for (running::PlannedSequence const& each : running::planned_sequences(scene, task))
        all += each.plan.pitches.size() * (1U + (coarse && each.plan.span != RunSpan::output_turn ? 1U : 0U) +
                                           (errors && each.plan.span != RunSpan::tooth_pitch ? 1U : 0U));
    return all;
}

}  // namespace

RunStudy study_run(Scene const& scene, RunOptions const& options, StageObserver const& on_stage,
                   Progress const& progress)
{
    throw_if_any(scene::value_faults(scene));
    Scene const checked = running::checked_run_scene(scene, options);
    running::RunTask const task = running::run_task(checked, options);
    bool const elastic = task.torque > 0;
    std::unique_ptr<contact::ContactStudyData> const data =
        elastic
            ? load::contact_data(checked, options.errors, on_stage).data
            : std::make_unique<contact::ContactStudyData>(checked, Verb::load, on_stage, std::nullopt, options.errors);
    // The drive is solved by the plan of `load`. The clock enters only stages of its plan: from here on those of `run`.
    data->plan = plan_run(checked, options);
    RunStudy study;
    study.output = task.motion.output;
    study.ratio = task.motion.ratio();
    study.elastic = elastic;
    study.torque = task.torque;
    study.spline_torque = task.motion.spline_torque(task.torque);
    PositionProgress told(progress, positions_of(checked, task, options.errors));
    SequenceObserver const observer{options.stop, [&] { told.step(); },
                                    [&](std::string const& cause) { study.missing.push_back(cause); }};
    surface::SurfaceSpec const spec = contact::surface_choices(checked, {}).front();
    if (elastic)
        run_elastic(*data, task, options, observer, spec, study);
    else
        data->clock.run(Stage::run, [&] { run_prescribed(*data, task, options, observer, spec, study); });
    if (study.sequences.empty() && options.stop && options.stop())
        throw NumericalError(ErrorCode::stopped, "run", "positions", "the run was stopped before the first");
    if (study.sequences.empty())
        throw NumericalError(ErrorCode::not_converged, "run", "positions of the wave generator", study.missing.front(),
                             "write a smaller torque, or another circular_spline.backlash_offset");
    if (std::optional<std::string> note = load::note_on_bent_cup(scene, checked); elastic && note)
        study.solution.notes.push_back(std::move(*note));
    if (!elastic && checked.errors && checked.errors->wave_generator)
        study.solution.notes.emplace_back(
            "errors.wave_generator has no effect without a torque: set load.torque, or --torque above 0");
    study.solution.notes.insert(study.solution.notes.end(), study.missing.begin(), study.missing.end());
    study.solution.plan = plan_run(scene, options);
    study.solution.scene = scene;
    std::ranges::copy(data->clock.times(), std::back_inserter(study.solution.timing));
    return study;
}

}  // namespace hdconj
