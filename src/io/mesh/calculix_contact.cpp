// SPDX-License-Identifier: GPL-3.0-or-later
// Cup and bearing in unilateral contact, as a deck for CalculiX.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "calculix_deck.hpp"

namespace hdconj::io {
namespace {

/// Elements on a surface of the wall, named by the face that lies there: sides xi = -1 (inner) and xi = 1 (outer) of
/// the section's elements.
void put_surface(std::string& deck, DeckBody const& body, std::string const& name, bool inner, double low, double high)
{
    deck += "*SURFACE, NAME=" + name + "\n";
    constexpr double close = 1e-9;  // of one and the same height, rounded differently
    int const layers = body.section.layers;
    auto const in_step = static_cast<int>(body.section.elements.size());
    for (int e = 0; e < static_cast<int>(body.mesh.elements.size()); ++e) {
        int const of_section = e % in_step;
        if (of_section >= static_cast<int>(body.section.wall_elements()) ||
            of_section / layers < body.section.straight || of_section % layers != (inner ? 0 : layers - 1)) {
            continue;
        }
        elastic::QuadraticElement const& q = body.section.elements[static_cast<std::size_t>(of_section)];
        double const bottom = body.section.nodes[static_cast<std::size_t>(q[0])].y(),
                     top = body.section.nodes[static_cast<std::size_t>(q[3])].y();
        if (bottom > low - close && top < high + close)
            fmt::format_to(std::back_inserter(deck), "{}, S{}\n", body.elements_before + e + 1, inner ? 6 : 4);
    }
}

/// The bearing as a ring of elements twice as long as the cup's, whose middle carries the line of balls.
DeckBody bearing_body(elastic::BentCup const& cup, DeckBody const& cup_body)
{
    double const along = elastic::mesh_size(cup.section().inner_radius).across;
    double const backing = 1.2 * along;  // of a rigid surface, which is as thick as one likes
    // Surfaces that coincide to rounding would touch at some points and not at others. CalculiX then finds a state with
    // a third of the force, or none. With an overlap of 10 nm it starts from contact everywhere.
    constexpr double overlap = 1e-5;  // [mm]
    elastic::Bearing const& bearing = cup.bearing();
    double const thickness = bearing.ring ? bearing.ring->thickness : backing;
    double const outer = cup.section().inner_radius + overlap + (bearing.ring ? bearing.fit : 0),
                 half = bearing.width / 2;
    DeckBody body =
        deck_body(elastic::ring_mesh({outer - thickness, bearing.middle - half}, {outer, bearing.middle + half},
                                     bearing.ring ? bearing.ring->material : cup.solid().mesh().material,
                                     {along, std::max(along, thickness / 2)}),
                  cup.cam(), cup_body.steps);
    body.before = static_cast<int>(cup_body.mesh.nodes.size());
    body.elements_before = static_cast<int>(cup_body.mesh.elements.size());
    return body;
}

/// Nodes that the cam moves: of a rigid bearing all, of a ring those on the line of balls where the ring lies on them.
std::vector<int> moved_nodes(elastic::BentCup const& cup, DeckBody const& body)
{
    elastic::WaveGeneratorContact const& contact = cup.contact();
    int const last = static_cast<int>(contact.ball_gap.size()) - 1;
    double const arc = last > 0 ? contact.ball_phi[1] : 0, lobe = 2 * std::numbers::pi / cup.cam().waves;
    auto const stands_off = [&](double phi) {
        double inside = std::fmod(phi, lobe);
        inside = body.half && inside > lobe / 2 ? lobe - inside : inside;
        int const below = static_cast<int>(std::lround(inside / arc));
        return contact.ball_gap[static_cast<std::size_t>(body.half ? std::min(below, last) : below % (last + 1))] > 0;
    };
    Vec2 line(std::numeric_limits<double>::max(), cup.bearing().middle);
    for (Vec2 const& at : body.section.nodes)
        line.x() = std::min(line.x(), at.x());
    constexpr double close = 1e-9;  // of one and the same place, rounded differently
    return nodes_where(body, [&](std::size_t i) {
        return !cup.bearing().ring || ((body.at(i) - line).norm() < close && !stands_off(body.mesh.nodes[i].phi));
    });
}

/// Resultant of the bearing's forces on the part of the cup that the deck has, in the plane across the axis [N].
Vec2 resultant(elastic::WaveGeneratorContact const& contact, bool half)
{
    Vec2 sum = Vec2::Zero();
    for (Eigen::Index i = 0; i < contact.force.rows(); ++i) {
        // on a plane of symmetry half of the force belongs to the other side
        double const share = half && (i == 0 || i == contact.force.rows() - 1) ? 0.5 : 1;
        double const phi = contact.phi[static_cast<std::size_t>(i)];
        sum += share * contact.force.row(i).sum() * Vec2(std::cos(phi), std::sin(phi));
    }
    return sum;
}

/// Both bodies with their materials and the sets of nodes and surfaces.
void put_bodies(std::string& deck, elastic::BentCup const& cup, DeckBody const& cup_body, DeckBody const& ring,
                std::vector<int> const& moved)
{
    put_nodes(deck, cup_body, "NCUP");
    put_nodes(deck, ring, "NRING");
    put_elements(deck, cup_body, "ECUP");
    put_elements(deck, ring, "ERING");
    put_material(deck, cup_body, "CUP", "ECUP");
    put_material(deck, ring, "RING", "ERING");
    put_node_set(deck, cup_body, "NCLAMP", held_nodes(cup_body));
    put_node_set(deck, cup_body, "NWATCH", watched_nodes(cup_body, cup));
    put_node_set(deck, ring, "NCAM", moved);
    if (ring.half) {
        put_node_set(deck, cup_body, "NPLANES", plane_nodes(cup_body));
        if (cup.bearing().ring)
            put_node_set(deck, ring, "NRINGPLANES", plane_nodes(ring));
    }
    put_surface(deck, cup_body, "SCUP", true, 0, cup.section().length);
    put_surface(deck, ring, "SRING", false, 0, cup.section().length);
}

/// Unilateral contact without friction by a linear penalty.
void put_contact(std::string& deck, double youngs_modulus)
{
    // Penalty in moduli per mm: 1000 MPa at an edge overlap by 0.1 um, and 1 um changes the coning by 0.02 degrees.
    constexpr double stiffer = 50;
    fmt::format_to(std::back_inserter(deck),
                   "*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{:.10g}\n"
                   "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE\nSRING, SCUP\n",
                   stiffer * youngs_modulus);
}

/// What holds the bodies while the cam moves the nodes of @p ring from number @p first on.
void put_supports(std::string& deck, elastic::Bearing const& bearing, DeckBody const& ring, int first)
{
    deck += "** 1 radial, 2 tangential, 3 axial\n";
    put_axes(deck, "NCUP");
    put_axes(deck, "NRING");
    deck += "*BOUNDARY\nNCLAMP, 1, 3\n";
    deck += ring.half ? "NPLANES, 2, 2\n" : "";
    if (!bearing.ring) {
        deck += "NCAM, 2, 3\n";
        return;
    }
    deck += ring.half ? "NRINGPLANES, 2, 2\n" : fmt::format("{}, 2, 2\n", first);
    deck += bearing.ring->axially_held ? "NCAM, 3, 3\n" : fmt::format("{}, 3, 3\n", first);
}

}  // namespace

ContactDeck contact_deck(elastic::BentCup const& cup, DeckBody const& cup_body)
{
    elastic::Bearing const& bearing = cup.bearing();
    DeckBody const ring = bearing_body(cup, cup_body);
    std::vector<int> const moved = moved_nodes(cup, ring);
    std::string deck = fmt::format(
        "** The cup of a harmonic drive and its wave generator's bearing in unilateral contact without friction, small "
        "displacements. mm, N, MPa.\n"
        "** The bearing is {}. Displacements must come near expected.csv, forces near expected_contact.csv: run ccx "
        "contact, then python3 compare.py contact.\n",
        bearing.ring ? "an elastic outer ring, its balls moved by the cam"
                     : "rigid: all of its nodes are moved by the cam");
    put_bodies(deck, cup, cup_body, ring, moved);
    put_contact(deck, cup_body.section.material.youngs_modulus);
    put_supports(deck, bearing, ring, ring.before + moved.front() + 1);
    // Contact turns large displacements on, unless they are forbidden. One increment, since each further one would take
    // up the contact in the deformed shape: 3 % less force. An iteration counts as converged only when no point changes
    // between open and closed; by default one in a thousand may.
    deck +=
        "*STEP, NLGEOM=NO, INC=100\n*CONTROLS, PARAMETERS=CONTACT\n1e-9, 0.1, 100, 200\n*STATIC\n1., 1.\n*BOUNDARY\n";
    double const oversize = bearing.cam_oversize + (bearing.ring ? 0 : bearing.fit);
    for (int const node : moved) {
        fmt::format_to(std::back_inserter(deck), "{}, 1, 1, {:.10g}\n", ring.before + node + 1,
                       cup.cam().at(ring.mesh.nodes[static_cast<std::size_t>(node)].phi) + oversize);
    }
    deck +=
        "*NODE PRINT, NSET=NWATCH, GLOBAL=NO\nU\n*NODE PRINT, NSET=NCAM, GLOBAL=NO\nRF\n*CONTACT PRINT, SLAVE=SRING, "
        "MASTER=SCUP\nCF\n"
        "*NODE FILE\nU\n*EL FILE\nS\n*CONTACT FILE\nCDIS, CSTR\n*END STEP\n";

    Vec2 const force = resultant(cup.contact(), ring.half);
    std::string const expected =
        fmt::format("quantity,value\nforce_x_N,{:.9g}\nforce_y_N,{:.9g}\n", force.x(), force.y());
    return {std::move(deck), expected};
}

}  // namespace hdconj::io
