// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What `load` writes and prints.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hdconj/load.hpp"
#include "hdconj/measured.hpp"
#include "hdconj/result_files.hpp"

namespace hdconj {

/// HDF5 result file: what write_hdf5() writes of the solution, the toothed surface as a mesh, and `/load`; layout in
/// docs/reference/hdf5.md.
/// @param study     what is written
/// @param file      of the result
/// @param measured  written beside the simulation; null: none
/// @throws FileError with the cause; std::logic_error where sizes in @p study contradict each other
void write_hdf5(LoadStudy const& study, std::filesystem::path const& file, Measurement const* measured = nullptr);

/// The printed summary that a designer reads: coning, one row per case, where pressure and stress are largest, the
/// measurement beside it.
[[nodiscard]] std::string summary_text(LoadStudy const& study, std::vector<WrittenFile> const& written = {},
                                       Measurement const* measured = nullptr);

/// The figures of summary_json() of the solution and, under "load", of the study; keys in docs/reference/json.md.
/// Numbers are finite or null.
[[nodiscard]] std::string summary_json(LoadStudy const& study, std::vector<WrittenFile> const& written = {},
                                       Measurement const* measured = nullptr);

/// What a measured curve says, alone, as the summary of a study has it beside the simulation.
[[nodiscard]] std::string summary_text(Measurement const& measured);
/// The same figures as an object of JSON, as under "measured" of a study; keys in docs/reference/json.md.
[[nodiscard]] std::string summary_json(Measurement const& measured);

/// Names of the pictures of a study, for which NAME.svg or NAME.png stands.
struct LoadPictures
{
    std::filesystem::path curve;  ///< NAME-curve.svg: torque against twist, all cases, with the two lines of each stage
    std::filesystem::path stiffness;  ///< NAME-stiffness.svg: stiffness against torque, all cases, with K1, K2, K3
    std::filesystem::path pressure;   ///< NAME-pressure.svg: pressure over tooth space and slice
    std::filesystem::path flank;      ///< NAME-flank.svg: pressure on the flank that carries most
    std::filesystem::path residual;   ///< NAME-residual.svg: a measured curve less its lines and less the simulation
    std::filesystem::path cup;        ///< NAME-cup.svg: deformed section of the cup at the major and the minor axis
    std::filesystem::path stress;     ///< NAME-stress.svg: the same coloured by von Mises stress
    std::filesystem::path balls;      ///< NAME-balls.svg: forces of single balls around the ring
};

/// Names of the pictures for @p file, NAME.svg or NAME.png.
[[nodiscard]] LoadPictures load_picture_names(std::filesystem::path const& file);

/// What can be known before the long work: ending, gnuplot, targets. Throws what write_load_pictures() would.
void check_load_pictures(std::filesystem::path const& file);

/// Draws by gnuplot what there is to draw: curves of two torques or more (or a measurement), a map, a shape, its
/// stress, single balls.
/// @param study     what is drawn
/// @param file      NAME.svg or NAME.png, see load_picture_names()
/// @param measured  drawn into the curve; null: none
/// @returns the files that were written, of the kinds "picture_curve", "picture_stiffness", "picture_residual",
/// "picture_pressure", "picture_flank", "picture_cup", "picture_stress", "picture_balls"
/// @throws InputError for another ending; FileError when gnuplot is missing or a file cannot be written
std::vector<WrittenFile> write_load_pictures(LoadStudy const& study, std::filesystem::path const& file,
                                             Measurement const* measured = nullptr);

/// The cup for ParaView: XML unstructured grid (.vtu), binary. Hexahedra, and wedges where the section has triangles,
/// are swept through the angles of the shape. Points are undeformed [mm]. Point data are `displacement` [mm], ready for
/// "Warp By Vector", and `von_mises` [MPa] where it was computed. Frame of the flexspline: the y axis is the major
/// axis, angles run clockwise, z is 0 in the middle of the bearing. Angles that fill a turn, or 1/sectors of one, make
/// a closed ring.
/// @throws FileError; std::logic_error where the shape contradicts itself, or has no cells
void write_cup_vtu(LoadStudy const& study, std::filesystem::path const& file);

}  // namespace hdconj
