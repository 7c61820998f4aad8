// SPDX-License-Identifier: GPL-3.0-or-later
// DXF R12 group by group: the oldest dialect that every CAD and wire-EDM program reads. Polylines only: bulges, arcs
// and splines get lost in readers, R12 has no LWPOLYLINE. Private to src/io.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hdconj/base/vec2.hpp"

namespace hdconj::file::dxf {

/// Decimals of a coordinate: rounding error 5e-11 mm whatever its size.
inline constexpr int decimals = 10;

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
    code_x_end = 11,
    code_y = 20,
    code_y_end = 21,
    code_z = 30,
    code_z_end = 31,
    code_length = 40,
    code_colour = 62,
    code_vertices_follow = 66,
    code_flags = 70,
    code_alignment = 72,
    code_count = 73
};

inline constexpr int closed = 1;  ///< polyline flag

/// Colour numbers.
enum Colour : int
{
    red = 1,
    green = 3,
    blue = 5,
    magenta = 6,
    white = 7,
    grey = 8
};

struct Layer
{
    char const* name;
    Colour colour;
};

/// Text of a DXF file, group by group.
class Groups
{
  public:
    void add(Code code, std::string_view value);
    void add(Code code, int value) { add(code, std::to_string(value)); }
    void add(Code code, double value);
    void point(double x, double y, double z);
    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    std::string text_;
};

/// Version and units (mm), the layers, and the beginning of the entities.
void begin(Groups& out, std::span<Layer const> layers);

/// What stands behind the last entity.
void end(Groups& out);

/// One polyline at height @p z, moved by @p shift; nothing where there are no points.
void write_polyline(Groups& out, Layer const& layer, int flags, std::vector<Vec2> const& points, Vec2 const& shift,
                    double z);

}  // namespace hdconj::file::dxf
