// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The plan: which stages a scene calls for, in order, and why. A pure function of the scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hdconj/scene.hpp"

namespace hdconj {

/// The stages that the program knows. A stage that is not in the plan is never constructed.
enum class Stage
{
    profile,         ///< given tooth from its family
    cup,             ///< elastic cup on its bearing: displacements of the wall
    neutral_curve,   ///< wave generator, closed length, r_0
    motion,          ///< relative motion flexspline tooth to circular spline
    envelope,        ///< meshing condition, branches
    region,          ///< outer boundary of the swept region: tooth space, or flexspline tooth
    backlash,        ///< side clearance: parallel offset
    root_clearance,  ///< deeper tooth-space bottom
    outline,         ///< tip land, sampling, order
    interference,    ///< finished pair over the full turn
    coning,          ///< a motion for each slice
    surface,         ///< outlines of all slices, matched
    tilt,            ///< outlines moved along the axis
    clearance,       ///< every slice over a full turn: least side clearance, tip circle and root
    gap_map,         ///< gaps of all teeth at an angle of the wave generator
    contact,         ///< first contact, contact area, backlash
    tip_relief,      ///< flanks of the flexspline stand back towards the tips
    end_relief,      ///< flanks stand back towards the ends of the face width
    errors,          ///< errors of making and assembly
    influence,       ///< what the elastic wall gives way by, harmonic by harmonic
    assembly,        ///< the cup on its wave generator, without torque
    compliance,      ///< torsional stiffnesses in series with the teeth
    load,            ///< teeth and wave generator in equilibrium, torque by torque
    run              ///< positions of the wave generator, one after the other
};

/// What is planned for.
enum class Verb
{
    solve,
    contact,
    load
};

/// One stage of a plan and the reason it is there.
struct PlannedStage
{
    Stage stage;         ///< that runs
    std::string reason;  ///< why the scene calls for it
};

/// An effect that the scene does not call for.
struct AbsentEffect
{
    std::string name;    ///< "coning"
    std::string remedy;  ///< the key that would turn it on
};

/// Stages that a scene calls for, in the order in which they run, and effects that it does not call for.
struct Plan
{
    std::vector<PlannedStage> stages;  ///< in the order in which they run
    std::vector<AbsentEffect> absent;  ///< effects that the scene does not call for

    /// Whether the plan contains @p stage.
    [[nodiscard]] bool has(Stage stage) const;
};

/// Stage name as written into results: "profile", "neutral_curve", ...
[[nodiscard]] std::string to_string(Stage stage);

/// Stages for @p verb, in the order they run.
[[nodiscard]] Plan make_plan(Scene const& scene, Verb verb = Verb::solve);

/// The plan as text for `hdconj check`.
[[nodiscard]] std::string describe(Plan const& plan);

/// Called at the start of each stage that runs, by any of the threads but never by two at once; for progress and for
/// tests that count stages.
using StageObserver = std::function<void(Stage)>;

}  // namespace hdconj
