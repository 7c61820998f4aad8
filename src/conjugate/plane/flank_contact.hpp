// SPDX-License-Identifier: GPL-3.0-or-later
// Where the flanks of a tooth touch, over the polar angle.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// Gathers the stretches of flank contact of a boundary.
class FlankContactSum
{
  public:
    /// Adds those of @p pieces, which index @p arcs.
    void add(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
             std::vector<BoundaryPiece> const& pieces);

    /// Angles of all that was added; where contacts overlap they count once.
    [[nodiscard]] FlankEngagement value() const;

  private:
    /// The stretch of @p piece before a cusp of its arc at @p cusp.
    void compare_with_cusp(envelope::AnyEnvelope const& envelope, BoundaryPiece const& piece, double cusp);

    std::array<std::vector<std::pair<double, double>>, 2> stretches_;  ///< of each flank, from and to [rad]
    FlankEngagement worst_;                                            ///< at a cusp
};

}  // namespace hdconj::conjugate
