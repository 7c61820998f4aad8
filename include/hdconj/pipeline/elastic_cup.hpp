// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The elastic cup of a scene on its wave generator, without any teeth being solved.
#pragma once

#include <memory>
#include <string>

#include "hdconj/elastic/bent_cup.hpp"
#include "hdconj/scene/scene.hpp"

namespace hdconj {

/// @throws InputError with every fault of the scene, that it has no elastic cup among them; NumericalError
[[nodiscard]] std::shared_ptr<BentCup const> elastic_cup(Scene const& scene);

/// What a reader has to know of it, in a line: coning, forces, and whether the ring leaves its balls.
[[nodiscard]] std::string describe(BentCup const& cup);

}  // namespace hdconj
