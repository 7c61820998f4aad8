// SPDX-License-Identifier: GPL-3.0-or-later
// The linear inextensional mode of a ring under a wave generator.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "hdconj/error.hpp"
#include "hdconj/numeric/fourier.hpp"
#include "hdconj/wavegen/material_displacement.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// Displacement of a linear shell or finite-element model of the ring. w(phi) is the wave generator's shape at the
/// *undeformed* angle. With v' = -(w - its mean) and v(0) = 0 there is no hoop strain of first order. The mean of w is
/// of second order in families that have one. It stays in w and is kept out of v, so that v is periodic. Accuracy:
/// Fourier coefficients to roundoff of the largest; those that are rounding are 0. Domain: shapes without breaks.
/// @throws NumericalError otherwise, or when the series is not resolved to roundoff.
template <WaveShape Shape>
[[nodiscard]] MaterialDisplacement inextensional_mode(Shape const& shape)
{
    if (!shape.breaks().empty())
        throw NumericalError(ErrorCode::not_smooth, "wave generator", "series in the undeformed angle",
                             "the shape's third derivative jumps, which a series does not follow",
                             "use the exact or the "
                             "first-order motion");
    numeric::FourierSeries const w([&](double phi) { return shape(phi).w; }, 2 * std::numbers::pi / shape.waves());
    if (!w.resolved())
        throw NumericalError(ErrorCode::not_smooth, "wave generator", "series in the undeformed angle",
                             "the shape is not smooth enough for it", "use the exact or the first-order motion");
    auto const above_noise = [&](double coefficient) { return std::abs(coefficient) > w.noise() ? coefficient : 0.0; };
    MaterialDisplacement mode{shape.waves(), {}};
    double v_at_0 = 0;
    for (std::size_t k = 0; k < w.terms(); ++k) {
        DisplacementHarmonic h{above_noise(w.cosine(k)), above_noise(w.sine(k)), 0, 0};
        if (k > 0) {
            double const order = static_cast<double>(k) * shape.waves();
            h.v_cosine = h.w_sine / order;
            h.v_sine = -h.w_cosine / order;
            v_at_0 += h.v_cosine;
        }
        mode.harmonics.push_back(h);
    }
    mode.harmonics.front().v_cosine = -v_at_0;
    drop_empty_tail(mode);
    return mode;
}

}  // namespace hdconj::wavegen
