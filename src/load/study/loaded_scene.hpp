// SPDX-License-Identifier: GPL-3.0-or-later
// The scene of a load study: checked, completed, and solved without torque.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "contact/study/contact_study_data.hpp"
#include "hdconj/load.hpp"
#include "torque_branch.hpp"

namespace hdconj::load {

/// As check_load(), for a torque of either sense, or 0.
[[nodiscard]] Faults check_either_sense(Scene const& scene, LoadOptions const& options);

/// loaded_scene() of a scene without faults. Everything that follows takes this scene.
/// @throws InputError with all faults of scene and options
[[nodiscard]] Scene checked_scene(Scene const& asked, LoadOptions const& options);

/// The note that load and run make the conjugate teeth for the bent cup, although @p asked has no table [coning], so
/// that other verbs make other teeth of it. Nothing where @p asked has that table.
/// @param loaded  loaded_scene() of it
[[nodiscard]] std::optional<std::string> note_on_bent_cup(Scene const& asked, Scene const& loaded);

/// The contact data of a drive under load.
struct LoadedDriveData
{
    std::unique_ptr<contact::ContactStudyData> data;  ///< owns the scene
    double standard_tip_increase = 0;                 ///< LoadStudy::standard_tip_increase [mm]
};

/// Where the scene gives no tip circle and the standard one, made for a ring that does not cone, leaves no land, the
/// tip circle is widened in steps of 4 % of the module.
/// @param errors  whether it is asked how well the cup is known
/// @throws NumericalError where the drive has no solution
[[nodiscard]] LoadedDriveData contact_data(Scene const& scene, bool errors, StageObserver const& on_stage);

/// What of the options concerns the surfaces.
[[nodiscard]] ContactOptions contact_options(LoadOptions const& options);

/// The largest torque of a study [N mm]. Domain: a checked scene.
[[nodiscard]] double rated_torque(Scene const& scene, LoadOptions const& options);

/// Torques of CatalogueFigures for a rated torque [N mm]: as the scene gives them, or standard fractions of it.
[[nodiscard]] CatalogueTorques catalogue_torques(Scene const& scene, double rated);

/// Torques of a case.
struct LoadingPath
{
    BranchTorques forth;  ///< towards the rated torque
    bool curve = true;    ///< false: the rated torque only
};

/// From zero to the rated torque: as many even steps as asked for, or as the stiffness needs; with the torques of the
/// catalogue's figures. Without a curve the rated torque alone. Domain: a checked scene.
[[nodiscard]] LoadingPath loading_path(Scene const& scene, LoadOptions const& options);

}  // namespace hdconj::load
