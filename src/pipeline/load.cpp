// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/load.hpp"

#include <utility>

#include "hdconj/scene/reading.hpp"
#include "judgement/judgement.hpp"
#include "load/model/ring_errors.hpp"
#include "load/study/load_study.hpp"
#include "load/study/loaded_scene.hpp"
#include "load/study/twist_members.hpp"
#include "part_of_case.hpp"

namespace hdconj {
namespace {

/// What a study says of the drive, beside cup and cases.
void describe_drive(contact::ContactStudyData& data, load::ElasticDrive const& drive, LoadStudy& study)
{
    Scene const& scene = data.scene;
    study.solution = data.middle;
    study.solution.plan = data.plan;
    study.solution.notes.insert(study.solution.notes.end(), study.missing.begin(), study.missing.end());
    LoadCase const& written = study.cases[study.written_case];
    study.side_clearance = pipeline::write_part(
        study.solution, data, {written.surface, written.kind.value_or(TiltKind::radial), written.tilt}, written.tip,
        written.backlash_offset);
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
    load::LoadObserver const observer{progress, talk};
    auto const [data, standard_tip_increase] = load::contact_data(load::checked_scene(scene, options), on_stage);
    contact::ContactContext const& context = *data->context;
    drive::StageClock& clock = data->clock;
    load::LoadGrid const grid = load::load_grid(context);
    load::LoadModel model = clock.value_of(Stage::influence, [&] { return load::load_model(context, grid); });
    LoadStudy study;
    load::DriveGrids drives = clock.value_of(Stage::assembly, [&] {
        load::LoadedDrive unloaded = load::assembly(context, model.drive);
        load::DriveGrids assembled{{grid, std::move(model), std::move(unloaded)}};
        study.cup = load::assembled_cup(context, assembled.fine);
        return assembled;
    });
    load::tell_assembly(observer, study.cup);
    if (data->plan.has(Stage::compliance)) {
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
        load::add_cases(context, drives, options, observer, study);
    });
    describe_drive(*data, drives.fine.model.drive, study);
    study.solution.scene = scene;
    study.rated_torque = load::rated_torque(context.scene, options);
    study.standard_tip_increase = standard_tip_increase;
    return study;
}

}  // namespace hdconj
