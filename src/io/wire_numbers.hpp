// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The numbers of a wire program that headings and summaries show; private to src/io.
#pragma once

#include <string>
#include <vector>

#include "hdconj/wedm/wire_program.hpp"

namespace hdconj {

/// Smallest and largest distance of a contour's points from the axis [mm]: tip and root of a toothed ring.
struct FaceRadii
{
    double inner = 0, outer = 0;
};

/// A pass in numbers.
struct PassFigures
{
    std::size_t blocks = 0;       ///< moves after the start hole
    double length = 0;            ///< of the path in the lower face [mm]
    double shortest = 0;          ///< block, in either face [mm]
    double largest_lean = 0;      ///< of the wire: largest |U - L| [mm]
    double residual = 0;          ///< highest material left [mm]
    std::size_t residuals = 0;    ///< places
};

struct WireNumbers
{
    explicit WireNumbers(WireProgram const& program);

    FaceRadii lower, upper;
    double face_shift = 0;        ///< largest |U - L| of the contour, T tan(tilt) of a radial tilt [mm]
    double least_shift = 0;       ///< smallest
    double guide_offset = 0;      ///< largest lateral distance of the guides, H tan(tilt) [mm]
    double largest_tilt = 0;      ///< of the wire against the axis [rad]
    double ellipse = 0;           ///< r (1/cos tilt - 1): the wire cuts an ellipse in the plane of a face, this much wider, neglected [mm]
    bool meshing_residual = false;
    std::vector<PassFigures> passes;

    /// "smaller than the lower face", "larger ...", "same as ...".
    [[nodiscard]] std::string larger_face() const;
};

}  // namespace hdconj
