// SPDX-License-Identifier: GPL-3.0-or-later
// From measured points and the nominal part to the result.
#pragma once

#include <vector>

#include "hdconj/inspect.hpp"
#include "nominal_part.hpp"

namespace hdconj::inspect {

/// Heights that differ by less are one plane [mm]: a probe's path is no plane to the last micrometre.
inline constexpr double plane_thickness = 0.02;

/// The planes of a file: heights that differ by less than a plane's thickness are one.
[[nodiscard]] std::vector<double> planes_of(PointFile const& measured, InspectOptions const& options);

/// @throws InputError where a plane lies beside the teeth, as far as @p scene says where they stand
void refuse_planes_outside(std::vector<double> const& z, Scene const& scene, PointFile const& measured,
                           InspectOptions const& options);

/// Registers the points of the planes @p z, fits the flanks, leaves out strays, and does so again without them.
/// @param part  with one plane for each of @p z
[[nodiscard]] Inspection evaluated(Scene const& scene, NominalPart const& part, std::vector<double> const& z,
                                   PointFile const& measured, InspectOptions const& options);

}  // namespace hdconj::inspect
