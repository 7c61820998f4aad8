// SPDX-License-Identifier: GPL-3.0-or-later
// The closed form of the exact motion of a cosine cam.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::motion {

/// The exact motion of a cosine cam, as the numbers that its closed form is made of.
struct CosineForm
{
    /// Harmonics of the arc length that are summed; type-50 has four above rounding.
    static constexpr std::size_t harmonics = 8;

    double w0, waves, r_0, r_m, ratio;
    double mean;                          ///< of the line element
    std::array<double, harmonics> sines;  ///< r_m phi = mean u + sum of sines[k - 1] sin(k n u)
};

/// Nothing where the motion has no such form: another model or wave generator, or more harmonics.
template <RelativeMotion Motion>
[[nodiscard]] std::optional<CosineForm> cosine_form(Motion const& motion)
{
    if constexpr (requires { motion.closed_form(); }) {
        return motion.closed_form();
    } else if constexpr (requires { motion.curve().shape().as_cosine(); }) {
        auto const cam = motion.curve().shape().as_cosine();
        auto const* series = motion.curve().length().series();
        if (!cam || series == nullptr)
            return std::nullopt;
        for (std::size_t k = CosineForm::harmonics + 1; k < series->terms(); ++k)
            if (std::abs(series->cosine(k)) > series->noise())
                return std::nullopt;
        double const waves = cam->n;
        CosineForm result{cam->w0,        waves, motion.curve().r_0(), motion.curve().r_m(), motion.tooth_ratio(),
                          series->mean(), {}};
        for (std::size_t k = 1; k <= CosineForm::harmonics; ++k) {
            if (series->sine(k) != 0)
                return std::nullopt;
            result.sines[k - 1] = series->cosine(k) / (static_cast<double>(k) * waves);
        }
        return result;
    } else {
        return std::nullopt;
    }
}

}  // namespace hdconj::motion
