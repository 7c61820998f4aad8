// SPDX-License-Identifier: GPL-3.0-or-later
// Where the flanks of a tooth touch, over the polar angle.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// Gathers the stretches of flank contact of a boundary, and those that flanks lose by undercut.
class FlankContactSum
{
  public:
    /// Adds the polar angles over which @p pieces of a boundary, which index @p arcs, touch a flank, and those of the
    /// contacts of @p arcs that reach a cusp, as far as @p in_space says that they lie in the space to be bounded.
    void add(envelope::AnyEnvelope const& envelope, std::vector<envelope::ContactArc> const& arcs,
             std::vector<BoundaryPiece> const& pieces, std::function<bool(Vec2 const&)> const& in_space);

    /// Angles of all that was added; where contacts overlap they count once.
    [[nodiscard]] FlankEngagement value() const;

  private:
    /// From and to, polar angles [rad].
    struct Flank
    {
        std::vector<std::pair<double, double>> used;
        std::vector<std::pair<double, double>> undercut;  ///< contacts that reach a cusp, with what is used of them
    };

    std::array<Flank, 2> flanks_;
};

}  // namespace hdconj::conjugate
