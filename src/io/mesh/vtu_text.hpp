// SPDX-License-Identifier: GPL-3.0-or-later
// What VTK's files of a cup share: the frame of text around their arrays, and the frame of axes that the cup stands
// in.
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace hdconj::io {

/// An unstructured grid. Arrays are whole elements <DataArray>.
struct VtuText
{
    std::string arrays_are;  ///< attributes of the file: version, byte order and the like
    std::size_t points = 0;
    std::size_t cells = 0;
    std::string point_array;  ///< places of the points
    std::string cell_arrays;  ///< connectivity, offsets, types
    std::string shown;        ///< attributes that say which of the data are vectors and scalars
    std::string data_arrays;  ///< of the points
};

[[nodiscard]] inline std::string vtu_text(VtuText const& grid)
{
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" {}>\n<UnstructuredGrid>\n", grid.arrays_are);
    text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points, grid.cells);
    text += "<Points>\n" + grid.point_array + "</Points>\n<Cells>\n" + grid.cell_arrays + "</Cells>\n";
    text += "<PointData " + grid.shown + ">\n" + grid.data_arrays + "</PointData>\n";
    return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

/// Axes of a section of the cup. Angles are clockwise from the y axis: outwards is (sin, cos), along growing angles
/// (cos, -sin).
struct SectionAxes
{
    double sine;
    double cosine;

    explicit SectionAxes(double phi) : sine(std::sin(phi)), cosine(std::cos(phi)) {}

    [[nodiscard]] std::array<double, 3> point(double r, double z) const { return {r * sine, r * cosine, z}; }
    [[nodiscard]] std::array<double, 3> vector(double radial, double tangential, double axial) const
    {
        return {radial * sine + tangential * cosine, radial * cosine - tangential * sine, axial};
    }
};

}  // namespace hdconj::io
