// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The toothed surface of the circular spline for other programs: ParaView, CAD, mesh generators.
///
/// The surface is the ruled surface through the slices, quadrilaterals between neighbouring slices, one row from slice to slice; normals
/// point out of the material. With one slice it is a cylinder as wide as `circular_spline.width`. Lengths in mm, frame of the circular spline.
#pragma once

#include <filesystem>

#include "hdconj/pipeline/contact_study.hpp"

namespace hdconj {

/// A tenth of a micrometre: below what can be made or measured. [mm]
inline constexpr double surface_tolerance = 1e-4;

struct SurfaceOptions
{
    bool ring = false;                     ///< all teeth; else one tooth space from mid-land to mid-land
    double tolerance = surface_tolerance;  ///< [mm] points of an outline are left out where no slice moves by more than this; 0: all are kept
};

/// XDMF 3 of one tooth space, referring to the datasets in `/circular_spline/surface` of @p result, the HDF5 file of the same study, by
/// its name relative to @p file: both may be moved together. The part of each cell (land, flank, root) is a cell attribute.
/// @throws FileError where the name of @p result cannot stand in XDMF; InputError where there is no surface (one slice, no width)
void write_xdmf(Solution const& solution, std::filesystem::path const& file, std::filesystem::path const& result);

/// The same of what @p options say, with its numbers in an HDF5 file beside it, called as @p file with `.h5` appended.
void write_xdmf(Solution const& solution, std::filesystem::path const& file, SurfaceOptions const& options);

/// Binary STL: triangles in single precision (2e-6 mm at a radius of 25 mm), those with two corners in one place left out.
void write_stl(Solution const& solution, std::filesystem::path const& file, SurfaceOptions const& options = {});

/// Legacy VTK, binary, unstructured grid of quadrilaterals, double precision. Cell data `part`; where the study has a map, point
/// data `gap` [mm] on the flanks and NaN, which means no data to VTK, off them. One tooth: the space with the largest contact on the driving side.
void write_vtk(ContactStudy const& study, std::filesystem::path const& file, SurfaceOptions const& options = {});

}  // namespace hdconj
