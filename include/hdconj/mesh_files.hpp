// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The toothed surface and the bent cup for other programs: ParaView, CAD, mesh generators, CalculiX.
///
/// A toothed surface is the ruled surface through the slices, quadrilaterals between neighbouring slices, one row from
/// slice to slice; normals point out of the material. With one slice it is a cylinder as wide as
/// `circular_spline.width`. Lengths in mm, frame of the circular spline.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/file/written_file.hpp"

namespace hdconj {

/// A tenth of a micrometre: below what can be made or measured. [mm]
inline constexpr double surface_tolerance = 1e-4;

/// Which part of the toothed surface is written, and how finely.
struct SurfaceOptions
{
    bool ring = false;                     ///< all teeth; else one tooth space from mid-land to mid-land
    double tolerance = surface_tolerance;  ///< [mm] points of an outline are left out where no slice moves by more than
                                           ///< this; 0: all are kept
};

/// XDMF 3 of one tooth space. It refers to the datasets in `/circular_spline/surface` of @p result, the HDF5 file of
/// the same study. The reference is relative to @p file, so both may be moved together. The part of each cell (land,
/// flank, root) is a cell attribute.
/// @throws FileError where the name of @p result cannot stand in XDMF; InputError where there is no surface (one slice,
/// no width)
void write_xdmf(Solution const& solution, std::filesystem::path const& file, std::filesystem::path const& result);

/// The same of what @p options say, with its numbers in an HDF5 file beside it, called as @p file with `.h5` appended.
void write_xdmf(Solution const& solution, std::filesystem::path const& file, SurfaceOptions const& options);

/// Binary STL: triangles in single precision (2e-6 mm at a radius of 25 mm), those with two corners in one place left
/// out.
void write_stl(Solution const& solution, std::filesystem::path const& file, SurfaceOptions const& options = {});

/// Legacy VTK, binary, unstructured grid of quadrilaterals, double precision. Cell data `part`; where the study has a
/// map, point data `gap` [mm] on the flanks and NaN, which means no data to VTK, off them. One tooth: the space with
/// the largest contact on the driving side.
void write_vtk(ContactStudy const& study, std::filesystem::path const& file, SurfaceOptions const& options = {});

/// VTK's XML format, text: the whole undeformed cup as hexahedra with twenty nodes. Point data are `displacement` [mm]
/// (ParaView's filter "Warp By Vector") and `von_mises` [MPa], extrapolated to the nodes and averaged there. Frame of
/// the drive: x = r sin phi, y = r cos phi, z from the middle of the bearing.
/// @param cup    the bent cup
/// @param file   NAME.vtu
/// @param steps  elements round the axis, 4 to 1440
/// @throws InputError for other steps
void write_vtu(elastic::BentCup const& cup, std::filesystem::path const& file, int steps = 96);

/// A folder with a complete deck for CalculiX (`ccx linear`) and the result that it must give:
/// - `linear.inp`: cup of C3D20R, bottom clamped at the flange, forces of the bearing on the inner surface,
///   geometrically linear
/// - `expected.csv`: node, r, z, phi_deg, u_r, u_t, u_z of some nodes whose displacements the deck prints
/// - `files.txt`: the list of these files
///
/// With @p contact also
/// - `contact.inp`: the cup, and the bearing as a second body in contact with it. The cam moves the bearing: a rigid
///   one, or an elastic ring on its line of balls. The displacements agree but for grids of contacts and a penalty
/// - `expected_contact.csv`: resultant of the forces between them, on the part of the cup that is modelled
///
/// The deck holds half a wave of a cup that is its own mirror image there, otherwise the whole turn. Where the ring
/// does not touch its balls the deck leaves it free. Domain of the contact: balls without radial stiffness, a bearing
/// with a width.
/// @param cup      the bent cup
/// @param folder   that is made, or replaced where it was written so before
/// @param steps    elements round that, 4 to 1440
/// @param contact  with the second deck
/// @throws FileError where the folder cannot be made or holds other files; InputError for other steps
void write_calculix(elastic::BentCup const& cup, std::filesystem::path const& folder, int steps = 48,
                    bool contact = false);

/// What can be known about that folder before the long work. @throws FileError
void check_calculix(std::filesystem::path const& folder);

/// Figures of the cup, and what was written of it, as one JSON object; keys in docs/reference/json.md.
/// @param cup      the bent cup
/// @param error    that elastic_cup_error() returns for @p cup
/// @param written  files that were written
[[nodiscard]] std::string summary_json(elastic::BentCup const& cup, BentCupError const& error,
                                       std::vector<WrittenFile> const& written);

}  // namespace hdconj
