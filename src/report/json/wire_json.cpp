// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/reference/json.md.
#include <algorithm>

#include "figures/wire_figures.hpp"
#include "summary_object.hpp"

namespace hdconj::report {
namespace {

Json face_object(FaceRadii const& radii, std::vector<Vec2> const& contour)
{
    Json object = {{"points", contour.size()}};
    add_figures(object, figures::face_figures(), radii);
    return object;
}

Json residual_object(Residual const& residual)
{
    Json object = figures_object(figures::residual_figures(), residual);
    object["face"] = residual.upper ? "upper" : "lower";
    return object;
}

Json file_object(WireFile const& file)
{
    Json object = {{"name", file.name}, {"dialect", file.dialect}};
    add_figures(object, figures::wire_file_figures(), file);
    object["verified_by"] = file.verified() ? Json(file.verified_by) : Json(nullptr);
    return object;
}

Json place(Vec2 const& p)
{
    return {number(p.x()), number(p.y())};
}

Json set_up_object(WireProgram const& program)
{
    WireFigures const found = measured(program);
    auto const& set_up = program.set_up;
    auto const& moves = program.passes.front().moves;
    Json result = {{"set_up", set_up.number},
                   {"first_space", program.closed() ? 0 : set_up.first},
                   {"spaces", program.spaces()},
                   {"part_turned_deg", set_up.turned ? 180 : 0},
                   {"start_mm", place(moves.front().lower)},
                   {"end_mm", place(moves.back().lower)}};
    result["passes"] = Json::array();
    for (std::size_t i = 0; i < program.passes.size(); ++i)
        result["passes"].push_back(figures_object(figures::pass_figures(), {program.passes[i], found.passes[i]}));
    result["residuals"] = list_of(program.residuals, residual_object);
    return result;
}

bool meshes(WireProgram const& program)
{
    return std::any_of(program.residuals.begin(), program.residuals.end(),
                       [](auto const& residual) { return residual.meshing; });
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_json(WireSetUps const& programs, std::vector<WireFile> const& files,
                         std::filesystem::path const& folder, std::vector<WrittenFile> const& pictures)
{
    figures::MeasuredProgram const first(programs.front());
    auto const& program = first.program;
    auto result = report::format_heading("hdconj-wire-summary", 1);
    result["part"] = program.name;
    report::add_figures(result, figures::wire_figures(), first);
    result["lower_face"] = report::face_object(first.figures.lower, program.nominal.lower);
    result["upper_face"] = report::face_object(first.figures.upper, program.nominal.upper);
    result["checks"] =
        program.tolerance > 0 ? report::figures_object(figures::wire_check_figures(), first) : report::Json(nullptr);
    result["warnings"] = figures::wire_warnings(program, files);
    result["notes"] = program.notes;
    result["left_out"] = program.left_out;
    result["judgement"] = report::notes_object(program.judgement);
    result["set_ups"] = report::list_of(programs, report::set_up_object);
    result["residual_in_meshing_zone"] = std::any_of(programs.begin(), programs.end(), report::meshes);
    result["folder"] = folder.string();
    result["files"] = report::list_of(files, report::file_object);
    result["pictures"] = report::files_object(pictures);
    return report::printed(result);
}

}  // namespace hdconj
