// SPDX-License-Identifier: GPL-3.0-or-later
// A drive of a report from a result file.
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <fstream>
#include <utility>

#include "hdconj/read_scene.hpp"
#include "hdconj/report.hpp"
#include "hdconj/result_files.hpp"
#include "io/hdf5/layout_reader.hpp"
#include "io/layout/results.hpp"
#include "page_data.hpp"
#include "stored_result.hpp"

namespace hdconj {
namespace {

using report::Json;
using namespace io::hdf5;

constexpr StoredKind result_file{"no result file that a report can show",
                                 "make it anew: hdconj solve, contact, load or run, each with -o FILE.h5", nullptr};

/// The parts that the file holds, as the page has them when they are computed.
Json parts_of(File const& file)
{
    require(number_of(file, "format_version") == io::layout::format_version,
            "it was written by an older version of hdconj");
    auto const holds = [&](char const* name) { return H5Lexists(file, name, H5P_DEFAULT) > 0; };
    int balls = 0;
    if (holds("load")) {
        Group const load(H5Gopen2(file, "load", H5P_DEFAULT), "open a group");
        balls = number_of(load, "balls");
    }
    io::layout::RecordedGroup const layout = io::layout::whole_layout(balls);
    Json parts;
    for (auto const& [part, group] : {std::pair("solve", "circular_spline"), std::pair("contact", "contact"),
                                      std::pair("load", "load"), std::pair("run", "running")}) {
        if (!holds(group))
            continue;
        report::JsonGroup root(report::left_of_part(part));
        read_layout(file, layout, root);
        parts[part] = root.json();
    }
    return parts;
}

/// A figure of the summary that the page cannot do without.
double summary_figure(Json const& attributes, char const* name)
{
    require(attributes.contains(name) && attributes.at(name).is_number(), "its summary has gaps");
    return attributes.at(name).get<double>();
}

Notes notes_of(Json const& solve)
{
    Notes notes;
    if (!solve.at("groups").contains("notes"))
        return notes;
    Json const& columns = solve.at("groups").at("notes").at("datasets");
    auto const text = [&](char const* name, std::size_t i) -> std::string {
        return columns.at(name).at("texts").at(i).get<std::string>();
    };
    for (std::size_t i = 0; i < columns.at("cause").at("texts").size(); ++i) {
        Note& note = notes.emplace_back();
        note.code = from_word<NoteCode>(text("code", i)).value_or(note.code);
        note.severity = from_word<Severity>(text("severity", i)).value_or(Severity::warning);
        note.place = text("place", i);
        note.cause = text("cause", i);
        note.advice = text("advice", i);
    }
    return notes;
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

ReportedDrive read_drive(std::filesystem::path const& file)
{
    StoredOutline stored = read_outline(file);
    auto const made = std::make_shared<report::StoredResult>();
    ReportedDrive drive;
    drive.stored = made;
    Solution& solution = drive.solution;
    read_stored(file, result_file, [&](File const& opened) {
        try {
            made->parts = parts_of(opened);
            Json const& solve = made->parts.at("solve");
            Json const& summary = solve.at("groups").at("summary").at("attributes");
            solution.geometry.circular_spline_inner_radius = summary_figure(summary, "tip_radius_mm");
            solution.error.chord = summary_figure(summary, "error_chord_mm");
            solution.error.point = summary_figure(summary, "error_point_mm");
            solution.judgement = notes_of(solve);
            solution.notes = solve.at("attributes").value("notes", std::vector<std::string>{});
            drive.origin = fmt::format("Read from {}, which hdconj {} wrote at {}.", file.filename().string(),
                                       text_of(opened, "program_version"), text_of(opened, "date"));
        } catch (Json::exception const&) {
            throw Misfit("parts of it are missing or damaged");
        }
        return true;
    });
    scene::SceneReading reading = examine_scene(stored.scene, file.string());
    examine_geometry(reading);
    if (!reading.faults.empty())
        throw InputError(Fault{file.string(), 0, "",
                               fmt::format("holds a scene that this version refuses, {} fault{}, the first: {}",
                                           reading.faults.size(), reading.faults.size() == 1 ? "" : "s",
                                           reading.faults.front().path + " " + reading.faults.front().reason),
                               "solve a scene of this version anew"});
    solution.scene = std::move(reading.scene);
    solution.circular_spline = std::move(stored.outline);
    return drive;
}

}  // namespace hdconj
