// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The elastic cup of a scene on its wave generator, without any teeth being solved.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "hdconj/scene.hpp"

namespace hdconj {

namespace elastic {
class BentCup;
}

/// Estimated discretisation errors of a bent cup.
struct BentCupError
{
    double displacement = 0;  ///< of the wall where teeth stand, in the plane of a slice [mm]
    double coning_major = 0;  ///< of BentCup::coning(0) [rad]
    double force = 0;         ///< of WaveGeneratorContact::total_force [N]
};

/// Solves for the cup of @p scene on its wave generator, without teeth in contact.
/// @throws InputError with every fault of the scene, that it has no elastic cup among them; NumericalError where the
/// contact with the bearing does not converge
[[nodiscard]] std::shared_ptr<elastic::BentCup const> elastic_cup(Scene const& scene);

/// Estimates the discretisation error of a cup by another one on another grid, in the plane z = 0 and at the ends of
/// the face width.
/// @param scene  the drive
/// @param cup    that elastic_cup() returns for @p scene
/// @throws NumericalError as elastic_cup()
[[nodiscard]] BentCupError elastic_cup_error(Scene const& scene, elastic::BentCup const& cup);

/// Keeps the responses of the last elastic bodies to unit loads, for other drives that have exactly the same bodies: a
/// study in which tooth, cam or tilt varies computes those of its cup and of its bearing once. No result changes by a
/// bit.
/// @param count  of each kind, at about 25 MB of memory for one of each; 0, before the first call too: none
void keep_elastic_bodies(std::size_t count);

/// Responses of elastic bodies to unit loads since the program began.
struct ElasticBodyCount
{
    std::size_t computed = 0;  ///< how often they were computed
    std::size_t reused = 0;    ///< how often they were taken from those that were kept
};
/// What keep_elastic_bodies() has saved so far.
[[nodiscard]] ElasticBodyCount elastic_body_count();

/// One line of text: coning and force with their errors, if known, and whether the ring leaves its balls; may be empty.
[[nodiscard]] std::string describe(elastic::BentCup const& cup, std::optional<BentCupError> const& error);

}  // namespace hdconj
