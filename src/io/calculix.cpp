// SPDX-License-Identifier: GPL-3.0-or-later
// A deck for CalculiX: https://www.dhondt.de, keywords as in its manual.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "atomic_folder.hpp"
#include "calculix_deck.hpp"
#include "hdconj/io/cup_files.hpp"

namespace hdconj {

namespace {

/// Radial forces of the bearing at the nodes of the deck [N].
std::vector<double> bearing_loads(BentCup const& cup, DeckBody const& body, int steps)
{
    SectionMesh const& section = cup.solid().mesh();
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
    return swept_loads(section, body.mesh, body.angle, steps, cup.cam().waves, radial * cup.contact().load_cosine, radial * cup.contact().load_sine);
}

std::string linear_deck(BentCup const& cup, DeckBody const& body, std::vector<int> const& watched, int steps)
{
    auto const loads = bearing_loads(cup, body, steps);
    std::string deck = fmt::format("** The cup of a harmonic drive under the forces of its wave generator's bearing, linear. mm, N, MPa.\n"
                                   "** {} of it. Displacements must come to expected.csv: run ccx linear, then compare linear.dat.\n",
                                   body.half ? "Half a lobe, between two planes of symmetry," : "All");
    auto const out = std::back_inserter(deck);
    put_nodes(deck, body, "NALL");
    put_elements(deck, body, "EALL");
    put_material(deck, body, "CUP", "EALL");
    put_node_set(deck, body, "NCLAMP", held_nodes(body));
    if (body.half) {
        put_node_set(deck, body, "NPLANES", plane_nodes(body));
    }
    put_node_set(deck, body, "NWATCH", watched);
    deck += "** 1 radial, 2 tangential, 3 axial\n";
    put_axes(deck, "NALL");
    deck += "*BOUNDARY\nNCLAMP, 1, 3\n";
    deck += body.half ? "NPLANES, 2, 2\n" : "";
    deck += "*STEP\n*STATIC\n*CLOAD\n";
    for (std::size_t i = 0; i < loads.size(); ++i) {
        if (loads[i] != 0) {
            fmt::format_to(out, "{}, 1, {:.10g}\n", i + 1, loads[i]);
        }
    }
    deck += "*NODE PRINT, NSET=NWATCH, GLOBAL=NO\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
    return deck;
}

/// What the program itself has at the watched nodes.
std::string expected_displacements(BentCup const& cup, DeckBody const& body, std::vector<int> const& watched)
{
    std::string expected = "node,r,z,phi_deg,u_r,u_t,u_z\n";
    for (int const i : watched) {
        SweptNode const& node = body.mesh.nodes[static_cast<std::size_t>(i)];
        Vec2 const& at = cup.solid().mesh().nodes[static_cast<std::size_t>(node.section)];
        Eigen::Vector3d const u = node_displacement(cup.field(), node.section, node.phi);
        fmt::format_to(std::back_inserter(expected), "{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", i + 1, at.x(), at.y(), node.phi * 180 / std::numbers::pi,
                       u[0], u[2], u[1]);
    }
    return expected;
}

}  // namespace

void check_calculix(std::filesystem::path const& folder)
{
    AtomicFolder::check(folder, AtomicFolder::calculix_deck);
}

void write_calculix(BentCup const& cup, std::filesystem::path const& folder, int steps, bool contact)
{
    DeckBody const body = deck_body(cup.solid().mesh(), cup.cam(), steps);
    auto const watched = watched_nodes(body, cup);
    std::string const deck = linear_deck(cup, body, watched, steps);
    std::string const expected = expected_displacements(cup, body, watched);
    AtomicFolder made(folder, AtomicFolder::calculix_deck);
    std::vector<std::pair<std::string, std::string>> list{{"linear.inp", "cup under the forces of its bearing, geometrically linear: run ccx linear"},
                                                          {"expected.csv", "what linear.dat must say of the nodes NWATCH: displacements in mm"}};
    made.write("linear.inp", deck);
    made.write("expected.csv", expected);
    if (contact) {
        ContactDeck const two = contact_deck(cup, body);
        made.write("contact.inp", two.deck);
        made.write("expected_contact.csv", two.expected);
        list.emplace_back("contact.inp", "cup and bearing in unilateral contact: run ccx contact; displacements of NWATCH again as in expected.csv");
        list.emplace_back("expected_contact.csv", "what contact.dat must say of the surfaces' total force, but for its sign");
    }
    made.publish(list);
}

}  // namespace hdconj
