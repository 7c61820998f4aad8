// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/json.md.
#include "load_figures.hpp"
#include "summary_figures.hpp"
#include "summary_object.hpp"

namespace hdconj {
namespace {

Json state_object(LoadedState const& state, LoadStudy const& study)
{
    Json object = Json::object();
    add_figures(object, loaded_state_figures(), state);
    object[ball_key(study)] = number(state.ball_force);
    object["balls"] = state.balls;
    object["teeth"] = state.teeth;
    object["pressure_space"] = state.pressure_space;
    object["rounds"] = state.rounds;
    object["steps"] = state.steps;
    return object;
}

Json error_object(LoadedState const& error, LoadStudy const& study)
{
    Json object = Json::object();
    add_figures(object, loaded_error_figures(), error);
    object[ball_key(study)] = number(error.ball_force);
    object["teeth"] = error.teeth;
    return object;
}

Json bearing_object(BearingMap const& bearing, LoadStudy const& study)
{
    Json object = {{"angle_deg", Json::array()}, {"z_mm", Json::array()}, {"force_N", Json::array()}, {"ball_angle_deg", Json::array()}, {ball_key(study), Json::array()}};
    for (double const angle : bearing.angle) {
        object["angle_deg"].push_back(number(angle * degree_per_radian));
    }
    for (double const z : bearing.z) {
        object["z_mm"].push_back(number(z));
    }
    for (std::size_t i = 0; i < bearing.angle.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < bearing.z.size(); ++j) {
            sum += bearing.force.at(i * bearing.z.size() + j);
        }
        object["force_N"].push_back(number(sum));
    }
    for (std::size_t b = 0; b < bearing.ball_angle.size(); ++b) {
        object["ball_angle_deg"].push_back(number(bearing.ball_angle[b] * degree_per_radian));
        object[ball_key(study)].push_back(number(bearing.ball_force.at(b)));
    }
    return object;
}

Json case_object(LoadCase const& each, LoadStudy const& study)
{
    Json object = {{"surface", each.surface}, {"kind", each.kind}};
    add_figures(object, load_case_figures(), each);
    object["raised"] = each.raised;
    object["stages_found"] = each.stages.found;
    auto const* rated = rated_state(each);
    object["rated"] = rated != nullptr ? state_object(*rated, study) : Json(nullptr);
    object["rated_error"] = each.estimated ? error_object(each.error, study) : Json(nullptr);
    object["backlash_error_arcmin"] = each.estimated ? number(each.backlash_error * arcmin_per_radian) : Json(nullptr);
    object["pressure_at_edge"] = each.pressure_at_edge;
    object["bearing"] = bearing_object(each.bearing, study);
    object["curve"] = Json::array();
    for (std::size_t i = 0; i < each.curve.size(); ++i) {
        Json state = state_object(each.curve[i], study);
        auto const* error = error_of(each, i);
        state["error"] = error != nullptr ? error_object(*error, study) : Json(nullptr);
        object["curve"].push_back(std::move(state));
    }
    return object;
}

Json cup_object(AssembledCup const& cup, LoadStudy const& study)
{
    Json object = Json::object();
    add_figures(object, assembled_cup_figures(), cup);
    object[ball_key(study)] = number(cup.ball_force);
    object["balls"] = cup.balls;
    object["error"] = nullptr;
    if (cup.estimated) {
        object["error"] = {{"coning_major_deg", number(cup.coning_major_error * degree_per_radian)},
                           {"coning_minor_deg", number(cup.coning_minor_error * degree_per_radian)},
                           {"wave_generator_force_N", number(cup.wave_generator_force_error)},
                           {"largest_stress_MPa", number(cup.largest_stress_error)},
                           {ball_key(study), number(cup.ball_force_error)}};
    }
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
    Json object = {{"path", curve.file}, {"columns", curve.columns}, {"samples", curve.twist.size()}, {"ratio", number(curve.rig.ratio)},
                   {"angle_per_spline", number(curve.rig.angle_per_spline)}};
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
                 {"edge_radius_um", number(study.edge_radius * um_per_mm)},
                 {"tip_widened_um", number(study.tip_widened * um_per_mm)},
                 {"balls", study.balls},
                 {"sharp_steps", study.sharp_steps},
                 {"cup", cup_object(study.cup, study)}};
    load["cases"] = Json::array();
    for (auto const& each : study.cases) {
        load["cases"].push_back(case_object(each, study));
    }
    if (measured != nullptr) {
        load["measured"] = measured_object(*measured);
    }
    auto summary = summary_object(study.solution);
    summary["load"] = std::move(load);
    return finished(std::move(summary), study.solution, written);
}

}  // namespace hdconj
