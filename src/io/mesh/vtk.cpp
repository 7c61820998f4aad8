// SPDX-License-Identifier: GPL-3.0-or-later
// Legacy VTK: lines of text with blocks of big-endian numbers between them.
#include <fmt/format.h>

#include <cstdint>

#include "gap_on_surface.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "number_bytes.hpp"

namespace hdconj {
namespace {

constexpr int quadrilateral = 9;  // VTK's number of the cell's kind

void append_mesh(std::string& bytes, io::Surface const& surface)
{
    bytes += fmt::format("DATASET UNSTRUCTURED_GRID\nPOINTS {} double\n", surface.points.size());
    for (auto const& point : surface.points) {
        for (double const number : point)
            io::append_big_endian(bytes, number);
    }
    std::size_t const cells = surface.quads.size();
    bytes += fmt::format("\nCELLS {} {}\n", cells, 5 * cells);
    for (auto const& quad : surface.quads) {
        io::append_big_endian(bytes, std::int32_t{4});
        for (int const index : quad)
            io::append_big_endian(bytes, static_cast<std::int32_t>(index));
    }
    bytes += fmt::format("\nCELL_TYPES {}\n", cells);
    for (std::size_t i = 0; i < cells; ++i)
        io::append_big_endian(bytes, std::int32_t{quadrilateral});
    bytes += '\n';
}

template <class Number>
void append_scalars(std::string& bytes, std::string const& name, char const* type, std::vector<Number> const& values)
{
    bytes += fmt::format("SCALARS {} {} 1\nLOOKUP_TABLE default\n", name, type);
    for (Number const value : values)
        io::append_big_endian(bytes, value);
    bytes += '\n';
}

}  // namespace

void write_vtk(ContactStudy const& study, std::filesystem::path const& file, SurfaceOptions const& options)
{
    auto const surface = io::spline_surface(study.solution, options);
    std::string bytes = "# vtk DataFile Version 3.0\ntoothed surface of the circular spline, mm, by hdconj\nBINARY\n";
    append_mesh(bytes, surface);
    bytes += fmt::format("CELL_DATA {}\n", surface.part.size());
    append_scalars(bytes, "part", "int", surface.part);
    if (!study.map.gap.empty()) {
        bytes += fmt::format("POINT_DATA {}\n", surface.points.size());
        append_scalars(bytes, "gap", "double", io::gaps_of(surface, study, options.ring));
    }
    file::write_text_atomically(file, bytes);
}

}  // namespace hdconj
