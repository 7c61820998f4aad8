// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_model.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <utility>

#include "contact/study/place_teeth.hpp"
#include "drive/elastic_cup.hpp"
#include "elastic/kept_results.hpp"
#include "elastic/wave_generator_contact.hpp"
#include "wave_generator.hpp"

namespace hdconj::load {
namespace {

/// Weights of the trapezoid rule, the whole width for one slice.
std::vector<double> slice_widths(std::vector<double> const& z, double width)
{
    if (z.size() == 1)
        return {width};
    std::vector<double> result(z.size(), 0);
    for (std::size_t k = 0; k + 1 < z.size(); ++k) {
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

/// Stations of the cup in the order of DriveStations.
struct CupStations
{
    std::vector<elastic::Station> places;  ///< in the section; turns follow from displacements and have none
    std::vector<RingStation> around;       ///< around the ring
};

/// @param spread  angle over which a force of the bearing acts [rad]
CupStations cup_stations(Scene const& scene, elastic::SectionMesh const& mesh, std::vector<double> const& circles,
                         double middle, std::vector<double> const& slices, double spread)
{
    using enum RingStation::Parity;
    double const tooth_spread = std::numbers::pi / scene.drive.flexspline_teeth;
    CupStations result;
    for (double const circle : circles) {
        result.places.push_back(elastic::wall_station(mesh, circle, 0, elastic::Direction::radial));
        result.around.push_back({cosine, spread});
    }
    double const depth = std::clamp(0.5 - scene.flexspline.neutral_offset / scene.flexspline.wall, 0.0, 1.0);
    for (elastic::Direction const direction :
         {elastic::Direction::radial, elastic::Direction::tangential, elastic::Direction::axial})
        for (double const z : slices) {
            result.places.push_back(elastic::wall_station(mesh, middle + z, depth, direction));
            result.around.push_back({direction == elastic::Direction::tangential ? sine : cosine, tooth_spread});
        }
    result.around.insert(result.around.end(), slices.size(), {sine, tooth_spread});
    return result;
}

/// Responses of all stations of the cup, turns included.
std::vector<HarmonicResponse> cup_responses(elastic::FourierSolid const& solid, elastic::UnitFields const& unit,
                                            CupStations const& stations, DriveStations const& layout, double radius,
                                            int threads)
{
    std::vector<HarmonicResponse> result =
        responses(elastic::influence_of_fields(solid, unit, stations.places, threads));
    std::vector<std::size_t> radial, tangential;
    for (std::size_t k = 0; k < layout.slices; ++k) {
        radial.push_back(layout.radial(k));
        tangential.push_back(layout.tangential(k));
    }
    add_turns(result, radial, tangential, radius);
    return result;
}

/// The drive without its wave generator, and without the response of its cup.
ElasticDrive cup_with_teeth(contact::ContactContext const& context, elastic::Elasticity const& material,
                            std::vector<double> const& z, DriveStations const& layout, PlacedBearing const& placed,
                            RingGrid const& around)
{
    Scene const& scene = context.scene;
    ElasticDrive drive{.stations = layout,
                       .response = nullptr,
                       .steps_per_tooth = around.steps,
                       .phase = contact::phase_of(scene, context.request.wave_generator),
                       .flexspline_teeth = scene.drive.flexspline_teeth,
                       .slice_width = slice_widths(z, context.width),
                       .flexspline = material,
                       .circular_spline = {scene.circular_spline.youngs_modulus, scene.circular_spline.poissons_ratio},
                       .contact_depth = 0.25 * std::numbers::pi * scene.drive.module,  // half a tooth at the pitch line
                       .bending = ToothBending(context.tooth, material, context.tolerance.length),
                       .bearing_z = above_middle(placed.circles, placed.bearing.middle),
                       .slice_z = z};
    if (scene.flow)
        drive.flow_pressure = scene.flow->pressure;
    return drive;
}

}  // namespace

LoadGrid load_grid(contact::ContactContext const& context)
{
    LoadGrid result{std::vector<std::size_t>(context.maker.z().size()), context.scene.bearing->circles,
                    context.scene.load.value_or(LoadRequest()).harmonics};
    std::iota(result.slices.begin(), result.slices.end(), std::size_t{0});
    return result;
}

LoadModel load_model(contact::ContactContext const& context, LoadGrid const& resolution)
{
    Scene const& scene = context.scene;
    RingGrid const around = ring_grid(scene);
    int const sectors = around.sectors, grid = around.angles();
    int const highest = around.highest_harmonic(resolution.harmonics);

    elastic::CupSection const section = drive::cup_section(scene, context.geometry.flexspline_inner_radius);
    PlacedBearing const placed = placed_bearing(context, resolution.circles, around);
    double const middle = placed.bearing.middle;
    elastic::MeshSize const size = elastic::contact_mesh_size(section, placed.bearing.width, resolution.circles);
    elastic::FourierSolid solid(elastic::section_mesh(section, elastic::in_layers(size, section, resolution.layers)));

    std::vector<double> z;
    for (std::size_t const k : resolution.slices)
        z.push_back(context.maker.z()[k]);
    DriveStations const layout{placed.circles.size(), z.size()};
    CupStations stations = cup_stations(scene, solid.mesh(), placed.circles, middle, z, placed.spread);
    std::vector<int> const orders = elastic::harmonics_of(sectors, highest);
    std::shared_ptr<elastic::UnitFields const> unit =
        elastic::unit_fields(solid, {}, stations.places, orders, context.threads);
    auto const depends_on = [&](elastic::Dependencies& on) {
        on.add(solid);
        on.add(stations.places);
        on.add(orders);
        on.add(layout.bearing);
        on.add(placed.spread);
        on.add(context.geometry.r_m);
        on.add(scene.drive.flexspline_teeth);
        on.add(grid);
    };
    auto const response = elastic::kept_or_made<PointResponse>(depends_on, [&] {
        return PointResponse(stations.around,
                             cup_responses(solid, *unit, stations, layout, context.geometry.r_m, context.threads),
                             sectors, grid, context.threads);
    });

    ElasticDrive drive = cup_with_teeth(context, section.material, z, layout, placed, around);
    drive.response = response;
    add_wave_generator(drive, placed, context, around, highest);
    auto const with_bearing = [&](elastic::Dependencies& on) {
        depends_on(on);
        on.add(placed.bearing);
        on.add(section.inner_radius);
        on.add(placed.circles);
        on.add(drive.bearing_steps);
    };
    auto const made = [&] { return bearing_compliance(drive, context.threads); };
    drive.bearing_compliance = drive.between_balls
                                   ? made()
                                   : *elastic::kept_or_made<std::shared_ptr<Eigen::MatrixXd const>>(with_bearing, made);
    return {std::move(solid), std::move(unit), context.geometry.r_m, middle, section, std::move(drive)};
}

ElasticDrive drive_at(LoadModel const& model, contact::ContactContext const& context, LoadGrid const& resolution,
                      double phase)
{
    RingGrid const around = ring_grid(context.scene);
    ElasticDrive drive = model.drive;
    drive.phase = phase;
    drive.outer_ring.reset();
    drive.balls.reset();
    drive.between_balls.reset();
    int const highest = around.highest_harmonic(resolution.harmonics);
    add_wave_generator(drive, placed_bearing(context, resolution.circles, around), context, around, highest);
    if (drive.between_balls)
        drive.bearing_compliance = bearing_compliance(drive, context.threads);
    return drive;
}

}  // namespace hdconj::load
