// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "hdconj/elastic/ball_line.hpp"
#include "hdconj/elastic/bearing.hpp"
#include "hdconj/elastic/discrete_balls.hpp"
#include "hdconj/elastic/unit_fields.hpp"
#include "hdconj/elastic/wave_generator_contact.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "elastic_cup.hpp"
#include "place_teeth.hpp"

namespace hdconj::detail {
namespace {

constexpr int fewest_angles = 96;    // of the wave generator's contact in one sector
constexpr int most_angles = 128;
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

/// Even angles around the ring: those of the teeth, and more where they are few.
struct RingGrid
{
    int lobes;       ///< how often teeth and lobes repeat around the ring
    int sectors;     ///< and single balls with them
    int per_sector;  ///< teeth
    int steps;       ///< from tooth to tooth

    [[nodiscard]] int angles() const { return per_sector * steps; }
};

RingGrid ring_grid(Scene const& scene)
{
    int const teeth = scene.drive.flexspline_teeth;
    int const lobes = std::gcd(teeth, scene.wave_generator.waves);
    int const sectors = scene.bearing && scene.bearing->balls ? std::gcd(lobes, *scene.bearing->balls) : lobes;
    int const per_sector = teeth / sectors;
    return {lobes, sectors, per_sector, (fewest_angles + per_sector - 1) / per_sector};
}

std::vector<double> above_middle(std::vector<double> const& circles, double middle)
{
    std::vector<double> result;
    for (double const circle : circles)
        result.push_back(circle - middle);
    return result;
}

/// Where each of some heights is among those of a finer grid; nothing unless all are.
std::optional<std::vector<std::size_t>> heights_within(std::vector<double> const& finer, std::vector<double> const& heights)
{
    constexpr double rounding = 1e-12;  // [mm] of heights that are the same
    std::vector<std::size_t> result;
    for (double const z : heights)
    {
        auto const same = std::find_if(finer.begin(), finer.end(), [&](double other) { return std::abs(other - z) <= rounding; });
        if (same == finer.end())
            return std::nullopt;
        result.push_back(static_cast<std::size_t>(same - finer.begin()));
    }
    return result;
}

/// The places of a finer model of the same cup that are those of a coarser one, in its order; nothing unless all are.
std::optional<std::vector<std::size_t>> places_within(LoadModel const& finer, std::vector<double> const& bearing_z, std::vector<double> const& slice_z)
{
    auto const circles = heights_within(finer.drive.bearing_z, bearing_z), slices = heights_within(finer.drive.slice_z, slice_z);
    if (!circles || !slices)
        return std::nullopt;
    std::vector<std::size_t> result = *circles;
    DriveStations const& stations = finer.drive.stations;
    for (std::size_t const first : {stations.radial(0), stations.tangential(0), stations.axial(0)})
        for (std::size_t const k : *slices)
            result.push_back(first + k);
    return result;
}

/// The shape at even angles of one sector.
std::vector<double> sampled(AnyWaveShape const& shape, int sectors, int samples)
{
    std::vector<double> w;
    for (int i = 0; i < samples; ++i)
        w.push_back(shape(2 * std::numbers::pi * i / (sectors * samples)).w);
    return w;
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

LoadModel load_model(ContactBench const& bench, LoadGrid const& resolution, LoadModel const* finer)
{
    Scene const& scene = bench.scene;
    int const teeth = scene.drive.flexspline_teeth;
    RingGrid const around = ring_grid(scene);
    int const lobes = around.lobes, sectors = around.sectors, steps = around.steps;
    int const grid = around.angles();
    int const highest = std::min(resolution.harmonics, grid * sectors / 2) / sectors * sectors;

    CupSection const section = cup_section(scene, bench.geometry.flexspline_inner_radius);
    Bearing bearing = bearing_of(scene);
    std::optional<double> ball_stiffness;
    if (scene.bearing->balls)
    {
        // of a line, the part that is a ball's
        if (auto const line = std::exchange(bearing.ring->radial_stiffness, std::nullopt))
            ball_stiffness = *line * 2 * std::numbers::pi * (bench.geometry.flexspline_inner_radius - bearing.ring->thickness) / *scene.bearing->balls;
    }
    double const middle = bearing.middle;
    std::vector<double> const circles = bearing_circles(bearing, resolution.circles);
    // the mesh is that of the scene, whatever the resolution
    FourierSolid const solid = finer != nullptr ? finer->solid : FourierSolid(section_mesh(section, contact_mesh_size(bearing, scene.bearing->circles)));
    SectionMesh const& mesh = solid.mesh();

    std::vector<double> z;
    for (std::size_t const k : resolution.slices)
        z.push_back(bench.maker.z()[k]);
    DriveStations layout{circles.size(), z.size()};
    std::vector<Station> places;
    std::vector<RingStation> stations;
    double const bearing_spread = 2 * std::numbers::pi / sectors / grid;
    double const tooth_spread = std::numbers::pi / teeth;
    for (double const circle : circles)
    {
        places.push_back(wall_station(mesh, circle, 0, Direction::radial));
        stations.push_back({RingStation::Parity::cosine, bearing_spread});
    }
    double const depth = std::clamp(0.5 - scene.flexspline.neutral_offset / scene.flexspline.wall, 0.0, 1.0);
    for (Direction const direction : {Direction::radial, Direction::tangential, Direction::axial})
        for (double const height : z)
        {
            places.push_back(wall_station(mesh, middle + height, depth, direction));
            stations.push_back({direction == Direction::tangential ? RingStation::Parity::sine : RingStation::Parity::cosine, tooth_spread});
        }
    for (std::size_t k = 0; k < z.size(); ++k)
        stations.push_back({RingStation::Parity::sine, tooth_spread});
    std::vector<int> const orders = harmonics_of(sectors, highest);
    std::optional<std::vector<std::size_t>> const known = finer != nullptr ? places_within(*finer, above_middle(circles, middle), z) : std::nullopt;
    UnitFields unit = known && orders.size() <= finer->unit.harmonics.size() ? part_of(finer->unit, *known, orders.size()) : unit_fields(solid, {}, places, orders, bench.threads);
    Influence const response = influence(solid, unit, places, bench.threads);
    std::vector<HarmonicResponse> harmonics;
    for (std::size_t i = 0; i < response.harmonics().size(); ++i)
        harmonics.push_back({response.harmonics()[i], response.compliance(i)});
    std::vector<std::size_t> radial, tangential;
    for (std::size_t k = 0; k < z.size(); ++k)
    {
        radial.push_back(layout.radial(k));
        tangential.push_back(layout.tangential(k));
    }
    add_turns(harmonics, radial, tangential, bench.geometry.r_m);

    ElasticDrive drive{layout, PointResponse(std::move(stations), std::move(harmonics), sectors, grid, bench.threads), {}, {}, steps, {}, {},
                       phase_of(scene, bench.request.wave_generator), teeth, slice_widths(z, bench.width), section.material,
                       {scene.circular_spline.youngs_modulus, scene.circular_spline.poissons_ratio}, 0, {}};
    drive.slice_z = z;
    drive.bearing_z = above_middle(circles, middle);
    // more angles than the harmonics tell apart would leave the compliance singular
    int const angles = std::min({grid, most_angles * (lobes / sectors), 2 * (highest / sectors)});
    for (int i = 0; i < angles; ++i)
        drive.bearing_steps.push_back(static_cast<int>(static_cast<long>(i) * grid / angles));
    drive.needed.resize(static_cast<Eigen::Index>(circles.size()), angles);
    int const samples = 2 * (highest / sectors);
    CamSeries const cam = cam_series(sampled(bench.shape, sectors, samples), sectors, bench.shape.even());
    BearingSurface const surface = bearing_surface(bearing, section.inner_radius, cam, circles, bench.threads);
    for (int i = 0; i < angles; ++i)
    {
        double const phi = drive.phase + drive.response.step() * drive.bearing_steps[static_cast<std::size_t>(i)];
        Eigen::VectorXd out = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(circles.size()));
        for (Eigen::Index k = 0; k < surface.cosine.cols(); ++k)
            out += surface.cosine.col(k) * std::cos(static_cast<double>(k) * sectors * phi) + surface.sine.col(k) * std::sin(static_cast<double>(k) * sectors * phi);
        drive.needed.col(i) = out;
    }
    if (surface.compliance)
    {
        std::vector<HarmonicResponse> ring;
        for (std::size_t i = 0; i < surface.compliance->harmonics().size(); ++i)
            ring.push_back({surface.compliance->harmonics()[i], surface.compliance->compliance(i)});
        BearingContacts contacts{{}, {}, bearing_spread};
        for (int const at : drive.bearing_steps)
            for (std::size_t j = 0; j < circles.size(); ++j)
            {
                contacts.phi.push_back(drive.phase + drive.response.step() * at);
                contacts.z.push_back(static_cast<Eigen::Index>(j));
            }
        if (scene.bearing->balls)
        {
            DiscreteBalls single = discrete_balls(surface, sectors, contacts, ball_angles(*scene.bearing->balls, sectors, scene.bearing->ball_phase), ball_stiffness);
            drive.needed -= Eigen::Map<Eigen::MatrixXd>(single.sag.data(), drive.needed.rows(), drive.needed.cols());
            drive.balls = std::move(single.balls);
            drive.between_balls = std::move(single.between);
        }
        else
        {
            drive.balls = ball_line(surface, sectors, contacts, std::min(samples, most_angles), false, bench.threads);
            drive.ball_arc = 2 * std::numbers::pi * (section.inner_radius - bearing.ring->thickness) / (sectors * static_cast<double>(drive.balls->phi.size()));
        }
        drive.outer_ring.emplace(std::vector<RingStation>(circles.size(), {RingStation::Parity::cosine, bearing_spread}), std::move(ring), sectors, grid, bench.threads);
    }
    drive.bearing_compliance = bearing_compliance(drive, bench.threads);
    drive.contact_depth = 0.25 * std::numbers::pi * scene.drive.module;  // half a tooth at the pitch line
    drive.bending = ToothBending(bench.tooth, section.material, bench.tolerance.length);
    return {solid, std::move(unit), bench.geometry.r_m, middle, std::move(drive)};
}

HarmonicField cup_field(LoadModel const& model, Eigen::MatrixXd const& forces, int threads)
{
    DriveStations const& layout = model.drive.stations;
    PointResponse::Loads const loads = model.drive.response.loads(forces, model.drive.phase, threads);
    auto const count = static_cast<Eigen::Index>(layout.turn(0));  // turns stand last
    Eigen::MatrixXd even = loads.even.topRows(count), odd = loads.odd.topRows(count);
    // a moment is the forces that do its work: turn = (V + n U)/r
    for (Eigen::Index k = 0; k < even.cols(); ++k)
        for (std::size_t slice = 0; slice < layout.slices; ++slice)
        {
            auto const turn = static_cast<Eigen::Index>(layout.turn(slice));
            auto const radial = static_cast<Eigen::Index>(layout.radial(slice)), tangential = static_cast<Eigen::Index>(layout.tangential(slice));
            double const n = model.unit.harmonics[static_cast<std::size_t>(k)];
            even(tangential, k) += loads.even(turn, k) / model.radius;
            odd(tangential, k) += loads.odd(turn, k) / model.radius;
            even(radial, k) += n * loads.even(turn, k) / model.radius;
            odd(radial, k) += n * loads.odd(turn, k) / model.radius;
        }
    return harmonic_field(model.unit, even, odd, threads);
}

CupShape cup_shape(LoadModel const& model, HarmonicField const& field, int angles, int threads)
{
    SectionMesh const& mesh = model.solid.mesh();
    CupShape shape;
    std::vector<int> number(mesh.nodes.size(), -1);
    std::vector<SectionPoint> place;
    constexpr double xi[] = {-1, 1, 1, -1}, eta[] = {-1, -1, 1, 1};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    {
        std::vector<int> cell;
        for (std::size_t c = 0; c < 4; ++c)
        {
            auto const node = static_cast<std::size_t>(mesh.elements[e][c]);
            if (number[node] < 0)
            {
                number[node] = static_cast<int>(shape.r.size());
                shape.r.push_back(mesh.nodes[node].x());
                shape.z.push_back(mesh.nodes[node].y() - model.middle);
                place.push_back({e, xi[c], eta[c]});
            }
            cell.push_back(number[node]);
        }
        shape.cells.push_back(std::move(cell));
    }
    for (int i = 0; i < angles; ++i)
        shape.phi.push_back(2 * std::numbers::pi * i / angles);
    std::size_t const points = place.size();
    for (auto* values : {&shape.u_r, &shape.u_t, &shape.u_z, &shape.stress})
        values->assign(points * shape.phi.size(), 0);
    Eigen::MatrixXd const gauss = gauss_stress(mesh, field, shape.phi, threads);
    std::vector<double> around(points, 0);
    constexpr std::size_t nearest[] = {0, 1, 3, 2};  // Gauss point beside each corner
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c)
            around[static_cast<std::size_t>(shape.cells[e][c])] += 1;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (std::size_t c = 0; c < 4; ++c)
        {
            auto const point = static_cast<std::size_t>(shape.cells[e][c]);
            for (std::size_t a = 0; a < shape.phi.size(); ++a)
                shape.stress[a * points + point] += gauss(static_cast<Eigen::Index>(4 * e + nearest[c]), static_cast<Eigen::Index>(a)) / around[point];
        }
    HarmonicWaves const waves(field, shape.phi);
    constexpr std::size_t grain = 64;
    parallel_for(points, threads, grain, [&](std::size_t p) {
        Eigen::Matrix3Xd const u = displacements_at(mesh, field, place[p], waves);
        for (std::size_t a = 0; a < shape.phi.size(); ++a)
        {
            auto const column = static_cast<Eigen::Index>(a);
            shape.u_r[a * points + p] = u(0, column);
            shape.u_z[a * points + p] = u(1, column);
            shape.u_t[a * points + p] = u(2, column);
        }
    });
    return shape;
}

}  // namespace hdconj::detail
