// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The bent cup for other programs: ParaView, and CalculiX to check it.
#pragma once

#include <filesystem>

#include "hdconj/elastic/bent_cup.hpp"

namespace hdconj {

/// VTK's XML format, text: the whole undeformed cup as hexahedra with twenty nodes, point data `displacement` [mm] (ParaView's filter "Warp By Vector")
/// and `von_mises` [MPa], extrapolated to the nodes and averaged there. Frame of the drive: x = r sin phi, y = r cos phi, z from the middle of the bearing.
/// @param steps  elements round the axis
void write_vtu(BentCup const& cup, std::filesystem::path const& file, int steps = 96);

/// A folder with a deck for CalculiX that needs nothing from here to run (`ccx linear`), and what it must come to:
///
///   linear.inp    cup of C3D20R, bottom clamped at the flange, forces of the bearing on the inner surface, geometrically linear
///   expected.csv  node, r, z, phi_deg, u_r, u_t, u_z of some nodes whose displacements the deck prints
///   files.txt     what is there
///
/// and with @p contact
///
///   contact.inp           the cup, and the bearing as a second body that touches it or does not, moved by the cam (rigid, or on the line of balls of an
///                         elastic ring): another way to the same displacements, to what grids of contacts and a penalty leave of it
///   expected_contact.csv  resultant of the forces between them, on the part of the cup that is there
///
/// Of a cup that is its own mirror image half a lobe, otherwise the whole turn. Where the ring stands off its balls the deck leaves it free.
/// Domain of the contact: balls without radial stiffness, a bearing with a width.
/// @param steps  elements round that
/// @throws FileError where the folder cannot be made or holds other files
void write_calculix(BentCup const& cup, std::filesystem::path const& folder, int steps = 48, bool contact = false);

/// What can be known about that folder before the long work. @throws FileError
void check_calculix(std::filesystem::path const& folder);

}  // namespace hdconj
