// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of a rig as pictures show them.
#pragma once

#include <vector>

#include "figures/measured_figures.hpp"

namespace hdconj::report {

/// A sample of the output.
struct RigSample
{
    double twist;   ///< from the middle of the loop, without drift [rad]
    double torque;  ///< [N mm]
};

/// At most some thousand samples, evenly taken from all: few enough for a picture that one can still open.
[[nodiscard]] std::vector<RigSample> rig_samples(Measurement const& measured);

}  // namespace hdconj::report
