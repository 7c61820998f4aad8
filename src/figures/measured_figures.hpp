// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of a measured torque-angle curve, each stated once.
#pragma once

#include <optional>
#include <span>

#include "figure_of.hpp"
#include "hdconj/load.hpp"
#include "hdconj/measured.hpp"

namespace hdconj::figures {

/// Of a measured curve, but for those that are averages.
[[nodiscard]] Rows<MeasuredStiffness> measured_curve_figures();

/// An average over the cycles of a test rig.
struct MeasuredFigure
{
    Name name;          ///< in HDF5 and JSON, without unit
    char const* words;  ///< in text
    Unit unit;
    Estimate const& (*value)(MeasuredStiffness const&);
    int angles;  ///< power of the angle in it: 1 of an angle, -1 of a torque, -2 of torque over angle; work is the same
                 ///< at both members
    /// The same of the simulation, on the circular spline; none where it has none.
    std::optional<double> (*simulated)(LoadCase const&);
};

[[nodiscard]] std::span<MeasuredFigure const> measured_figures();

}  // namespace hdconj::figures
