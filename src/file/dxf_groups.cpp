// SPDX-License-Identifier: GPL-3.0-or-later
#include "dxf_groups.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace hdconj::file::dxf {
namespace {

constexpr double smallest_shown = 0.5e-10;
/// Longest double in fixed notation: 309 digits, sign, point, decimals.
constexpr std::size_t longest_number = 330;

constexpr int millimetres = 4;  // $INSUNITS
constexpr int metric = 1;       // $MEASUREMENT
constexpr int letter_a = 65;    // alignment of a line type

void write_header(Groups& out)
{
    out.add(code_type, "SECTION");
    out.add(code_name, "HEADER");
    out.add(code_variable, "$ACADVER");
    out.add(code_text, "AC1009");
    out.add(code_variable, "$INSUNITS");
    out.add(code_flags, millimetres);
    out.add(code_variable, "$MEASUREMENT");
    out.add(code_flags, metric);
    out.add(code_type, "ENDSEC");
}

void begin_table(Groups& out, char const* name, int entries)
{
    out.add(code_type, "TABLE");
    out.add(code_name, name);
    out.add(code_flags, entries);
}

void write_tables(Groups& out, std::span<Layer const> layers)
{
    out.add(code_type, "SECTION");
    out.add(code_name, "TABLES");
    begin_table(out, "LTYPE", 1);
    out.add(code_type, "LTYPE");
    out.add(code_name, "CONTINUOUS");
    out.add(code_flags, 0);
    out.add(code_line_pattern, "Solid line");
    out.add(code_alignment, letter_a);
    out.add(code_count, 0);
    out.add(code_length, 0.0);
    out.add(code_type, "ENDTAB");
    begin_table(out, "LAYER", static_cast<int>(layers.size()));
    for (auto const& layer : layers) {
        out.add(code_type, "LAYER");
        out.add(code_name, layer.name);
        out.add(code_flags, 0);
        out.add(code_colour, layer.colour);
        out.add(code_line_type, "CONTINUOUS");
    }
    out.add(code_type, "ENDTAB");
    out.add(code_type, "ENDSEC");
}

}  // namespace

void Groups::add(Code code, std::string_view value)
{
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += value;
    text_ += '\n';
}

void Groups::add(Code code, double value)
{
    std::array<char, longest_number> digits = {};
    double const shown = std::abs(value) < smallest_shown ? 0.0 : value;  // and never -0
    auto const end =
        std::to_chars(digits.data(), digits.data() + digits.size(), shown, std::chars_format::fixed, decimals);
    std::string_view number(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
    while (number.ends_with("0") && !number.ends_with(".0"))
        number.remove_suffix(1);
    add(code, number);
}

void Groups::point(double x, double y, double z)
{
    add(code_x, x);
    add(code_y, y);
    add(code_z, z);
}

void begin(Groups& out, std::span<Layer const> layers)
{
    write_header(out);
    write_tables(out, layers);
    out.add(code_type, "SECTION");
    out.add(code_name, "ENTITIES");
}

void end(Groups& out)
{
    out.add(code_type, "ENDSEC");
    out.add(code_type, "EOF");
}

void write_polyline(Groups& out, Layer const& layer, int flags, std::vector<Vec2> const& points, Vec2 const& shift,
                    double z)
{
    if (points.empty())
        return;
    out.add(code_type, "POLYLINE");
    out.add(code_layer, layer.name);
    out.add(code_vertices_follow, 1);
    out.add(code_flags, flags);
    out.point(0, 0, z);
    for (auto const& point : points) {
        out.add(code_type, "VERTEX");
        out.add(code_layer, layer.name);
        out.point(point.x() + shift.x(), point.y() + shift.y(), z);
    }
    out.add(code_type, "SEQEND");
    out.add(code_layer, layer.name);
}

}  // namespace hdconj::file::dxf
