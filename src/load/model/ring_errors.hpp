// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of both rings of teeth, tooth by tooth.
#pragma once

#include <vector>

#include "contact/flank_deviation.hpp"
#include "hdconj/pitch_errors.hpp"
#include "hdconj/scene.hpp"

namespace hdconj::load {

/// Pitch errors as the scene gives them, or random ones.
///
/// Random places are independent and normal with the scene's standard deviation s, so that the distance of neighbours
/// deviates by s sqrt(2). A seed gives the same places on every machine (Mersenne Twister, ziggurat).
[[nodiscard]] PitchErrors pitch_errors(Scene const& scene);

/// Displacements of both rings from these places and from the eccentricities; empty where a ring has no errors.
struct RingDisplacements
{
    std::vector<contact::Displacement> teeth, spaces;
};
[[nodiscard]] RingDisplacements ring_displacements(Scene const& scene);

/// Whether a ring has errors: then the drive is no mirror image of itself.
[[nodiscard]] inline bool has_ring_errors(Scene const& scene)
{
    return scene.errors && (scene.errors->flexspline || scene.errors->circular_spline);
}

/// Whether the errors of both rings come again after every part of the turn, of @p parts equal ones.
[[nodiscard]] bool errors_repeat(Scene const& scene, int parts);

}  // namespace hdconj::load
