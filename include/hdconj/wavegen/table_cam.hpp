// SPDX-License-Identifier: GPL-3.0-or-later
// Wave generator "table": radial displacement from a file, by a periodic spline.
#pragma once

#include <memory>
#include <vector>

#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// Periodic cubic spline with continuous curvature through (angle, w) of one wave, the mean taken away.
///
/// Whether the file holds the displacement, or the radius, of the neutral curve makes no difference: closing the
/// curve's length fixes the mean radius. The angle is counted from the major axis. w''' jumps at the knots: these are
/// the breaks. Domain: 4 angles or more, increasing, within one wave of 360/n degrees; the closing row (same value one
/// wave on) may be given. Accuracy: passes through every row to roundoff; between rows O(h^4) for a table of a smooth
/// cam, h^2 in w''.
class TableCam
{
  public:
    TableCam() = default;
    /// @param angles  (k) [rad], increasing, spanning less than one wave
    /// @param values  (k) [mm]
    TableCam(std::vector<double> const& angles, std::vector<double> const& values, int n);

    [[nodiscard]] int waves() const { return n_; }
    [[nodiscard]] double amplitude() const { return largest_; }
    [[nodiscard]] bool even() const { return even_; }
    [[nodiscard]] std::span<double const> breaks() const
    {
        return spline_ ? std::span<double const>(spline_->knots) : std::span<double const>{};
    }

    [[nodiscard]] RadialDisplacement operator()(double u) const;

    [[nodiscard]] static scene::FamilyDescription describe()
    {
        return {"table",
                "radial displacement from a file, by a periodic cubic spline",
                {{"file", scene::Quantity::file,
                  "CSV file with columns angle in degrees from the major axis, radial displacement (or radius) in mm; "
                  "one wave"}}};
    }

    [[nodiscard]] static TableCam build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place,
                                        Faults& faults);

  private:
    /// Powers of (u - knot) on the interval that starts at a knot.
    struct Cubic
    {
        double c0, c1, c2, c3;

        /// Largest value from the knot to @p h after it: at the knot, or where the slope vanishes.
        [[nodiscard]] double largest(double h) const;
    };
    struct Spline
    {
        std::vector<double> knots;  ///< in (-pi/n, pi/n]
        std::vector<Cubic> cubics;  ///< one per knot, the last one reaches over the end of the wave
    };

    std::shared_ptr<Spline const> spline_;  ///< shared: shapes are copied into motions
    int n_ = 2;
    double largest_ = 0;
    bool even_ = false;
};

}  // namespace hdconj::wavegen
