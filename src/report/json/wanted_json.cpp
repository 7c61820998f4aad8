// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include "figures/wanted_figures.hpp"
#include "hdconj/version.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

constexpr int wanted_json_version = 1;

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(WantedCurve const& found, std::vector<WrittenFile> const& written)
{
    using report::Json, report::list_of;
    Json result = {{"format", "hdconj-neutral-curve"},     {"format_version", report::wanted_json_version},
                   {"program_version", program_version()}, {"git_revision", git_revision()},
                   {"drive", found.scene.drive.name},      {"kinematics", to_string(found.scene.solver.kinematics)}};
    report::add_figures(result, figures::wanted_figures(), found);
    result["ends"] = found.ends;
    result["rows"] = list_of(
        found.rows, [](WantedCurveRow const& row) { return report::figures_object(figures::wanted_rows(), row); });
    result["notes"] = found.notes;
    Json const stages = list_of(found.timing, [](StageTime const& entry) -> Json {
        return {{"stage", entry.stage}, {"seconds", report::number(entry.seconds)}};
    });
    result["timing"] = {{"threads", found.threads}, {"stages", stages}};
    result["files"] = report::files_object(written);
    return report::printed(result);
}

}  // namespace hdconj
