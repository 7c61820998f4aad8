// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "hdconj/conjugate/outline.hpp"
#include "hdconj/profile/registry.hpp"

namespace hdconj::detail {

Profile flexspline_tooth(Scene const& scene, Faults& faults)
{
    ToothPlace const place{scene.drive.module, scene.drive.flexspline_teeth, scene.flexspline.wall, scene.flexspline.neutral_offset,
                           scene.folder.string(), false, scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth,
                           scene.wave_generator.waves};
    return build_profile(scene.flexspline.profile, place, faults);
}

PairGeometry ring_geometry(Scene const& scene, Profile const& tooth)
{
    PairGeometry g;
    double const wall = scene.flexspline.wall;
    g.addendum = tooth.addendum;
    g.dedendum = tooth.dedendum;
    g.pitch_line = tooth.pitch_line;
    g.flexspline_inner_radius = scene.flexspline.inner_radius.value_or(
        scene.drive.module * scene.drive.flexspline_teeth / 2 - tooth.dedendum - wall);
    g.r_m = g.flexspline_inner_radius + wall / 2 - scene.flexspline.neutral_offset;
    return g;
}

AnyWaveShape wave_shape(Scene const& scene, Profile const& tooth, Faults& faults)
{
    double const r_m = tooth.pieces.empty() ? 0 : ring_geometry(scene, tooth).r_m;
    return build_wave_shape(scene.wave_generator.shape, {r_m, scene.wave_generator.waves, scene.folder.string()}, faults);
}

PairGeometry pair_geometry(Scene const& scene, Profile const& tooth, double amplitude)
{
    PairGeometry g = ring_geometry(scene, tooth);
    g.w0 = amplitude;
    g.circular_spline_inner_radius =
        scene.circular_spline.inner_radius.value_or(g.r_m + tooth.pitch_line + amplitude - tooth.addendum);
    g.ratio = -static_cast<double>(scene.drive.flexspline_teeth)
              / (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth);
    return g;
}

int pitches_per_lobe(Scene const& scene)
{
    return (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth) / scene.wave_generator.waves;
}

namespace {

/// The tooth must fit into its share of the flexspline at every height.
void judge_width(Scene const& scene, Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    double worst = 0;
    Vec2 where = Vec2::Zero();
    double const chord = (tooth.addendum + tooth.dedendum) * 0x1p-10;
    double const half_share = std::numbers::pi / scene.drive.flexspline_teeth;
    for (Vec2 const& p : polygon_of(tooth, chord))
    {
        double const excess = std::abs(p.x()) - half_share * (g.r_m + p.y());
        if (excess > worst)
        {
            worst = excess;
            where = p;
        }
    }
    if (worst > 0)
        faults.push_back({scene.flexspline.profile.path, scene.flexspline.profile.line, "",
                          "the tooth is wider than its pitch: " + short_number(2 * std::abs(where.x())) + " mm thick at height "
                              + short_number(where.y() - tooth.pitch_line) + " mm, where the pitch is " + short_number(2 * half_share * (g.r_m + where.y())) + " mm",
                          "make the tooth thinner, or use fewer teeth or a larger module"});
}

void judge_tip_circle(Scene const& scene, Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    double const tip = g.r_m + g.w0 + tooth.pitch_line + tooth.addendum;
    double const rim = g.r_m + g.w0 + tooth.pitch_line - tooth.dedendum;
    bool const given = scene.circular_spline.inner_radius.has_value();
    std::string const value = given ? short_number(*scene.circular_spline.inner_radius) : "";
    double const radius = g.circular_spline_inner_radius;
    if (!(radius < tip))
        faults.push_back({"circular_spline.inner_radius", 0, value,
                          "the flexspline's tips reach a radius of " + short_number(tip) + " mm only, so no tooth enters the circular spline at "
                              + short_number(radius) + " mm",
                          "write a radius between " + short_number(rim) + " and " + short_number(tip)});
    else if (!(radius > rim))
        faults.push_back({"circular_spline.inner_radius", 0, value,
                          "the circular spline's tips at " + short_number(radius) + " mm would cut into the flexspline's rim, which reaches " + short_number(rim)
                              + " mm at the major axis",
                          "write a radius between " + short_number(rim) + " and " + short_number(tip)});
}

}  // namespace

void judge_geometry(Scene const& scene, Profile const& tooth, PairGeometry const& g, Faults& faults)
{
    if (!(g.flexspline_inner_radius > 0))
        faults.push_back({"flexspline.wall", 0, short_number(scene.flexspline.wall),
                          "wall and dedendum leave no hole: the inner radius would be " + short_number(g.flexspline_inner_radius) + " mm",
                          "write a thinner wall, or more teeth or a larger module"});
    else if (!(g.r_m > g.w0))
        faults.push_back({scene.wave_generator.shape.path + ".radial_deformation", 0, short_number(g.w0),
                          "is not smaller than the neutral radius " + short_number(g.r_m) + " mm",
                          "write about one module (" + short_number(scene.drive.module) + ")"});
    else
    {
        judge_width(scene, tooth, g, faults);
        judge_tip_circle(scene, tooth, g, faults);
    }
    bool has_tip = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i)
        has_tip = has_tip || is_tip(tooth, static_cast<int>(i));
    if (scene.circular_spline.root_clearance > 0 && !has_tip)
        faults.push_back({"circular_spline.root_clearance", 0, short_number(scene.circular_spline.root_clearance),
                          "the tooth has no flat or sharp tip whose trace could be moved outward",
                          "leave root_clearance out, or give the tooth a tip land"});
}

void judge_curvature(Scene const& scene, AnyWaveShape const& shape, double r_m, Faults& faults)
{
    constexpr int probes = 1440;
    double const half_lobe = std::numbers::pi / shape.waves();
    double flattest = std::numeric_limits<double>::infinity();
    double where = 0;
    for (int i = 0; i <= probes; ++i)
    {
        double const u = half_lobe * (2.0 * i / probes - 1);
        RadialDisplacement const d = shape(u);
        double const rho = r_m + d.w;
        // curvature times a positive length squared
        double const bend = rho * rho + 2 * d.w1 * d.w1 - rho * d.w2;
        if (!(bend >= flattest))
        {
            flattest = bend;
            where = u;
        }
    }
    if (!(flattest > 0))
        faults.push_back({scene.wave_generator.shape.path, scene.wave_generator.shape.line, scene.wave_generator.shape.family,
                          "the neutral curve would be hollow at " + short_number(where * 180 / std::numbers::pi) + " degrees from the major axis",
                          "write a smaller radial deformation, or smooth the table it comes from"});
}

}  // namespace hdconj::detail
