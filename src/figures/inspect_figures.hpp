// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of an inspection.
#pragma once

#include "figure_of.hpp"
#include "hdconj/inspect.hpp"

namespace hdconj::figures {

/// Of the inspection as a whole: what was asked, noise, numbers of points.
[[nodiscard]] Rows<Inspection> inspection_figures();
/// Where the part lies, and its deviations there.
[[nodiscard]] Rows<PartPlacement> placement_figures();
/// Of the nominal outline in a plane.
[[nodiscard]] Rows<NominalFigures> nominal_figures();
[[nodiscard]] Rows<FlankFigures> flank_rows();
[[nodiscard]] Rows<ToothFigures> tooth_rows();
[[nodiscard]] Rows<SideFigures> side_rows();
/// Pitch of a side; only where it has pitches.
[[nodiscard]] Rows<SideFigures> pitch_rows();
[[nodiscard]] Rows<PlaneFigures> plane_rows();
/// Eccentricity of a plane; only where its teeth suffice.
[[nodiscard]] Rows<PlaneFigures> eccentricity_rows();
[[nodiscard]] Rows<PointDeviation> point_rows();

/// "left" or "right".
[[nodiscard]] inline char const* flank_word(bool right)
{
    return right ? "right" : "left";
}

}  // namespace hdconj::figures
