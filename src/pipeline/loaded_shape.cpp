// SPDX-License-Identifier: GPL-3.0-or-later
#include "loaded_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/contact/gap_field.hpp"
#include "hdconj/motion/material_motion.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/wavegen/length_kept.hpp"
#include "solve_motion.hpp"

namespace hdconj::detail {
namespace {

/// Series of w and v as MaterialMotion takes them.
MaterialDisplacement displacement_of(ElasticDrive const& drive, std::vector<double> const& w, std::vector<double> const& v, double r_m)
{
    MaterialDisplacement result;
    result.waves = drive.response.sectors();
    std::size_t const count = drive.response.harmonics().size();
    for (std::size_t k = 0; k < count; ++k)
        result.harmonics.push_back({w[2 * k], w[2 * k + 1], v[2 * k], v[2 * k + 1]});
    return length_kept(std::move(result), r_m);
}

/// Between two poses, and beyond.
Pose between(Pose const& a, Pose const& b, double t)
{
    Pose p;
    p.origin = a.origin + t * (b.origin - a.origin);
    double const c = a.cosine + t * (b.cosine - a.cosine), s = a.sine + t * (b.sine - a.sine);
    double const length = std::hypot(c, s);
    p.cosine = c / length;
    p.sine = s / length;
    return p;
}

}  // namespace

LoadedShape loaded_shape(ContactBench const& bench, ElasticDrive const& drive, Eigen::MatrixXd const& forces)
{
    LoadedShape shape;
    shape.series = displacements(drive, forces);
    double const r_m = bench.geometry.r_m;
    std::size_t const slices = drive.stations.slices;
    std::vector<MaterialMotion> motions;
    for (std::size_t k = 0; k < slices; ++k)
        motions.emplace_back(displacement_of(drive, shape.series[drive.stations.radial(k)], shape.series[drive.stations.tangential(k)], r_m), r_m, tooth_ratio(bench.scene));
    std::array<int, 2> const needed = teeth_needed(bench.scene.drive.flexspline_teeth, bench.scene.drive.circular_spline_teeth, drive.phase);
    auto const teeth = static_cast<std::size_t>(needed[1] - needed[0] + 1);
    shape.places = ToothPlaces{needed[0], slices, std::vector<Pose>(teeth * slices)};
    std::vector<double> const& z = bench.maker.z();
    constexpr std::size_t grain = 32;
    parallel_for(teeth, bench.threads, grain, [&](std::size_t i) {
        double const phi = 2 * std::numbers::pi * (needed[0] + static_cast<int>(i)) / bench.scene.drive.flexspline_teeth + drive.phase;
        std::vector<Pose> pose(slices);
        std::vector<double> moved(slices);
        for (std::size_t k = 0; k < slices; ++k)
        {
            pose[k] = motions[k].pose(phi);
            moved[k] = z[k] + series_at(drive, shape.series[drive.stations.axial(k)], phi).value;
        }
        for (std::size_t k = 0; k < slices; ++k)
        {
            Pose& at = shape.places.pose[i * slices + k];
            at = pose[k];
            if (slices < 2)
                continue;
            std::size_t j = 0;
            while (j + 2 < slices && moved[j + 1] <= z[k])
                ++j;
            at = between(pose[j], pose[j + 1], (z[k] - moved[j]) / (moved[j + 1] - moved[j]));
        }
    });
    return shape;
}

double normal_displacement(ElasticDrive const& drive, LoadedShape const& shape, FlankContact const& c)
{
    double const phi = 2 * std::numbers::pi * c.tooth / drive.flexspline_teeth + drive.phase;
    auto const at = [&](std::size_t station) { return series_at(drive, shape.series[station], phi).value; };
    return c.c_r * at(drive.stations.radial(c.slice)) + c.c_t * at(drive.stations.tangential(c.slice)) + c.c_turn * at(drive.stations.turn(c.slice));
}

}  // namespace hdconj::detail
