// SPDX-License-Identifier: GPL-3.0-or-later
#include "traced_space.hpp"

namespace hdconj::conjugate {

std::vector<envelope::ContactArc> all_arcs(std::vector<envelope::Branch> const& branches)
{
    std::vector<envelope::ContactArc> arcs;
    for (envelope::Branch const& branch : branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    return arcs;
}

TracedSpace traced_space(envelope::AnyEnvelope const& envelope, std::vector<envelope::Branch> const& branches,
                         double chord, Tolerance const& tolerance, Solution& out)
{
    TracedSpace traced;
    traced.arcs = all_arcs(branches);
    ToothSpaceFinder<motion::AnyMotion> find(envelope, traced.arcs, out.geometry.circular_spline_inner_radius,
                                             out.scene.drive.circular_spline_teeth, tolerance, chord);
    traced.space = find();
    out.work.arrangement_edges += traced.space.segments;
    return traced;
}

}  // namespace hdconj::conjugate
