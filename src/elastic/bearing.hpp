// SPDX-License-Identifier: GPL-3.0-or-later
// The wave generator's bearing: the surface that presses the wall of the cup outward, and its compliance.
#pragma once

#include <Eigen/Core>

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "hdconj/wavegen/radial_displacement.hpp"
#include "influence.hpp"

namespace hdconj::elastic {

/// Outer ring of a thin-section ball bearing: rectangular section, as wide as the bearing.
struct BearingRing
{
    double thickness = 1.2;  ///< [mm]
    /// The groove keeps the line of balls from moving along the axis. A ring that is free to move can cone with the
    /// cup, which changes the result much.
    bool axially_held = true;
    /// Radial stiffness of the line of balls on the cam [N/mm per mm of arc at the ring's inner surface]; absent:
    /// rigid.
    std::optional<double> radial_stiffness;
    Elasticity material{206e3, 0.3};
};

/// Bearing on its cam. z from the outer face of the cup's bottom.
struct Bearing
{
    double middle = 9;                ///< z of the line of balls [mm]
    double width = 6;                 ///< of the surface that the cup may touch [mm]; 0: one line
    double fit = 0;                   ///< interference: its outer radius less the inner radius of the cup [mm]
    double cam_oversize = 0;          ///< all round under the line of balls: preload that takes up their play [mm]
    std::optional<BearingRing> ring;  ///< absent: the surface is rigid and straight along the axis
};

/// A radial displacement sampled @p count times in a lobe, and its trigonometric interpolant
/// sum_k cosine[k] cos(k n phi) + sine[k] sin(k n phi), k = 0 ... count/2, n = waves: exact at the samples.
struct CamSeries
{
    int waves = 2;
    bool even = true;
    std::vector<double> cosine;  ///< [mm]
    std::vector<double> sine;

    [[nodiscard]] double at(double phi) const;
};

/// Series of values at the angles 2 pi j/(n N), j = 0 ... N - 1. Domain: N even.
[[nodiscard]] CamSeries cam_series(std::vector<double> const& samples, int waves, bool even);

/// The shape w(phi) is taken at the undeformed angle of the points of the wall. The polar angle of the displaced points
/// differs from it to second order, v w'/r: some micrometres.
/// @param angles  samples in a lobe, even
template <wavegen::WaveShape Shape>
[[nodiscard]] CamSeries cam_series(Shape const& shape, int angles)
{
    std::vector<double> samples;
    for (int j = 0; j < angles; ++j)
        samples.push_back(shape(2 * std::numbers::pi * j / (shape.waves() * angles)).w);
    return cam_series(samples, shape.waves(), shape.even());
}

/// Outer surface of the bearing. Rows of `cosine` and `sine`: z, columns: harmonics k waves, k = 0, 1, ...
struct BearingSurface
{
    std::vector<double> z;                ///< [mm]
    std::optional<Influence> compliance;  ///< radial, between the circles z, the line of balls on the cam; none: rigid
    Eigen::MatrixXd cosine;  ///< unloaded surface against the cup's inner radius, fit included, outward [mm]
    Eigen::MatrixXd sine;
    /// Reaction of the line of balls [N/rad] that gives the unloaded ring the shape of the cam.
    Eigen::VectorXd reaction_cosine;
    Eigen::VectorXd reaction_sine;
    Eigen::VectorXd reaction_to_lift;  ///< for 1 mm of the cam [N/rad]
    Eigen::MatrixXd reaction_to_load;  ///< for 1 N/rad on each z: rows harmonics, columns z
};

/// @throws NumericalError about the bearing, always
[[noreturn]] void refuse_bearing(std::string const& place, std::string const& cause, std::string const& remedy = {});

/// Circles across the bearing's width: @p count of them, edges included; one in the middle for a width of 0.
[[nodiscard]] std::vector<double> bearing_circles(Bearing const& bearing, int count);

/// @param inner_radius  of the cup [mm]
/// The ring is free but for the line of balls on its inner surface, which is held radially, and against rigid motions.
/// @throws NumericalError for impossible dimensions
[[nodiscard]] BearingSurface bearing_surface(Bearing const& bearing, double inner_radius, CamSeries const& cam,
                                             std::vector<double> const& z, int threads = 1);

}  // namespace hdconj::elastic
