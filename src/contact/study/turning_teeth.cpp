// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/turning_teeth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "conjugate/plane/plane_motion.hpp"
#include "contact_study_data.hpp"

namespace hdconj {
namespace {

constexpr double wanted_error = 1e-6;  // [mm]
constexpr int most_steps = 4096;
constexpr double outline_chord = 1e-6;  // [mm]

/// Position of the tooth in the frame of the wave generator, less its undeformed angle.
struct Place
{
    double radius, advance, lean;
};

double reduced(double angle)
{
    return std::remainder(angle, 2 * std::numbers::pi);
}

Place place_of(Pose const& pose, double phi, double ratio)
{
    double const turn = (ratio - 1) * phi;
    return {pose.origin.norm(), reduced(std::atan2(pose.origin.x(), pose.origin.y()) + turn),
            reduced(std::atan2(pose.sine, pose.cosine) + turn)};
}

/// The cubic through four even entries, in the middle.
double middle(double a, double b, double c, double d)
{
    return (9 * (b + c) - a - d) / 16;
}

/// Places at even angles over one period, twice as many as the table has: every second one checks the table.
std::vector<std::vector<Place>> places_of(contact::ContactContext const& context, std::vector<double> const& z,
                                          double period, int steps)
{
    std::vector<double> phi(static_cast<std::size_t>(2 * steps));
    for (std::size_t i = 0; i < phi.size(); ++i)
        phi[i] = period * static_cast<double>(i) / static_cast<double>(phi.size());
    std::vector<Pose> const poses = contact::poses_at(context, phi, z);
    double const ratio = conjugate::tooth_ratio(context.scene);
    std::vector<std::vector<Place>> places(z.size());
    for (std::size_t k = 0; k < z.size(); ++k)
        for (std::size_t i = 0; i < phi.size(); ++i)
            places[k].push_back(place_of(poses[i * z.size() + k], phi[i], ratio));
    return places;
}

/// How far a point at most @p reach from the tooth's origin is from its place.
double error_of(std::vector<Place> const& places, double reach)
{
    std::size_t const n = places.size();
    double largest = 0;
    for (std::size_t i = 1; i < n; i += 2) {
        auto const off = [&](double Place::*value) {
            auto const at = [&](std::size_t ahead) { return places[(i + n + ahead - 3) % n].*value; };
            return std::abs(middle(at(0), at(2), at(4), at(6)) - places[i].*value);
        };
        largest = std::max(largest,
                           off(&Place::radius) + places[i].radius * off(&Place::advance) + reach * off(&Place::lean));
    }
    return largest;
}

/// A scene that has all that poses need: without a face width it has one plane.
Scene with_width(Scene scene)
{
    if (!scene.circular_spline.width) {
        scene.circular_spline.width = 1;
        scene.slices.reset();
    }
    return scene;
}

}  // namespace

TurningTeeth turning_teeth(Scene const& scene, std::vector<double> const& z, StageObserver const& on_stage)
{
    contact::require_planes(scene, z);
    contact::ContactStudyData data(with_width(scene), Verb::contact, on_stage, static_cast<int>(z.size()));
    TurningTeeth turning;
    turning.z = z;
    turning.period = 2 * data.maker->motion(0).motion.half_lobe();
    if (scene.is_reverse()) {
        turning.chord = data.middle.error.chord;
        for (Vec2 const& point : data.middle.flexspline_outline)
            turning.tooth.push_back(point + Vec2(0, data.middle.geometry.pitch_line));
    } else {
        turning.chord = outline_chord;
        turning.tooth = profile::polygon_of(data.tooth, outline_chord);
    }
    double reach = 0;
    for (Vec2 const& point : turning.tooth)
        reach = std::max(reach, point.norm());
    std::vector<std::vector<Place>> places;
    constexpr int first_steps = 256;
    for (turning.steps = first_steps;; turning.steps *= 2) {
        places = places_of(*data.context, z, turning.period, turning.steps);
        turning.interpolation_error = 0;
        for (auto const& plane : places)
            turning.interpolation_error = std::max(turning.interpolation_error, error_of(plane, reach));
        if (turning.interpolation_error <= wanted_error || turning.steps >= most_steps)
            break;
    }
    for (auto const& plane : places)
        for (std::size_t i = 0; i < plane.size(); i += 2) {
            turning.radius.push_back(plane[i].radius);
            turning.advance.push_back(plane[i].advance);
            turning.lean.push_back(plane[i].lean);
        }
    return turning;
}

}  // namespace hdconj
