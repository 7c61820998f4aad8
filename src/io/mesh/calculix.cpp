// SPDX-License-Identifier: GPL-3.0-or-later
// A deck for CalculiX: https://www.dhondt.de, keywords as in its manual.
#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "calculix_deck.hpp"
#include "compare_script.hpp"
#include "file/atomic_folder.hpp"
#include "hdconj/mesh_files.hpp"
#include "hdconj/units.hpp"

namespace hdconj {
namespace {

/// Radial forces of the bearing at the nodes of the deck [N].
std::vector<double> bearing_loads(elastic::BentCup const& cup, io::DeckBody const& body, int steps)
{
    elastic::SectionMesh const& section = cup.solid().mesh();
    std::vector<elastic::Station> stations;
    for (double const z : cup.contact().z)
        stations.push_back(elastic::wall_station(section, z, 0, elastic::Direction::radial));
    Eigen::MatrixXd const shares = elastic::station_shares(cup.solid(), stations);
    auto const nodes = static_cast<Eigen::Index>(section.nodes.size());
    Eigen::MatrixXd radial(nodes, shares.cols());
    for (Eigen::Index i = 0; i < nodes; ++i)
        radial.row(i) = shares.row(3 * i);
    return elastic::swept_loads(section, body.mesh, body.angle, steps, cup.cam().waves,
                                radial * cup.contact().load_cosine, radial * cup.contact().load_sine);
}

std::string linear_deck(elastic::BentCup const& cup, io::DeckBody const& body, std::vector<int> const& watched,
                        int steps)
{
    auto const loads = bearing_loads(cup, body, steps);
    std::string deck = fmt::format(
        "** The cup of a harmonic drive under the forces of its wave generator's bearing, linear. mm, N, MPa.\n"
        "** {} of it. Displacements must come to expected.csv: run ccx linear, then python3 compare.py linear.\n",
        body.half ? "Half a lobe, between two planes of symmetry," : "All");
    auto const out = std::back_inserter(deck);
    io::put_nodes(deck, body, "NALL");
    io::put_elements(deck, body, "EALL");
    io::put_material(deck, body, "CUP", "EALL");
    io::put_node_set(deck, body, "NCLAMP", io::held_nodes(body));
    if (body.half)
        io::put_node_set(deck, body, "NPLANES", io::plane_nodes(body));
    io::put_node_set(deck, body, "NWATCH", watched);
    deck += "** 1 radial, 2 tangential, 3 axial\n";
    io::put_axes(deck, "NALL");
    deck += "*BOUNDARY\nNCLAMP, 1, 3\n";
    deck += body.half ? "NPLANES, 2, 2\n" : "";
    deck += "*STEP\n*STATIC\n*CLOAD\n";
    for (std::size_t i = 0; i < loads.size(); ++i)
        if (loads[i] != 0)
            fmt::format_to(out, "{}, 1, {:.10g}\n", i + 1, loads[i]);
    deck += "*NODE PRINT, NSET=NWATCH, GLOBAL=NO\nU\n*NODE FILE\nU\n*EL FILE\nS\n*END STEP\n";
    return deck;
}

/// What the program itself has at the watched nodes.
std::string expected_displacements(elastic::BentCup const& cup, io::DeckBody const& body,
                                   std::vector<int> const& watched)
{
    std::string expected = "node,r,z,phi_deg,u_r,u_t,u_z\n";
    for (int const i : watched) {
        elastic::SweptNode const& node = body.mesh.nodes[static_cast<std::size_t>(i)];
        Vec2 const& at = cup.solid().mesh().nodes[static_cast<std::size_t>(node.section)];
        Eigen::Vector3d const u = elastic::node_displacement(cup.field(), node.section, node.phi);
        fmt::format_to(std::back_inserter(expected), "{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", i + 1, at.x(),
                       at.y(), to_deg(node.phi), u[0], u[2], u[1]);
    }
    return expected;
}

}  // namespace

void check_calculix(std::filesystem::path const& folder)
{
    file::AtomicFolder::check(folder, file::AtomicFolder::calculix_deck);
}

void write_calculix(elastic::BentCup const& cup, std::filesystem::path const& folder, int steps, bool contact)
{
    io::DeckBody const body = io::deck_body(cup.solid().mesh(), cup.cam(), steps);
    auto const watched = io::watched_nodes(body, cup);
    std::string const deck = linear_deck(cup, body, watched, steps);
    std::string const expected = expected_displacements(cup, body, watched);
    file::AtomicFolder made(folder, file::AtomicFolder::calculix_deck);
    std::vector<std::pair<std::string, std::string>> list{
        {"linear.inp", "cup under the forces of its bearing, geometrically linear: run ccx linear"},
        {"expected.csv", "what linear.dat must say of the nodes NWATCH: displacements in mm"},
        {"compare.py", "compares them: python3 compare.py linear"}};
    made.write("linear.inp", deck);
    made.write("expected.csv", expected);
    made.write("compare.py", std::string(io::compare_script));
    if (contact) {
        io::ContactDeck const two = io::contact_deck(cup, body);
        made.write("contact.inp", two.deck);
        made.write("expected_contact.csv", two.expected);
        list.emplace_back(
            "contact.inp",
            "cup and bearing in unilateral contact: run ccx contact; displacements of NWATCH again as in expected.csv");
        list.emplace_back("expected_contact.csv",
                          "what contact.dat must say of the surfaces' total force, but for its sign: python3 "
                          "compare.py contact");
    }
    made.publish(list);
}

}  // namespace hdconj
