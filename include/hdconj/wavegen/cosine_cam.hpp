// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Wave generator "cosine": w(u) = w0 cos(n u), thesis (2-11).
#pragma once

#include <cmath>

#include "hdconj/scene/fault.hpp"
#include "hdconj/scene/parameters.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj {

/// Radial displacement of a cosine cam.
/// Domain: any u. Accuracy: that of sin and cos.
struct CosineCam
{
    double w0 = 0;  ///< largest radial displacement [mm]
    int n = 2;      ///< waves per turn

    [[nodiscard]] int waves() const { return n; }
    [[nodiscard]] double amplitude() const { return w0; }
    [[nodiscard]] bool even() const { return true; }

    [[nodiscard]] RadialDisplacement operator()(double u) const
    {
        double const k = n;
        double const s = std::sin(k * u);
        double const c = std::cos(k * u);
        return {w0 * c, -k * w0 * s, -k * k * w0 * c, k * k * k * w0 * s, w0 * s / k, s, c};
    }

    /// What the scene reader needs to know.
    [[nodiscard]] static FamilyDescription describe()
    {
        return {"cosine",
                "cosine cam, w = w0 cos(n u)",
                {{"radial_deformation", Quantity::positive_length, "largest radial deformation w0 of the neutral curve"}}};
    }

    [[nodiscard]] static CosineCam build(FamilyChoice const& choice, int waves, Faults&)
    {
        return {choice.number_or("radial_deformation", 0), waves};
    }
};

}  // namespace hdconj
