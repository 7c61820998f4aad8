// SPDX-License-Identifier: GPL-3.0-or-later
// DXF R12: the oldest dialect that every CAD and wire-EDM program reads. Polylines only: bulges, arcs and splines
// get lost in readers, R12 has no LWPOLYLINE.
#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/result_files.hpp"

namespace hdconj {
namespace {

/// Decimals of a coordinate: rounding error 5e-11 mm whatever its size.
constexpr int decimals = 10;
constexpr double smallest_shown = 0.5e-10;
/// Longest double in fixed notation: 309 digits, sign, point, decimals.
constexpr std::size_t longest_number = 330;

/// Group codes used here.
enum Code : int
{
    code_type = 0,
    code_text = 1,
    code_name = 2,
    code_line_pattern = 3,
    code_line_type = 6,
    code_layer = 8,
    code_variable = 9,
    code_x = 10,
    code_y = 20,
    code_z = 30,
    code_length = 40,
    code_colour = 62,
    code_vertices_follow = 66,
    code_flags = 70,
    code_alignment = 72,
    code_count = 73
};

constexpr int millimetres = 4;               // $INSUNITS
constexpr int metric = 1;                    // $MEASUREMENT
constexpr int closed = 1;                    // polyline flag
constexpr int letter_a = 65;                 // alignment of a line type
constexpr int white = 7, red = 1, blue = 5;  // colour numbers

struct Layer
{
    char const* name;
    int colour;
};
constexpr Layer circular_spline = {"CIRCULAR_SPLINE", white};
constexpr Layer flexspline_tooth = {"FLEXSPLINE_TOOTH", red};
constexpr Layer neutral_curve = {"NEUTRAL_CURVE", blue};

/// Text of a DXF file, group by group.
class Groups
{
  public:
    void add(Code code, std::string_view value)
    {
        text_ += std::to_string(code);
        text_ += '\n';
        text_ += value;
        text_ += '\n';
    }
    void add(Code code, int value) { add(code, std::to_string(value)); }
    void add(Code code, double value)
    {
        std::array<char, longest_number> digits = {};
        double const shown = std::abs(value) < smallest_shown ? 0.0 : value;  // and never -0
        auto const end =
            std::to_chars(digits.data(), digits.data() + digits.size(), shown, std::chars_format::fixed, decimals);
        std::string_view number(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
        while (number.ends_with("0") && !number.ends_with(".0")) {
            number.remove_suffix(1);
        }
        add(code, number);
    }
    void point(double x, double y, double z)
    {
        add(code_x, x);
        add(code_y, y);
        add(code_z, z);
    }
    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    std::string text_;
};

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

void write_polyline(Groups& out, Layer const& layer, int flags, std::vector<Vec2> const& points, Vec2 const& shift,
                    double z)
{
    if (points.empty()) {
        return;
    }
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

/// The tooth where the wave generator is largest: its frame's origin at (0, r_0 + w0), its outline from the pitch line.
Vec2 major_axis(PairGeometry const& geometry)
{
    return {0, geometry.r_0 + geometry.w0 + geometry.pitch_line};
}

}  // namespace

void write_dxf(Solution const& solution, std::filesystem::path const& file)
{
    constexpr std::array layers = {circular_spline, flexspline_tooth, neutral_curve};
    constexpr double middle = 0;
    Groups out;
    write_header(out);
    write_tables(out, layers);
    out.add(code_type, "SECTION");
    out.add(code_name, "ENTITIES");
    auto const& slices = solution.circular_spline;
    for (std::size_t k = 0; k < slices.outline.size(); ++k) {
        write_polyline(out, circular_spline, 0, slices.outline[k], Vec2::Zero(), slices.z.at(k));
    }
    write_polyline(out, flexspline_tooth, 0, solution.flexspline_outline, major_axis(solution.geometry), middle);
    write_polyline(out, neutral_curve, closed, solution.neutral_curve, Vec2::Zero(), middle);
    out.add(code_type, "ENDSEC");
    out.add(code_type, "EOF");
    write_text_atomically(file, out.text());
}

}  // namespace hdconj
