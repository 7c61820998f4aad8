// SPDX-License-Identifier: GPL-3.0-or-later
// The solved outline spread over the face width, and the side clearance that it needs there.
#pragma once

#include <vector>

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

/// Writes @p outline at the places @p z, made as @p surface, with what is known of its errors: of a coned ruled one,
/// points between its end planes are where they are as well as chords are.
void write_outlines(Solution& out, conjugate::MatchedOutline const& outline, profile::Profile const& tooth,
                    std::vector<double> const& z, ToothSurface surface);

/// The slices of the same surface in other planes: each outline is the one that the surface has there.
/// @param out  result of solve(), with two slices or more
/// @param z    places [mm], increasing, from the first end plane of its slices to the last
void move_slices(Solution& out, profile::Profile const& tooth, wavegen::AnyWaveShape const& shape,
                 std::vector<double> const& z);

}  // namespace hdconj::surface
