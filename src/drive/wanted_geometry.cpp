// SPDX-License-Identifier: GPL-3.0-or-later
#include "wanted_geometry.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "hdconj/check.hpp"
#include "hdconj/profile/registry.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::drive {
namespace {

/// The curve is looked for on one side of the major axis.
void validate_symmetry(scene::FamilyChoice const& choice, profile::Profile const& tooth, Faults& faults)
{
    if (!tooth.mirror_symmetric)
        faults.push_back({choice.path, choice.line, "",
                          "this tooth is not its own mirror image, and the wanted neutral curve is",
                          "give one flank, side = \"right\", or choose a symmetric family"});
}

/// On the major axis tips of neither member may reach the other's roots.
void validate_depth(Scene const& scene, GivenPair const& pair, Faults& faults)
{
    scene::FamilyChoice const& choice = scene.wave_generator.shape;
    auto const major = choice.number("major_displacement");
    if (!(pair.deepest > 0))
        faults.push_back({"circular_spline.inner_radius", 0, short_number(*scene.circular_spline.inner_radius),
                          "tips would meet roots before the neutral curve is displaced outward at all",
                          "write more than " + short_number(*scene.circular_spline.inner_radius - pair.deepest) +
                              ", or a larger dedendum of either tooth"});
    else if (major && !(*major < pair.rim_limit))
        faults.push_back({choice.path + ".major_displacement", choice.line_of("major_displacement"),
                          choice.text_of("major_displacement"),
                          "the circular spline's tips would cut into the flexspline's rim on the major axis",
                          "write less than " + short_number(pair.rim_limit) + ", or remove the key"});
    PairGeometry const& g = pair.geometry;
    // a radius that leaves room for far more than the usual displacement is a wrong one
    constexpr double far = 2;
    double const most = major.value_or(std::min(pair.deepest, far * scene::usual_deformation(scene.drive)));
    double const reach = g.r_m + most + g.pitch_line + pair.flexspline.addendum;
    if (pair.deepest > 0 && !(reach > *scene.circular_spline.inner_radius))
        faults.push_back({"circular_spline.inner_radius", 0, short_number(*scene.circular_spline.inner_radius),
                          "the flexspline's tips reach a radius of " + short_number(reach) +
                              " mm only, so no tooth enters the circular spline",
                          "write less than " + short_number(reach) + ", usually " +
                              short_number(scene.drive.module * scene.drive.circular_spline_teeth / 2 -
                                           pair.circular_spline.addendum) +
                              ", the pitch radius less the addendum"});
}

}  // namespace

GivenPair given_pair(Scene const& scene, Faults& faults)
{
    GivenPair pair;
    pair.flexspline = tooth_of(scene, false, faults);
    pair.circular_spline = tooth_of(scene, true, faults);
    if (!faults.empty() || pair.flexspline.pieces.empty() || pair.circular_spline.pieces.empty())
        return {};
    PairGeometry& g = pair.geometry = ring_geometry(scene, pair.flexspline);
    g.circular_spline_inner_radius = scene.circular_spline.inner_radius.value_or(0);
    g.ratio = -static_cast<double>(scene.drive.flexspline_teeth) /
              (scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth);
    profile::Profile const& outer = pair.circular_spline;
    pair.seat_height = given_tooth_seat(g, outer) - g.r_m;
    double const bottom = pair.seat_height - outer.pitch_line + outer.dedendum;
    double const tip = g.pitch_line + pair.flexspline.addendum;
    double const rim = g.pitch_line - pair.flexspline.dedendum;
    pair.rim_limit = g.circular_spline_inner_radius - g.r_m - rim;
    pair.root_limit = bottom - tip;
    pair.deepest = std::min(pair.root_limit, pair.rim_limit);
    return pair;
}

}  // namespace hdconj::drive

namespace hdconj {

Faults check_wanted_scene(Scene const& scene)
{
    scene::FamilyChoice const& shape = scene.wave_generator.shape;
    if (!scene.wants_neutral_curve())
        return {{shape.path + ".family", shape.line, shape.family,
                 "the neutral curve of this scene is known, and only one that is wanted is looked for",
                 "solve the scene as it is, or write family = \"wanted\" and give both teeth"}};
    Faults faults;
    drive::GivenPair const pair = drive::given_pair(scene, faults);
    if (pair.flexspline.pieces.empty())
        return faults;
    if (!(pair.geometry.flexspline_inner_radius > 0)) {
        faults.push_back({"flexspline.wall", 0, short_number(scene.flexspline.wall),
                          "wall and dedendum leave no hole: the inner radius would be " +
                              short_number(pair.geometry.flexspline_inner_radius) + " mm",
                          "write a thinner wall, or more teeth or a larger module"});
        return faults;
    }
    drive::validate_width(scene, pair.flexspline, pair.geometry, false, faults);
    drive::validate_width(scene, pair.circular_spline, pair.geometry, true, faults);
    drive::validate_symmetry(scene.flexspline.profile, pair.flexspline, faults);
    drive::validate_symmetry(*scene.circular_spline.profile, pair.circular_spline, faults);
    drive::validate_depth(scene, pair, faults);
    double const distance = shape.number_or("inner_distance", 0);
    if (!(distance < pair.geometry.r_m))
        faults.push_back({shape.path + ".inner_distance", shape.line_of("inner_distance"),
                          shape.text_of("inner_distance"),
                          "leaves no cam inside a neutral curve of radius " + short_number(pair.geometry.r_m) + " mm",
                          "write half the wall and the thickness of the bearing, some millimetres"});
    return faults;
}

}  // namespace hdconj
