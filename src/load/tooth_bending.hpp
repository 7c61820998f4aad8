// SPDX-License-Identifier: GPL-3.0-or-later
// A tooth as a cantilever on the rim.
#pragma once

#include <vector>

#include "elastic/elasticity.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::load {

/// Bending and shear of a tooth (Weber and Banaschek 1953, without the rim's part, which the cup has): deflection along
/// x at height h under a line load along x at height k,
///
///   compliance(h, k) = integral_foot^min(h, k) 12 (h - y)(k - y)/(E' s^3) + 2.4 (1 + nu)/(E s) dy,  s(y) thickness, E'
///   = E/(1 - nu^2).
///
/// Symmetric (Betti). Plane strain in bending, 1.2 of the mean shear. Accuracy: that of a beam as short as it is high,
/// some ten per cent; the integral to 1e-3, the thickness constant over a two-hundredth of the height.
class ToothBending
{
  public:
    ToothBending() = default;  ///< a rigid tooth
    /// @param chord  error of the polygon that the thickness is taken from [mm]
    ToothBending(profile::Profile const& tooth, elastic::Elasticity const& material, double chord);

    /// [mm per N/mm]; heights in the tooth frame [mm], above the tip as at the tip, below the foot 0.
    [[nodiscard]] double operator()(double h, double k) const;

  private:
    double foot_ = 0;
    double step_ = 0;
    std::vector<double> bend_, shear_;  ///< 12/(E' s^3) and 2.4 (1 + nu)/(E s) of each part
    /// Integrals of bend, bend y, bend y^2 and shear from the foot to each part, y from the foot.
    std::vector<double> moment0_, moment1_, moment2_, shears_;
};

}  // namespace hdconj::load
