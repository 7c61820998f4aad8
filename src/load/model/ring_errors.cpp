// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_errors.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <random>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/wavegen/table_cam.hpp"

namespace hdconj::load {
namespace {

/// @param stream  the rings have random numbers of their own
std::vector<double> places_of(Errors const& errors, std::optional<RingErrors> const& ring, int teeth, int stream)
{
    if (!ring || !ring->pitch.empty() || ring->pitch_deviation == 0)
        return ring ? ring->pitch : std::vector<double>();
    std::seed_seq seed{errors.seed, stream};
    std::mt19937_64 random(seed);
    boost::random::normal_distribution<double> normal(0, ring->pitch_deviation);
    std::vector<double> places;
    for (int i = 0; i < teeth; ++i)
        places.push_back(normal(random));
    return places;
}

/// The direction at an angle from the y axis.
Vec2 clockwise(double angle)
{
    return {std::sin(angle), std::cos(angle)};
}

/// @param places  of the teeth on the pitch circle of a ring with as many teeth
std::vector<contact::Displacement> displacements_of(std::optional<RingErrors> const& ring,
                                                    std::vector<double> const& places, int teeth, double module)
{
    if (!ring)
        return {};
    std::vector<contact::Displacement> result(static_cast<std::size_t>(teeth));
    for (std::size_t i = 0; i < result.size(); ++i) {
        double const place = 2 * std::numbers::pi * static_cast<double>(i) / teeth;
        result[i].shift = ring->eccentricity * clockwise(ring->eccentricity_phase - place);
        result[i].lean = std::tan(ring->wobble) * clockwise(ring->wobble_phase - place);
        if (i < places.size())
            result[i].turn = places[i] / (module * teeth / 2);
    }
    return result;
}

}  // namespace

PitchErrors pitch_errors(Scene const& scene)
{
    if (!scene.errors)
        return {};
    Errors const& errors = *scene.errors;
    return {places_of(errors, errors.flexspline, scene.drive.flexspline_teeth, 0),
            places_of(errors, errors.circular_spline, scene.drive.circular_spline_teeth, 1)};
}

RingDisplacements ring_displacements(Scene const& scene)
{
    if (!scene.errors)
        return {};
    PitchErrors const places = pitch_errors(scene);
    Drive const& drive = scene.drive;
    return {displacements_of(scene.errors->flexspline, places.flexspline, drive.flexspline_teeth, drive.module),
            displacements_of(scene.errors->circular_spline, places.circular_spline, drive.circular_spline_teeth,
                             drive.module)};
}

std::function<SurfaceDeviation(double)> wave_generator_deviation(Scene const& scene)
{
    if (!scene.errors || !scene.errors->wave_generator)
        return nullptr;
    WaveGeneratorErrors const& errors = *scene.errors->wave_generator;
    bool const has_cam = std::ranges::any_of(errors.cam_deviation, [](auto const& row) { return row[1] != 0; });
    if (errors.eccentricity == 0 && !has_cam)
        return nullptr;
    auto const eccentric = [amount = errors.eccentricity, phase = errors.eccentricity_phase](double angle) {
        return SurfaceDeviation{amount * std::cos(angle - phase), -amount * std::sin(angle - phase)};
    };
    if (!has_cam)
        return eccentric;
    std::vector<double> angles, values;
    for (auto const& row : errors.cam_deviation) {
        angles.push_back(row[0]);
        values.push_back(row[1]);
    }
    wavegen::TableCam const cam(angles, values, 1);
    double const mean = values.front() - cam(angles.front()).w;  // which a cam does not have
    return [=](double angle) {
        SurfaceDeviation const shifted = eccentric(angle);
        wavegen::RadialDisplacement const at = cam(angle);
        return SurfaceDeviation{shifted.out + mean + at.w, shifted.slope + at.w1};
    };
}

bool break_the_mirror(Scene const& scene)
{
    if (!scene.errors)
        return false;
    auto const displaced = [](std::optional<RingErrors> const& ring) {
        return ring &&
               (ring->pitch_deviation != 0 || !ring->pitch.empty() || ring->eccentricity != 0 || ring->wobble != 0);
    };
    return displaced(scene.errors->flexspline) || displaced(scene.errors->circular_spline) ||
           wave_generator_deviation(scene) != nullptr;
}

namespace {

/// Whether @p deviation of a ring of @p radius [mm] is the same after each of @p parts of the turn.
bool repeats(std::function<SurfaceDeviation(double)> const& deviation, int parts, double radius)
{
    constexpr int samples = 720;
    double const same = Tolerance{0, radius}.coincidence();
    double const part = 2 * std::numbers::pi / parts;
    for (int i = 0; deviation && i < samples; ++i) {
        double const angle = 2 * std::numbers::pi * i / samples;
        if (std::abs(deviation(angle + part).out - deviation(angle).out) > same)
            return false;
    }
    return true;
}

}  // namespace

bool errors_repeat(Scene const& scene, int parts)
{
    RingDisplacements const all = ring_displacements(scene);
    auto const repeat = [&](std::vector<contact::Displacement> const& ring) {
        std::size_t const step = ring.size() / static_cast<std::size_t>(parts);
        for (std::size_t i = 0; i + step < ring.size(); ++i)
            if (ring[i].turn != ring[i + step].turn || ring[i].shift != ring[i + step].shift ||
                ring[i].lean != ring[i + step].lean)
                return false;
        return true;
    };
    return parts == 1 ||
           (repeat(all.teeth) && repeat(all.spaces) &&
            repeats(wave_generator_deviation(scene), parts, scene.drive.module * scene.drive.flexspline_teeth / 2));
}

}  // namespace hdconj::load
