// SPDX-License-Identifier: GPL-3.0-or-later
// Contours and wire for CAM, vertex k of the lower one paired with vertex k of the upper one, at their heights; the
// lines of layer SYNC join the marks that CAM synchronises on, those of STOP are the wire where the program stops.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "file/dxf_groups.hpp"
#include "post.hpp"
#include "reading.hpp"

namespace hdconj::wedm::dxf {
namespace {

constexpr file::dxf::Layer part_lower = {"PART_LOWER", file::dxf::white};
constexpr file::dxf::Layer part_upper = {"PART_UPPER", file::dxf::red};
constexpr file::dxf::Layer wire_lower = {"WIRE_LOWER", file::dxf::blue};
constexpr file::dxf::Layer wire_upper = {"WIRE_UPPER", file::dxf::magenta};
constexpr file::dxf::Layer start_hole = {"START", file::dxf::green};
constexpr file::dxf::Layer stop_lines = {"STOP", file::dxf::green};
constexpr file::dxf::Layer sync_lines = {"SYNC", file::dxf::grey};

/// A line from face to face.
void write_line(file::dxf::Groups& out, file::dxf::Layer const& layer, Vec2 const& lower, Vec2 const& upper,
                double height)
{
    out.add(file::dxf::code_type, "LINE");
    out.add(file::dxf::code_layer, layer.name);
    out.point(lower.x(), lower.y(), 0);
    out.add(file::dxf::code_x_end, upper.x());
    out.add(file::dxf::code_y_end, upper.y());
    out.add(file::dxf::code_z_end, height);
}

std::vector<WireText> write(WireProgram const& program, std::string const& stem)
{
    constexpr std::array layers = {part_lower, part_upper, wire_lower, wire_upper, start_hole, stop_lines, sync_lines};
    double const height = program.machine.thickness;
    file::dxf::Groups out;
    file::dxf::begin(out, layers);
    auto const& nominal = program.nominal;
    file::dxf::write_polyline(out, part_lower, file::dxf::closed, nominal.lower, Vec2::Zero(), 0);
    file::dxf::write_polyline(out, part_upper, file::dxf::closed, nominal.upper, Vec2::Zero(), height);
    std::size_t blocks = 0;
    for (auto const& path : exact_passes(program)) {
        file::dxf::write_polyline(out, wire_lower, 0, path.lower, Vec2::Zero(), 0);
        file::dxf::write_polyline(out, wire_upper, 0, path.upper, Vec2::Zero(), height);
        blocks += path.lower.size() - 1;
    }
    Vec2 const start = program.passes.front().moves.front().lower;
    out.add(file::dxf::code_type, "POINT");
    out.add(file::dxf::code_layer, start_hole.name);
    out.point(start.x(), start.y(), 0);
    for (auto const& path : exact_passes(program))
        for (auto const k : path.stops)
            write_line(out, stop_lines, path.lower[k], path.upper[k], height);
    for (auto const k : nominal.sync)
        write_line(out, sync_lines, nominal.lower[k], nominal.upper[k], height);
    file::dxf::end(out);
    return {{stem + "_planes.dxf", out.text(), 0, blocks}};
}

/// Polylines by layer, in order, of lines the lower ends; every vertex must be at the height of its layer.
std::map<std::string, std::vector<std::vector<Vec2>>, std::less<>> polylines_of(WireText const& file, double thickness)
{
    std::map<std::string, std::vector<std::vector<Vec2>>, std::less<>> found;
    std::string_view type;
    std::vector<std::vector<Vec2>>* layer = nullptr;
    auto const lines = lines_of(file);
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        auto const code = lines[i].text();
        auto const& value = lines[i + 1];
        if (code == "0") {
            type = value.text();
            layer = nullptr;
        } else if (code == "8") {
            layer = &found[std::string(value.text())];
            if (type == "POLYLINE" || type == "LINE")
                layer->emplace_back();
        } else if ((type == "VERTEX" || type == "LINE") && layer != nullptr && !layer->empty()) {
            if (code == "10") {
                layer->back().emplace_back(value.number(value.text()), 0);
            } else if (code == "20") {
                layer->back().back().y() = value.number(value.text());
            } else if (code == "30") {
                bool const upper = layer == &found["PART_UPPER"] || layer == &found["WIRE_UPPER"];
                constexpr double rounding = 1e-9;  // [mm], of the decimals written
                if (std::abs(value.number(value.text()) - (upper ? thickness : 0)) > rounding)
                    value.refuse("wrong height");
            }
        }
    }
    return found;
}

std::vector<FacePath> read(std::vector<WireText> const& files, WireProgram const& program)
{
    auto found = polylines_of(files.at(0), program.machine.thickness);
    if (found["PART_LOWER"].size() != 1 || found["PART_UPPER"].size() != 1 ||
        found["WIRE_LOWER"].size() != found["WIRE_UPPER"].size())
        refuse_to_write(files.at(0).name, "contours or passes are missing");
    std::vector<FacePath> paths = {{"contour", found["PART_LOWER"][0], found["PART_UPPER"][0]}};
    auto const& stops = found["STOP"];
    for (std::size_t i = 0; i < found["WIRE_LOWER"].size(); ++i) {
        auto& path =
            paths.emplace_back(FacePath{fmt::format("pass {}", i + 1), found["WIRE_LOWER"][i], found["WIRE_UPPER"][i]});
        for (std::size_t k = 0; k < path.lower.size(); ++k)
            if (std::ranges::any_of(stops, [&](auto const& line) { return line.front() == path.lower[k]; }))
                path.stops.push_back(k);
    }
    return paths;
}

std::vector<FacePath> exact(WireProgram const& program)
{
    std::vector<FacePath> paths = {{"contour", program.nominal.lower, program.nominal.upper}};
    auto const passes = exact_passes(program);
    paths.insert(paths.end(), passes.begin(), passes.end());
    return paths;
}

}  // namespace

WirePost post()
{
    return {.dialect = {"dxf", "DXF R12 for CAM: contours and wire in both faces", "ezdxf, GDAL"},
            .unit = [](WireProgram const&) { return std::pow(10.0, -file::dxf::decimals); },
            .write = write,
            .exact = exact,
            .read = read};
}

}  // namespace hdconj::wedm::dxf
