// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/text.hpp"
#include "hdconj/profile/registry.hpp"
#include "hdconj/units.hpp"

namespace hdconj::drive {

profile::Profile given_tooth(Scene const& scene, Faults& faults)
{
    bool const reverse = scene.is_reverse();
    int const difference = scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth;
    profile::ToothPlace const inside{scene.drive.module,
                                     scene.drive.flexspline_teeth,
                                     scene.flexspline.wall,
                                     scene.flexspline.neutral_offset,
                                     scene.folder.string(),
                                     false,
                                     difference,
                                     scene.wave_generator.waves};
    profile::ToothPlace const outside{
        scene.drive.module, scene.drive.circular_spline_teeth, 0, 0, scene.folder.string(), true,
        difference,         scene.wave_generator.waves};
    return profile::build_profile(scene.given_profile(), reverse ? outside : inside, faults);
}

PairGeometry ring_geometry(Scene const& scene, profile::Profile const& tooth)
{
    PairGeometry g;
    double const wall = scene.flexspline.wall;
    g.addendum = scene.is_reverse() ? scene.flexspline.addendum.value_or(0) : tooth.addendum;
    g.dedendum = scene.is_reverse() ? scene.flexspline.dedendum.value_or(0) : tooth.dedendum;
    g.pitch_line = scene.is_reverse() ? wall / 2 + g.dedendum + scene.flexspline.neutral_offset : tooth.pitch_line;
    g.flexspline_inner_radius = scene.flexspline.inner_radius.value_or(
        scene.drive.module * scene.drive.flexspline_teeth / 2 - g.dedendum - wall);
    g.r_m = g.flexspline_inner_radius + wall / 2 - scene.flexspline.neutral_offset;
    return g;
}

wavegen::AnyWaveShape wave_shape(Scene const& scene, profile::Profile const& tooth, Faults& faults)
{
    double const r_m = tooth.pieces.empty() ? 0 : ring_geometry(scene, tooth).r_m;
    return wavegen::build_wave_shape(scene.wave_generator.shape,
                                     {r_m, scene.wave_generator.waves, scene.folder.string()}, faults);
}

PairGeometry pair_geometry(Scene const& scene, profile::Profile const& tooth, double amplitude)
{
    PairGeometry g = ring_geometry(scene, tooth);
    g.w0 = amplitude;
    g.circular_spline_inner_radius =
        scene.circular_spline.inner_radius.value_or(g.r_m + g.pitch_line + amplitude - tooth.addendum);
    g.ratio = -static_cast<double>(scene.drive.flexspline_teeth) /
              (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth);
    return g;
}

int pitches_per_lobe(Scene const& scene)
{
    return (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth) / scene.wave_generator.waves;
}

namespace {

/// The tooth must fit into its share of the flexspline at every height.
void validate_width(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    double worst = 0;
    Vec2 where = Vec2::Zero();
    double const chord = (tooth.addendum + tooth.dedendum) * 0x1p-10;
    double const half_share = std::numbers::pi / scene.drive.flexspline_teeth;
    for (Vec2 const& p : profile::polygon_of(tooth, chord)) {
        double const excess = std::abs(p.x()) - half_share * (g.r_m + p.y());
        if (excess > worst) {
            worst = excess;
            where = p;
        }
    }
    if (worst > 0)
        faults.push_back({scene.flexspline.profile.path, scene.flexspline.profile.line, "",
                          "the tooth is wider than its pitch: " + short_number(2 * std::abs(where.x())) +
                              " mm thick at height " + short_number(where.y() - tooth.pitch_line) +
                              " mm, where the pitch is " + short_number(2 * half_share * (g.r_m + where.y())) + " mm",
                          "make the tooth thinner, or use fewer teeth or a larger module"});
}

/// The same for a circular-spline tooth, whose share of the circle gets wider towards its root.
void validate_outer_width(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    double worst = 0;
    Vec2 where = Vec2::Zero();
    double const chord = (tooth.addendum + tooth.dedendum) * 0x1p-10;
    double const half_pitch = std::numbers::pi / scene.drive.circular_spline_teeth;
    double const seat = given_tooth_seat(g, tooth);
    for (Vec2 const& p : profile::polygon_of(tooth, chord)) {
        double const excess = std::atan2(std::abs(p.x()), seat - p.y()) - half_pitch;
        if (excess > worst) {
            worst = excess;
            where = p;
        }
    }
    if (worst > 0)
        faults.push_back({scene.given_profile().path, scene.given_profile().line, "",
                          "the tooth is wider than its pitch: " + short_number(2 * std::abs(where.x())) +
                              " mm thick at height " + short_number(where.y() - tooth.pitch_line) +
                              " mm, where the pitch is " + short_number(2 * half_pitch * (seat - where.y())) + " mm",
                          "make the tooth thinner, or use fewer teeth or a larger module"});
}

/// Tips of the flexspline against the bottom of the given tooth spaces, at the major axis.
void validate_space_depth(profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    double const bottom = given_tooth_seat(g, tooth) - tooth.pitch_line + tooth.dedendum;
    double const pitch_radius = g.r_m + g.w0 + g.pitch_line;
    if (!(pitch_radius + g.addendum < bottom))
        faults.push_back({"flexspline.addendum", 0, short_number(g.addendum),
                          "the flexspline's tips at " + short_number(pitch_radius + g.addendum) +
                              " mm would cut into the bottom of the given tooth spaces, which are " +
                              short_number(bottom) + " mm deep",
                          "write less than " + short_number(bottom - pitch_radius) +
                              ", or a larger circular_spline.profile.dedendum"});
}

void validate_tip_circle(Scene const& scene, PairGeometry const& g, Faults& faults)
{
    double const tip = g.r_m + g.w0 + g.pitch_line + g.addendum;
    double const rim = g.r_m + g.w0 + g.pitch_line - g.dedendum;
    bool const given = scene.circular_spline.inner_radius.has_value();
    if (scene.is_reverse() && !given && !(g.circular_spline_inner_radius > rim)) {
        faults.push_back({"flexspline.dedendum", 0, short_number(g.dedendum),
                          "the tips of the given circular-spline teeth at " +
                              short_number(g.circular_spline_inner_radius) +
                              " mm would cut into the flexspline's rim, which reaches " + short_number(rim) +
                              " mm at the major axis",
                          "write more than " + short_number(g.dedendum + rim - g.circular_spline_inner_radius) +
                              ", or a smaller circular_spline.profile.addendum"});
        return;
    }
    std::string const value = given ? short_number(*scene.circular_spline.inner_radius) : "";
    double const radius = g.circular_spline_inner_radius;
    if (!(radius < tip))
        faults.push_back({"circular_spline.inner_radius", 0, value,
                          "the flexspline's tips reach a radius of " + short_number(tip) +
                              " mm only, so no tooth enters the circular spline at " + short_number(radius) + " mm",
                          "write a radius between " + short_number(rim) + " and " + short_number(tip)});
    else if (!(radius > rim))
        faults.push_back({"circular_spline.inner_radius", 0, value,
                          "the circular spline's tips at " + short_number(radius) +
                              " mm would cut into the flexspline's rim, which reaches " + short_number(rim) +
                              " mm at the major axis",
                          "write a radius between " + short_number(rim) + " and " + short_number(tip)});
}

}  // namespace

void validate_geometry(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    if (!(g.flexspline_inner_radius > 0))
        faults.push_back({"flexspline.wall", 0, short_number(scene.flexspline.wall),
                          "wall and dedendum leave no hole: the inner radius would be " +
                              short_number(g.flexspline_inner_radius) + " mm",
                          "write a thinner wall, or more teeth or a larger module"});
    else if (!(g.r_m > g.w0))
        faults.push_back({scene.wave_generator.shape.path + ".radial_deformation", 0, short_number(g.w0),
                          "is not smaller than the neutral radius " + short_number(g.r_m) + " mm",
                          "write about one module (" + short_number(scene.drive.module) + ")"});
    else {
        validate_tip_circle(scene, g, faults);
        if (scene.is_reverse()) {
            validate_outer_width(scene, tooth, g, faults);
            validate_space_depth(tooth, g, faults);
        } else {
            validate_width(scene, tooth, g, faults);
        }
    }
    bool has_tip = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i)
        has_tip = has_tip || profile::is_tip(tooth, static_cast<int>(i));
    if (scene.circular_spline.root_clearance > 0 && !scene.is_reverse() && !has_tip)
        faults.push_back({"circular_spline.root_clearance", 0, short_number(scene.circular_spline.root_clearance),
                          "the tooth has no flat or sharp tip whose trace could be moved outward",
                          "leave root_clearance out, or give the tooth a tip land"});
}

