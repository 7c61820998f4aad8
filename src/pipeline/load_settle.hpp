// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Forces and loaded shape that belong to each other.
#pragma once

#include <cstddef>
#include <vector>

#include "contact_bench.hpp"
#include "hdconj/contact/flank_grid.hpp"
#include "hdconj/contact/gap_field.hpp"
#include "hdconj/load/equilibrium.hpp"
#include "hdconj/load/flank_contacts.hpp"
#include "loaded_shape.hpp"

namespace hdconj::detail {

/// Of the edges where teeth touch, given or 1/25 of the module [mm].
[[nodiscard]] double edge_radius(Scene const& scene);

/// One torque of a surface: what the rounds hand on.
struct Loaded
{
    Equilibrium state;
    std::vector<FlankContact> contacts;
    Eigen::MatrixXd forces;  ///< on the cup's stations
    LoadedShape shape;
    double residual = 0;     ///< [mm] largest gap of the loaded shape against that of the linear problem
    int rounds = 0;
    int steps = 0;
};

/// A drive with one surface of the circular spline.
struct LoadWork
{
    ContactBench const& bench;
    ElasticDrive const& drive;
    FlankGrid const& flanks;  ///< with their sharp edges: areas
    FlankGrid edges;          ///< with round ones: contacts

    LoadWork(ContactBench const& bench, ElasticDrive const& drive, FlankGrid const& flanks);

    [[nodiscard]] Scene const& scene() const { return bench.scene; }
    [[nodiscard]] std::size_t spaces() const { return static_cast<std::size_t>(scene().drive.circular_spline_teeth / drive.response.sectors()); }
    [[nodiscard]] double reach() const;    ///< contacts with a smaller gap are in the problem [mm]
    [[nodiscard]] double settled() const;  ///< gap of the loaded shape against that of the linear problem that rounds aim at [mm]
    /// @param depth  of strips, as a multiple of the standard one
    [[nodiscard]] FlankSearch search(double turn, double limit, double depth = 1) const;
    [[nodiscard]] GapField field(LoadedShape const& shape, FlankGrid const& grid) const;
    [[nodiscard]] double width_of(FlankContact const& c) const { return drive.slice_width[c.slice]; }
};

/// Equilibrium at @p torque [N mm], from the shape of @p start on.
/// @throws NumericalError with the torque when forces and shape do not settle, or no flank carries the torque
[[nodiscard]] Loaded settled_at(LoadWork const& work, double torque, Loaded const& start);

}  // namespace hdconj::detail
