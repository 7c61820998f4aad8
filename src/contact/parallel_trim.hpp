// SPDX-License-Identifier: GPL-3.0-or-later
// A flank moved along its normals, without what such a move makes of corners and tight bends.
#pragma once

#include <vector>

#include "flank_grid.hpp"
#include "hdconj/base/vec2.hpp"

namespace hdconj::contact {

/// Cuts the overlaps of a curve that was moved along its normals: the points of each come to lie where its two branches
/// cross.
///
/// At a corner of the material that turns by theta each moved branch overruns the other by d tan(theta/2), nearer to
/// the tooth than the parallel by up to d (1 - cos theta); where a bend is tighter than the radius d its points run
/// backwards. Between two neighbouring points whose tangents meet at a after the first and at b before the second,
/// moving leaves a - d tan(theta/2) and b - d tan(theta/2); where either is below zero at a corner (a step that turns
/// four times as much as those beside it), or a step of a bend has turned round, there is an overlap. Its crossing is
/// looked for on the moved points, each branch carried on to the corner, or along its last tangent as far as where the
/// bare tangents meet, and as curves, not chords (hermite_between()). A corner that turns the other way opens, and is
/// left to the chord. An overlap that ends beyond an end of the flank has no crossing and is left as it is.
/// @param bare    the curve before [mm]
/// @param moved   its points moved by one distance along @p normal; changed
/// @param normal  unit; changed between points that come together: those of the branch that they belong to
/// @returns by how much the branches of the sharpest overlap that was cut turn [rad]; 0 where nothing was
double trim_overlaps(std::vector<Vec2> const& bare, std::vector<Vec2>& moved, std::vector<Vec2>& normal);

/// How much nearer to the teeth than the parallel a moved flank may be because an overlap ends beyond its end [mm].
///
/// A corner that has left through an end of the flank between two slices still has its overlap on the flank while it is
/// nearer to the end than d tan(theta/2). What it then takes is d (1 - cos theta) at most, theta that of the sharpest
/// corner of any slice. 0 where all slices have overlaps, or none has.
/// @param clearance  of each slice [mm]: the missing length is less by what the two slices beside it, and all between
///                   them, clear more than the closest slice; empty: it counts in full
[[nodiscard]] double overlap_at_ends(FlankGrid const& bare, double distance, std::vector<double> const& clearance = {});

}  // namespace hdconj::contact
