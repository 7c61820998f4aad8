// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "figures/load_figures.hpp"
#include "figures/measured_figures.hpp"
#include "hdconj/load_files.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

using States = figures::Rows<LoadedState>;

Json error_object(States const& rows, LoadedState const* error)
{
    return error != nullptr ? errors_object(rows, *error) : Json(nullptr);
}

Json bearing_object(BearingMap const& bearing, States const& rows)
{
    auto const degrees = [](double angle) { return number(figures::unit::degree.shown(angle)); };
    Json object = {{"angle_deg", list_of(bearing.angle, degrees)},
                   {"z_mm", list_of(bearing.z, number)},
                   {"force_N", Json::array()},
                   {"ball_angle_deg", list_of(bearing.ball_angle, degrees)}};
    for (std::size_t i = 0; i < bearing.angle.size(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < bearing.z.size(); ++j)
            sum += bearing.force.at(i * bearing.z.size() + j);
        object["force_N"].push_back(number(sum));
    }
    auto const& ball = rows["ball_force"];
    object[ball.json_key()] = list_of(bearing.ball_force, number);
    auto const& errors = bearing.ball_force_error;
    object["ball_force_error" + ball.unit.suffix()] = errors.empty() ? Json(nullptr) : list_of(errors, number);
    return object;
}

Json load_case_object(LoadCase const& each, int balls)
{
    States const rows = figures::loaded_state_figures(balls);
    Json object = {{"surface", to_string(each.surface)}, {"kind", to_string(each.kind)}};
    add_figures(object, figures::load_case_figures(), each, each.estimated);
    auto const* rated = figures::rated_state(each);
    object["rated"] = rated != nullptr ? figures_object(rows, *rated) : Json(nullptr);
    object["rated_error"] = error_object(rows, each.estimated ? &each.error : nullptr);
    object["pressure_at_edge"] = each.pressure_at_edge;
    object["not_converged"] = figures::unconverged_figures(each, balls);
    object["bearing"] = bearing_object(each.bearing, rows);
    for (auto const& [torque, cause] : each.unsettled)
        object["unsettled"].push_back({{"torque_Nm", number(torque / newton_metre)}, {"cause", cause}});
    if (each.catalogue)
        object["catalogue"] = figures_object(figures::catalogue_rows(), *each.catalogue, each.catalogue->estimated);
    object["members"] = Json::array();
    for (TwistMember const& member : each.members) {
        object["members"].push_back({{"name", member.name}});
        add_figures(object["members"].back(), figures::twist_member_rows(), member, each.estimated);
    }
    object["curve"] = Json::array();
    for (std::size_t i = 0; i < each.curve.size(); ++i) {
        Json state = figures_object(rows, each.curve[i]);
        state["error"] = error_object(rows, figures::error_of(each, i));
        object["curve"].push_back(std::move(state));
    }
    return object;
}

Json cup_object(AssembledCup const& cup, figures::Rows<AssembledCup> const& rows)
{
    Json object = figures_object(rows, cup);
    object["error"] = cup.estimated ? errors_object(rows, cup) : Json(nullptr);
    object["displacement_error_mm"] = cup.estimated ? number(cup.displacement_error) : Json(nullptr);
    object["slices"] = Json::array();
    for (std::size_t k = 0; k < cup.z.size(); ++k) {
        object["slices"].push_back({{"z_mm", number(cup.z[k])},
                                    {"w_major_mm", number(cup.w_major.at(k))},
                                    {"w_minor_mm", number(cup.w_minor.at(k))}});
    }
    return object;
}

Json estimate_object(figures::MeasuredFigure const& figure, MeasuredStiffness const& found)
{
    Estimate const& estimate = figure.value(found);
    if (estimate.count == 0)
        return nullptr;
    return {{"value" + figure.unit.suffix(), number(figure.unit.shown(estimate.value))},
            {"error" + figure.unit.suffix(), number(figure.unit.shown(estimate.error))},
            {"count", estimate.count}};
}

Json measured_object(Measurement const& measured)
{
    auto const& [curve, found] = measured;
    Json object = {{"path", curve.file},
                   {"columns", curve.columns},
                   {"samples", curve.twist.size()},
                   {"ratio", number(curve.rig.ratio)},
                   {"angle_per_spline", number(curve.rig.angle_per_spline)}};
    if (curve.rig.torque_constant != 0) {
        object["torque_constant_Nm_per_A"] = number(curve.rig.torque_constant);
        object["efficiency"] = number(curve.rig.efficiency);
    }
    if (curve.rig.counts_per_turn != 0)
        object["counts_per_turn"] = number(curve.rig.counts_per_turn);
    add_figures(object, figures::measured_curve_figures(), found);
    for (auto const& figure : figures::measured_figures())
        add(object, figure.name, estimate_object(figure, found));
    return object;
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(LoadStudy const& study, std::vector<WrittenFile> const& written, Measurement const* measured)
{
    auto load = report::figures_object(figures::load_study_figures(), study);
    load["cup"] = report::cup_object(study.cup, figures::assembled_cup_figures(study.balls));
    load["cases"] =
        report::list_of(study.cases, [&](auto const& each) { return report::load_case_object(each, study.balls); });
    auto const add_pitch_errors = [&](char const* key, std::vector<double> const& places) {
        if (!places.empty())
            load[key] = report::list_of(places, [](double place) { return report::number(per_um * place); });
    };
    add_pitch_errors("flexspline_pitch_errors_um", study.pitch_errors.flexspline);
    add_pitch_errors("circular_spline_pitch_errors_um", study.pitch_errors.circular_spline);
    if (measured != nullptr)
        load["measured"] = report::measured_object(*measured);
    auto summary = report::summary_object(study.solution);
    summary["load"] = std::move(load);
    return report::finished(std::move(summary), study.solution, written);
}

std::string summary_json(Measurement const& measured)
{
    return report::indented(report::measured_object(measured));
}

}  // namespace hdconj
