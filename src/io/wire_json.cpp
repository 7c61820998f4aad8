// SPDX-License-Identifier: GPL-3.0-or-later
// The keys are an interface, described in docs/json.md.
#include <algorithm>

#include "hdconj/io/version.hpp"
#include "hdconj/io/wire_files.hpp"
#include "summary_figures.hpp"
#include "summary_object.hpp"
#include "wire_post.hpp"

namespace hdconj {
namespace {

constexpr int json_version = 1;
constexpr int indent = 2;

Json face(FaceRadii const& radii, std::vector<Vec2> const& contour)
{
    return {{"points", contour.size()}, {"inner_radius_mm", number(radii.inner)}, {"outer_radius_mm", number(radii.outer)}};
}

Json pass_object(WirePass const& pass, PassFigures const& figures)
{
    return {{"pass", pass.number},
            {"offset_mm", number(pass.offset)},
            {"stock_mm", number(pass.stock)},
            {"reversed", pass.reversed},
            {"blocks", figures.blocks},
            {"length_mm", number(figures.length)},
            {"shortest_block_mm", number(figures.shortest)},
            {"residual_um", number(figures.residual * um_per_mm)},
            {"residual_places", figures.residuals}};
}

Json residual_object(Residual const& residual)
{
    return {{"pass", residual.pass},
            {"tooth", residual.tooth},
            {"face", residual.upper ? "upper" : "lower"},
            {"x_mm", number(residual.where.x())},
            {"y_mm", number(residual.where.y())},
            {"height_um", number(residual.height * um_per_mm)},
            {"meshing", residual.meshing}};
}

Json file_object(WireFile const& file)
{
    auto const dialects = wire_dialects();
    auto const dialect = std::find_if(dialects.begin(), dialects.end(), [&](auto const& each) { return each.name == file.dialect; });
    bool const verified = dialect != dialects.end() && dialect->verified();
    return {{"name", file.name},
            {"dialect", file.dialect},
            {"set_up", file.set_up},
            {"pass", file.pass},
            {"blocks", file.blocks},
            {"bytes", file.bytes},
            {"unit_um", number(file.unit * um_per_mm)},
            {"drift_um", number(file.drift * um_per_mm)},
            {"verified_by", verified ? Json(dialect->verified_by) : Json(nullptr)}};
}

Json place(Vec2 const& p)
{
    return {number(p.x()), number(p.y())};
}

Json set_up_object(WireProgram const& program)
{
    WireFigures const figures = measured(program);
    auto const& set_up = program.set_up;
    auto const& moves = program.passes.front().moves;
    Json result = {{"set_up", set_up.number},
                   {"first_space", program.closed() ? 0 : set_up.first},
                   {"spaces", program.spaces()},
                   {"part_turned_deg", set_up.turned ? 180 : 0},
                   {"start_mm", place(moves.front().lower)},
                   {"end_mm", place(moves.back().lower)}};
    result["passes"] = Json::array();
    for (std::size_t i = 0; i < program.passes.size(); ++i) {
        result["passes"].push_back(pass_object(program.passes[i], figures.passes[i]));
    }
    result["residuals"] = Json::array();
    for (auto const& residual : program.residuals) {
        result["residuals"].push_back(residual_object(residual));
    }
    return result;
}

/// What the checks found; null where no check was made.
Json checks_object(WireProgram const& program, WireFigures const& figures)
{
    if (program.tolerance <= 0) {
        return nullptr;
    }
    return {{"tolerance_um", number(program.tolerance * um_per_mm)},
            {"face_error_um", number(figures.face_error * um_per_mm)},
            {"guide_chord_um", number(figures.guide_chord * um_per_mm)},
            {"middle_error_um", number(figures.middle_error * um_per_mm)},
            {"ruling_error_um", number(figures.ruling_error * um_per_mm)},
            {"matched_edges_turn_deg", number(figures.normal_angle * degree_per_radian)},
            {"constant_taper_error_um", number(figures.constant_taper_error * um_per_mm)},
            {"constant_taper_known_to_um", number(taper_known_to(program, figures) * um_per_mm)}};
}

}  // namespace

std::string summary_json(WireSetUps const& programs, std::vector<WireFile> const& files, std::filesystem::path const& folder,
                         std::vector<WrittenFile> const& pictures)
{
    auto const& program = programs.front();
    WireFigures const figures = measured(program);
    auto const& machine = program.machine;
    Json result = {{"format", "hdconj-wire-summary"},
                   {"format_version", json_version},
                   {"program_version", program_version()},
                   {"git_revision", git_revision()},
                   {"part", program.name},
                   {"teeth", program.teeth},
                   {"external", program.external},
                   {"wire_diameter_mm", number(program.wire_diameter)},
                   {"spark_gap_mm", number(program.spark_gap)},
                   {"contour_error_um", number(program.contour_error * um_per_mm)},
                   {"cup_error_um", number(program.cup_error * um_per_mm)},
                   {"thickness_mm", number(machine.thickness)},
                   {"lower_guide_mm", number(machine.lower_guide)},
                   {"upper_guide_mm", number(machine.upper_guide)},
                   {"guide_distance_mm", number(machine.guide_distance())},
                   {"decimals", program.decimals},
                   {"lower_face", face(figures.lower, program.nominal.lower)},
                   {"upper_face", face(figures.upper, program.nominal.upper)},
                   {"face_shift_mm", number(figures.face_shift)},
                   {"least_face_shift_mm", number(figures.least_shift)},
                   {"guide_offset_mm", number(figures.guide_shift)},
                   {"largest_wire_tilt_deg", number(figures.tilt * degree_per_radian)},
                   {"travel_mm", number(figures.travel)},
                   {"uv_travel_mm", number(figures.uv_travel)},
                   {"sync_marks", program.nominal.sync.size()},
                   {"checks", checks_object(program, figures)},
                   {"warnings", program.warnings}};
    bool meshing = false;
    result["set_ups"] = Json::array();
    for (auto const& each : programs) {
        result["set_ups"].push_back(set_up_object(each));
        meshing = meshing || std::any_of(each.residuals.begin(), each.residuals.end(), [](auto const& residual) { return residual.meshing; });
    }
    result["residual_in_meshing_zone"] = meshing;
    result["folder"] = folder.string();
    result["files"] = Json::array();
    for (auto const& file : files) {
        result["files"].push_back(file_object(file));
    }
    result["pictures"] = Json::object();
    for (auto const& picture : pictures) {
        result["pictures"][picture.kind] = {{"path", picture.file.string()}, {"seconds", number(picture.seconds)}};
    }
    // File names need not be UTF-8: replace what is not, rather than fail after the work is done.
    return result.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace hdconj
