// SPDX-License-Identifier: GPL-3.0-or-later
// Wave generator "cosine": w(u) = w0 cos(n u), thesis (2-11).
#pragma once

#include <cmath>
#include <optional>

#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// Radial displacement of a cosine cam.
/// Domain: any u. Accuracy: that of sin and cos.
struct CosineCam
{
    double w0 = 0;  ///< largest radial displacement [mm]
    int n = 2;      ///< waves per turn

    [[nodiscard]] int waves() const { return n; }
    [[nodiscard]] double amplitude() const { return w0; }
    [[nodiscard]] bool even() const { return true; }
    [[nodiscard]] std::span<double const> breaks() const { return {}; }

    /// For AnyWaveShape, which may be another.
    [[nodiscard]] std::optional<CosineCam> as_cosine() const;

    [[nodiscard]] RadialDisplacement operator()(double u) const
    {
        double const k = n;
        double const s = std::sin(k * u);
        double const c = std::cos(k * u);
        return {w0 * c, -k * w0 * s, -k * k * w0 * c, k * k * k * w0 * s, s, c};
    }

    /// What the scene reader needs to know.
    [[nodiscard]] static scene::FamilyDescription describe()
    {
        return {"cosine", "cosine cam, w = w0 cos(n u)", {radial_deformation_key()}};
    }

    [[nodiscard]] static CosineCam build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults&)
    {
        return {choice.number_or(radial_deformation, 0), place.waves};
    }
};

inline std::optional<CosineCam> CosineCam::as_cosine() const
{
    return *this;
}

}  // namespace hdconj::wavegen
