// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_wave_generator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "hdconj/elastic/ball_line.hpp"
#include "hdconj/elastic/discrete_balls.hpp"
#include "hdconj/elastic/wave_generator_contact.hpp"
#include "elastic_cup.hpp"

namespace hdconj::detail {
namespace {

constexpr int most_angles = 128;   // of the wave generator's contact in one sector

/// The shape at even angles of one sector.
std::vector<double> sampled(AnyWaveShape const& shape, int sectors, int samples)
{
    std::vector<double> w;
    for (int i = 0; i < samples; ++i)
        w.push_back(shape(2 * std::numbers::pi * i / (sectors * samples)).w);
    return w;
}

/// The bearing's contacts in the order of ElasticDrive::bearing_steps.
BearingContacts contacts_of(ElasticDrive const& drive, PlacedBearing const& placed)
{
    BearingContacts contacts{{}, {}, placed.spread};
    for (int const at : drive.bearing_steps)
        for (std::size_t j = 0; j < placed.circles.size(); ++j)
        {
            contacts.phi.push_back(drive.phase + drive.response.step() * at);
            contacts.z.push_back(static_cast<Eigen::Index>(j));
        }
    return contacts;
}

/// Adds the outer ring, and what is between it and the cam.
void add_ring(ElasticDrive& drive, PlacedBearing const& placed, BearingSurface const& surface, ContactBench const& bench, int samples)
{
    Scene const& scene = bench.scene;
    int const sectors = drive.response.sectors();
    BearingContacts const contacts = contacts_of(drive, placed);
    if (scene.bearing->balls)
    {
        DiscreteBalls single = discrete_balls(surface, sectors, contacts, ball_angles(*scene.bearing->balls, sectors, scene.bearing->ball_phase), placed.ball_stiffness);
        drive.needed -= Eigen::Map<Eigen::MatrixXd>(single.sag.data(), drive.needed.rows(), drive.needed.cols());
        drive.balls = std::move(single.balls);
        drive.between_balls = std::move(single.between);
    }
    else
    {
        drive.balls = ball_line(surface, sectors, contacts, std::min(samples, most_angles), false, bench.threads);
        drive.ball_arc =
            2 * std::numbers::pi * (bench.geometry.flexspline_inner_radius - placed.bearing.ring->thickness) / (sectors * static_cast<double>(drive.balls->phi.size()));
    }
    std::vector<RingStation> const stations(placed.circles.size(), {RingStation::Parity::cosine, placed.spread});
    drive.outer_ring.emplace(stations, responses(*surface.compliance), sectors, drive.response.grid(), bench.threads);
}

}  // namespace

std::vector<HarmonicResponse> responses(Influence const& influence)
{
    std::vector<HarmonicResponse> result;
    for (std::size_t i = 0; i < influence.harmonics().size(); ++i)
        result.push_back({influence.harmonics()[i], influence.compliance(i)});
    return result;
}

PlacedBearing placed_bearing(ContactBench const& bench, int circles, RingGrid const& around)
{
    Scene const& scene = bench.scene;
    PlacedBearing result{bearing_of(scene), {}, 2 * std::numbers::pi / around.sectors / around.angles(), {}};
    if (scene.bearing->balls)
    {
        // of a line, the part that is a ball's
        if (auto const line = std::exchange(result.bearing.ring->radial_stiffness, std::nullopt))
            result.ball_stiffness = *line * 2 * std::numbers::pi * (bench.geometry.flexspline_inner_radius - result.bearing.ring->thickness) / *scene.bearing->balls;
    }
    result.circles = bearing_circles(result.bearing, circles);
    return result;
}

void add_wave_generator(ElasticDrive& drive, PlacedBearing const& placed, ContactBench const& bench, RingGrid const& around, int highest)
{
    int const sectors = around.sectors, grid = around.angles();
    int const samples = 2 * (highest / sectors);
    // more angles than the harmonics tell apart would leave the compliance singular
    int const angles = std::min({grid, most_angles * (around.lobes / sectors), samples});
    for (int i = 0; i < angles; ++i)
        drive.bearing_steps.push_back(static_cast<int>(static_cast<long>(i) * grid / angles));
    auto const circles = static_cast<Eigen::Index>(placed.circles.size());
    drive.needed.resize(circles, angles);
    CamSeries const cam = cam_series(sampled(bench.shape, sectors, samples), sectors, bench.shape.even());
    BearingSurface const surface = bearing_surface(placed.bearing, bench.geometry.flexspline_inner_radius, cam, placed.circles, bench.threads);
    for (int i = 0; i < angles; ++i)
    {
        double const phi = drive.phase + drive.response.step() * drive.bearing_steps[static_cast<std::size_t>(i)];
        Eigen::VectorXd out = Eigen::VectorXd::Zero(circles);
        for (Eigen::Index k = 0; k < surface.cosine.cols(); ++k)
            out += surface.cosine.col(k) * std::cos(static_cast<double>(k) * sectors * phi) + surface.sine.col(k) * std::sin(static_cast<double>(k) * sectors * phi);
        drive.needed.col(i) = out;
    }
    if (surface.compliance)
        add_ring(drive, placed, surface, bench, samples);
}

}  // namespace hdconj::detail
