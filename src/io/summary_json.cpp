// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of summary_text as JSON; the keys are an interface, described in docs/json.md.
#include <algorithm>
#include <cmath>

#include "hdconj/io/version.hpp"
#include "summary_figures.hpp"
#include "summary_object.hpp"

namespace hdconj {
namespace {

/// Number of the set of keys; goes up when a key changes its meaning.
constexpr int json_version = 1;
constexpr int indent = 2;

Json object(std::vector<Figure> const& figures)
{
    Json result = Json::object();
    for (auto const& figure : figures) {
        result[figure.key] = number(figure.value);
    }
    return result;
}

Json drive(Solution const& solution)
{
    auto const& drive = solution.scene.drive;
    return {{"name", drive.name},
            {"module_mm", number(drive.module)},
            {"flexspline_teeth", drive.flexspline_teeth},
            {"circular_spline_teeth", drive.circular_spline_teeth},
            {"waves", solution.scene.wave_generator.waves},
            {"kinematics", to_string(solution.scene.is_elastic() ? Kinematics::material : solution.scene.solver.kinematics)},
            {"tolerance_mm", number(solution.scene.solver.tolerance)},
            {"given", given_member(solution)}};
}

Json branches(Solution const& solution)
{
    auto const count = [&](auto condition) {
        return std::count_if(solution.branches.begin(), solution.branches.end(), condition);
    };
    return {{"count", solution.branches.size()},
            {"regular", count([](auto const& branch) { return branch.kind == "regular"; })},
            {"corner", count([](auto const& branch) { return branch.kind == "corner"; })},
            {"on_boundary", count([](auto const& branch) { return branch.on_boundary; })}};
}

Json zone(ConjugateZone const& zone)
{
    return {{"segment", zone.segment},
            {"segment_name", zone.segment_name},
            {"kind", zone.kind},
            {"branch", zone.branch},
            {"u_begin_deg", number(zone.u_begin * degree_per_radian)},
            {"u_end_deg", number(zone.u_end * degree_per_radian)},
            {"phi_begin_deg", number(zone.phi_begin * degree_per_radian)},
            {"phi_end_deg", number(zone.phi_end * degree_per_radian)},
            {"t_begin", number(zone.t_begin)},
            {"t_end", number(zone.t_end)},
            {"phi_error_deg", number(zone.phi_error * degree_per_radian)},
            {"t_error", number(zone.t_error)},
            {"outer", zone.outer},
            {"on_boundary", zone.on_boundary}};
}

Json pieces(std::vector<OutlinePiece> const& of)
{
    Json list = Json::array();
    for (auto const& piece : of) {
        list.push_back(
            {{"kind", piece.kind}, {"segment_name", piece.segment_name}, {"first", piece.first}, {"last", piece.last}});
    }
    return list;
}

Json certificate(Solution const& solution)
{
    Json undecided = Json::array();
    for (auto const& place : solution.certificate.undecided) {
        undecided.push_back({{"segment_name", place.segment_name},
                             {"t", number(place.t)},
                             {"u_deg", number(place.u * degree_per_radian)},
                             {"u_width_deg", number(place.u_width * degree_per_radian)},
                             {"reach_mm", number(place.reach)},
                             {"what", place.what}});
    }
    return {{"certified", solution.certificate.certified()}, {"undecided", std::move(undecided)}};
}

Json outline(Solution const& solution)
{
    auto const& spline = solution.circular_spline;
    return {{"slices", spline.outline.size()},
            {"points", outline_points(solution)},
            {"landmarks", spline.landmarks},
            {"pieces", pieces(spline.pieces)}};
}

/// Absent as a whole where the pair was not checked.
void add_clearance(Json& result, Solution const& solution)
{
    if (!solution.check) {
        return;
    }
    auto clearance = object(clearance_figures(solution));
    clearance["checked_points"] = solution.check->points;
    clearance["checked_positions"] = solution.check->positions;
    result["clearance"] = std::move(clearance);
}

Json timing(Solution const& solution)
{
    Json stages = Json::array();
    for (auto const& entry : solution.timing) {
        stages.push_back({{"stage", entry.stage}, {"seconds", number(entry.seconds)}});
    }
    return {{"threads", solution.threads}, {"total_s", number(total_seconds(solution))}, {"stages", std::move(stages)}};
}

Json files(std::vector<WrittenFile> const& written)
{
    Json result = Json::object();
    for (auto const& file : written) {
        result[file.kind] = {{"path", file.file.string()}, {"seconds", number(file.seconds)}};
    }
    return result;
}

}  // namespace

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json summary_object(Solution const& solution)
{
    Json result = {{"format", "hdconj-summary"},
                   {"format_version", json_version},
                   {"program_version", program_version()},
                   {"git_revision", git_revision()},
                   {"drive", drive(solution)},
                   {"geometry", object(geometry_figures(solution))},
                   {"branches", branches(solution)}};
    result["conjugate_zones"] = Json::array();
    for (auto const& each : solution.zones) {
        result["conjugate_zones"].push_back(zone(each));
    }
    if (solution.scene.is_reverse()) {
        result["flexspline"] = {{"points", solution.flexspline_outline.size()},
                                {"pieces", pieces(solution.flexspline_pieces)}};
    }
    if (!solution.notes.empty()) {
        result["notes"] = solution.notes;
    }
    result["certificate"] = certificate(solution);
    result["circular_spline"] = outline(solution);
    add_clearance(result, solution);
    result["error"] = object(error_figures(solution));
    result["work"] = {{"envelope_points", solution.work.envelope_points},
                      {"roots_isolated", solution.work.roots_isolated},
                      {"arrangement_edges", solution.work.arrangement_edges}};
    return result;
}

std::string finished(Json summary, Solution const& solution, std::vector<WrittenFile> const& written)
{
    summary["timing"] = timing(solution);
    summary["files"] = files(written);
    // File names need not be UTF-8: replace what is not, rather than fail after the work is done.
    return summary.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string summary_json(Solution const& solution, std::vector<WrittenFile> const& written)
{
    return finished(summary_object(solution), solution, written);
}

}  // namespace hdconj
