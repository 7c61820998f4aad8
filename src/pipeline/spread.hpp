// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The solved outline spread over the face width, and the side clearance that it needs there.
#pragma once

#include <string>

#include "hdconj/conjugate/matched_outline.hpp"
#include "hdconj/pipeline/solve.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "stage_clock.hpp"

namespace hdconj::detail {

/// Replaces the one outline of @p out by those of all slices, as [slices] and [tilt] say (design 3.4). An outline that is only moved
/// radially keeps its points, bit for bit at z = 0.
void spread_over_width(Solution& out, Profile const& tooth, AnyWaveShape const& shape, StageClock& clock);

/// Takes over what is known of the errors of @p outline, made as @p surface: of a coned ruled one, points between its end planes are where they are as well as chords are.
void take_errors(Solution& out, MatchedOutline const& outline, std::string const& surface);

/// Solves a scene with backlash_offset = "auto": first for the least side clearance (and the tip circle that goes with it), then with it.
[[nodiscard]] Solution solve_with_automatic_backlash(Scene const& scene, StageObserver const& on_stage);

}  // namespace hdconj::detail
