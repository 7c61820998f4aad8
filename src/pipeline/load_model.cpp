// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "hdconj/elastic/unit_fields.hpp"
#include "hdconj/elastic/wave_generator_contact.hpp"
#include "elastic_cup.hpp"
#include "load_wave_generator.hpp"
#include "place_teeth.hpp"

namespace hdconj::detail {
namespace {

constexpr int standard_harmonics = 100;

/// Weights of the trapezoid rule, the whole width for one slice.
std::vector<double> slice_widths(std::vector<double> const& z, double width)
{
    if (z.size() == 1)
        return {width};
    std::vector<double> result(z.size(), 0);
    for (std::size_t k = 0; k + 1 < z.size(); ++k)
    {
        result[k] += 0.5 * (z[k + 1] - z[k]);
        result[k + 1] += 0.5 * (z[k + 1] - z[k]);
    }
    return result;
}

std::vector<double> above_middle(std::vector<double> const& circles, double middle)
{
    std::vector<double> result;
    for (double const circle : circles)
        result.push_back(circle - middle);
    return result;
}

/// Stations of the cup: what is asked of its sections, and how that acts around the ring. Turns have no place of their own.
struct CupStations
{
    std::vector<Station> places;
    std::vector<RingStation> around;
};

/// @param spread  of a force of the bearing around the ring [rad]
CupStations cup_stations(Scene const& scene, SectionMesh const& mesh, std::vector<double> const& circles, double middle, std::vector<double> const& slices, double spread)
{
    using enum RingStation::Parity;
    double const tooth_spread = std::numbers::pi / scene.drive.flexspline_teeth;
    CupStations result;
    for (double const circle : circles)
    {
        result.places.push_back(wall_station(mesh, circle, 0, Direction::radial));
        result.around.push_back({cosine, spread});
    }
    double const depth = std::clamp(0.5 - scene.flexspline.neutral_offset / scene.flexspline.wall, 0.0, 1.0);
    for (Direction const direction : {Direction::radial, Direction::tangential, Direction::axial})
        for (double const z : slices)
        {
            result.places.push_back(wall_station(mesh, middle + z, depth, direction));
            result.around.push_back({direction == Direction::tangential ? sine : cosine, tooth_spread});
        }
    result.around.insert(result.around.end(), slices.size(), {sine, tooth_spread});
    return result;
}

/// What the stations of the cup answer, turns among them.
std::vector<HarmonicResponse> cup_responses(FourierSolid const& solid, UnitFields const& unit, CupStations const& stations, DriveStations const& layout, double radius, int threads)
{
    std::vector<HarmonicResponse> result = responses(influence(solid, unit, stations.places, threads));
    std::vector<std::size_t> radial, tangential;
    for (std::size_t k = 0; k < layout.slices; ++k)
    {
        radial.push_back(layout.radial(k));
        tangential.push_back(layout.tangential(k));
    }
    add_turns(result, radial, tangential, radius);
    return result;
}

}  // namespace

LoadGrid load_grid(ContactBench const& bench)
{
    LoadGrid result{std::vector<std::size_t>(bench.maker.z().size()), bench.scene.bearing->circles, bench.scene.load ? bench.scene.load->harmonics : standard_harmonics};
    std::iota(result.slices.begin(), result.slices.end(), std::size_t{0});
    return result;
}

int highest_harmonic(Scene const& scene)
{
    RingGrid const grid = ring_grid(scene);
    return grid.angles() * grid.sectors / 2;
}

LoadModel load_model(ContactBench const& bench, LoadGrid const& resolution)
{
    Scene const& scene = bench.scene;
    RingGrid const around = ring_grid(scene);
    int const sectors = around.sectors, grid = around.angles();
    int const highest = std::min(resolution.harmonics, grid * sectors / 2) / sectors * sectors;

    CupSection const section = cup_section(scene, bench.geometry.flexspline_inner_radius);
    PlacedBearing const placed = placed_bearing(bench, resolution.circles, around);
    double const middle = placed.bearing.middle;
    FourierSolid solid(section_mesh(section, in_layers(contact_mesh_size(placed.bearing, resolution.circles), section, resolution.layers)));

    std::vector<double> z;
    for (std::size_t const k : resolution.slices)
        z.push_back(bench.maker.z()[k]);
    DriveStations const layout{placed.circles.size(), z.size()};
    CupStations stations = cup_stations(scene, solid.mesh(), placed.circles, middle, z, placed.spread);
    std::vector<int> const orders = harmonics_of(sectors, highest);
    UnitFields unit = unit_fields(solid, {}, stations.places, orders, bench.threads);
    std::vector<HarmonicResponse> harmonics = cup_responses(solid, unit, stations, layout, bench.geometry.r_m, bench.threads);

    ElasticDrive drive{layout, PointResponse(std::move(stations.around), std::move(harmonics), sectors, grid, bench.threads), {}, {}, around.steps, {}, {},
                       phase_of(scene, bench.request.wave_generator), scene.drive.flexspline_teeth, slice_widths(z, bench.width), section.material,
                       {scene.circular_spline.youngs_modulus, scene.circular_spline.poissons_ratio}, 0, {}};
    drive.slice_z = z;
    drive.bearing_z = above_middle(placed.circles, middle);
    add_wave_generator(drive, placed, bench, around, highest);
    drive.bearing_compliance = bearing_compliance(drive, bench.threads);
    drive.contact_depth = 0.25 * std::numbers::pi * scene.drive.module;  // half a tooth at the pitch line
    drive.bending = ToothBending(bench.tooth, section.material, bench.tolerance.length);
    return {std::move(solid), std::move(unit), bench.geometry.r_m, middle, std::move(drive)};
}

}  // namespace hdconj::detail
