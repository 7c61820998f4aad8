// SPDX-License-Identifier: GPL-3.0-or-later
#include "assembled_drive.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "hdconj/error.hpp"
#include "load/elastic_drive.hpp"
#include "load/model/cup_shape.hpp"
#include "load/study/bearing_map.hpp"
#include "numeric/moments.hpp"

namespace hdconj::load {
namespace {

/// Indices of about half of @p count things, the first and the last among them.
std::vector<std::size_t> about_half(std::size_t count)
{
    std::size_t const kept = count / 2 + 1;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < kept; ++i)
        result.push_back((i * (count - 1) + (kept - 1) / 2) / (kept - 1));
    return result;
}

/// The elements of @p all with the indices @p which, as far as there are any.
template <class T>
std::vector<T> selected(std::vector<T> const& all, std::vector<std::size_t> const& which)
{
    std::vector<T> result;
    for (std::size_t const i : which)
        if (i < all.size())
            result.push_back(all[i]);
    return result;
}

/// Slope of the line of least squares through (x, y); 0 where all x are equal.
double slope_of(std::vector<double> const& x, std::vector<double> const& y)
{
    numeric::Moments const m = numeric::moments(x, y);
    return m.xx > 0 ? m.xy / m.xx : 0;
}

}  // namespace

LoadedDrive assembly(contact::ContactContext const& context, ElasticDrive const& drive)
{
    LoadedDrive result;
    result.state = equilibrium(drive, {}, std::nullopt, nullptr, context.threads);
    result.forces = forces_on_cup(drive, {}, result.state);
    result.shape = loaded_shape(context, drive, result.forces);
    return result;
}

std::vector<AssembledDrive> coarser_drives(contact::ContactContext const& context, std::size_t most)
{
    constexpr std::size_t fewest_slices = 3;
    constexpr int fewest_circles = 2, fewest_harmonics = 8;
    std::vector<AssembledDrive> drives;
    LoadGrid grid = load_grid(context);
    // The error of the elements shows on a finer mesh: there cannot be less than one element across the wall.
    grid.layers = 2;
    while (drives.size() < most && grid.slices.size() >= fewest_slices) {
        grid.slices = selected(grid.slices, about_half(grid.slices.size()));
        grid.circles = std::max(std::min(grid.circles, fewest_circles), (grid.circles + 1) / 2);
        grid.harmonics = std::max(std::min(grid.harmonics, fewest_harmonics), grid.harmonics / 2);
        try {
            LoadModel model = load_model(context, grid);
            LoadedDrive unloaded = assembly(context, model.drive);
            drives.push_back({grid, std::move(model), std::move(unloaded)});
        } catch (NumericalError const& error) {
            error.rethrow_unless_infeasible();
            return drives;  // such as more rigid balls than half of the harmonics resolve
        }
    }
    return drives;
}

contact::FlankGrid coarsened(contact::FlankGrid const& grid)
{
    contact::FlankGrid result;
    std::vector<std::size_t> const slices = about_half(grid.slices());
    std::vector<std::size_t> const points =
        grid.points() > 2 ? about_half(grid.points()) : std::vector<std::size_t>{0, 1};
    result.z = selected(grid.z, slices);
    result.station = selected(grid.station, points);
    for (std::size_t f = 0; f < 2; ++f) {
        for (std::size_t const k : slices) {
            result.point[f].push_back(selected(grid.point[f][k], points));
            result.normal[f].push_back(selected(grid.normal[f][k], points));
        }
        result.line[f] = selected(grid.line[f], slices);
        result.line_normal[f] = selected(grid.line_normal[f], slices);
        result.index[f] = selected(grid.index[f], points);
    }
    return result;
}

AssembledCup assembled_cup(contact::ContactContext const& context, AssembledDrive const& assembled)
{
    ElasticDrive const& drive = assembled.model.drive;
    LoadedDrive const& unloaded = assembled.unloaded;
    int const sectors = drive.response->sectors();
    double const minor = std::numbers::pi / context.scene.wave_generator.waves;
    AssembledCup cup;
    cup.z = drive.slice_z;
    for (std::size_t k = 0; k < cup.z.size(); ++k) {
        std::vector<double> const& series = unloaded.shape.series[drive.stations.radial(k)];
        cup.w_major.push_back(series_at(drive, series, 0).value);
        cup.w_minor.push_back(series_at(drive, series, minor).value);
    }
    cup.coning_major = slope_of(cup.z, cup.w_major);
    cup.coning_minor = slope_of(cup.z, cup.w_minor);
    cup.wave_generator_force = unloaded.state.bearing.sum() * sectors;
    cup.contacts = static_cast<int>((unloaded.state.bearing.array() > 0).count()) * sectors;
    BallPeak const ball = ball_peak(drive, unloaded.state);
    cup.ball_force = ball.force;
    cup.ball_phi = ball.phi;
    cup.balls = ball.carrying;
    CupStress const stress =
        cup_stress(assembled.model, cup_field(assembled.model, unloaded.forces, context.threads), context.threads);
    cup.largest_stress = stress.peak.stress;
    cup.largest_stress_error = stress.unresolved;
    return cup;
}

}  // namespace hdconj::load
