// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement of the curves in which planes across the axis cut the neutral surface of a bent cup.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "hdconj/wavegen/material_displacement.hpp"

namespace hdconj::surface {

/// Displacements (w, v)(phi, h) of a wall between two heights, interpolated between Chebyshev nodes in h.
///
/// Through the plane at z passes the part of the wall that was at h(phi) with h + u_z(phi, h) = z. Its displacement,
/// w(phi, h(phi)) and v(phi, h(phi)), is a Fourier series again: so the section of a tooth moves by material motion,
/// the tooth along the section curve's normal (which is the projection of the wall's own normal). SectionPoses says the
/// same of one pose; this gives the whole motion, which has a conjugate profile.
///
/// Accuracy: of the interpolation, geometric in the number of nodes (8 on an inextensional cone: 1e-13 mm on type-50);
/// of the series, roundoff.
class SectionDisplacement
{
  public:
    using DisplacementOf = std::function<wavegen::MaterialDisplacement(double height)>;
    using HeightOf = std::function<double(double phi)>;

    /// @param low, high        heights between which the planes meet the wall [mm], low < high
    /// @param displacement_of  the wall's slice at a height
    /// @param nodes            Chebyshev nodes
    SectionDisplacement(double low, double high, DisplacementOf const& displacement_of, int nodes, int threads = 1);

    /// w and v [mm] of the wall at one angle, at any height; derivatives are not given.
    class Line
    {
      public:
        [[nodiscard]] wavegen::PointDisplacement operator()(double height) const;

      private:
        friend SectionDisplacement;
        Line(std::vector<double> const& height, std::vector<wavegen::PointDisplacement> at)
            : height_(&height), at_(std::move(at))
        {
        }

        std::vector<double> const* height_;
        std::vector<wavegen::PointDisplacement> at_;  ///< each node
    };
    /// The line at @p phi; this must outlive it.
    [[nodiscard]] Line line(double phi) const;

    /// w and v [mm] of the wall at @p phi and @p height; derivatives are not given.
    [[nodiscard]] wavegen::PointDisplacement operator()(double phi, double height) const;

    /// The section along which the wall's height is @p height_of(phi), periodic and smooth. Empty where a series does
    /// not follow it to roundoff.
    [[nodiscard]] std::optional<wavegen::MaterialDisplacement> along(HeightOf const& height_of) const;

  private:
    std::vector<double> height_;
    std::vector<wavegen::MaterialDisplacement> slice_;
};

}  // namespace hdconj::surface
