// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "design_object.hpp"
#include "hdconj/design_files.hpp"

namespace hdconj::report {
namespace {

Json value_object(scene::ParameterValue const& value)
{
    if (auto const* const rows = std::get_if<scene::NumberRows>(&value))
        return *rows;
    if (auto const* const text = std::get_if<std::string>(&value))
        return *text;
    return number(std::get<double>(value));
}

Json range_object(std::optional<DesignRange> const& range)
{
    return range ? Json{number(range->low), number(range->high)} : Json();
}

Json row_object(DesignRow const& row)
{
    return {{"name", row.name},
            {"symbol", row.symbol},
            {"key", row.key},
            {"rule", row.rule},
            {"range", range_object(row.range)},
            {"value", value_object(row.value)},
            {"unit", row.unit},
            {"source", row.source},
            {"origin", to_string(row.origin)},
            {"remark", row.remark}};
}

Json trial_object(MeshTrial const& trial)
{
    return {{"deformation_ratio", number(trial.ratio)},
            {"radial_deformation_mm", number(trial.w0)},
            {"tip_radius_mm", number(trial.tip_radius)},
            {"land_modules", number(trial.land)},
            {"flank_contact", number(trial.flank_contact)},
            {"lost_before_cusp", number(trial.lost)},
            {"refusal", trial.refusal}};
}

Json wall_object(WallTrial const& trial)
{
    return {{"wall_mm", number(trial.wall)},
            {"stress_assembled_MPa", number(trial.assembled)},
            {"stress_loaded_MPa", number(trial.loaded)},
            {"stress_loaded_error_MPa", number(trial.error)},
            {"side_clearance_mm", number(trial.side_clearance)},
            {"refusal", trial.refusal}};
}

Json difference_object(DesignDifference const& each)
{
    return {{"key", each.key}, {"here", each.here}, {"type_50", each.type_50}, {"why", each.why}};
}

}  // namespace

Json design_object(Design const& design)
{
    return {{"name", design.wishes.name},
            {"rows", list_of(design.rows, row_object)},
            {"mesh", list_of(design.mesh, trial_object)},
            {"walls", list_of(design.walls, wall_object)},
            {"remarks", design.remarks},
            {"differences", list_of(design.differences, difference_object)}};
}

Json beside_object(SceneDesign const& made)
{
    Json object = design_object(made.design);
    for (std::size_t i = 0; i < made.here.size(); ++i) {
        Json& row = object["rows"][i];
        row["written"] = made.design.rows[i].written();
        row["range"] = range_object(made.here[i].range);
        row["range_text"] = range_text(made.here[i].range);
        row["here"] = made.here[i].here;
        row["standing"] = to_string(made.here[i].standing);
    }
    object["derived"] = list_of(made.derived, [](DerivedWish const& wish) -> Json {
        return {{"option", wish.option}, {"value", wish.value}, {"from", wish.from}};
    });
    return object;
}

}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(Design const& design, std::vector<WrittenFile> const& written)
{
    auto object = report::format_heading("hdconj-design", 1);
    object.update(report::design_object(design));
    object["files"] = report::files_object(written);
    return report::printed(object);
}

}  // namespace hdconj
