// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of a deck for CalculiX: https://www.dhondt.de, keywords as in its manual.
#pragma once

#include <string>
#include <vector>

#include "elastic/bent_cup.hpp"
#include "elastic/swept_mesh.hpp"

namespace hdconj::io {

/// A body of a deck: half a lobe of it between two planes of symmetry where the cam is even, otherwise all of it.
struct DeckBody
{
    elastic::SectionMesh section;
    elastic::SweptMesh mesh;
    double angle = 0;  ///< [rad]
    int steps = 0;     ///< elements round it
    bool half = true;
    int before = 0;  ///< nodes of bodies in front of it
    int elements_before = 0;

    [[nodiscard]] Vec2 const& at(std::size_t node) const
    {
        return section.nodes[static_cast<std::size_t>(mesh.nodes[node].section)];
    }
};

[[nodiscard]] DeckBody deck_body(elastic::SectionMesh section, elastic::CamSeries const& cam, int steps);

/// Numbers of the nodes of @p body for which @p holds is true.
template <class Condition>
[[nodiscard]] std::vector<int> nodes_where(DeckBody const& body, Condition holds)
{
    std::vector<int> nodes;
    for (std::size_t i = 0; i < body.mesh.nodes.size(); ++i)
        if (holds(i))
            nodes.push_back(static_cast<int>(i));
    return nodes;
}
/// Nodes of @p body that the section holds, and those of its planes of symmetry that it does not.
[[nodiscard]] std::vector<int> held_nodes(DeckBody const& body);
[[nodiscard]] std::vector<int> plane_nodes(DeckBody const& body);

/// Nodes of the cup whose displacements are compared: on the inner and outer surface of the tooth ring, in three
/// planes.
[[nodiscard]] std::vector<int> watched_nodes(DeckBody const& body, elastic::BentCup const& cup);

void put_nodes(std::string& deck, DeckBody const& body, std::string const& name);
/// Two sets where there is a layer of teeth: its elements are named with TEETH behind @p name.
void put_elements(std::string& deck, DeckBody const& body, std::string const& name);
/// Of the elements of @p body: the set @p elements and, where there is a layer of teeth, that with TEETH behind its
/// name.
void put_material(std::string& deck, DeckBody const& body, std::string const& name, std::string const& elements);
void put_node_set(std::string& deck, DeckBody const& body, std::string const& name, std::vector<int> const& nodes);

/// Axes of the nodes @p set: 1 radial, 2 tangential, 3 axial.
void put_axes(std::string& deck, std::string const& set);

/// Cup and bearing as two bodies in contact, and what comes of it: rows of name and value.
struct ContactDeck
{
    std::string deck;
    std::string expected;
};

/// @param cup_body  of @p cup, in front of all others
[[nodiscard]] ContactDeck contact_deck(elastic::BentCup const& cup, DeckBody const& cup_body);

}  // namespace hdconj::io
