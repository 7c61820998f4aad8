// SPDX-License-Identifier: GPL-3.0-or-later
// Binary STL: 80 bytes that say nothing, the number of triangles, 50 bytes for each, little-endian.
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>

#include "hdconj/file/atomic_file.hpp"
#include "number_bytes.hpp"
#include "spline_surface.hpp"

namespace hdconj {
namespace {

constexpr std::size_t title_bytes = 80, triangle_bytes = 50;
using Corner = Eigen::Vector3f;

Corner single(std::array<double, 3> const& point)
{
    return {static_cast<float>(point[0]), static_cast<float>(point[1]), static_cast<float>(point[2])};
}

/// Left out where corners coincide in single precision: neighbours still fit. Three corners on a line have the normal
/// 0.
void append_triangle(std::string& bytes, Corner const& a, Corner const& b, Corner const& c)
{
    Eigen::Vector3d const normal = (b - a).cast<double>().cross((c - a).cast<double>());
    if (a == b || b == c || c == a)
        return;
    for (Corner const& each : {Corner(normal.normalized().cast<float>()), a, b, c}) {
        for (float const number : each)
            io::append_little_endian(bytes, number);
    }
    io::append_little_endian(bytes, std::uint16_t{0});
}

}  // namespace

void write_stl(Solution const& solution, std::filesystem::path const& file, SurfaceOptions const& options)
{
    auto const surface = io::spline_surface(solution, options);
    std::string triangles;
    triangles.reserve(2 * surface.quads.size() * triangle_bytes);
    for (auto const& quad : surface.quads) {
        auto const corner = [&](std::size_t i) { return single(surface.points[static_cast<std::size_t>(quad[i])]); };
        append_triangle(triangles, corner(0), corner(1), corner(2));
        append_triangle(triangles, corner(0), corner(2), corner(3));
    }
    std::string bytes = "binary STL by hdconj, toothed surface of the circular spline, mm";
    bytes.resize(title_bytes, ' ');
    io::append_little_endian(bytes, static_cast<std::uint32_t>(triangles.size() / triangle_bytes));
    file::write_text_atomically(file, bytes + triangles);
}

}  // namespace hdconj
