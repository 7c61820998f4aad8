// SPDX-License-Identifier: GPL-3.0-or-later
// From measured points and the nominal part to the result.
#pragma once

#include <vector>

#include "hdconj/inspect.hpp"
#include "measured_planes.hpp"
#include "nominal_part.hpp"

namespace hdconj::inspect {

/// Registers the points of @p planes, fits the flanks, leaves out strays, and does so again without them.
/// @param part  with one plane for each of @p planes
[[nodiscard]] Inspection evaluated(Scene const& scene, NominalPart const& part,
                                   std::vector<MeasuredPlane> const& planes, PointFile const& measured,
                                   InspectOptions const& options);

}  // namespace hdconj::inspect
