// SPDX-License-Identifier: GPL-3.0-or-later
// The linear model of a drive about a loaded shape.
#pragma once

#include <vector>

#include "load_problem.hpp"

namespace hdconj::load {

/// How contacts are chosen.
struct ContactChoice
{
    double depth = 1;        ///< of the strips, as a multiple of the standard one
    bool hold = false;       ///< loaded contacts stay where their minimum of the gap vanishes
    bool in_middle = false;  ///< of FlankSearch
    FlankTangents tangents = FlankTangents::parabola;

    [[nodiscard]] bool operator==(ContactChoice const&) const = default;
};

[[nodiscard]] FlankSearch search_of(LoadProblem const& problem, ContactChoice const& choice, double turn, double limit);

/// The linear model about a shape, and the forces of the iteration before at its contacts.
struct Linearisation
{
    LinearGaps gaps;  ///< without displacements
    std::vector<double> force;
};

[[nodiscard]] Linearisation linearised(LoadProblem const& problem, LoadedDrive const& now, ContactChoice const& choice,
                                       SearchReach& reach);

/// Goes back to the linear model that the forces of @p now were solved for, where it is known, and else linearises.
[[nodiscard]] Linearisation first_linearised(LoadProblem const& problem, LoadedDrive& now, ContactChoice const& choice,
                                             SearchReach& reach);

/// Largest difference between the gaps of the shape and those that the forces were solved for [mm].
[[nodiscard]] double mismatch_of(Linearisation const& at);

/// Solves the linear model at @p torque; the forces of @p at are its start.
[[nodiscard]] Equilibrium solved_linear(LoadProblem const& problem, LoadedDrive const& now, double torque,
                                        Linearisation& at);

}  // namespace hdconj::load
