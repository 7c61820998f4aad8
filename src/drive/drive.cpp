// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"

#include <fmt/format.h>

#include "curvature_faults.hpp"
#include "elastic_cup.hpp"
#include "fault_advice.hpp"
#include "hdconj/check.hpp"
#include "hdconj/scene/parameter_fault.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::drive {

profile::Profile given_tooth(Scene const& scene, Faults& faults)
{
    return tooth_of(scene, scene.is_reverse(), faults);
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

PairGeometry pair_geometry(Scene const& scene)
{
    Faults faults;
    profile::Profile const tooth = given_tooth(scene, faults);
    return pair_geometry(scene, tooth, wave_shape(scene, tooth, faults).amplitude());
}

double given_tooth_seat(PairGeometry const& g, profile::Profile const& tooth)
{
    return g.circular_spline_inner_radius + tooth.addendum + tooth.pitch_line;
}

int pitches_per_lobe(Scene const& scene)
{
    return (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth) / scene.wave_generator.waves;
}

namespace {

/// Radius of the bottom of the given tooth spaces [mm].
double given_bottom(PairGeometry const& g, profile::Profile const& tooth)
{
    return given_tooth_seat(g, tooth) - tooth.pitch_line + tooth.dedendum;
}

/// Tips of the flexspline against the bottom of the given tooth spaces, at the major axis.
void validate_space_depth(Scene const& scene, double bottom, PairGeometry const& g, Faults& faults)
{
    double const pitch_radius = g.r_m + g.w0 + g.pitch_line;
    if (!(pitch_radius + g.addendum < bottom))
        faults.push_back(
            {"flexspline.addendum", 0, fmt::format("{:g}", g.addendum),
             fmt::format("the flexspline's tips at {:g} mm would cut into the bottom of the given tooth spaces, at a "
                         "radius of {:g} mm",
                         pitch_radius + g.addendum, bottom),
             fmt::format("write less than {:g}, or {}", bottom - pitch_radius,
                         scene::with_height(*scene.circular_spline.profile, "larger", "dedendum"))});
}

void validate_tip_circle(Scene const& scene, PairGeometry const& g, Faults& faults)
{
    double const tip = g.r_m + g.w0 + g.pitch_line + g.addendum;
    double const rim = g.r_m + g.w0 + g.pitch_line - g.dedendum;
    double const radius = g.circular_spline_inner_radius;
    bool const given = scene.circular_spline.inner_radius.has_value();
    auto const cut_into_rim = [&](char const* whose) {
        return fmt::format(
            "the {} at {:g} mm would cut into the flexspline's rim, which reaches {:g} mm at the major axis", whose,
            radius, rim);
    };
    if (scene.is_reverse() && !given && !(radius > rim)) {
        faults.push_back({"flexspline.dedendum", 0, fmt::format("{:g}", g.dedendum),
                          cut_into_rim("tips of the given circular-spline teeth"),
                          fmt::format("write more than {:g}, or {}", g.dedendum + rim - radius,
                                      scene::with_height(*scene.circular_spline.profile, "smaller", "addendum"))});
        return;
    }
    if (radius > rim && radius < tip)
        return;
    int const digits = tip > 1000 * (tip - rim) ? 12 : 6;  // six do not tell tip and rim apart
    Fault fault{"circular_spline.inner_radius", 0, given ? fmt::format("{:g}", radius) : "",
                radius < tip
                    ? cut_into_rim("circular spline's tips")
                    : fmt::format("the flexspline's tips reach a radius of {:g} mm only, so no tooth enters the "
                                  "circular spline at {:g} mm",
                                  tip, radius),
                fmt::format("write a radius between {:.{}g} and {:.{}g}", rim, digits, tip, digits)};
    double const usual = scene::usual_tip_radius(scene, g.w0).value_or(tip - 2 * g.addendum);
    if (usual > rim && usual < tip) {
        std::string const text = fmt::format("{:.{}g}", usual, digits);
        fault.remedy += ", usually " + text;
        if (!scene.is_reverse())
            fault.set = {"circular_spline.inner_radius=" + text};
    }
    faults.push_back(fault);
}

void validate_tip_relief(Scene const& scene, profile::Profile const& tooth, Faults& faults)
{
    double const from = scene.tip_relief->from_height;
    if (!scene.is_reverse() && !(from < tooth.addendum && from >= -tooth.dedendum))
        faults.push_back({"tip_relief.from_height", scene.tip_relief->line, fmt::format("{:g}", from),
                          fmt::format("no height of the tooth, which reaches from {:g} to {:g} mm above its pitch line",
                                      -tooth.dedendum, tooth.addendum),
                          fmt::format("write a height below the tip, such as {:g}", tooth.addendum / 2)});
}

/// What only the assembled dimensions show: tooth against pitch, tips of either member against roots of the other.
void validate_geometry(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    if (!(g.flexspline_inner_radius > 0))
        faults.push_back({"flexspline.wall", 0, fmt::format("{:g}", scene.flexspline.wall),
                          fmt::format("wall and dedendum leave no hole: the inner radius would be {:g} mm",
                                      g.flexspline_inner_radius),
                          "write a thinner wall, or more teeth or a larger module"});
    else {
        Faults deformed;  // may follow from the radial deformation
        scene::FamilyChoice const& shape = scene.wave_generator.shape;
        double const usual = scene::usual_deformation(scene.drive);
        if (!(g.r_m > g.w0) && shape.has("file")) {
            deformed.push_back(scene::parameter_fault(
                shape, "file",
                fmt::format("the radial displacement of {:g} mm is not smaller than the neutral radius {:g} mm; usual "
                            "is {:g}, m (z_c - z_f)/2",
                            g.w0, g.r_m, usual),
                "name the unit in the heading of the second column, such as angle [deg],w [um]"));
        } else if (!(g.r_m > g.w0)) {
            deformed.push_back({shape.path + ".radial_deformation", 0, fmt::format("{:g}", g.w0),
                                fmt::format("is not smaller than the neutral radius {:g} mm", g.r_m),
                                fmt::format("write {:g}, m (z_c - z_f)/2", usual)});
        } else {
            validate_tip_circle(scene, g, deformed);
            validate_width(scene, tooth, g, scene.is_reverse(), scene.is_reverse() ? deformed : faults);
            if (scene.is_reverse())
                validate_space_depth(scene, given_bottom(g, tooth), g, deformed);
        }
        say_likely_cause(scene, g.w0, true, deformed);
        faults.insert(faults.begin(), deformed.begin(), deformed.end());
    }
    if (scene.tip_relief)
        validate_tip_relief(scene, tooth, faults);
    bool has_tip = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i)
        has_tip = has_tip || profile::is_tip(tooth, static_cast<int>(i));
    if (scene.circular_spline.root_clearance > 0 && !scene.is_reverse() && !has_tip)
        faults.push_back({"circular_spline.root_clearance", 0,
                          fmt::format("{:g}", scene.circular_spline.root_clearance),
                          "the tooth has no flat or sharp tip whose trace could be moved outward",
                          "leave root_clearance out, or give the tooth a tip land"});
}

/// The body of the circular spline against its root circle, as far as this is known before anything is solved.
void validate_body(Scene const& scene, profile::Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    constexpr double usual = 1.4;  // of the root circle, as of the drive of the thesis
    CircularSpline const& spline = scene.circular_spline;
    double const root = scene.is_reverse()
                            ? given_bottom(g, tooth)
                            : g.r_m + g.w0 + g.pitch_line + g.addendum + spline.root_clearance + spline.backlash_offset;
    if (scene.compliance && scene.compliance->outer_radius && !(*scene.compliance->outer_radius > root))
        faults.push_back(
            {"compliance.outer_radius", 0, fmt::format("{:g}", *scene.compliance->outer_radius),
             fmt::format("the circular spline has its root circle at {:g} mm: nothing is left of its body", root),
             fmt::format("write the radius at which it is held, such as {:g}", std::round(usual * root))});
}

/// Neighbouring balls touch where the chord between their centres is as long as they are thick.
void validate_balls(BearingChoice const& bearing, double inner_radius, Faults& faults)
{
    if (!bearing.ball_diameter || !bearing.balls || !bearing.ring_thickness)
        return;
    double const raceway = inner_radius - *bearing.ring_thickness, half = std::sin(std::numbers::pi / *bearing.balls);
    double const largest = 2 * raceway * half / (1 + half);
    if (raceway > 0 && !(*bearing.ball_diameter < largest))
        faults.push_back(
            {"bearing.ball_diameter", 0, fmt::format("{:g}", *bearing.ball_diameter),
             fmt::format("{} balls of this size do not fit in a ring of {:g} mm inner radius", *bearing.balls, raceway),
             fmt::format("write less than {:.3g}, or fewer balls", largest)});
}

/// Motion model against wave generator: "material" needs a shape that a Fourier series follows.
void validate_kinematics(Scene const& scene, wavegen::AnyWaveShape const& shape, Faults& faults)
{
    if (scene.solver.kinematics != Kinematics::material || shape.breaks().empty())
        return;
    faults.push_back({"solver.kinematics", 0, "\"material\"",
                      "this model is a Fourier series, and wave generator \"" + scene.wave_generator.shape.family +
                          "\" has angles where the third derivative of its shape jumps",
                      "write \"exact\" or \"first-order\", or take a smooth wave generator such as \"cosine\""});
}

}  // namespace
}  // namespace hdconj::drive

namespace hdconj {

Faults check_scene(Scene const& scene)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    bool const is_of_tooth = !faults.empty();
    wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
    if (tooth.pieces.empty() || !faults.empty()) {
        double const w0 = scene.wave_generator.shape.number_or("radial_deformation", 0);
        if (!is_of_tooth)
            drive::say_likely_cause(scene, w0, false, faults);
        return faults;
    }
    PairGeometry const g = drive::pair_geometry(scene, tooth, shape.amplitude());
    // without it there is no place to check the bearing at, and that it is missing is said elsewhere
    bool const placed = scene.coning && scene.coning->bottom_to_middle;
    if (scene.is_elastic() && placed)
        drive::validate_cup(scene, g.flexspline_inner_radius, faults);
    else if (!scene.is_elastic())
        drive::validate_kinematics(scene, shape, faults);
    drive::validate_curvature(scene, shape, g.r_m, faults);
    if (!faults.empty())
        return faults;
    drive::validate_geometry(scene, tooth, g, faults);
    drive::validate_body(scene, tooth, g, faults);
    if (scene.bearing)
        drive::validate_balls(*scene.bearing, g.flexspline_inner_radius, faults);
    return faults;
}

}  // namespace hdconj
