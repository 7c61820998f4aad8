// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML, unstructured grid, as text.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "hdconj/elastic/swept_mesh.hpp"
#include "hdconj/io/atomic_file.hpp"
#include "hdconj/io/cup_files.hpp"

namespace hdconj {
namespace {

constexpr int quadratic_hexahedron = 25;  // VTK's number of the cell's kind

/// Equivalent stress at a node: in each of its elements extrapolated from the reduced Gauss points, then averaged.
class NodalStress
{
  public:
    NodalStress(SectionMesh const& mesh, HarmonicField const& field, std::vector<double> const& phi) : stress_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(mesh.nodes.size()), static_cast<Eigen::Index>(phi.size())))
    {
        Eigen::MatrixXd const gauss = gauss_stress(mesh, field, phi);
        Eigen::VectorXd times = Eigen::VectorXd::Zero(stress_.rows());
        constexpr double corner[8][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
        double const far = std::sqrt(3.0);
        for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        {
            for (std::size_t a = 0; a < 8; ++a)
            {
                double const x = far * corner[a][0], y = far * corner[a][1];
                auto const first = static_cast<Eigen::Index>(4 * e);
                auto const node = static_cast<Eigen::Index>(mesh.elements[e][a]);
                stress_.row(node) += ((1 - x) * (1 - y) * gauss.row(first) + (1 + x) * (1 - y) * gauss.row(first + 1) + (1 - x) * (1 + y) * gauss.row(first + 2) +
                                      (1 + x) * (1 + y) * gauss.row(first + 3)) / 4;
                times[node] += 1;
            }
        }
        stress_ = times.cwiseInverse().asDiagonal() * stress_;
    }

    [[nodiscard]] double at(int node, std::size_t angle) const { return std::max(0.0, stress_(node, static_cast<Eigen::Index>(angle))); }

  private:
    Eigen::MatrixXd stress_;
};

void array(std::string& text, char const* attributes)
{
    text += fmt::format("<DataArray {} format=\"ascii\">\n", attributes);
}

}  // namespace

void write_vtu(BentCup const& cup, std::filesystem::path const& file, int steps)
{
    SectionMesh const& section = cup.solid().mesh();
    SweptMesh const mesh = swept_mesh(section, 2 * std::numbers::pi, steps);
    std::vector<double> phi;
    for (int i = 0; i < 2 * steps; ++i) {
        phi.push_back(std::numbers::pi * i / steps);
    }
    NodalStress const stress(section, cup.field(), phi);
    auto const angle_of = [&](SweptNode const& node) { return static_cast<std::size_t>(std::lround(node.phi * steps / std::numbers::pi)); };

    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n";
    auto const out = std::back_inserter(text);
    fmt::format_to(out, "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n", mesh.nodes.size(), mesh.elements.size());
    array(text, "type=\"Float64\" NumberOfComponents=\"3\"");
    for (SweptNode const& node : mesh.nodes) {
        Vec2 const& at = section.nodes[static_cast<std::size_t>(node.section)];
        fmt::format_to(out, "{:.9g} {:.9g} {:.9g}\n", at.x() * std::sin(node.phi), at.x() * std::cos(node.phi), at.y() - cup.bearing().middle);
    }
    text += "</DataArray>\n</Points>\n<Cells>\n";
    array(text, "type=\"Int32\" Name=\"connectivity\"");
    for (auto const& element : mesh.elements) {
        // sin and cos have changed places: the frame is the mirror image, and the faces change theirs
        for (std::size_t const a : {4U, 5U, 6U, 7U, 0U, 1U, 2U, 3U, 12U, 13U, 14U, 15U, 8U, 9U, 10U, 11U, 16U, 17U, 18U, 19U}) {
            fmt::format_to(out, "{} ", element[a]);
        }
        text += '\n';
    }
    text += "</DataArray>\n";
    array(text, "type=\"Int32\" Name=\"offsets\"");
    for (std::size_t i = 1; i <= mesh.elements.size(); ++i) {
        fmt::format_to(out, "{}\n", 20 * i);
    }
    text += "</DataArray>\n";
    array(text, "type=\"UInt8\" Name=\"types\"");
    for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
        fmt::format_to(out, "{}\n", quadratic_hexahedron);
    }
    text += "</DataArray>\n</Cells>\n<PointData Vectors=\"displacement\" Scalars=\"von_mises\">\n";
    array(text, "type=\"Float64\" Name=\"displacement\" NumberOfComponents=\"3\"");
    for (SweptNode const& node : mesh.nodes) {
        Eigen::Vector3d const u = node_displacement(cup.field(), node.section, node.phi);
        double const s = std::sin(node.phi), c = std::cos(node.phi);
        fmt::format_to(out, "{:.9g} {:.9g} {:.9g}\n", u[0] * s + u[2] * c, u[0] * c - u[2] * s, u[1]);
    }
    text += "</DataArray>\n";
    array(text, "type=\"Float64\" Name=\"von_mises\"");
    for (SweptNode const& node : mesh.nodes) {
        fmt::format_to(out, "{:.6g}\n", stress.at(node.section, angle_of(node)));
    }
    text += "</DataArray>\n</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    write_text_atomically(file, text);
}

}  // namespace hdconj
