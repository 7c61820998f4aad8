// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The tooth space of a set of branches.
#pragma once

#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// Contact arcs of all branches in one list, which boundary pieces index.
[[nodiscard]] inline std::vector<envelope::ContactArc> all_arcs(std::vector<envelope::Branch> const& branches)
{
    std::vector<envelope::ContactArc> arcs;
    for (envelope::Branch const& branch : branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    return arcs;
}

/// A tooth space and the arcs that its pieces index.
struct TracedSpace
{
    std::vector<envelope::ContactArc> arcs;
    ToothSpace space;
};

/// What the teeth of @p envelope leave of the ring outside its tip circle, from polygons of the chord error @p chord
/// [mm]. Segments are counted in @p out.
[[nodiscard]] inline TracedSpace traced_space(envelope::AnyEnvelope const& envelope,
                                              std::vector<envelope::Branch> const& branches, double chord,
                                              Tolerance const& tolerance, Solution& out)
{
    TracedSpace traced;
    traced.arcs = all_arcs(branches);
    traced.space = ToothSpaceFinder<motion::AnyMotion>(envelope, traced.arcs, out.geometry.circular_spline_inner_radius,
                                                       out.scene.drive.circular_spline_teeth, tolerance, chord)();
    out.work.arrangement_edges += traced.space.segments;
    return traced;
}

}  // namespace hdconj::conjugate
