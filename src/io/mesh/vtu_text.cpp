// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtu_text.hpp"

#include <fmt/format.h>

namespace hdconj::io {

std::string vtu_text(VtuText const& grid)
{
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" {}>\n<UnstructuredGrid>\n", grid.arrays_are);
    text += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", grid.points, grid.cells);
    text += "<Points>\n" + grid.point_array + "</Points>\n<Cells>\n" + grid.cell_arrays + "</Cells>\n";
    text += "<PointData " + grid.shown + ">\n" + grid.data_arrays + "</PointData>\n";
    return text + "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace hdconj::io
