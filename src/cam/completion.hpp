// SPDX-License-Identifier: GPL-3.0-or-later
// The neutral curve from where the flanks part to the minor axis.
#pragma once

#include "start.hpp"

namespace hdconj::cam {

/// The displacement from @p end to the axis at @p half_wave as an even polynomial about that axis, of the angle from
/// it.
///
/// It goes on with the displacement, the slope and the second derivative @p bend of the curve at its end, lets the
/// tangential state vanish on the axis, which closes the length, and among these has the least integral of the square
/// of its third derivative: curvature changes as little as it can. The closing is not linear; Newton's method solves
/// it.
/// @throws NumericalError where that does not converge
[[nodiscard]] EvenPolynomial completion(CurveRule const& rule, MeshPoint const& end, double bend, double half_wave);

}  // namespace hdconj::cam
