// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/json.md.
#include "contact_figures.hpp"
#include "hdconj/io/contact_files.hpp"
#include "summary_figures.hpp"
#include "summary_object.hpp"

namespace hdconj {
namespace {

Json state_object(ContactState const& state, ContactStudy const& study)
{
    Json object = Json::object();
    add_figures(object, state_figures(), state);
    object["backlash_um"] = number(at_pitch_circle(state.backlash(), study) * um_per_mm);
    object["backlash_error_um"] = number(at_pitch_circle(state.backlash_error(), study) * um_per_mm);
    object["teeth"] = state.teeth;
    object["teeth_least"] = state.teeth_least;
    object["teeth_most"] = state.teeth_most;
    object["smallest_space"] = state.smallest_space;
    object["smallest_spaces"] = state.smallest_spaces;
    return object;
}

Json closest_object(Closest const& closest, double error)
{
    return {{"clearance_um", number(closest.clearance * um_per_mm)},
            {"clearance_error_um", number(error * um_per_mm)},
            {"x_mm", number(closest.where.x())},
            {"y_mm", number(closest.where.y())},
            {"phi_deg", number(closest.phi * degree_per_radian)}};
}

Json slice_object(SliceClearance const& slice)
{
    return {{"z_mm", number(slice.z)},
            {"amplitude_mm", number(slice.amplitude)},
            {"flank", closest_object(slice.flank, slice.flank_error)},
            {"root", closest_object(slice.root, slice.root_error)}};
}

Json case_object(ContactCase const& each, ContactStudy const& study)
{
    Json object = {{"surface", each.surface}, {"kind", each.kind}};
    add_figures(object, case_figures(), each);
    object["backlash_of_clearing_um"] = number(at_pitch_circle(each.backlash_of_clearing, study) * um_per_mm);
    object["backlash_of_clearing_error_um"] = number(at_pitch_circle(each.backlash_of_clearing_error, study) * um_per_mm);
    object["raised"] = each.raised;
    object["closest_flank"] = nullptr;
    if (!each.slices.empty()) {
        object["closest_flank"] = closest_object(each.closest_flank(), each.clearance_error);
        object["closest_flank"]["z_mm"] = number(each.closest_slice().z);
    }
    object["state"] = state_object(each.state, study);
    object["slices"] = Json::array();
    for (auto const& slice : each.slices) {
        object["slices"].push_back(slice_object(slice));
    }
    object["revolution"] = Json::array();
    for (auto const& state : each.revolution) {
        object["revolution"].push_back(state_object(state, study));
    }
    return object;
}

Json best_object(BestTilt const& best)
{
    bool const area = best.what == "area";
    return {{"what", best.what},
            {"kind", best.kind},
            {"tilt_deg", number(degrees_of(best.tilt))},
            {"tolerance_deg", number(best.tolerance * degree_per_radian)},
            {area ? "share" : "clearing_offset_um", number(area ? best.value : best.value * um_per_mm)},
            {area ? "share_error" : "clearing_offset_error_um", number(area ? best.value_error : best.value_error * um_per_mm)},
            {"on_bound", best.on_bound},
            {"refused", best.refused},
            {"possible_from_deg", number(degrees_of(best.possible_from))},
            {"possible_to_deg", number(degrees_of(best.possible_to))},
            {"from_deg", number(degrees_of(best.from))},
            {"to_deg", number(degrees_of(best.to))}};
}

}  // namespace

std::string summary_json(ContactStudy const& study, std::vector<WrittenFile> const& written)
{
    Json contact = {{"contact_gap_um", number(study.contact_gap * um_per_mm)},
                    {"pitch_radius_mm", number(study.pitch_radius)},
                    {"shown", study.shown}};
    contact["cases"] = Json::array();
    for (auto const& each : study.cases) {
        contact["cases"].push_back(case_object(each, study));
    }
    contact["best"] = Json::array();
    for (auto const& each : study.best) {
        contact["best"].push_back(best_object(each));
    }
    auto summary = summary_object(study.solution);
    summary["contact"] = std::move(contact);
    return finished(std::move(summary), study.solution, written);
}

}  // namespace hdconj
