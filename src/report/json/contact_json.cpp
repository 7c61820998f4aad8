// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "figures/contact_figures.hpp"
#include "hdconj/contact_files.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

/// Adds the figures of @p record; angles of which the table says so also as a length at the pitch circle.
template <class Record>
Json with_lengths(Json object, figures::Rows<Record> const& rows, Record const& record, ContactStudy const& study)
{
    auto const length = [&](double angle) {
        return number(figures::unit::um.shown(figures::at_pitch_circle(angle, study)));
    };
    add_figures(object, rows, record, study.estimated);
    rows.for_each_name([&](auto const& figure) {
        if (!figure.as_length)
            return;
        object[figure.key_stem() + figures::unit::um.suffix()] = length(figure.value(record));
        object[figure.column_of_error() + figures::unit::um.suffix()] =
            study.estimated ? length(figure.error(record)) : Json(nullptr);
    });
    return object;
}

Json slice_object(SliceClearance const& slice, bool estimated)
{
    Json object = figures_object(figures::slice_figures(), slice);
    object["flank"] = figures_object(figures::closest_figures(), {slice.flank, slice.flank_error}, estimated);
    object["root"] = figures_object(figures::closest_figures(), {slice.root, slice.root_error}, estimated);
    return object;
}

Json closest_flank_object(ContactCase const& each, bool estimated)
{
    Json object = figures_object(figures::closest_figures(), {each.closest_flank(), each.clearance_error}, estimated);
    auto const height = figures::slice_figures()["z"];
    object[height.json_key()] = value_of(height, each.closest_slice());
    return object;
}

Json contact_case_object(ContactCase const& each, ContactStudy const& study)
{
    auto const state_object = [&](ContactState const& state) {
        return with_lengths(Json::object(), figures::state_figures(), state, study);
    };
    Json object = with_lengths({{"surface", to_string(each.surface)}, {"kind", to_string(each.kind)}},
                               figures::case_figures(), each, study);
    object["closest_flank"] = each.slices.empty() ? Json(nullptr) : closest_flank_object(each, study.estimated);
    object["state"] = state_object(each.state);
    object["slices"] = list_of(each.slices, [&](auto const& slice) { return slice_object(slice, study.estimated); });
    object["revolution"] = list_of(each.revolution, state_object);
    return object;
}

Json best_object(BestTilt const& best, bool estimated)
{
    Json object = {
        {"goal", figures::goal_name(best)}, {"what", figures::former_goal_name(best)}, {"kind", to_string(best.kind)}};
    add_figures(object, figures::best_tilt_figures(), best);
    auto const value = figures::best_value_figure(best);
    add_figures(object, figures::Rows<BestTilt>(&value, 1), best, estimated);
    return object;
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(ContactStudy const& study, std::vector<WrittenFile> const& written)
{
    auto contact = report::figures_object(figures::contact_study_figures(), study);
    contact["cases"] =
        report::list_of(study.cases, [&](ContactCase const& each) { return report::contact_case_object(each, study); });
    contact["best"] =
        report::list_of(study.best, [&](BestTilt const& best) { return report::best_object(best, study.estimated); });
    auto summary = report::summary_object(study.solution);
    summary["contact"] = std::move(contact);
    return report::finished(std::move(summary), study.solution, written);
}

}  // namespace hdconj
