// SPDX-License-Identifier: GPL-3.0-or-later
// Legacy VTK: lines of text with blocks of big-endian numbers between them.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gap_on_surface.hpp"
#include "hdconj/io/atomic_file.hpp"

namespace hdconj {
namespace {

constexpr int quadrilateral = 9;  // VTK's number of the cell's kind

static_assert(std::endian::native == std::endian::little, "numbers are turned round to be written");

template <class Number>
void append(std::string& bytes, Number number)
{
    auto const raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(raw.rbegin(), raw.rend());
}

void append_mesh(std::string& bytes, Surface const& surface)
{
    bytes += fmt::format("DATASET UNSTRUCTURED_GRID\nPOINTS {} double\n", surface.points.size());
    for (auto const& point : surface.points) {
        for (double const number : point) {
            append(bytes, number);
        }
    }
    std::size_t const cells = surface.quads.size();
    bytes += fmt::format("\nCELLS {} {}\n", cells, 5 * cells);
    for (auto const& quad : surface.quads) {
        append(bytes, std::int32_t{4});
        for (int const index : quad) {
            append(bytes, static_cast<std::int32_t>(index));
        }
    }
    bytes += fmt::format("\nCELL_TYPES {}\n", cells);
    for (std::size_t i = 0; i < cells; ++i) {
        append(bytes, std::int32_t{quadrilateral});
    }
    bytes += '\n';
}

template <class Number>
void append_scalars(std::string& bytes, std::string const& name, char const* type, std::vector<Number> const& values)
{
    bytes += fmt::format("SCALARS {} {} 1\nLOOKUP_TABLE default\n", name, type);
    for (Number const value : values) {
        append(bytes, value);
    }
    bytes += '\n';
}

}  // namespace

void write_vtk(ContactStudy const& study, std::filesystem::path const& file, SurfaceOptions const& options)
{
    auto const surface = spline_surface(study.solution, options);
    std::string bytes = "# vtk DataFile Version 3.0\ntoothed surface of the circular spline, mm, by hdconj\nBINARY\n";
    append_mesh(bytes, surface);
    bytes += fmt::format("CELL_DATA {}\n", surface.part.size());
    append_scalars(bytes, "part", "int", surface.part);
    if (!study.map.gap.empty()) {
        bytes += fmt::format("POINT_DATA {}\n", surface.points.size());
        append_scalars(bytes, "gap", "double", gaps_of(surface, study, options.ring));
    }
    write_text_atomically(file, bytes);
}

}  // namespace hdconj
