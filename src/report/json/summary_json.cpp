// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of summary_text as JSON; the keys are an interface, described in docs/reference/json.md.
#include <algorithm>
#include <cmath>

#include "figures/summary_figures.hpp"
#include "figures/wanted_figures.hpp"
#include "hdconj/version.hpp"
#include "hdconj/wanted_curve_files.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

Json drive_object(Solution const& solution)
{
    Json object = {{"name", solution.scene.drive.name}};
    add_figures(object, figures::drive_figures(), solution);
    object["kinematics"] = figures::kinematics_name(solution);
    object["given"] = figures::given_member(solution);
    return object;
}

Json branches_object(Solution const& solution)
{
    return {{"count", solution.branches.size()},
            {"regular", figures::branches_of_kind(solution, "regular")},
            {"corner", figures::branches_of_kind(solution, "corner")},
            {"on_boundary", std::count_if(solution.branches.begin(), solution.branches.end(),
                                          [](auto const& branch) { return branch.on_boundary; })}};
}

Json zone_object(ConjugateZone const& zone)
{
    Json object = {
        {"segment", zone.segment}, {"segment_name", zone.segment_name}, {"kind", zone.kind}, {"branch", zone.branch}};
    add_figures(object, figures::zone_figures(), zone);
    return object;
}

Json pieces(std::vector<OutlinePiece> const& of)
{
    return list_of(of, [](OutlinePiece const& piece) -> Json {
        return {
            {"kind", piece.kind}, {"segment_name", piece.segment_name}, {"first", piece.first}, {"last", piece.last}};
    });
}

Json certificate_object(RootCertificate const& certificate)
{
    Json const undecided = list_of(certificate.undecided, [](UndecidedPlace const& place) {
        Json object = {{"segment_name", place.segment_name}};
        add_figures(object, figures::undecided_figures(), place);
        object["what"] = place.what;
        return object;
    });
    return {{"certified", certificate.certified()}, {"undecided", undecided}};
}

/// All errors in one object.
Json solution_errors(Solution const& solution)
{
    Json object = figures_object(figures::error_figures(), solution);
    object.update(errors_object(figures::geometry_figures(), solution));
    return object;
}

Json timing_object(Solution const& solution)
{
    return {{"threads", solution.threads},
            {"total_s", number(figures::total_seconds(solution))},
            {"stages", stages_object(solution.timing)}};
}

}  // namespace

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json format_heading(char const* format, int version)
{
    return {{"format", format},
            {"format_version", version},
            {"program_version", program_version()},
            {"git_revision", git_revision()}};
}

Json stages_object(std::vector<StageTime> const& timing)
{
    return list_of(timing, [](StageTime const& entry) -> Json {
        return {{"stage", entry.stage}, {"seconds", number(entry.seconds)}};
    });
}

Json notes_object(Notes const& notes)
{
    return list_of(notes, [](Note const& note) -> Json {
        return {{"code", to_string(note.code)},
                {"severity", to_string(note.severity)},
                {"figure", number(note.figure)},
                {"limit", number(note.limit)},
                {"unit", note.unit},
                {"place", note.place},
                {"cause", note.cause},
                {"advice", note.advice},
                {"set", note.set}};
    });
}

Json files_object(std::vector<WrittenFile> const& written)
{
    Json object = Json::object();
    for (auto const& file : written)
        object[file.kind] = {{"path", file.file.string()}, {"seconds", number(file.seconds)}};
    return object;
}

Json summary_object(Solution const& solution)
{
    constexpr int format_version = 2;  // goes up when a key changes its meaning
    Json result = format_heading("hdconj-summary", format_version);
    result["drive"] = drive_object(solution);
    add_values(result["geometry"], figures::geometry_figures(), solution);
    result["branches"] = branches_object(solution);
    result["conjugate_zones"] = list_of(solution.zones, zone_object);
    if (solution.scene.is_reverse()) {
        result["flexspline"] = {{"points", solution.flexspline_outline.size()},
                                {"pieces", pieces(solution.flexspline_pieces)}};
    }
    if (!solution.notes.empty())
        result["notes"] = solution.notes;
    result["judgement"] = notes_object(solution.judgement);
    result["certificate"] = certificate_object(solution.certificate);
    auto const& spline = solution.circular_spline;
    result["circular_spline"] = {{"slices", spline.outline.size()},
                                 {"points", figures::outline_points(solution)},
                                 {"landmarks", spline.landmarks},
                                 {"pieces", pieces(spline.pieces)}};
    if (solution.check)
        result["clearance"] = figures_object(figures::clearance_figures(), solution);
    result["error"] = solution_errors(solution);
    result["work"] = figures_object(figures::work_figures(), solution.work);
    return result;
}

std::string finished(Json summary, Solution const& solution, std::vector<WrittenFile> const& written)
{
    summary["timing"] = timing_object(solution);
    summary["files"] = files_object(written);
    return printed(summary);
}

std::string indented(Json const& object)
{
    constexpr int indent = 2;
    return object.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string printed(Json const& summary)
{
    return indented(summary) + '\n';
}

}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(Solution const& solution, std::vector<WrittenFile> const& written)
{
    return report::finished(report::summary_object(solution), solution, written);
}

std::string summary_json(WantedCurve const& found, std::vector<WrittenFile> const& written)
{
    auto result = report::format_heading("hdconj-neutral-curve", 1);
    result.update({{"drive", found.scene.drive.name}, {"kinematics", to_string(found.scene.solver.kinematics)}});
    report::add_figures(result, figures::wanted_figures(), found);
    result["ends"] = found.ends;
    result["rows"] = report::list_of(
        found.rows, [](WantedCurveRow const& row) { return report::figures_object(figures::wanted_rows(), row); });
    result["notes"] = found.notes;
    result["timing"] = {{"threads", found.threads}, {"stages", report::stages_object(found.timing)}};
    result["files"] = report::files_object(written);
    return report::printed(result);
}

}  // namespace hdconj