namespace {

/// Where the neutral curve bends least.
struct Flattest
{
    double bend =
        std::numeric_limits<double>::infinity();  ///< curvature times a positive length squared; not above 0: hollow
    double where = 0;                             ///< [rad]
};

Flattest flattest_place(wavegen::AnyWaveShape const& shape, double r_m)
{
    constexpr int probes = 1440;
    double const half_lobe = std::numbers::pi / shape.waves();
    Flattest found;
    for (int i = 0; i <= probes; ++i) {
        double const u = half_lobe * (2.0 * i / probes - 1);
        wavegen::RadialDisplacement const d = shape(u);
        double const rho = r_m + d.w;
        double const bend = rho * rho + 2 * d.w1 * d.w1 - rho * d.w2;
        if (!(bend >= found.bend))
            found = {bend, u};
    }
    return found;
}

/// The largest radial deformation below the scene's that leaves no hollow, by halving, rounded down to what a user
/// types; 0 where there is none.
double largest_deformation(Scene scene, profile::Profile const& tooth, double r_m)
{
    constexpr std::string_view key = "radial_deformation";
    constexpr int halvings = 40;
    double low = 0, high = scene.wave_generator.shape.number(key).value_or(0);
    for (int i = 0; i < halvings; ++i) {
        double const middle = (low + high) / 2;
        scene.wave_generator.shape.given.find(key)->second.value = middle;
        Faults faults;
        wavegen::AnyWaveShape const shape = wave_shape(scene, tooth, faults);
        bool const convex = faults.empty() && flattest_place(shape, r_m).bend > 0;
        (convex ? low : high) = middle;
    }
    if (!(low > 0))
        return 0;
    double const step = std::pow(10.0, std::floor(std::log10(low)) - 3);
    return std::floor(low / step) * step;
}

}  // namespace

