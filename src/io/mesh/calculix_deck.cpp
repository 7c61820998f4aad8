// SPDX-License-Identifier: GPL-3.0-or-later
#include "calculix_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace hdconj::io {

DeckBody deck_body(elastic::SectionMesh section, elastic::CamSeries const& cam, int steps)
{
    DeckBody body;
    body.half = cam.even;
    body.angle = cam.even ? std::numbers::pi / cam.waves : 2 * std::numbers::pi;
    body.steps = steps;
    body.mesh = elastic::swept_mesh(section, body.angle, steps);
    body.section = std::move(section);
    return body;
}

namespace {

bool is_held(DeckBody const& body, std::size_t node)
{
    auto const& clamped = body.section.clamped;
    return std::find(clamped.begin(), clamped.end(), body.mesh.nodes[node].section) != clamped.end();
}

}  // namespace

std::vector<int> held_nodes(DeckBody const& body)
{
    return nodes_where(body, [&](std::size_t i) { return is_held(body, i); });
}

std::vector<int> plane_nodes(DeckBody const& body)
{
    double const close = body.angle / (4 * body.steps);
    return nodes_where(body, [&](std::size_t i) {
        double const phi = body.mesh.nodes[i].phi;
        return body.half && (phi < close || phi > body.angle - close) && !is_held(body, i);
    });
}

std::vector<int> watched_nodes(DeckBody const& body, elastic::BentCup const& cup)
{
    elastic::CupSection const& section = cup.section();
    double const angle = std::numbers::pi / cup.cam().waves;
    constexpr double close = 1e-9;  // of one and the same coordinate, rounded differently
    return nodes_where(body, [&](std::size_t i) {
        double const phi = body.mesh.nodes[i].phi;
        Vec2 const& at = body.at(i);
        bool const inner = std::abs(at.x() - section.inner_radius) < close,
                   outer = std::abs(at.x() - section.inner_radius - section.ring_wall) < close;
        bool const in_ring = at.y() > section.ring_begin - close && at.y() < section.ring_end + close;
        bool const in_plane =
            std::abs(phi) < close || std::abs(phi - angle) < close || std::abs(phi - angle / 2) < close;
        return in_ring && in_plane && (inner || outer);
    });
}

void put_nodes(std::string& deck, DeckBody const& body, std::string const& name)
{
    auto const out = std::back_inserter(deck);
    fmt::format_to(out, "*NODE, NSET={}\n", name);
    for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i) {
        Vec2 const& at = body.at(i);
        double const phi = body.mesh.nodes[i].phi;
        fmt::format_to(out, "{}, {:.10g}, {:.10g}, {:.10g}\n", body.before + static_cast<int>(i) + 1,
                       at.x() * std::cos(phi), at.x() * std::sin(phi), at.y());
    }
}

void put_elements(std::string& deck, DeckBody const& body, std::string const& name)
{
    auto const out = std::back_inserter(deck);
    // teeth, whose material lacks two of the six stresses, need full integration
    for (bool const outside : {false, true}) {
        if (!outside || body.section.outer) {
            fmt::format_to(out, "*ELEMENT, TYPE={}, ELSET={}\n", outside ? "C3D20" : "C3D20R",
                           outside ? name + "TEETH" : name);
        }
        for (std::size_t e = 0; e < body.mesh.elements.size(); ++e) {
            if ((e % body.section.elements.size() >= body.section.wall_elements()) != outside)
                continue;
            fmt::format_to(out, "{}, ", body.elements_before + static_cast<int>(e) + 1);
            std::size_t written = 1;
            for (int const node : body.mesh.elements[e]) {
                // at most sixteen numbers in a line, and no comma behind the last
                fmt::format_to(out, "{}{}", body.before + node + 1,
                               written == 20       ? "\n"
                               : written % 15 == 0 ? ",\n"
                                                   : ", ");
                ++written;
            }
        }
    }
}

void put_material(std::string& deck, DeckBody const& body, std::string const& name, std::string const& elements)
{
    auto const out = std::back_inserter(deck);
    elastic::SectionMesh const& section = body.section;
    if (section.outer) {
        // 1 radial, 2 tangential, 3 axial; ours are rr, zz, tt, rz, rt, zt
        elastic::StressMatrix const& d = section.outer->stress;
        constexpr Eigen::Index rr = 0, zz = 1, tt = 2, rz = 3, rt = 4, zt = 5;
        fmt::format_to(out,
                       "*ORIENTATION, NAME=ROUND, SYSTEM=CYLINDRICAL\n0., 0., 0., 0., 0., 1.\n*MATERIAL, "
                       "NAME={}TEETH\n*ELASTIC, TYPE=ORTHO\n",
                       name);
        fmt::format_to(out, "{:.10g}, {:.10g}, {:.10g}, {:.10g}, {:.10g}, {:.10g}, {:.10g}, {:.10g},\n{:.10g}\n",
                       d(rr, rr), d(rr, tt), d(tt, tt), d(rr, zz), d(tt, zz), d(zz, zz), d(rt, rt), d(rz, rz),
                       d(zt, zt));
        fmt::format_to(out, "*SOLID SECTION, ELSET={}TEETH, MATERIAL={}TEETH, ORIENTATION=ROUND\n", elements, name);
    }
    fmt::format_to(out, "*MATERIAL, NAME={0}\n*ELASTIC\n{2:.10g}, {3:.10g}\n*SOLID SECTION, ELSET={1}, MATERIAL={0}\n",
                   name, elements, section.material.youngs_modulus, section.material.poissons_ratio);
}

void put_node_set(std::string& deck, DeckBody const& body, std::string const& name, std::vector<int> const& nodes)
{
    fmt::format_to(std::back_inserter(deck), "*NSET, NSET={}\n", name);
    std::size_t i = 0;
    for (int const node : nodes) {
        deck += std::to_string(body.before + node + 1);
        deck += ++i % 12 == 0 || i == nodes.size() ? ",\n" : ", ";
    }
}

void put_axes(std::string& deck, std::string const& set)
{
    deck += "*TRANSFORM, NSET=" + set + ", TYPE=C\n0., 0., 0., 0., 0., 1.\n";
}

}  // namespace hdconj::io
