// SPDX-License-Identifier: GPL-3.0-or-later
// A drive of a report from a stored result.
#include "stored_drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <utility>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "io/layout/results.hpp"
#include "page_data.hpp"
#include "stored_result.hpp"

namespace hdconj {
namespace {

using io::layout::Misfit;
using io::layout::require;
using io::layout::StoredGroup;
using report::Json;

/// The parts that the result holds, as the page has them when they are computed.
Json stored_parts(StoredGroup const& result)
{
    require(result.attribute<int>("format_version") == io::layout::format_version,
            "it was written by an older version of hdconj");
    int const balls = result.holds("load") ? result.group("load")->attribute<int>("balls") : 0;
    io::layout::RecordedGroup const layout = io::layout::whole_layout(balls);
    Json parts;
    for (auto const& [part, group] : {std::pair("solve", "circular_spline"), std::pair("contact", "contact"),
                                      std::pair("load", "load"), std::pair("run", "running")}) {
        if (!result.holds(group))
            continue;
        report::JsonGroup root(report::left_of_part(part));
        io::layout::read_layout(result, layout, root);
        parts[part] = root.json();
    }
    return parts;
}

}  // namespace

bool is_result_file(std::filesystem::path const& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
    if (ending == ".h5" || ending == ".hdf5")
        return true;
    constexpr std::array<char, 8> signature = {'\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n'};
    std::array<char, signature.size()> first = {};
    std::error_code error;
    return std::filesystem::is_regular_file(file, error) &&
           std::ifstream(file, std::ios::binary).read(first.data(), first.size()) && first == signature;
}

namespace report {

ReportedDrive drive_from(StoredGroup const& result, std::filesystem::path const& file)
{
    StoredOutline stored = io::layout::stored_outline(result);
    auto const made = std::make_shared<report::StoredResult>();
    ReportedDrive drive;
    drive.stored = made;
    try {
        made->parts = stored_parts(result);
        drive.origin =
            fmt::format("Read from {}, which hdconj {} wrote at {}.", file.filename().string(),
                        result.attribute<std::string>("program_version"), result.attribute<std::string>("date"));
    } catch (Json::exception const&) {
        throw Misfit("parts of it are missing or damaged");
    }
    scene::SceneReading reading = examine_stored_scene(stored, file);
    if (!reading.faults.empty())
        throw InputError(Fault{file.string(), 0, "",
                               fmt::format("holds a scene that this version refuses, {} fault{}, the first: {}",
                                           reading.faults.size(), reading.faults.size() == 1 ? "" : "s",
                                           reading.faults.front().path + " " + reading.faults.front().reason),
                               "solve a scene of this version anew"});
    drive.solution = std::move(stored.solution);
    drive.solution.scene = std::move(reading.scene);
    return drive;
}

}  // namespace report
}  // namespace hdconj
