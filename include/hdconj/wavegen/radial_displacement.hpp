// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The radial displacement of the neutral curve and its derivatives at one angle.
#pragma once

#include <concepts>

namespace hdconj {

/// w(u), its derivatives and its integral at one angle.
struct RadialDisplacement
{
    double w;         ///< [mm]
    double w1;        ///< dw/du
    double w2;        ///< d2w/du2
    double w3;        ///< d3w/du3
    double integral;  ///< integral of w from the major axis; -integral is the first-order tangential displacement v
    double sine;      ///< sin(n u), for series in the same angle
    double cosine;    ///< cos(n u)
};

/// A wave generator family: radial displacement with period 2 pi / waves(), w(0) = amplitude() at the major axis.
template<class S>
concept WaveShape = requires(S const& shape, double u) {
    { shape(u) } -> std::same_as<RadialDisplacement>;
    { shape.waves() } -> std::convertible_to<int>;
    { shape.amplitude() } -> std::convertible_to<double>;
    { shape.even() } -> std::convertible_to<bool>;
};

}  // namespace hdconj
