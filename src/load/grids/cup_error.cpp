// SPDX-License-Identifier: GPL-3.0-or-later
#include "cup_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elastic/bent_cup.hpp"
#include "grid_error.hpp"
#include "load/model/cup_shape.hpp"
#include "load/study/bearing_map.hpp"

namespace hdconj::load {
namespace {

/// Largest difference between the forces of the balls of two grids.
double bearing_distance(AssembledDrive const& a, AssembledDrive const& b)
{
    return ball_distance(bearing_map(a.model.drive, a.unloaded.state), bearing_map(b.model.drive, b.unloaded.state),
                         a.model.drive.response->sectors());
}

/// Radial displacement of the assembled wall in each slice, at @p phi from the major axis [mm].
std::vector<double> wall_at(AssembledDrive const& assembled, double phi)
{
    ElasticDrive const& drive = assembled.model.drive;
    std::vector<double> result;
    for (std::size_t k = 0; k < drive.slice_z.size(); ++k)
        result.push_back(series_at(drive, assembled.unloaded.shape.series[drive.stations.radial(k)], phi).value);
    return result;
}

/// Largest difference between the displacements of two grids at both axes, in the slices of the coarse one, which the
/// fine one has.
double displacement_distance(AssembledDrive const& fine, AssembledDrive const& coarse, double minor)
{
    std::vector<double> const &z = fine.model.drive.slice_z, &others = coarse.model.drive.slice_z;
    double worst = 0;
    for (double const phi : {0.0, minor}) {
        std::vector<double> const here = wall_at(fine, phi), there = wall_at(coarse, phi);
        for (std::size_t k = 0, at = 0; k < others.size(); ++k) {
            while (at + 1 < z.size() && z[at] < others[k])
                ++at;
            worst = std::max(worst, std::abs(here[at] - there[k]));
        }
    }
    return worst;
}

}  // namespace

double wall_difference(contact::ContactContext const& context, DriveGrids const& drives)
{
    double const minor = std::numbers::pi / context.scene.wave_generator.waves;
    std::vector<double> distances;
    for (AssembledDrive const& drive : drives.coarser)
        distances.push_back(displacement_distance(drives.fine, drive, minor));
    return grid_difference(0, distances);
}

double stress_error(double fine, std::span<double const> coarser, double unresolved, double of_slices, double safety)
{
    constexpr double part = 0.5, least = 0.08, slices = 1.5;
    return std::max({part * (safety * grid_difference(fine, coarser) + unresolved), slices * of_slices, least * fine});
}

void estimate_errors(contact::ContactContext const& context, DriveGrids const& drives, AssembledCup& cup)
{
    double const safety = grid_safety(cup.z.size());
    std::vector<AssembledCup> coarser;
    std::vector<double> balls;
    for (AssembledDrive const& drive : drives.coarser) {
        coarser.push_back(assembled_cup(context, drive));
        balls.push_back(bearing_distance(drives.fine, drive));
    }
    auto const difference = [&](double AssembledCup::*figure) {
        std::vector<double> values(coarser.size());
        std::ranges::transform(coarser, values.begin(), figure);
        return grid_difference(cup.*figure, values);
    };
    cup.displacement_error = safety * wall_difference(context, drives);
    // The slope over three slices is that over the two at the ends, so a coarser grid does not show this part.
    auto const between_slices = [&, field = cup_field(drives.fine.model, drives.fine.unloaded.forces, context.threads)](
                                    double slope, double phi) {
        LoadModel const& model = drives.fine.model;
        return std::abs(slope - elastic::wall_slope(model.solid.mesh(), field, model.middle + cup.z.front(),
                                                    model.middle + cup.z.back(), phi));
    };
    auto const coning_error = [&](double AssembledCup::*coning, double phi) {
        double const grids = difference(coning);
        return std::max(safety * grids, grids + between_slices(cup.*coning, phi));
    };
    cup.coning_major_error = coning_error(&AssembledCup::coning_major, 0);
    cup.coning_minor_error =
        coning_error(&AssembledCup::coning_minor, std::numbers::pi / context.scene.wave_generator.waves);
    constexpr double force = 0.85, ball = 0.42;  // they converge faster than the shape
    constexpr double least_force = 0.005;        // of it: grids agree by chance, and share their harmonics
    cup.wave_generator_force_error = std::max(force * safety * difference(&AssembledCup::wave_generator_force),
                                              least_force * std::abs(cup.wave_generator_force));
    cup.ball_force_error = ball * safety * std::max(grid_difference(0, balls), difference(&AssembledCup::ball_force));
    std::vector<double> stress(coarser.size());
    std::ranges::transform(coarser, stress.begin(), &AssembledCup::largest_stress);
    cup.largest_stress_error = stress_error(cup.largest_stress, stress, cup.largest_stress_error, 0, safety);
    cup.estimated = true;
}

}  // namespace hdconj::load
