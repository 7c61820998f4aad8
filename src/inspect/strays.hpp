// SPDX-License-Identifier: GPL-3.0-or-later
// Points that are no form of their flank: dust, a wild touch, a burr.
#pragma once

#include <cstddef>
#include <vector>

#include "common_form.hpp"

namespace hdconj::inspect {

/// Strays of the flanks of one side, as indices into each run.
///
/// A stray jumps against its neighbours along the flank, and it does what the other flanks do not do there. It lies
/// further than 2 um and five standard deviations from the parabola of its flank and the form that most flanks share.
/// Between neighbours it sticks out to one side, and it is off the parabola through the six points beside it by more
/// than noise and the bend of the flank there explain. At the end of a flank that is measured alone the neighbour must
/// not depart to the same side: that is how a relief begins. Noise is taken from medians over the side. Points are left
/// out one by one, or by two where two hide each other.
[[nodiscard]] std::vector<std::vector<std::size_t>> strays_of(std::vector<FlankRun> const& side);

}  // namespace hdconj::inspect
