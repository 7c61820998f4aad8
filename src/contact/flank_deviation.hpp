// SPDX-License-Identifier: GPL-3.0-or-later
// How flanks that are made differ from those that are drawn.
#pragma once

#include <functional>
#include <vector>

namespace hdconj::contact {

/// Changes of gaps along the normal of the flank. They are added to the distance between the nominal flanks: right but
/// for the square of the deviation's slope along the flank times the gap.
struct FlankDeviation
{
    /// (k) by how much all gaps of a slice are larger [mm]; empty: by nothing
    std::vector<double> slice{};
    /// By how much the flexspline's flanks stand back at a height of the tooth frame [mm]; null: by nothing. The land
    /// counts as the edge beside it.
    std::function<double(double)> height{};
};

}  // namespace hdconj::contact
