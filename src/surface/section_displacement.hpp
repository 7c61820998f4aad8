// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement of the curves in which planes across the axis cut the neutral surface of a bent cup.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "hdconj/wavegen/material_displacement.hpp"

namespace hdconj::surface {

/// Displacement of a point of a wall [mm].
struct WallPoint
{
    double w = 0, v = 0;
};

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

    /// The wall at one angle, at any height.
    class Line
    {
      public:
        [[nodiscard]] WallPoint operator()(double height) const;

      private:
        friend SectionDisplacement;
        Line(SectionDisplacement const& of, std::vector<WallPoint> at) : of_(&of), at_(std::move(at)) {}

        SectionDisplacement const* of_;
        std::vector<WallPoint> at_;  ///< each node
    };
    /// The line at @p phi; this must outlive it.
    [[nodiscard]] Line line(double phi) const;

    /// The wall at @p phi and @p height.
    [[nodiscard]] WallPoint operator()(double phi, double height) const;

    /// The section along which the wall's height is @p height_of(phi), periodic and smooth. Empty where a series does
    /// not follow it to roundoff.
    [[nodiscard]] std::optional<wavegen::MaterialDisplacement> along(HeightOf const& height_of) const;

  private:
    std::vector<double> height_;  ///< of the nodes [mm]
    std::vector<double> weight_;  ///< of the nodes in the barycentric form (Berrut and Trefethen 2004)
    std::vector<wavegen::MaterialDisplacement> slice_;
};

}  // namespace hdconj::surface
