// SPDX-License-Identifier: GPL-3.0-or-later
// The bent cup, quadratic elements, arrays as text.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "elastic/bent_cup.hpp"
#include "elastic/swept_mesh.hpp"
#include "hdconj/file/atomic_file.hpp"
#include "hdconj/mesh_files.hpp"
#include "vtu_text.hpp"

namespace hdconj {
namespace {

constexpr int quadratic_hexahedron = 25;  // VTK's number of the cell's kind

/// Equivalent stress at a node: the mean of its elements.
class NodalStress
{
  public:
    NodalStress(elastic::SectionMesh const& mesh, elastic::HarmonicField const& field, std::vector<double> const& phi)
        : stress_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(mesh.nodes.size()),
                                        static_cast<Eigen::Index>(phi.size())))
    {
        std::vector<Vec2> const nodes{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}};
        Eigen::MatrixXd const stress = elastic::recovered_stress(mesh, field, nodes, phi);
        Eigen::VectorXd times = Eigen::VectorXd::Zero(stress_.rows());
        for (std::size_t e = 0; e < mesh.elements.size(); ++e)
            for (std::size_t a = 0; a < nodes.size(); ++a) {
                auto const node = static_cast<Eigen::Index>(mesh.elements[e][a]);
                stress_.row(node) += stress.row(static_cast<Eigen::Index>(nodes.size() * e + a));
                times[node] += 1;
            }
        stress_ = times.cwiseInverse().asDiagonal() * stress_;
    }

    [[nodiscard]] double at(int node, std::size_t angle) const
    {
        return stress_(node, static_cast<Eigen::Index>(angle));
    }

  private:
    Eigen::MatrixXd stress_;
};

/// An array as text, a line for each of @p items.
template <class Items, class Write>
std::string array(char const* attributes, Items const& items, Write write)
{
    std::string text = fmt::format("<DataArray {} format=\"ascii\">\n", attributes);
    for (auto const& item : items) {
        write(std::back_inserter(text), item);
        text += '\n';
    }
    return text + "</DataArray>\n";
}

using Out = std::back_insert_iterator<std::string>;

void write_three(Out out, std::array<double, 3> const& values)
{
    fmt::format_to(out, "{:.9g} {:.9g} {:.9g}", values[0], values[1], values[2]);
}

}  // namespace

void write_vtu(elastic::BentCup const& cup, std::filesystem::path const& file, int steps)
{
    elastic::SectionMesh const& section = cup.solid().mesh();
    elastic::SweptMesh const mesh = elastic::swept_mesh(section, 2 * std::numbers::pi, steps);
    std::vector<double> phi;
    for (int i = 0; i < 2 * steps; ++i)
        phi.push_back(std::numbers::pi * i / steps);
    NodalStress const stress(section, cup.field(), phi);
    auto const angle_of = [&](elastic::SweptNode const& node) {
        return static_cast<std::size_t>(std::lround(node.phi * steps / std::numbers::pi));
    };

    std::vector<std::size_t> number(mesh.elements.size());
    std::iota(number.begin(), number.end(), std::size_t{0});

    io::VtuText grid;
    grid.arrays_are = "version=\"0.1\" byte_order=\"LittleEndian\"";
    grid.points = mesh.nodes.size();
    grid.cells = mesh.elements.size();
    grid.point_array =
        array("type=\"Float64\" NumberOfComponents=\"3\"", mesh.nodes, [&](Out out, elastic::SweptNode const& node) {
            Vec2 const& at = section.nodes[static_cast<std::size_t>(node.section)];
            write_three(out, io::SectionAxes(node.phi).point(at.x(), at.y() - cup.bearing().middle));
        });
    grid.cell_arrays = array("type=\"Int32\" Name=\"connectivity\"", mesh.elements, [](Out out, auto const& element) {
        // sin and cos have changed places: the frame is the mirror image, and the faces change theirs
        for (std::size_t const a :
             {4U, 5U, 6U, 7U, 0U, 1U, 2U, 3U, 12U, 13U, 14U, 15U, 8U, 9U, 10U, 11U, 16U, 17U, 18U, 19U}) {
            fmt::format_to(out, "{} ", element[a]);
        }
    });
    grid.cell_arrays += array("type=\"Int32\" Name=\"offsets\"", number,
                              [](Out out, std::size_t i) { fmt::format_to(out, "{}", 20 * (i + 1)); });
    grid.cell_arrays += array("type=\"UInt8\" Name=\"types\"", number,
                              [](Out out, std::size_t) { fmt::format_to(out, "{}", quadratic_hexahedron); });
    grid.shown = "Vectors=\"displacement\" Scalars=\"von_mises\"";
    grid.data_arrays = array("type=\"Float64\" Name=\"displacement\" NumberOfComponents=\"3\"", mesh.nodes,
                             [&](Out out, elastic::SweptNode const& node) {
                                 Eigen::Vector3d const u =
                                     elastic::node_displacement(cup.field(), node.section, node.phi);
                                 write_three(out, io::SectionAxes(node.phi).vector(u[0], u[2], u[1]));
                             });
    grid.data_arrays +=
        array("type=\"Float64\" Name=\"von_mises\"", mesh.nodes, [&](Out out, elastic::SweptNode const& node) {
            fmt::format_to(out, "{:.6g}", stress.at(node.section, angle_of(node)));
        });
    file::write_text_atomically(file, io::vtu_text(grid));
}

}  // namespace hdconj
