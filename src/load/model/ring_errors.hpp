// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of both rings of teeth, tooth by tooth, and those of the wave generator.
#pragma once

#include <functional>
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

/// How the surface of the wave generator deviates from its shape.
struct SurfaceDeviation
{
    double out;    ///< by how much it stands out [mm]
    double slope;  ///< derivative of that by the angle [mm/rad]
};

/// The deviation at an angle from the major axis, clockwise; null: nowhere.
///
/// An eccentric wave generator stands out by E cos(angle - phase), and a wall that goes with it is moved as a whole.
/// The deviation of the cam is a periodic cubic spline through the rows of its table.
[[nodiscard]] std::function<SurfaceDeviation(double)> wave_generator_deviation(Scene const& scene);

/// Whether the drive under a torque is no mirror image of itself under the opposite one, for the errors of its teeth or
/// of its wave generator.
[[nodiscard]] bool break_the_mirror(Scene const& scene);

/// Whether all errors come again after every part of the turn, of @p parts equal ones: those of teeth to the last bit,
/// those of the wave generator to a picometre.
[[nodiscard]] bool errors_repeat(Scene const& scene, int parts);

}  // namespace hdconj::load
