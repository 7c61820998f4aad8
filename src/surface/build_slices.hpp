// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The solved outline spread over the face width, and the side clearance that it needs there.
#pragma once

#include "conjugate/matched_outline.hpp"
#include "drive/stage_clock.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::surface {

/// Replaces the one outline of @p out by those of all slices, as [slices] and [tilt] say (design 3.4). An outline that
/// is only moved radially keeps its points, bit for bit at z = 0.
void build_slices(Solution& out, profile::Profile const& tooth, wavegen::AnyWaveShape const& shape,
                  drive::StageClock& clock);

/// Takes over what is known of the errors of @p outline, made as @p surface: of a coned ruled one, points between its
/// end planes are where they are as well as chords are.
void take_errors(Solution& out, conjugate::MatchedOutline const& outline, ToothSurface surface);

}  // namespace hdconj::surface
