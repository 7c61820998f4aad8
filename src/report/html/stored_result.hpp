// SPDX-License-Identifier: GPL-3.0-or-later
// What a report shows of a result file.
#pragma once

#include "hdconj/report.hpp"
#include "report/json/summary_object.hpp"

namespace hdconj::report {

struct StoredResult
{
    Json parts = Json::object();  ///< by the word of ReportPart, as the page has them
};

[[nodiscard]] inline Json left_out_json(std::vector<LeftOut> const& left_out)
{
    return list_of(left_out, [](LeftOut const& each) -> Json {
        return {{"part", each.part}, {"why", each.why}, {"failed", each.failed}};
    });
}

[[nodiscard]] inline Json failed_json(std::vector<FailedDrive> const& failed)
{
    return list_of(failed, [](FailedDrive const& each) -> Json { return {{"name", each.name}, {"why", each.why}}; });
}

}  // namespace hdconj::report
