// SPDX-License-Identifier: GPL-3.0-or-later
#include "clearance.hpp"

#include <limits>
#include <numbers>

#include "hdconj/base/parallel.hpp"
#include "hdconj/distance/tooth_distance.hpp"

namespace hdconj::cam {
namespace {

constexpr int positions = 720;

/// The teeth that the flexspline's passes in half a wave, and the bottom of the space it begins in, from (0, r_m).
std::vector<Vec2> outline_of(drive::GivenPair const& given, double r_m, Scene const& scene, double chord)
{
    double const pitch = 2 * std::numbers::pi / scene.drive.circular_spline_teeth;
    std::vector<Vec2> const tooth = profile::polygon_of(given.circular_spline, chord);
    int const last = 2 + drive::pitches_per_lobe(scene) / 2;
    std::vector<Vec2> points;
    for (int k = 0; k < last; ++k) {
        Pose const seat = right_wall((k - 0.5) * pitch, r_m, given.seat_height);
        for (Vec2 const& p : tooth)
            points.push_back(seat(p));
    }
    return points;
}

}  // namespace

LeastClearance least_clearance(drive::GivenPair const& given, CurveRule const& rule, ClosedCurve const& curve,
                               Scene const& scene, int threads)
{
    double const chord = (given.circular_spline.addendum + given.circular_spline.dedendum) * 0x1p-17;
    std::vector<Vec2> const points = outline_of(given, rule.r_m, scene, chord);
    distance::ToothDistance const distance(given.flexspline);
    double const half_wave = std::numbers::pi / scene.wave_generator.waves;
    std::vector<double> least(positions + 1, std::numeric_limits<double>::infinity());
    parallel_for(least.size(), threads, 16, [&](std::size_t i) {
        double const u = half_wave * static_cast<double>(i) / positions;
        ClosedCurve::Place const at = curve(u);
        ToothOrigin const origin = rule.origin(u, at.state);
        double const theta = rule.theta(origin, at.slope);
        Pose const pose{std::cos(theta), std::sin(theta), origin.point()};
        for (Vec2 const& point : points) {
            Vec2 const p = pose.inverse(point);
            if (distance.lower_bound(p) < least[i])
                least[i] = std::min(least[i], distance(p).distance);
        }
    });
    auto const smallest = std::min_element(least.begin(), least.end());
    return {*smallest, half_wave * static_cast<double>(smallest - least.begin()) / positions, chord};
}

}  // namespace hdconj::cam
