// SPDX-License-Identifier: GPL-3.0-or-later
// The elastic cup that a scene describes.
#pragma once

#include <memory>

#include "elastic/bent_cup.hpp"
#include "elastic/section_mesh.hpp"
#include "hdconj/error.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::drive {

/// Section of the cup of [flexspline.cup]. Domain: the scene has that table.
[[nodiscard]] elastic::CupSection cup_section(Scene const& scene, double inner_radius);

/// Bearing of [bearing] at the height of [coning]. Domain: the scene has both.
[[nodiscard]] elastic::Bearing bearing_of(Scene const& scene);

/// What the dimensions of cup, bearing and teeth say to each other, for a scene that asks for the elastic cup.
void validate_cup(Scene const& scene, double inner_radius, Faults& faults);

/// Cup, bearing and cam, solved.
/// @throws NumericalError as BentCup does, and for a bearing that nowhere touches the cup
[[nodiscard]] std::shared_ptr<elastic::BentCup const> bent_cup(Scene const& scene, double inner_radius,
                                                               wavegen::AnyWaveShape const& shape, int threads);

/// How well it is known: in the plane z = 0, and in those at the ends of @p width about it [mm].
[[nodiscard]] BentCupError cup_error(Scene const& scene, elastic::BentCup const& cup,
                                     wavegen::AnyWaveShape const& shape, double r_m, double width, int threads);

/// Height of the front face of the teeth above the middle of the bearing [mm], at the major axis of the bent cup and
/// the radius @p r_m of its neutral curve.
[[nodiscard]] double front_of_teeth(elastic::BentCup const& cup, double r_m);

/// Displacements of the slice at @p z of the scene (0 in the middle of the bearing).
[[nodiscard]] wavegen::MaterialDisplacement displacement_at(elastic::BentCup const& cup, double z, double r_m);

}  // namespace hdconj::drive
