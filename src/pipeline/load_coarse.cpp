// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_coarse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hdconj/numeric/error.hpp"

namespace hdconj::detail {
namespace {

/// About half of @p count things, first and last among them.
std::vector<std::size_t> about_half(std::size_t count)
{
    std::size_t const kept = count / 2 + 1;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < kept; ++i)
        result.push_back((i * (count - 1) + (kept - 1) / 2) / (kept - 1));
    return result;
}

/// The elements of @p all that are named.
template<class T>
std::vector<T> some(std::vector<T> const& all, std::vector<std::size_t> const& which)
{
    std::vector<T> result;
    for (std::size_t const i : which)
        if (i < all.size())
            result.push_back(all[i]);
    return result;
}

}  // namespace

std::optional<CoarseDrive> coarse_drive(ContactBench const& bench)
{
    constexpr std::size_t fewest_slices = 3;
    constexpr int fewest_circles = 2, fewest_harmonics = 8;
    LoadGrid grid = load_grid(bench);
    if (grid.slices.size() < fewest_slices)
        return std::nullopt;
    grid.slices = about_half(grid.slices.size());
    grid.circles = std::max(std::min(grid.circles, fewest_circles), (grid.circles + 1) / 2);
    grid.harmonics = std::max(std::min(grid.harmonics, fewest_harmonics), grid.harmonics / 2);
    // the elements' error shows where there are more of them: fewer than one across the wall there cannot be
    grid.layers = 2;
    try
    {
        LoadModel model = load_model(bench, grid);
        Assembly start = assembly(bench, model.drive);
        return CoarseDrive{std::move(grid), std::move(model), std::move(start)};
    }
    catch (NumericalError const&)
    {
        return std::nullopt;  // such as more rigid balls than half of the harmonics tell apart
    }
}

FlankGrid thinned(FlankGrid const& grid, std::vector<std::size_t> const& slices)
{
    FlankGrid result;
    std::vector<std::size_t> const points = grid.points() > 2 ? about_half(grid.points()) : std::vector<std::size_t>{0, 1};
    result.z = some(grid.z, slices);
    result.station = some(grid.station, points);
    for (std::size_t f = 0; f < 2; ++f)
    {
        for (auto const* from : {&grid.point[f], &grid.normal[f]})
        {
            auto& to = from == &grid.point[f] ? result.point[f] : result.normal[f];
            for (std::size_t const k : slices)
                to.push_back(some((*from)[k], points));
        }
        result.line[f] = some(grid.line[f], slices);
        result.line_normal[f] = some(grid.line_normal[f], slices);
        result.index[f] = some(grid.index[f], points);
    }
    return result;
}

LoadedState error_between(LoadedState const& a, LoadedState const& b, double safety)
{
    LoadedState d;
    for (double LoadedState::* const figure :
         {&LoadedState::twist, &LoadedState::stiffness, &LoadedState::contact_area, &LoadedState::contact_share, &LoadedState::near_share, &LoadedState::node_share,
          &LoadedState::largest_pressure, &LoadedState::largest_force, &LoadedState::wave_generator_force, &LoadedState::wave_generator_torque, &LoadedState::lobe_force,
          &LoadedState::lobe_force_across, &LoadedState::lobe_z, &LoadedState::ball_force})
        d.*figure = safety * std::abs(a.*figure - b.*figure);
    // what depends on which contacts are closed may agree by chance on two grids: none of it is known much better than the rest
    constexpr double LoadedState::* contacts[] = {&LoadedState::stiffness, &LoadedState::contact_share, &LoadedState::near_share, &LoadedState::largest_force, &LoadedState::largest_pressure};
    auto const relative_to_size = [&](double LoadedState::* figure) { return a.*figure != 0 ? d.*figure / std::abs(a.*figure) : 0; };
    std::vector<double> relative;
    for (auto const figure : contacts)
        relative.push_back(relative_to_size(figure));
    std::sort(relative.begin(), relative.end());
    double const middle = relative[relative.size() / 2];
    for (auto const figure : contacts)
        d.*figure = std::max(d.*figure, middle * std::abs(a.*figure));
    d.contact_area = std::max(d.contact_area, middle * a.contact_area);
    // so do the forces of the bearing, of which two may agree where the third does not
    constexpr double LoadedState::* bearing[] = {&LoadedState::wave_generator_force, &LoadedState::lobe_force, &LoadedState::ball_force};
    double worst = 0;
    for (auto const figure : bearing)
        worst = std::max(worst, relative_to_size(figure));
    for (auto const figure : bearing)
        d.*figure = std::max(d.*figure, worst * std::abs(a.*figure));
    d.teeth = std::abs(a.teeth - b.teeth);
    d.balls = std::abs(a.balls - b.balls);
    return d;
}

double stress_at_corners(LoadModel const& model, HarmonicField const& field, StressPeak const& peak)
{
    SectionMesh const& mesh = model.solid.mesh();
    std::vector<SectionPoint> const places = gauss_points(mesh);
    auto const nearest = std::min_element(places.begin(), places.end(), [&](SectionPoint const& a, SectionPoint const& b) {
        return (position(mesh, a) - peak.at).squaredNorm() < (position(mesh, b) - peak.at).squaredNorm();
    });
    double worst = 0;
    if (nearest != places.end())
        for (double const xi : {-1.0, 1.0})
            for (double const eta : {-1.0, 1.0})
                worst = std::max(worst, von_mises(stress_at(mesh, field, {nearest->element, xi, eta}, peak.phi)) - peak.stress);
    return worst;
}

}  // namespace hdconj::detail
