// SPDX-License-Identifier: GPL-3.0-or-later
// The conjugate pair in the plane z = 0.
#pragma once

#include <optional>

#include "drive/stage_clock.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::conjugate {

/// A pair that is conjugate at z = 0, with the tooth and the wave shape that it was solved for.
struct SolvedPlane
{
    Solution solution;
    profile::Profile tooth;
    wavegen::AnyWaveShape shape;
};

/// Solves the scene of @p plane at z = 0: tooth, cup where the scene has an elastic one, branches, tooth space,
/// outline. Slices, tilt and a side clearance that is looked for are not its affair.
/// @param plane  its solution has the scene and the plan, by which @p clock runs, and the cup where it is known
/// @param cup_error  width about the middle over which it is asked how well an elastic cup is known, which takes
/// another
///                   cup [mm]; 0: in the middle; none: not asked
/// Domain: check_scene() finds no fault in the scene.
/// @throws NumericalError as solve() does
void solve_plane(SolvedPlane& plane, drive::StageClock& clock, std::optional<double> cup_error);

}  // namespace hdconj::conjugate
