// SPDX-License-Identifier: GPL-3.0-or-later
// A deck for CalculiX: https://www.dhondt.de, keywords as in its manual.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "hdconj/elastic/swept_mesh.hpp"
#include "hdconj/io/cup_files.hpp"
#include "wire_folder.hpp"

namespace hdconj {
namespace {

/// Numbers in lines of a few.
template <class Range, class Write>
void in_lines(std::string& text, Range const& range, std::size_t each, Write&& write)
{
    std::size_t i = 0;
    for (auto const& item : range) {
        write(item);
        text += ++i % each == 0 || i == range.size() ? ",\n" : ", ";
    }
}

void node_set(std::string& text, std::string const& name, std::vector<int> const& nodes)
{
    fmt::format_to(std::back_inserter(text), "*NSET, NSET={}\n", name);
    in_lines(text, nodes, 12, [&](int node) { text += std::to_string(node + 1); });
}

/// Nodes whose displacements are compared: on the inner and outer surface of the tooth ring, in two planes.
std::vector<int> watched(SectionMesh const& section, SweptMesh const& mesh, CupSection const& cup, double angle)
{
    std::vector<int> nodes;
    constexpr double close = 1e-9;  // of one and the same coordinate, rounded differently
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        SweptNode const& node = mesh.nodes[i];
        Vec2 const& at = section.nodes[static_cast<std::size_t>(node.section)];
        bool const inner = std::abs(at.x() - cup.inner_radius) < close, outer = std::abs(at.x() - cup.inner_radius - cup.ring_wall) < close;
        bool const in_ring = at.y() > cup.ring_begin - close && at.y() < cup.ring_end + close;
        bool const in_plane = std::abs(node.phi) < close || std::abs(node.phi - angle) < close || std::abs(node.phi - angle / 2) < close;
        if (in_ring && in_plane && (inner || outer)) {
            nodes.push_back(static_cast<int>(i));
        }
    }
    return nodes;
}

}  // namespace

void write_calculix(BentCup const& cup, std::filesystem::path const& folder, int steps)
{
    SectionMesh const& section = cup.solid().mesh();
    int const waves = cup.cam().waves;
    bool const half = cup.cam().even;
    double const angle = half ? std::numbers::pi / waves : 2 * std::numbers::pi;
    SweptMesh const mesh = swept_mesh(section, angle, steps);

    std::vector<Station> stations;
    for (double const z : cup.contact().z) {
        stations.push_back(wall_station(section, z, 0, Direction::radial));
    }
    Eigen::MatrixXd const shares = station_shares(cup.solid(), stations);
    auto const nodes = static_cast<Eigen::Index>(section.nodes.size());
    Eigen::MatrixXd radial(nodes, shares.cols());
    for (Eigen::Index i = 0; i < nodes; ++i) {
        radial.row(i) = shares.row(3 * i);
    }
    auto const loads = swept_loads(section, mesh, angle, steps, waves, radial * cup.contact().load_cosine, radial * cup.contact().load_sine);

    std::string deck = fmt::format("** The cup of a harmonic drive under the forces of its wave generator's bearing, linear. mm, N, MPa.\n"
                                   "** {} of it. Displacements must come to expected.csv: run ccx linear, then compare linear.dat.\n*NODE, NSET=NALL\n",
                                   half ? "Half a lobe, between two planes of symmetry," : "All");
    auto const out = std::back_inserter(deck);
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        Vec2 const& at = section.nodes[static_cast<std::size_t>(mesh.nodes[i].section)];
        double const phi = mesh.nodes[i].phi;
        fmt::format_to(out, "{}, {:.10g}, {:.10g}, {:.10g}\n", i + 1, at.x() * std::cos(phi), at.x() * std::sin(phi), at.y());
    }
    deck += "*ELEMENT, TYPE=C3D20R, ELSET=EALL\n";
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        deck += std::to_string(e + 1) + ", ";
        std::size_t written = 1;
        for (int const node : mesh.elements[e]) {
            // at most sixteen numbers in a line, and no comma behind the last
            fmt::format_to(out, "{}{}", node + 1, written == 20 ? "\n" : written % 15 == 0 ? ",\n" : ", ");
            ++written;
        }
    }
    fmt::format_to(out, "*MATERIAL, NAME=CUP\n*ELASTIC\n{:.10g}, {:.10g}\n*SOLID SECTION, ELSET=EALL, MATERIAL=CUP\n", section.material.youngs_modulus,
                   section.material.poissons_ratio);
    std::vector<int> clamped, planes;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        SweptNode const& node = mesh.nodes[i];
        bool const is_clamped = std::find(section.clamped.begin(), section.clamped.end(), node.section) != section.clamped.end();
        bool const on_plane = half && (node.phi == 0 || std::abs(node.phi - angle) < angle / (4 * steps));
        if (is_clamped) {
            clamped.push_back(static_cast<int>(i));
        } else if (on_plane) {
            planes.push_back(static_cast<int>(i));
        }
    }
    auto const compared = watched(section, mesh, cup.section(), half ? angle : std::numbers::pi / waves);
    node_set(deck, "NCLAMP", clamped);
    if (half) {
        node_set(deck, "NPLANES", planes);
    }
    node_set(deck, "NWATCH", compared);
    deck += "** 1 radial, 2 tangential, 3 axial\n*TRANSFORM, NSET=NALL, TYPE=C\n0., 0., 0., 0., 0., 1.\n*BOUNDARY\nNCLAMP, 1, 3\n";
    deck += half ? "NPLANES, 2, 2\n" : "";
    deck += "*STEP\n*STATIC\n*CLOAD\n";
    for (std::size_t i = 0; i < loads.size(); ++i) {
        if (loads[i] != 0) {
            fmt::format_to(out, "{}, 1, {:.10g}\n", i + 1, loads[i]);
        }
    }
    deck += "*NODE PRINT, NSET=NWATCH, GLOBAL=NO\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";

    std::string expected = "node,r,z,phi_deg,u_r,u_t,u_z\n";
    for (int const i : compared) {
        SweptNode const& node = mesh.nodes[static_cast<std::size_t>(i)];
        Vec2 const& at = section.nodes[static_cast<std::size_t>(node.section)];
        Eigen::Vector3d const u = node_displacement(cup.field(), node.section, node.phi);
        fmt::format_to(std::back_inserter(expected), "{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", i + 1, at.x(), at.y(), node.phi * 180 / std::numbers::pi,
                       u[0], u[2], u[1]);
    }
    WireFolder made(folder);
    made.write("linear.inp", deck);
    made.write("expected.csv", expected);
    made.publish({{"linear.inp", "cup under the forces of its bearing, geometrically linear: run ccx linear"},
                  {"expected.csv", "what linear.dat must say of the nodes NWATCH: displacements in mm"}});
}

}  // namespace hdconj
