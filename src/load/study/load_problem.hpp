// SPDX-License-Identifier: GPL-3.0-or-later
// An elastic drive with one surface of the circular spline, and its state at one torque.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "contact/flank_deviation.hpp"
#include "contact/flank_grid.hpp"
#include "contact/gap_field.hpp"
#include "contact/study/contact_context.hpp"
#include "hdconj/load.hpp"
#include "load/equilibrium.hpp"
#include "load/flank_contacts.hpp"
#include "loaded_shape.hpp"

namespace hdconj::load {

/// A drive with one surface of the circular spline. Refers to what it was made from.
struct LoadProblem
{
    contact::ContactContext const& context;
    ElasticDrive const& drive;
    contact::FlankGrid const& flanks;  ///< with sharp edges: areas are taken from these
    contact::FlankGrid edges;          ///< with round edges: contacts are looked for on these
    std::optional<contact::FlankDeviation> deviation = std::nullopt;  ///< of flanks from their nominal form
};

[[nodiscard]] LoadProblem load_problem(contact::ContactContext const& context, ElasticDrive const& drive,
                                       contact::FlankGrid const& flanks);

/// Radius of the edges where teeth touch [mm]: as the scene gives it, or 1/25 of the module.
[[nodiscard]] double edge_radius(Scene const& scene);

/// Tooth spaces of one sector of the ring.
[[nodiscard]] std::size_t spaces_of(LoadProblem const& problem);

/// Contacts with a smaller gap belong to the problem [mm].
[[nodiscard]] double search_limit(LoadProblem const& problem);

/// Difference between the gaps of the loaded shape and those of the linear model below which a torque has converged
/// [mm].
[[nodiscard]] double gap_tolerance(LoadProblem const& problem);

/// @param depth  of the strips, as a multiple of the standard one
[[nodiscard]] FlankSearch flank_search(LoadProblem const& problem, double turn, double limit, double depth = 1);

/// Gaps of @p flanks against the teeth in @p shape.
[[nodiscard]] contact::GapField gap_field(LoadProblem const& problem, LoadedShape const& shape,
                                          contact::FlankGrid const& flanks);

/// How far flanks are searched for contacts. The first search of an iteration finds all contacts within search_limit().
/// Each later one looks only as far as the step before it has closed a gap, since contacts farther away cost time and
/// carry no force. Where a step closes a gap that is wider, teeth overlap in the next shape, and every search finds
/// contacts that overlap.
struct SearchReach
{
    double limit;            ///< of the next search [mm]
    GapBounds known = {};    ///< from the searches before
    LoadedShape shape = {};  ///< at which the last step found its contacts
    double turn = 0;         ///< at which it found them [rad]
    double solved_limit;     ///< within which it found them [mm]
};

/// A drive in equilibrium at one torque.
struct LoadedDrive
{
    double torque = 0;  ///< [N mm]
    Equilibrium state;
    std::vector<FlankContact> contacts;
    Eigen::MatrixXd forces;  ///< on the stations of the cup
    LoadedShape shape;
    double gap_mismatch = 0;  ///< largest difference between the gaps of the shape and those of the linear model [mm]
    int iterations = 0;       ///< of the shape
    int steps = 0;            ///< of the active set, in all iterations
    /// Where `contacts` were found, all within search_limit(): the linear model that another torque may start from.
    /// None: other limits than the standard ones were needed, or nothing was searched yet.
    std::optional<SearchReach> found = std::nullopt;
};

/// Figures of a drive in equilibrium. @param middle  turn from which the twist counts [rad]
[[nodiscard]] LoadedState loaded_state(LoadProblem const& problem, LoadedDrive const& loaded, double middle);

/// Its forces on the flanks, by tooth space, flank and slice.
[[nodiscard]] LoadMap load_map(LoadProblem const& problem, LoadedDrive const& loaded);

/// Its contacts that carry force.
[[nodiscard]] std::vector<ContactForce> contact_forces(LoadProblem const& problem, LoadedDrive const& loaded);

}  // namespace hdconj::load
