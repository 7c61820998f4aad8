// SPDX-License-Identifier: GPL-3.0-or-later
// Branches, zones and positions of the tooth as they are written into results.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// The branch sampled to the chord error, exact ends included.
[[nodiscard]] BranchRecord branch_record(envelope::AnyEnvelope const& envelope, envelope::Branch const& branch,
                                         double chord, std::size_t& evaluations);

/// The conjugate zones of a branch: stretches on which t is monotone and the envelope stays outer or inner.
void append_zones(envelope::AnyEnvelope const& envelope, envelope::Branch const& branch, std::size_t index,
                  std::vector<envelope::ContactArc> const& boundary_arcs, std::vector<BoundaryPiece> const& pieces,
                  std::vector<ConjugateZone>& zones);

/// Adds the tooth at 41 instants from one end of the lobe to the other to @p family, as polygons, each moved by -@p
/// down along y [mm].
void add_positions(profile::Profile const& tooth, motion::AnyMotion const& motion, double down,
                   std::vector<std::vector<Vec2>>& family);

}  // namespace hdconj::conjugate
