// SPDX-License-Identifier: GPL-3.0-or-later
// The cup under load, cells of corners alone, arrays in base64 after their length in bytes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

#include "hdconj/file/atomic_file.hpp"
#include "hdconj/load_files.hpp"
#include "number_bytes.hpp"
#include "vtu_text.hpp"

namespace hdconj {
namespace {

// VTK's numbers of the cells' kinds.
constexpr std::uint8_t hexahedron = 12, wedge = 13;

void append_base64(std::string& text, std::string const& bytes)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t block = 0;
        for (std::size_t k = 0; k < 3; ++k)
            block = block << 8U | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? letters[block >> (18U - 6U * k) & 63U] : '=';
    }
}

template <class Number>
void append_array(std::string& text, std::string const& name, char const* type, std::size_t components,
                  std::vector<Number> const& values)
{
    text += fmt::format("<DataArray type=\"{}\"{}{} format=\"binary\">\n", type,
                        name.empty() ? "" : " Name=\"" + name + "\"",
                        components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "");
    std::string bytes;
    bytes.reserve((values.size() + 1) * sizeof(std::uint64_t));
    io::append_little_endian(bytes, std::uint64_t{values.size() * sizeof(Number)});
    for (Number const value : values)
        io::append_little_endian(bytes, value);
    append_base64(text, bytes);
    text += "\n</DataArray>\n";
}

/// The angles of the shape as a ring, or as much of it as they fill.
struct Sweep
{
    std::size_t copies = 1;  ///< of the shape, each turned by turn/copies
    bool closed = false;
};

Sweep sweep_of(std::vector<double> const& phi, int sectors)
{
    constexpr double turn = 2 * std::numbers::pi, rounding = 1e-6;  // of the turn, in the angles that are drawn
    if (phi.size() < 2)
        throw std::logic_error("a cup with fewer than two angles has no volume");
    double const filled = phi.back() - phi.front() + phi[1] - phi[0];
    for (std::size_t const copies : {std::size_t{1}, static_cast<std::size_t>(std::max(sectors, 1))})
        if (std::abs(filled * static_cast<double>(copies) - turn) < rounding * turn)
            return {copies, true};
    return {};
}

void check(CupShape const& shape)
{
    std::size_t const nodes = shape.r.size(), all = nodes * shape.phi.size();
    bool const fits = shape.z.size() == nodes && shape.u_r.size() == all && shape.u_t.size() == all &&
                      shape.u_z.size() == all && (shape.stress.empty() || shape.stress.size() == all);
    if (!fits || shape.cells.empty())
        throw std::logic_error("the shape of the cup has no cells, or does not match its nodes and angles");
    for (auto const& cell : shape.cells) {
        for (int const node : cell)
            if (node < 0 || static_cast<std::size_t>(node) >= nodes)
                throw std::logic_error("an element of the cup has a node that is not there");
        if (cell.size() != 3 && cell.size() != 4)
            throw std::logic_error("an element of the cup with neither three corners nor four");
    }
}

/// Nodes that are corners, numbered anew: the others would be points of no cell.
struct Corners
{
    std::vector<std::size_t> node;     ///< of each corner
    std::vector<std::int64_t> number;  ///< of each node; -1: no corner
};

Corners corners_of(CupShape const& shape)
{
    Corners corners;
    corners.number.assign(shape.r.size(), -1);
    for (auto const& cell : shape.cells) {
        for (int const node : cell) {
            auto& number = corners.number[static_cast<std::size_t>(node)];
            if (number < 0) {
                number = static_cast<std::int64_t>(corners.node.size());
                corners.node.push_back(static_cast<std::size_t>(node));
            }
        }
    }
    return corners;
}

}  // namespace

void write_cup_vtu(LoadStudy const& study, std::filesystem::path const& file)
{
    auto const& shape = study.shape;
    check(shape);
    Corners const corners = corners_of(shape);
    Sweep const sweep = sweep_of(shape.phi, study.sectors);
    std::size_t const angles = shape.phi.size() * sweep.copies, gaps = angles - (sweep.closed ? 0 : 1);
    std::vector<double> points, displacement, stress;
    for (std::size_t a = 0; a < angles; ++a) {
        std::size_t const from = a % shape.phi.size();
        double const phi = shape.phi[from] + 2 * std::numbers::pi * static_cast<double>(a / shape.phi.size()) /
                                                 static_cast<double>(sweep.copies);
        io::SectionAxes const axes(phi);
        for (std::size_t const node : corners.node) {
            std::size_t const at = from * shape.r.size() + node;
            auto const point = axes.point(shape.r[node], shape.z[node]),
                       moved = axes.vector(shape.u_r[at], shape.u_t[at], shape.u_z[at]);
            points.insert(points.end(), point.begin(), point.end());
            displacement.insert(displacement.end(), moved.begin(), moved.end());
            if (!shape.stress.empty())
                stress.push_back(shape.stress[at]);
        }
    }
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    auto const stride = static_cast<std::int64_t>(corners.node.size());
    for (std::size_t a = 0; a < gaps; ++a) {
        for (auto const& cell : shape.cells) {
            // The section's outward side, r x z, is the side of growing angles: hexahedra of positive volume. VTK turns
            // wedges the other way.
            bool const near_first = cell.size() == 4;
            for (bool const second : {!near_first, near_first}) {
                std::size_t const section = second ? (a + 1) % angles : a;
                for (int const node : cell) {
                    connectivity.push_back(static_cast<std::int64_t>(section) * stride +
                                           corners.number[static_cast<std::size_t>(node)]);
                }
            }
            offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
            types.push_back(near_first ? hexahedron : wedge);
        }
    }
    io::VtuText grid;
    grid.arrays_are = "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\"";
    grid.points = points.size() / 3;
    grid.cells = types.size();
    append_array(grid.point_array, "", "Float64", 3, points);
    append_array(grid.cell_arrays, "connectivity", "Int64", 1, connectivity);
    append_array(grid.cell_arrays, "offsets", "Int64", 1, offsets);
    append_array(grid.cell_arrays, "types", "UInt8", 1, types);
    grid.shown = "Vectors=\"displacement\"";
    append_array(grid.data_arrays, "displacement", "Float64", 3, displacement);
    if (!stress.empty()) {
        grid.shown += " Scalars=\"von_mises\"";
        append_array(grid.data_arrays, "von_mises", "Float64", 1, stress);
    }
    file::write_text_atomically(file, io::vtu_text(grid));
}

}  // namespace hdconj
