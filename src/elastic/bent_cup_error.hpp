// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Estimated discretisation error of a bent cup.
#pragma once

#include <vector>

#include "bent_cup.hpp"
#include "hdconj/elastic_cup.hpp"

namespace hdconj::elastic {

/// Differences between two cups of the same bodies; displacements are compared at even angles of a lobe.
/// @param z       heights above the bottom [mm]
/// @param radius  of the layer that carries the teeth [mm]
/// @throws NumericalError as BentCup::displacement does
[[nodiscard]] BentCupError distance_between(BentCup const& cup, BentCup const& other, std::vector<double> const& z,
                                            double radius);

/// What that says of the first: 3/(sqrt 2 - 1) times the distance (a bearing's edges are singular: order one half; of
/// two grids, Roache's safety of 3), of no figure less than of the middle one relative to its size.
/// @param other   with half the circles and angles of the bearing's contact, and two elements across the wall:
/// discretised_otherwise() Accuracy: an estimate, no proof. Of three drives no finer grid of four was further away;
/// displacements are stated 1.9, 24 and 9 times as large as their distance from the finest.
/// @throws NumericalError as BentCup::displacement does
[[nodiscard]] BentCupError bent_cup_error(BentCup const& cup, BentCup const& other, std::vector<double> const& z,
                                          double radius);

/// The grid to compare @p grid with.
[[nodiscard]] BentCupGrid discretised_otherwise(BentCupGrid const& grid);

}  // namespace hdconj::elastic
