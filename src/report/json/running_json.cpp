// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "figures/running_figures.hpp"
#include "hdconj/running_files.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

Json sequence_object(RunSequence const& sequence)
{
    bool const under_torque = sequence.torque != 0;
    Json object = {{"span", to_string(sequence.span)}, {"torque_Nm", number(sequence.torque * per_newton_metre)}};
    add_figures(object, figures::run_sequence_figures(under_torque), sequence, sequence.estimated);
    object["positions"] = list_of(sequence.positions, [&](RunPosition const& each) {
        return figures_object(figures::run_position_rows(under_torque), each, sequence.estimated);
    });
    object["spectrum"] = list_of(sequence.orders, [&](RunOrder const& each) {
        return figures_object(figures::run_order_rows(), each, sequence.estimated);
    });
    return object;
}

Json losses_object(RunLosses const& losses)
{
    Json object = figures_object(figures::run_loss_figures(), losses, losses.estimated);
    auto const back = figures::back_driving_figures();
    object[back["back_driving_torque"].json_key()] = nullptr;
    if (losses.back_driving)
        add_figures(object, back, {*losses.back_driving, losses.back_driving_error}, losses.estimated);
    object["efficiency"] = list_of(losses.efficiency, [&](EfficiencyRow const& each) {
        return figures_object(figures::efficiency_rows(), each, losses.estimated);
    });
    return object;
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(RunStudy const& study, std::vector<WrittenFile> const& written)
{
    using report::Json, report::list_of;
    Json result = report::summary_object(study.solution);
    Json running = {{"output", to_string(study.output)}, {"elastic", study.elastic}};
    report::add_figures(running, figures::run_study_figures(), study);
    running["sequences"] = list_of(study.sequences, report::sequence_object);
    running["losses"] = study.losses ? report::losses_object(*study.losses) : Json(nullptr);
    running["missing"] = study.missing;
    result["running"] = std::move(running);
    return report::finished(std::move(result), study.solution, written);
}

}  // namespace hdconj