void validate_curvature(Scene const& scene, profile::Profile const& tooth, wavegen::AnyWaveShape const& shape,
                        double r_m, Faults& faults)
{
    Flattest const flattest = flattest_place(shape, r_m);
    if (flattest.bend > 0)
        return;
    scene::FamilyChoice const& choice = scene.wave_generator.shape;
    std::string const reason =
        "the neutral curve would be hollow at " + short_number(to_deg(flattest.where)) + " degrees from the major axis";
    if (!choice.has("radial_deformation")) {
        faults.push_back({choice.path + ".file", choice.line_of("file"), choice.text_of("file"), reason,
                          "write smaller radial displacements, or smooth them"});
        return;
    }
    double const largest = largest_deformation(scene, tooth, r_m);
    faults.push_back({choice.path + ".radial_deformation", choice.line_of("radial_deformation"),
                      choice.text_of("radial_deformation"), reason,
                      largest > 0 ? "write at most " + short_number(largest) + ", usually about one module"
                                  : "write a smaller one, usually about one module"});
}

void validate_kinematics(Scene const& scene, wavegen::AnyWaveShape const& shape, Faults& faults)
{
    if (scene.solver.kinematics != Kinematics::material || shape.breaks().empty())
        return;
    faults.push_back({"solver.kinematics", 0, "\"material\"",
                      "this model is a Fourier series, and wave generator \"" + scene.wave_generator.shape.family +
                          "\" has angles where the third derivative of its shape jumps",
                      "write \"exact\" or \"first-order\", or take a smooth wave generator such as \"cosine\""});
}

}  // namespace hdconj::drive
