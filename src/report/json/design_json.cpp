// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "hdconj/design_files.hpp"
#include "hdconj/version.hpp"
#include "summary_object.hpp"

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

Json row_object(DesignRow const& row)
{
    Json range = nullptr;
    if (row.range)
        range = {number(row.range->low), number(row.range->high)};
    return {{"name", row.name},    {"symbol", row.symbol}, {"key", row.key},
            {"rule", row.rule},    {"range", range},       {"value", value_object(row.value)},
            {"unit", row.unit},    {"source", row.source}, {"origin", to_string(row.origin)},
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
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(Design const& design, std::vector<WrittenFile> const& written)
{
    using report::Json;
    constexpr int format_version = 1;
    Json object = {{"format", "hdconj-design"},
                   {"format_version", format_version},
                   {"program_version", program_version()},
                   {"git_revision", git_revision()},
                   {"name", design.wishes.name},
                   {"rows", report::list_of(design.rows, report::row_object)},
                   {"mesh", report::list_of(design.mesh, report::trial_object)},
                   {"walls", report::list_of(design.walls, report::wall_object)},
                   {"remarks", design.remarks},
                   {"differences", report::list_of(design.differences, report::difference_object)}};
    object["files"] = report::files_object(written);
    return report::printed(object);
}

}  // namespace hdconj
