// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a report: data as JSON between the parts of the page that web/ holds.
#include <algorithm>
#include <stdexcept>

#include "hdconj/contact_files.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/judgement.hpp"
#include "hdconj/load_files.hpp"
#include "hdconj/report.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/running_files.hpp"
#include "hdconj/version.hpp"
#include "hdconj/wire_files.hpp"
#include "io/layout/results.hpp"
#include "json_group.hpp"
#include "page_data.hpp"
#include "page_parts.hpp"
#include "report/json/design_object.hpp"
#include "static_chart.hpp"
#include "static_map.hpp"
#include "static_picture.hpp"
#include "static_text.hpp"
#include "static_wire.hpp"
#include "stored_result.hpp"

namespace hdconj::report {
namespace {

std::string page_part(std::string_view name)
{
    for (PagePart const& part : page_parts)
        if (part.name == name)
            return std::string(part.text);
    throw std::logic_error("the page has no part " + std::string(name));
}

Json teeth_json(ReportedDrive const& drive)
{
    if (!drive.teeth)
        return nullptr;
    TurningTeeth const& teeth = *drive.teeth;
    io::layout::Shape const shape{teeth.z.size(), static_cast<std::size_t>(teeth.steps)};
    auto const table = [&](std::vector<double> const& values) {
        return array_json("f8", shape, values.data(), values.size() * sizeof(double));
    };
    return {{"z", teeth.z},
            {"steps", teeth.steps},
            {"period", teeth.period},
            {"radius", table(teeth.radius)},
            {"advance", table(teeth.advance)},
            {"lean", table(teeth.lean)},
            {"tooth", array_json("f8", {teeth.tooth.size(), 2}, teeth.tooth.data(), teeth.tooth.size() * sizeof(Vec2))},
            {"chord", teeth.chord},
            {"interpolation_error", teeth.interpolation_error}};
}

Json spline_json(CircularSplineOutline const& outline)
{
    return layout_json({}, [&](io::layout::Writer const& root) { io::layout::write_circular_spline(root, outline); });
}

/// The results of the parts, each with its layout.
Json results_json(ReportedDrive const& drive)
{
    if (drive.stored)
        return drive.stored->parts;
    Json results;
    auto const add = [&](char const* part, auto const& result) {
        results[part] = layout_json(left_of_part(part),
                                    [&](io::layout::Writer const& root) { io::layout::write_result(root, result); });
    };
    add("solve", drive.solution);
    if (drive.contact)
        add("contact", *drive.contact);
    if (drive.load)
        add("load", *drive.load);
    if (drive.run)
        add("run", *drive.run);
    if (!drive.wire.empty())
        add("wedm", drive.wire);
    return results;
}

Json residuals_json(WireSetUps const& wire)
{
    Json list = Json::array();
    for (auto const& program : wire)
        for (Residual const& each : program.residuals)
            list.push_back({{"set_up", program.set_up.number},
                            {"pass", each.pass},
                            {"tooth", each.tooth},
                            {"x", each.where.x()},
                            {"y", each.where.y()},
                            {"upper", each.upper},
                            {"height", each.height},
                            {"meshing", each.meshing}});
    return list;
}

/// The solutions that the page is of: with `load` also that of the drive on its elastic cup.
std::vector<Solution const*> solutions_of(ReportedDrive const& drive)
{
    std::vector<Solution const*> all{&drive.solution};
    if (drive.load)
        all.push_back(&drive.load->solution);
    return all;
}

void add_once(Json& list, Json const& more)
{
    for (Json const& each : more)
        if (std::find(list.begin(), list.end(), each) == list.end())
            list.push_back(each);
}

/// Warnings of the judgement.
Json judgement_json(ReportedDrive const& drive)
{
    Json notes = Json::array();
    for (Solution const* solution : solutions_of(drive))
        add_once(notes, list_of(solution->judgement, [](Note const& note) -> Json {
                     return {{"code", to_string(note.code)},
                             {"severity", to_string(note.severity)},
                             {"place", note.place},
                             {"cause", note.cause},
                             {"advice", note.advice}};
                 }));
    return notes;
}

/// The rules that a design is judged by.
Json limits_json(Scene const& scene)
{
    return list_of(design_limits(scene), [](DesignLimit const& limit) -> Json {
        return {{"code", to_string(limit.code)},
                {"figure", limit.figure},
                {"unit", limit.unit},
                {"usual", {number(limit.usual.low), number(limit.usual.high)}},
                {"accepted", {number(limit.accepted.low), number(limit.accepted.high)}},
                {"source", limit.source}};
    });
}

/// What is printed beside them.
Json notes_json(ReportedDrive const& drive)
{
    Json notes = Json::array();
    for (Solution const* solution : solutions_of(drive))
        add_once(notes, solution->notes);
    for (auto const& program : drive.wire)
        for (auto const& warning : program.warnings)
            notes.push_back("wire: " + warning);
    return notes;
}

std::string text_of(ReportedDrive const& drive)
{
    if (drive.stored)
        return stored_text(drive.stored->parts);
    std::string text = drive.contact ? summary_text(*drive.contact) : summary_text(drive.solution);
    if (drive.load)
        text += '\n' + summary_text(*drive.load);
    if (drive.run)
        text += '\n' + summary_text(*drive.run);
    if (!drive.wire.empty())
        text += '\n' + summary_text(drive.wire);
    if (drive.design)
        text += '\n' + summary_text(drive.design->design);
    return text;
}

Json drive_json(ReportedDrive const& drive)
{
    Scene const& scene = drive.solution.scene;
    return {{"name", scene.drive.name},
            {"flexspline_teeth", scene.drive.flexspline_teeth},
            {"circular_spline_teeth", scene.drive.circular_spline_teeth},
            {"module", scene.drive.module},
            {"origin", drive.origin},
            {"scene", scene.text},
            {"judgement", judgement_json(drive)},
            {"limits", limits_json(scene)},
            {"notes", notes_json(drive)},
            {"left_out", left_out_json(drive.left_out)},
            {"outline_error", drive.solution.error.largest()},
            {"spline", spline_json(drive.outline())},
            {"loaded_spline", drive.load && !drive.load->teeth.phi.empty()
                                  ? spline_json(drive.load->solution.circular_spline)
                                  : Json(nullptr)},
            {"teeth", teeth_json(drive)},
            {"results", results_json(drive)},
            {"design", drive.design ? beside_object(*drive.design) : Json(nullptr)},
            {"residuals", residuals_json(drive.wire)},
            {"text", text_of(drive)}};
}

void replace_all(std::string& text, std::string_view from, std::string_view to)
{
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// Text that is no markup, whoever wrote it.
std::string escaped(std::string text)
{
    replace_all(text, "&", "&amp;");
    replace_all(text, "<", "&lt;");
    replace_all(text, ">", "&gt;");
    replace_all(text, "\"", "&quot;");
    return text;
}

/// JSON that stays inside its element whatever texts it holds.
std::string script_data(Json const& data)
{
    std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
    replace_all(text, "<", "\\u003c");
    return text;
}

/// A list under a heading; nothing for no lines.
std::string list_under(std::string const& heading, std::vector<std::string> const& lines)
{
    std::string items;
    for (std::string const& line : lines)
        items += "<li>" + escaped(line) + "</li>";
    return lines.empty() ? "" : "<h3>" + heading + "</h3><ul>" + items + "</ul>";
}

/// What is read where scripts do not run: pictures, the printed summary of each drive, what is noted on it and what the
/// page does not hold.
/// @param data  of the drives, as drive_json() makes them
std::string static_part(Report const& report, Json const& data)
{
    std::string html;
    for (std::size_t i = 0; i < report.drives.size(); ++i) {
        Json const& results = data[i].at("results");
        html += "<h2>" + escaped(data[i].at("name")) + "</h2>" + static_picture(report.drives[i]) +
                "<div class=\"figures\">" + static_gap_maps(results.value("contact", Json::object())) +
                static_charts(results) + static_wire_path(results.value("wedm", Json::object())) + "</div><pre>" +
                escaped(data[i].at("text")) + "</pre>";
        if (report.drives[i].stored)  // the printed summaries have it
            html += list_under("Notes", noted(data[i]));
        html += list_under("Not in this page", parts_left_out(data[i]));
    }
    for (FailedDrive const& each : report.failed)
        html += "<h2>" + escaped(each.name) + "</h2><pre>" + escaped(each.why) + "</pre>";
    return html;
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string report_page(Report const& made)
{
    if (made.drives.empty())
        throw std::logic_error("a report of no drive");
    report::Json const data = {{"program_version", program_version()},
                               {"git_revision", git_revision()},
                               {"build", build_description()},
                               {"date", io::layout::date_text()},
                               {"failed", report::failed_json(made.failed)},
                               {"drives", report::list_of(made.drives, report::drive_json)}};
    std::string title = "hdconj:";
    for (ReportedDrive const& drive : made.drives)
        title += (&drive == made.drives.data() ? " " : ", ") + drive.solution.scene.drive.name;
    std::string const page = report::page_part("page");
    std::string html;
    std::size_t at = 0;
    // in the order of the page, in one pass: what is put in is not looked at again
    for (auto const& [mark, text] : {std::pair<std::string_view, std::string>{"@TITLE@", report::escaped(title)},
                                     {"@LIBRARY_STYLE@", report::page_part("uPlot.min")},
                                     {"@STYLE@", report::page_part("style")},
                                     {"@STATIC@", report::static_part(made, data.at("drives"))},
                                     {"@DATA@", report::script_data(data)},
                                     {"@LICENCE@", report::page_part("uPlot-licence")},
                                     {"@LIBRARY@", report::page_part("uPlot.iife.min")},
                                     {"@SCRIPT@", report::page_part("bundle")}}) {
        std::size_t const next = page.find(mark, at);
        if (next == std::string_view::npos)
            throw std::logic_error("the page has no mark " + std::string(mark));
        html.append(page, at, next - at).append(text);
        at = next + mark.size();
    }
    return html.append(page, at);
}

}  // namespace hdconj
