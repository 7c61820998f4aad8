// SPDX-License-Identifier: GPL-3.0-or-later
// The radial displacement of the neutral curve and its derivatives at one angle.
#pragma once

#include <concepts>
#include <span>

namespace hdconj::wavegen {

/// w(u) and its derivatives at one angle.
struct RadialDisplacement
{
    double w = 0;       ///< [mm]
    double w1 = 0;      ///< dw/du
    double w2 = 0;      ///< d2w/du2
    double w3 = 0;      ///< d3w/du3; at a break the one of the side of larger u
    double sine = 0;    ///< sin(n u), for series in the same angle; unused by shapes that have breaks
    double cosine = 1;  ///< cos(n u)
};

/// A wave generator family: radial displacement with period 2 pi / waves(), largest, amplitude(), at the major axis u =
/// 0. w, w' and w'' are continuous; between breaks(), angles in increasing order in (-pi/n, pi/n], w is analytic.
template <class S>
concept WaveShape = requires(S const& shape, double u)
{
    {
        shape(u)
        } -> std::same_as<RadialDisplacement>;
    {
        shape.waves()
        } -> std::convertible_to<int>;
    {
        shape.amplitude()
        } -> std::convertible_to<double>;
    {
        shape.even()
        } -> std::convertible_to<bool>;
    {
        shape.breaks()
        } -> std::convertible_to<std::span<double const>>;
};

}  // namespace hdconj::wavegen
