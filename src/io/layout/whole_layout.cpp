// SPDX-License-Identifier: GPL-3.0-or-later
// The layout of a result that has every part.
#include <memory>

#include "results.hpp"

namespace hdconj::io {
namespace {

Solution solution_with_all()
{
    Solution solution;
    solution.scene.files.emplace("", std::make_shared<std::string const>());
    solution.check.emplace();
    solution.notes.emplace_back();
    solution.judgement.emplace_back();
    solution.branches.emplace_back();
    return solution;
}

ContactStudy contact_with_all()
{
    ContactStudy study;
    study.solution = solution_with_all();
    ContactCase& each = study.cases.emplace_back();
    each.slices.emplace_back();
    each.revolution.emplace_back();
    each.gaps = {{0}, {0, 0}};
    study.best.emplace_back();
    study.map = {{0}, {0}, {0}, {0, 0}};
    return study;
}

LoadStudy load_with_all(int balls)
{
    LoadStudy study;
    study.solution = solution_with_all();
    study.balls = balls;
    study.shape = {{0}, {0}, {{0, 0, 0}}, {0}, {0}, {0}, {0}, {0}, {0}};
    study.cup.estimated = true;
    study.teeth = {0, {0}, {0}, {Vec2::Zero()}, {0}};
    study.pitch_errors = {{0}, {0}};
    LoadCase& each = study.cases.emplace_back();
    each.curve.emplace_back().twist = 1;
    each.unsettled.emplace_back();
    each.members.emplace_back();
    each.catalogue.emplace();
    each.estimated = true;
    each.error.twist = 1;  // more than a third: the figure is named as not converged
    each.contacts.emplace_back();
    each.bearing = {{0}, {0}, {0}, {0}, {0}, {0}};
    LoadMap& map = each.map;
    map.z = map.angle = map.tooth_force = map.tooth_force_error = {0};
    map.force = map.line_load = map.pressure = map.gap = map.height = {0, 0};
    return study;
}

RunStudy run_with_all()
{
    RunStudy study;
    study.solution = solution_with_all();
    study.missing.emplace_back();
    RunSequence& sequence = study.sequences.emplace_back();
    sequence.torque = 1;
    sequence.estimated = true;
    sequence.positions.emplace_back();
    sequence.orders.emplace_back();
    RunLosses& losses = study.losses.emplace();
    losses.back_driving = 0;
    losses.efficiency.emplace_back();
    return study;
}

}  // namespace

layout::RecordedGroup layout::whole_layout(int balls)
{
    RecordedGroup root;
    LayoutRecorder recorder(root);
    write_result(Writer(recorder), contact_with_all());
    RecordedGroup loaded;
    LayoutRecorder of_load(loaded);
    Measurement const measured;
    write_result(Writer(of_load), load_with_all(balls), &measured);
    root.groups.push_back(std::move(loaded.groups.back()));
    RecordedGroup running;
    LayoutRecorder of_run(running);
    write_result(Writer(of_run), run_with_all());
    root.groups.push_back(std::move(running.groups.back()));
    return root;
}

}  // namespace hdconj::io
