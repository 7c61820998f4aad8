// SPDX-License-Identifier: GPL-3.0-or-later
// The part of second order by which a linear displacement must be completed so that the neutral curve keeps its
// stretch.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/wavegen/material_displacement.hpp"

namespace hdconj::wavegen {

/// A linear model gives the stretch (w + v')/r_m of the neutral curve to first order; its turning w' - v adds e = (w' -
/// v)^2/(2 r_m) [mm]. To leave the stretch as it is, the mean of w falls by that of e, and v' by the rest of e:
///
///   w -> w - mean(e),   v -> v - integral of (e - mean(e)).
///
/// For w = w0 cos(n phi), v' = -w the mean of e is w0^2 (n - 1/n)^2/(4 r_m) to first order: 1.44 um on type-50; of
/// the 2.57 um of the exact curve (design 3.1) the rest is that w is told at the deformed angle there. e has twice the
/// harmonics of the displacement; what is below a rounding of r_m at the end of them is left out. Accuracy: third order
/// in w/r_m; as arithmetic, a few roundings of r_m. Domain: r_m > 0. No harmonics: nothing to do.
[[nodiscard]] inline MaterialDisplacement length_kept(MaterialDisplacement displacement, double r_m)
{
    auto& harmonics = displacement.harmonics;
    if (harmonics.empty())
        return displacement;
    bool const symmetric = is_symmetric(displacement);
    std::size_t const given = harmonics.size();
    // an even sum over more than twice as many points as the harmonics of e has no error
    std::size_t const points = 4 * given;
    std::vector<double> e(points), cosine(points), sine(points);
    for (std::size_t i = 0; i < points; ++i) {
        double const angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
        cosine[i] = std::cos(angle);
        sine[i] = std::sin(angle);
    }
    double mean = 0;
    for (std::size_t i = 0; i < points; ++i) {
        double turned = 0;  // w' - v
        for (std::size_t k = 0; k < given; ++k) {
            DisplacementHarmonic const& h = harmonics[k];
            double const order = static_cast<double>(k) * displacement.waves;
            std::size_t const m = k * i % points;
            turned += (order * h.w_sine - h.v_cosine) * cosine[m] - (order * h.w_cosine + h.v_sine) * sine[m];
        }
        e[i] = turned * turned / (2 * r_m);
        mean += e[i] / static_cast<double>(points);
    }
    harmonics.resize(2 * given - 1);
    harmonics.front().w_cosine -= mean;
    for (std::size_t k = 1; k < harmonics.size(); ++k) {
        double on_cosine = 0, on_sine = 0;
        for (std::size_t i = 0; i < points; ++i) {
            std::size_t const m = k * i % points;
            on_cosine += e[i] * cosine[m];
            on_sine += e[i] * sine[m];
        }
        // v' = -e
        double const per_order = 2 / (static_cast<double>(points) * static_cast<double>(k) * displacement.waves);
        harmonics[k].v_sine -= on_cosine * per_order;
        // what the sum leaves of an even e is rounding and would spoil exact symmetry
        harmonics[k].v_cosine += symmetric ? 0 : on_sine * per_order;
    }
    auto const is_rounding = [&](DisplacementHarmonic const& h) {
        return std::hypot(h.v_cosine, h.v_sine) <= unit_roundoff * r_m;
    };
    while (harmonics.size() > given && is_rounding(harmonics.back()))
        harmonics.pop_back();
    return displacement;
}

}  // namespace hdconj::wavegen
