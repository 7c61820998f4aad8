// SPDX-License-Identifier: GPL-3.0-or-later
// What the scene asks of the wire, read once: the steps of `wedm` see this and no scene.
#pragma once

#include <optional>
#include <string>

#include "faces.hpp"
#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wedm.hpp"

namespace hdconj::wedm {

/// A part to be cut by wire. Lengths in mm.
struct WireJob
{
    /// Reads what @p scene, which must have no faults of check_wedm(), asks for the part with @p part_faces.
    WireJob(Scene const& scene, WireFaces part_faces);

    WireFaces faces;
    std::string name;                     ///< of the part, ASCII
    WireRequest wire;                     ///< the table [wedm], at least one pass
    WireMachine machine;                  ///< workpiece and guides
    double contour_error = 0;             ///< of the faces against the true ones
    std::optional<ToothSurface> surface;  ///< nothing where both faces are the same
    std::optional<TiltKind> tilt_kind;    ///< nothing where the teeth are not tilted
    Fault wire_key;                       ///< where the scene states wire_diameter, for messages

    /// Of the height of what the wire leaves; where no residual is told, no more than this is left.
    [[nodiscard]] double residual_error() const { return wire.tolerance + contour_error; }
};

/// @throws InputError with all faults of check_wedm()
void refuse_wire_faults(Scene const& scene);

/// Whether the flexspline is the part.
[[nodiscard]] bool cuts_flexspline(Scene const& scene);

/// Thickness of the workpiece [mm]; 0: not stated.
[[nodiscard]] double thickness_of(Scene const& scene);

/// Whether straight lines join the slices of the circular spline point for point.
[[nodiscard]] bool has_straight_rulings(Scene const& scene);

/// Slices of @p outline that are not those of the toothing make another part.
/// @throws InputError where the outer ones do not stand at the ends of the face width
void check_slices(Scene const& scene, CircularSplineOutline const& outline);

}  // namespace hdconj::wedm
