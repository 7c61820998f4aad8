// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "figures/inspect_figures.hpp"
#include "hdconj/inspect_files.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

Json flank_object(FlankFigures const& flank)
{
    Json object = {{"flank", figures::flank_word(flank.right)}};
    add_figures(object, figures::flank_rows(), flank);
    return object;
}

Json side_object(SideFigures const& side)
{
    Json object = {{"flank", figures::flank_word(side.right)}};
    add_figures(object, figures::side_rows(), side);
    object["pitch"] = side.pitches > 0 ? figures_object(figures::pitch_rows(), side) : Json(nullptr);
    return object;
}

Json plane_object(PlaneFigures const& plane)
{
    Json object = figures_object(figures::plane_rows(), plane);
    object["shift_of_teeth"] = plane.circle ? figures_object(figures::eccentricity_rows(), plane) : Json(nullptr);
    return object;
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(Inspection const& inspection, std::vector<WrittenFile> const& written)
{
    using report::list_of;
    auto result = report::format_heading("hdconj-inspection", 1);
    result.update({{"drive", inspection.scene.drive.name},
                   {"part", to_string(inspection.options.part)},
                   {"points_file", inspection.file},
                   {"registration", to_string(inspection.options.registration)}});
    report::add_figures(result, figures::inspection_figures(), inspection);
    result["placement"] = report::figures_object(figures::placement_figures(), inspection.placement);
    result["nominal"] = list_of(inspection.nominal, [](NominalFigures const& each) {
        return report::figures_object(figures::nominal_figures(), each);
    });
    result["planes"] = list_of(inspection.planes, report::plane_object);
    result["sides"] = list_of(inspection.sides, report::side_object);
    result["flanks"] = list_of(inspection.flanks, report::flank_object);
    result["teeth"] = list_of(
        inspection.teeth, [](ToothFigures const& each) { return report::figures_object(figures::tooth_rows(), each); });
    result["notes"] = inspection.notes;
    result["files"] = report::files_object(written);
    return report::printed(result);
}

}  // namespace hdconj
