// SPDX-License-Identifier: GPL-3.0-or-later
// What the verb `report` wrote, as JSON.
#include <filesystem>

#include "hdconj/report.hpp"
#include "report/html/stored_result.hpp"
#include "summary_object.hpp"

namespace hdconj {
namespace report {
namespace {

Json parts_of(ReportedDrive const& drive)
{
    Json parts = Json::array();
    if (drive.stored)
        for (auto const& each : drive.stored->parts.items())
            parts.push_back(each.key());
    else
        parts.push_back("solve");
    for (auto const& [name, is_there] :
         {std::pair{"contact", drive.contact.has_value()}, std::pair{"load", drive.load.has_value()},
          std::pair{"run", drive.run.has_value()}, std::pair{"wedm", !drive.wire.empty()},
          std::pair{"design", drive.design.has_value()}})
        if (is_there)
            parts.push_back(name);
    return parts;
}

Json drive_object(ReportedDrive const& drive)
{
    return {{"name", drive.solution.scene.drive.name},
            {"origin", drive.origin.empty() ? Json(nullptr) : Json(drive.origin)},
            {"parts", parts_of(drive)},
            {"teeth_in_mesh", drive.teeth.has_value()},
            {"left_out", left_out_json(drive.left_out)}};
}

}  // namespace
}  // namespace report

std::string summary_json(Report const& made, std::vector<WrittenFile> const& written)
{
    auto object = report::format_heading("hdconj-report", 1);
    object["drives"] = report::list_of(made.drives, report::drive_object);
    object["failed"] = report::failed_json(made.failed);
    object["files"] = report::files_object(written);
    for (WrittenFile const& file : written)
        object["files"][file.kind]["bytes"] = std::filesystem::file_size(file.file);
    return report::printed(object);
}

}  // namespace hdconj
