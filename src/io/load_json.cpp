// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/json.md.
#include <span>

#include "load_figures.hpp"
#include "summary_figures.hpp"
#include "summary_object.hpp"

namespace hdconj {
namespace {

template <class Record>
void add_figures(Json& object, std::span<LoadFigure<Record> const> figures, Record const& record)
{
    for (auto const& figure : figures) {
        object[figure.key] = number(figure.value(record) * figure.json_per_stored);
    }
}

Json state_object(LoadedState const& state)
{
    Json object = Json::object();
    add_figures(object, loaded_state_figures(), state);
    object["teeth"] = state.teeth;
    object["pressure_space"] = state.pressure_space;
    object["rounds"] = state.rounds;
    object["steps"] = state.steps;
    return object;
}

Json case_object(LoadCase const& each)
{
    Json object = {{"surface", each.surface}, {"kind", each.kind}};
    add_figures(object, load_case_figures(), each);
    object["raised"] = each.raised;
    object["stages_found"] = each.stages.found;
    auto const* rated = rated_state(each);
    object["rated"] = rated != nullptr ? state_object(*rated) : Json(nullptr);
    object["curve"] = Json::array();
    for (auto const& state : each.curve) {
        object["curve"].push_back(state_object(state));
    }
    return object;
}

Json cup_object(AssembledCup const& cup)
{
    Json object = Json::object();
    add_figures(object, assembled_cup_figures(), cup);
    object["contacts"] = cup.contacts;
    object["slices"] = Json::array();
    for (std::size_t k = 0; k < cup.z.size(); ++k) {
        object["slices"].push_back({{"z_mm", number(cup.z[k])}, {"w_major_mm", number(cup.w_major.at(k))}, {"w_minor_mm", number(cup.w_minor.at(k))}});
    }
    return object;
}

Json measured_object(Measurement const& measured)
{
    auto const& [curve, found] = measured;
    Json object = {{"path", curve.file}, {"columns", curve.columns}, {"samples", curve.twist.size()}, {"ratio", number(curve.rig.ratio)}};
    if (curve.rig.torque_constant != 0) {
        object["torque_constant_Nm_per_A"] = number(curve.rig.torque_constant);
        object["efficiency"] = number(curve.rig.efficiency);
    }
    if (curve.rig.counts_per_turn != 0) {
        object["counts_per_turn"] = number(curve.rig.counts_per_turn);
    }
    object["cycles"] = found.cycles;
    object["straight_branches"] = found.straight;
    object["largest_torque_Nm"] = number(found.largest_torque * nm_per_nmm);
    object["angle_step_arcmin"] = number(found.angle_step * arcmin_per_radian);
    object["middle_arcmin"] = number(found.middle * arcmin_per_radian);
    for (auto const& figure : measured_figures()) {
        Estimate const& estimate = figure.value(found);
        object[figure.name] = nullptr;
        if (estimate.count > 0) {
            std::string const unit = std::string("_") + figure.key_unit;
            object[figure.name] = {{"value" + unit, number(estimate.value * figure.shown_per_stored)},
                                   {"error" + unit, number(estimate.error * figure.shown_per_stored)},
                                   {"count", estimate.count}};
        }
    }
    return object;
}

}  // namespace

std::string summary_json(LoadStudy const& study, std::vector<WrittenFile> const& written, Measurement const* measured)
{
    Json load = {{"rated_torque_Nm", number(study.rated_torque * nm_per_nmm)},
                 {"contact_gap_um", number(study.contact_gap * um_per_mm)},
                 {"pitch_radius_mm", number(study.pitch_radius)},
                 {"harmonics", study.harmonics},
                 {"sectors", study.sectors},
                 {"shown", study.shown},
                 {"cup", cup_object(study.cup)}};
    load["cases"] = Json::array();
    for (auto const& each : study.cases) {
        load["cases"].push_back(case_object(each));
    }
    if (measured != nullptr) {
        load["measured"] = measured_object(*measured);
    }
    auto summary = summary_object(study.solution);
    summary["load"] = std::move(load);
    return finished(std::move(summary), study.solution, written);
}

}  // namespace hdconj
