// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/load.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "contact/study/surface_choices.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/units.hpp"
#include "judgement/judgement.hpp"
#include "load/grids/cup_error.hpp"
#include "load/model/cup_shape.hpp"
#include "load/model/ring_errors.hpp"
#include "load/study/load_case.hpp"
#include "load/study/loaded_scene.hpp"
#include "load/study/twist_members.hpp"
#include "part_of_case.hpp"

namespace hdconj {
namespace {

/// Who is told of a study while it is computed.
struct LoadObserver
{
    Progress progress;
    std::function<void(std::string const&)> talk;  ///< first figures in words
};

void tell_play(LoadObserver const& observer, LoadCase const& known)
{
    if (observer.talk)
        observer.talk(fmt::format("{}{}: side clearance {:.1f} um, backlash {:.2f} arcmin", to_string(known.surface),
                                  known.tilt != 0 ? fmt::format(" {:.2f} deg", to_deg(known.tilt)) : "",
                                  per_um * known.backlash_offset, per_arcmin * known.backlash));
}

double rated_line_load(LoadCase const& each)
{
    return each.curve[each.rated].largest_line_load;
}

void tell_assembly(LoadObserver const& observer, AssembledCup const& cup)
{
    if (observer.talk)
        observer.talk(
            fmt::format("assembled: wave generator {:.0f} N, coning {:.3f} and {:.3f} deg at the major and minor axis, "
                        "cup {:.0f} MPa",
                        cup.wave_generator_force, to_deg(std::atan(cup.coning_major)),
                        to_deg(std::atan(cup.coning_minor)), cup.largest_stress));
}

/// Adds every case that scene and options ask for to @p study, names those that are missing, and draws the cup of the
/// case shown.
/// @throws NumericalError of the first case where none can be computed
void add_cases(contact::ContactStudyData& data, load::DriveGrids const& drives, LoadOptions const& options,
               LoadObserver const& observer, LoadStudy& study)
{
    contact::ContactContext const& context = *data.context;
    std::vector<surface::SurfaceSpec> const surfaces =
        contact::surface_choices(context.scene, load::contact_options(options));
    load::LoadingPath const torques = load::loading_path(context.scene, options);
    study.missing = contact::impossible_choices(load::contact_options(options));
    std::optional<NumericalError> first;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        load::CaseObserver const told{[&](LoadCase const& known) { tell_play(observer, known); },
                                      [&](double fraction) {
                                          if (observer.progress)
                                              observer.progress("load", (static_cast<double>(i) + fraction) /
                                                                            static_cast<double>(surfaces.size()));
                                      }};
        try {
            if (torques.forth.is_stopped())
                throw NumericalError(ErrorCode::stopped, "load", "torques", "the run was stopped before");
            load::SolvedCase solved = load::load_case(context, drives, surfaces[i], torques, told);
            for (auto const& [torque, cause] : solved.result.unsettled)
                study.missing.push_back(fmt::format("no result at {:g} N m for {}: {}", torque / newton_metre,
                                                    contact::spec_words(surfaces[i]), cause));
            if (study.cases.empty() ||
                rated_line_load(solved.result) < rated_line_load(study.cases[study.written_case])) {
                study.solution =
                    pipeline::solution_with_part(data, {surfaces[i], solved.result.tip, solved.result.backlash_offset});
                study.written_case = study.cases.size();
                study.shape = load::cup_shape(drives.fine.model, solved.field, context.threads);
                study.teeth = std::move(solved.teeth);
            }
            study.cases.push_back(std::move(solved.result));
        } catch (NumericalError const& error) {
            study.missing.push_back(contact::no_row(surfaces[i], error.what()));
            if (!first)
                first.emplace(error);
        }
    }
    if (study.cases.empty())
        throw NumericalError(*first);
}

/// What a study says of the drive, beside cup and cases.
void describe_drive(contact::ContactStudyData& data, load::ElasticDrive const& drive, LoadStudy& study)
{
    Scene const& scene = data.scene;
    study.solution.plan = data.plan;
    study.solution.notes.insert(study.solution.notes.end(), study.missing.begin(), study.missing.end());
    LoadCase const& written = study.cases[study.written_case];
    if (auto const note =
            written.tips ? judgement::tip_interference(written.backlash, written.tips->depth, written.tips->least_tip)
                         : judgement::backlash(scene, written.backlash, written.backlash_offset, ""))
        study.solution.judgement.push_back(*note);
    std::vector<StageTime> const times = data.clock.times();
    study.solution.timing.insert(study.solution.timing.end(), times.begin(), times.end());
    study.harmonics = drive.response->harmonics().back().n;
    study.sectors = drive.response->sectors();
    study.contact_gap = data.context->request.gap;
    study.pitch_radius = scene.drive.module * scene.drive.flexspline_teeth / 2;
    study.edge_radius = load::edge_radius(scene);
    study.pitch_errors = load::pitch_errors(scene);
    study.balls = scene.bearing->balls.value_or(0);
    study.ball_constant = drive.balls ? drive.balls->hertz.value_or(0) : 0;
    Cup const& cup = *scene.flexspline.cup;
    study.sharp_steps = scene.flexspline.wall != cup.barrel_wall && !(cup.rear_fillet && cup.front_fillet);
}

}  // namespace

LoadStudy study_load(Scene const& scene, LoadOptions const& options, StageObserver const& on_stage,
                     Progress const& progress, std::function<void(std::string const&)> const& talk)
{
    throw_if_any(scene::value_faults(scene));
    LoadObserver const observer{progress, talk};
    load::LoadedDriveData const loaded =
        load::contact_data(load::checked_scene(scene, options), options.errors, on_stage);
    contact::ContactStudyData& data = *loaded.data;
    contact::ContactContext const& context = *data.context;
    drive::StageClock& clock = data.clock;
    load::LoadGrid const grid = load::load_grid(context);
    load::LoadModel model = clock.value_of(Stage::influence, [&] { return load::load_model(context, grid); });
    LoadStudy study;
    load::DriveGrids drives = clock.value_of(Stage::assembly, [&] {
        load::LoadedDrive unloaded = load::assembly(context, model.drive);
        load::DriveGrids assembled{{grid, std::move(model), std::move(unloaded)}};
        study.cup = load::assembled_cup(context, assembled.fine);
        return assembled;
    });
    tell_assembly(observer, study.cup);
    if (data.plan.has(Stage::compliance)) {
        PairGeometry const& g = context.geometry;
        double const side_clearance = context.scene.is_reverse() ? 0 : context.scene.circular_spline.backlash_offset;
        double const root = g.circular_spline_inner_radius + g.space_depth + side_clearance;
        drives.series = clock.value_of(Stage::compliance, [&] { return load::series_members(context.scene, root); });
    }
    clock.run(Stage::load, [&] {
        constexpr std::size_t coarser_grids = 2;
        if (options.errors)
            drives.coarser = load::coarser_drives(context, coarser_grids);
        if (!drives.coarser.empty())
            load::estimate_errors(context, drives, study.cup);
        add_cases(data, drives, options, observer, study);
    });
    if (std::optional<std::string> note = load::note_on_bent_cup(scene, context.scene))
        study.solution.notes.push_back(std::move(*note));
    describe_drive(data, drives.fine.model.drive, study);
    study.solution.scene = scene;
    study.rated_torque = load::rated_torque(context.scene, options);
    study.standard_tip_increase = loaded.standard_tip_increase;
    return study;
}

}  // namespace hdconj
