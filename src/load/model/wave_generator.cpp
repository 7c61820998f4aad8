// SPDX-License-Identifier: GPL-3.0-or-later
#include "wave_generator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "drive/elastic_cup.hpp"
#include "elastic/ball_contact.hpp"
#include "elastic/discrete_balls.hpp"
#include "elastic/wave_generator_contact.hpp"
#include "ring_errors.hpp"

namespace hdconj::load {
namespace {

constexpr int most_angles = 128;  // of the wave generator's contact on one lobe

/// The shape of the cam with its errors, as series over one sector.
elastic::CamSeries made_cam(contact::ContactContext const& context, int sectors, int samples)
{
    auto const deviation = wave_generator_deviation(context.scene);
    std::vector<double> w;
    for (int i = 0; i < samples; ++i) {
        double const angle = 2 * std::numbers::pi * i / (sectors * samples);
        w.push_back(context.shape(angle).w + (deviation ? deviation(angle).out : 0));
    }
    return elastic::cam_series(w, sectors, !deviation && context.shape.even());
}

/// The largest number of equal parts of a lobe of @p angles, at most @p most.
int equal_parts(int angles, int most)
{
    int parts = std::min(angles, most);
    while (angles % parts != 0)
        --parts;
    return parts;
}

/// Whether @p parts serve as well as @p most.
bool enough(int parts, int most)
{
    return 10 * parts >= 7 * most;
}

/// @p count of a lobe's @p angles, as even as these allow, which mirror themselves about the first.
std::vector<int> mirrored_steps(int angles, int count)
{
    if (angles % 2 == 1 && count % 2 == 0)
        --count;  // an even number has one in the middle, where there is no angle
    auto const rounded = [&](int i) { return (2 * i * angles + count) / (2 * count); };
    std::vector<int> steps;
    for (int i = 0; i < count; ++i)
        steps.push_back(2 * i <= count ? rounded(i) : angles - rounded(count - i));
    return steps;
}

/// Angles of the bearing's contacts in the order of ElasticDrive::bearing_steps [rad].
std::vector<double> contact_angles(std::vector<int> const& steps, double phase, double step)
{
    std::vector<double> phi;
    for (int const at : steps)
        phi.push_back(phase + step * at);
    return phi;
}

/// The contacts at @p phi, heights within angles.
elastic::BearingContacts contacts_of(PlacedBearing const& placed, std::vector<double> const& phi)
{
    elastic::BearingContacts contacts{{}, {}, placed.spread};
    for (double const angle : phi)
        for (std::size_t j = 0; j < placed.circles.size(); ++j) {
            contacts.phi.push_back(angle);
            contacts.z.push_back(static_cast<Eigen::Index>(j));
        }
    return contacts;
}

/// How far the unloaded surface stands out at the angles @p phi: (circles, angles) [mm].
Eigen::MatrixXd unloaded_surface(elastic::BearingSurface const& surface, int sectors, std::vector<double> const& phi)
{
    Eigen::MatrixXd needed(surface.cosine.rows(), static_cast<Eigen::Index>(phi.size()));
    for (std::size_t i = 0; i < phi.size(); ++i) {
        Eigen::VectorXd out = Eigen::VectorXd::Zero(surface.cosine.rows());
        for (Eigen::Index k = 0; k < surface.cosine.cols(); ++k)
            out += surface.cosine.col(k) * std::cos(static_cast<double>(k) * sectors * phi[i]) +
                   surface.sine.col(k) * std::sin(static_cast<double>(k) * sectors * phi[i]);
        needed.col(static_cast<Eigen::Index>(i)) = out;
    }
    return needed;
}

/// Adds the outer ring and the balls between it and the cam to @p drive.
/// @param points  of a line of balls in a sector
void add_ring(ElasticDrive& drive, PlacedBearing const& placed, elastic::BearingSurface const& surface,
              contact::ContactContext const& context, RingGrid const& around, int points,
              std::vector<double> const& phi)
{
    BearingChoice const& bearing = *context.scene.bearing;
    int const sectors = around.sectors, threads = context.threads;
    elastic::BearingContacts const contacts = contacts_of(placed, phi);
    if (bearing.balls) {
        elastic::DiscreteBalls single = elastic::discrete_balls(
            surface, sectors, contacts, elastic::ball_angles(*bearing.balls, sectors, bearing.ball_phase),
            placed.ball_stiffness);
        drive.needed -= Eigen::Map<Eigen::MatrixXd>(single.sag.data(), drive.needed.rows(), drive.needed.cols());
        drive.balls = std::move(single.balls);
        drive.balls->hertz = placed.ball_constant;
        drive.between_balls = std::move(single.between);
    } else {
        drive.balls = elastic::ball_line(surface, sectors, contacts, points, false, threads);
        drive.ball_arc = 2 * std::numbers::pi *
                         (context.geometry.flexspline_inner_radius - placed.bearing.ring->thickness) /
                         (sectors * static_cast<double>(drive.balls->phi.size()));
    }
    std::vector<RingStation> const stations(placed.circles.size(), {RingStation::Parity::cosine, placed.spread});
    drive.outer_ring.emplace(stations, responses(*surface.compliance), sectors, around.angles(), threads);
}

}  // namespace

std::vector<HarmonicResponse> responses(elastic::Influence const& influence)
{
    std::vector<HarmonicResponse> result;
    for (std::size_t i = 0; i < influence.harmonics().size(); ++i)
        result.push_back({influence.harmonics()[i], influence.compliance(i)});
    return result;
}

std::vector<int> bearing_steps(RingGrid const& around, int highest)
{
    int const in_sector = around.lobes / around.sectors, angles = around.angles() / in_sector;
    // More angles than the harmonics resolve would leave the compliance singular.
    int const most = std::min({angles, most_angles, 2 * (highest / around.lobes)});
    int const equal = equal_parts(angles, most);
    std::vector<int> const lobe = mirrored_steps(angles, enough(equal, most) ? equal : most);
    std::vector<int> steps;
    for (int i = 0; i < in_sector; ++i)
        for (int const step : lobe)
            steps.push_back(i * angles + step);
    return steps;
}

PlacedBearing placed_bearing(contact::ContactContext const& context, int circles, RingGrid const& around)
{
    Scene const& scene = context.scene;
    int const highest = around.highest_harmonic(scene.load.value_or(LoadRequest()).harmonics);
    double const contacts = around.sectors * static_cast<double>(bearing_steps(around, highest).size());
    PlacedBearing result{drive::bearing_of(scene), {}, 2 * std::numbers::pi / contacts, {}, {}};
    BearingChoice const& choice = *scene.bearing;
    result.bearing.cam_oversize -= choice.clearance / 2;  // of radii
    if (choice.ball_diameter)
        result.ball_constant =
            elastic::ball_constant({*choice.ball_diameter,
                                    context.geometry.flexspline_inner_radius - result.bearing.ring->thickness,
                                    choice.inner_conformity,
                                    choice.outer_conformity,
                                    {choice.ball_youngs_modulus, choice.ball_poissons_ratio},
                                    result.bearing.ring->material});
    if (choice.balls) {
        // the part of a line's stiffness that one ball has
        if (auto const line = std::exchange(result.bearing.ring->radial_stiffness, std::nullopt))
            result.ball_stiffness = *line * 2 * std::numbers::pi *
                                    (context.geometry.flexspline_inner_radius - result.bearing.ring->thickness) /
                                    *choice.balls;
    }
    result.circles = elastic::bearing_circles(result.bearing, circles);
    return result;
}

void add_wave_generator(ElasticDrive& drive, PlacedBearing const& placed, contact::ContactContext const& context,
                        RingGrid const& around, int highest)
{
    int const sectors = around.sectors, samples = 2 * (highest / sectors);
    drive.bearing_steps = bearing_steps(around, highest);
    std::vector<double> const phi = contact_angles(drive.bearing_steps, drive.phase, drive.response->step());
    elastic::BearingSurface const surface =
        elastic::bearing_surface(placed.bearing, context.geometry.flexspline_inner_radius,
                                 made_cam(context, sectors, samples), placed.circles, context.threads);
    drive.needed = unloaded_surface(surface, sectors, phi);
    if (surface.compliance)
        add_ring(drive, placed, surface, context, around, std::min(samples, most_angles * (around.lobes / sectors)),
                 phi);
}

RingGrid ring_grid(Scene const& scene)
{
    constexpr int fewest_angles = 96;  // on one lobe
    constexpr int tries = 4;
    int const teeth = scene.drive.flexspline_teeth;
    int const lobes = std::gcd(teeth, scene.wave_generator.waves);
    int const per_lobe = teeth / lobes, fewest = (fewest_angles + per_lobe - 1) / per_lobe;
    int const contacts = std::min(most_angles, 2 * (LoadRequest().harmonics / lobes));
    int steps = fewest, best = equal_parts(per_lobe * fewest, contacts);
    for (int more = fewest + 1; more < fewest + tries; ++more)
        if (int const parts = equal_parts(per_lobe * more, contacts); parts > best && enough(parts, contacts)) {
            best = parts;
            steps = more;
        }
    int const repeats = errors_repeat(scene, lobes) ? lobes : 1;
    int const sectors = scene.bearing && scene.bearing->balls ? std::gcd(repeats, *scene.bearing->balls) : repeats;
    return {lobes, sectors, teeth / sectors, steps};
}

}  // namespace hdconj::load
