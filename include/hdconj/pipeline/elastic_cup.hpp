// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The elastic cup of a scene on its wave generator, without any teeth being solved.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "hdconj/elastic/bent_cup_error.hpp"
#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// @throws InputError with every fault of the scene, that it has no elastic cup among them; NumericalError
[[nodiscard]] std::shared_ptr<BentCup const> elastic_cup(Scene const& scene);

/// How well that cup is known, by another one on another grid: bent_cup_error() in the plane z = 0 and at the ends of the face width.
/// Domain: @p cup is that of @p scene. @throws NumericalError
[[nodiscard]] BentCupError elastic_cup_error(Scene const& scene, BentCup const& cup);

/// What a reader has to know of it, in a line: coning, forces, and whether the ring leaves its balls.
[[nodiscard]] std::string describe(BentCup const& cup, std::optional<BentCupError> const& error);

}  // namespace hdconj
