// SPDX-License-Identifier: GPL-3.0-or-later
// XDMF 3: the light half is XML, the numbers are in HDF5. Cells are listed one by one: meshio reads no structured
// meshes.
#include <fmt/format.h>

#include "hdconj/error.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "io/hdf5/hdf5_writer.hpp"
#include "io/layout/results.hpp"
#include "spline_surface.hpp"

namespace hdconj {
namespace {

std::string escaped(std::string const& text)
{
    std::string result;
    for (char const c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    return result;
}

/// @p result as seen from the folder of @p file.
std::string relative_name(std::filesystem::path const& result, std::filesystem::path const& file)
{
    auto const from = std::filesystem::absolute(file).lexically_normal().parent_path();
    auto const to = std::filesystem::absolute(result).lexically_normal();
    std::string name = to.lexically_relative(from).generic_string();
    // "NAME:/dataset|selection" is how XDMF says where numbers are, with blanks at the ends cut off.
    if (name.empty() || name.find_first_of(":|\n\r\t") != std::string::npos || name.front() == ' ') {
        throw FileError(file, "the name of the HDF5 file that it refers to cannot stand in XDMF: " + name +
                                  " (no colon, bar, tab or line break may be in it, and no blank before it)");
    }
    return name;
}

std::string document(std::string const& drive, std::string const& heavy, std::string const& group,
                     io::Surface const& surface)
{
    auto const item = [&](char const* dataset, std::string const& dimensions, char const* type, int precision) {
        return fmt::format(
            "<DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"{}\" Format=\"HDF\">{}:{}/{}</DataItem>",
            dimensions, type, precision, escaped(heavy), group, dataset);
    };
    auto const count = [](std::size_t rows, int columns) { return fmt::format("{} {}", rows, columns); };
    std::size_t const cells = surface.quads.size();
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
        "<Xdmf Version=\"3.0\">\n"
        "  <Domain>\n"
        "    <Grid Name=\"{}\" GridType=\"Uniform\">\n"
        "      <Topology TopologyType=\"Quadrilateral\" NumberOfElements=\"{}\">\n        {}\n      </Topology>\n"
        "      <Geometry GeometryType=\"XYZ\">\n        {}\n      </Geometry>\n"
        "      <Attribute Name=\"part\" AttributeType=\"Scalar\" Center=\"Cell\">\n        {}\n      </Attribute>\n"
        "    </Grid>\n"
        "  </Domain>\n"
        "</Xdmf>\n",
        escaped(drive), cells, item("quads", count(cells, 4), "Int", sizeof(int)),
        item("points", count(surface.points.size(), 3), "Float", sizeof(double)),
        item("part", std::to_string(cells), "Int", sizeof(int)));
}

}  // namespace

void write_xdmf(Solution const& solution, std::filesystem::path const& file, std::filesystem::path const& result)
{
    auto const text = document(solution.scene.drive.name, relative_name(result, file), "/circular_spline/surface",
                               io::tooth_surface(solution));
    file::write_text_atomically(file, text);
}

void write_xdmf(Solution const& solution, std::filesystem::path const& file, SurfaceOptions const& options)
{
    auto const surface = io::spline_surface(solution, options);
    auto heavy = file;
    heavy += ".h5";
    auto const text = document(solution.scene.drive.name, relative_name(heavy, file), "/surface", surface);
    io::hdf5::write_file(heavy, [&](io::layout::Writer const& root) {
        root.group("surface", [&](io::layout::Writer const& place) { io::layout::write_surface(place, surface); });
    });
    file::write_text_atomically(file, text);
}

}  // namespace hdconj
