// SPDX-License-Identifier: GPL-3.0-or-later
// The friction of a measured loop.
#pragma once

#include <vector>

#include "branches.hpp"
#include "fits.hpp"

namespace hdconj::rig {

/// Torque that friction takes: half the difference between a branch and the next one at equal angles, the median over
/// all angles [N mm]. Coulomb friction T_f gives T_f, also where an angle lies within the backlash. Its error
/// is that of the median over all angles, of the mean over the pairs of branches and of the steps.
/// @param step  of the encoder, whose readings of one angle count once [rad]; 0: its steps are finer than the noise
[[nodiscard]] Found friction_torque(Samples const& samples, std::vector<LoadBranch> const& branches, double step);

}  // namespace hdconj::rig
