// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_cup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "drive.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/check.hpp"
#include "hdconj/elastic_cup.hpp"
#include "hdconj/scene/schema.hpp"
#include "hdconj/units.hpp"
#include "scene/usual_cup.hpp"
#include "wavegen/length_kept.hpp"

namespace hdconj::drive {

elastic::CupSection cup_section(Scene const& scene, double inner_radius)
{
    Cup const& cup = *scene.flexspline.cup;
    double const step = std::abs(scene.flexspline.wall - cup.barrel_wall);
    elastic::CupSection section;
    section.inner_radius = inner_radius;
    section.length = cup.length;
    section.wall = cup.barrel_wall;
    section.ring_wall = scene.flexspline.wall;
    section.ring_end = cup.length - cup.front_land;
    section.ring_begin = section.ring_end - cup.tooth_width;
    section.rear_ramp = cup.rear_ramp.value_or(step);
    section.front_ramp = cup.front_ramp.value_or(step);
    section.rear_fillet = cup.rear_fillet.value_or(0);
    section.front_fillet = cup.front_fillet.value_or(0);
    if (cup.tooth_layer) {
        section.tooth_layer = *cup.tooth_layer;
        section.tooth_share = cup.tooth_share;
    }
    section.bottom = cup.bottom;
    section.corner_radius = cup.corner_radius;
    section.clamp_radius = cup.flange_radius;
    section.material = {cup.youngs_modulus, cup.poissons_ratio};
    return section;
}

elastic::Bearing bearing_of(Scene const& scene)
{
    BearingChoice const& choice = *scene.bearing;
    elastic::Bearing bearing{*scene.coning->bottom_to_middle, choice.width, choice.fit, choice.cam_oversize,
                             std::nullopt};
    if (choice.elastic)
        bearing.ring = elastic::BearingRing{*choice.ring_thickness,
                                            choice.axially_held,
                                            choice.radial_stiffness,
                                            {choice.youngs_modulus, choice.poissons_ratio}};
    return bearing;
}

namespace {

/// What to write where the dimensions of @p part contradict others.
std::string remedy_of(std::optional<elastic::SectionPart> part)
{
    using Part = elastic::SectionPart;
    std::string const cup = "flexspline.cup.";
    switch (part.value_or(Part::walls)) {
        case Part::fillet:
            return "write " + cup + "rear_fillet and front_fillet larger than what flexspline.wall is thicker than " +
                   cup + "barrel_wall, or leave them out";
        case Part::flange:
            return "write a smaller " + cup + "flange_radius or corner_radius";
        case Part::corner:
            return "write a larger " + cup + "corner_radius, or a smaller barrel_wall or bottom";
        case Part::rear_ramp:
            return "write a " + cup + "rear_ramp above 0";
        case Part::front_ramp:
            return "write a larger " + cup + "front_land, or a smaller front_ramp or front_fillet above 0";
        case Part::tooth_ring:
            return "write a larger " + cup +
                   "length, or a smaller tooth_width, front_land, corner_radius, rear_ramp or rear_fillet";
        default:  // the mesh is too fine
            return "write a smaller " + cup + "length, or thicker flexspline.wall, barrel_wall and bottom";
    }
}

}  // namespace

void validate_cup(Scene const& scene, double inner_radius, Faults& faults)
{
    elastic::CupSection const section = cup_section(scene, inner_radius);
    elastic::Bearing const bearing = bearing_of(scene);
    std::string const origin = scene.flexspline.cup->line > 0 ? "" : "--set";
    auto const refuse = [&](NumericalError const& error, std::optional<elastic::SectionPart> part = std::nullopt) {
        faults.push_back({"flexspline.cup", scene.flexspline.cup->line, "", error.what(), remedy_of(part), origin});
    };
    try {
        elastic::MeshSize const size = elastic::contact_mesh_size(section, bearing.width, scene.bearing->circles);
        (void)elastic::section_mesh(section, size);
    } catch (elastic::UnsoundSection const& error) {
        return refuse(error, error.part());
    } catch (NumericalError const& error) {
        return refuse(error);
    }
    auto const at = [&](std::string const& path, std::string const& reason, std::string const& remedy) {
        auto const given = scene.given.find(path);
        int const line = given == scene.given.end() ? 0 : given->second.line;
        faults.push_back({path, line, given == scene.given.end() ? "" : given->second.written, reason, remedy,
                          line > 0 ? "" : "--set"});
    };
    if (bearing.middle - bearing.width / 2 < section.corner_radius ||
        bearing.middle + bearing.width / 2 > section.length) {
        double const most = 2 * std::min(bearing.middle - section.corner_radius, section.length - bearing.middle);
        at("bearing.width",
           fmt::format("the bearing would reach beyond the straight wall, from {:g} to {:g} mm above the bottom: its "
                       "middle is at {:g} mm",
                       section.corner_radius, section.length, bearing.middle),
           "write " + (most > 0 ? "a bearing.width of at most " + at_most_text(most) + ", or " : std::string()) +
               (scene.given.contains("coning.bottom_to_middle") ? "another coning.bottom_to_middle"
                                                                : "a longer flexspline.cup.length"));
    }
    if (bearing.ring && bearing.ring->thickness >= inner_radius)
        at("bearing.ring_thickness", fmt::format("the cup's inner radius is {:g} mm", inner_radius),
           "write a small part of that, such as " + scene::length_text(scene::UsualCup(scene).ring_thickness));
    double const half = scene.circular_spline.width.value_or(0) / 2;
    bool const spread = scene.slices && scene.slices->count > 1;
    if (spread && (bearing.middle - half < section.ring_begin || bearing.middle + half > section.ring_end))
        at("circular_spline.width",
           fmt::format(
               "the circular spline would reach beyond the flexspline's teeth, which stand from {:g} to {:g} mm",
               section.ring_begin - bearing.middle, section.ring_end - bearing.middle),
           "write a smaller width, or another flexspline.cup.tooth_width");
}

std::shared_ptr<elastic::BentCup const> bent_cup(Scene const& scene, double inner_radius,
                                                 wavegen::AnyWaveShape const& shape, int threads)
{
    elastic::BentCupGrid const grid{scene.bearing->angles, scene.bearing->circles};
    auto cup = elastic::solved_cup(cup_section(scene, inner_radius), bearing_of(scene),
                                   elastic::cam_series(shape, grid.angles), grid, threads);
    auto const& balls = cup->contact().ball_force;
    bool const loose = !balls.empty() && *std::max_element(balls.begin(), balls.end()) <= 0;
    if (loose)
        throw NumericalError(ErrorCode::no_contact, "elastic cup", "bearing",
                             "the cam reaches no ball, and the cup stays round", "write a larger bearing.cam_oversize");
    if (!(cup->contact().total_force > 0))
        throw NumericalError(ErrorCode::no_contact, "elastic cup", "bearing",
                             "it does not touch the cup, which stays round", "write a larger bearing.fit");
    return cup;
}

BentCupError cup_error(Scene const& scene, elastic::BentCup const& cup, wavegen::AnyWaveShape const& shape, double r_m,
                       double width, int threads)
{
    elastic::BentCupGrid const grid = elastic::discretised_otherwise({scene.bearing->angles, scene.bearing->circles});
    auto const other =
        elastic::solved_cup(cup.section(), cup.bearing(), elastic::cam_series(shape, grid.angles), grid, threads);
    std::vector<double> z = {cup.bearing().middle};
    if (width > 0)
        for (double const side : {-0.5, 0.5})
            z.push_back(cup.bearing().middle + side * width);
    return elastic::bent_cup_error(cup, *other, z, r_m);
}

double front_of_teeth(elastic::BentCup const& cup, double r_m)
{
    double const face = cup.section().ring_end;
    return face + cup.axial(face, r_m, 0).u_z - cup.bearing().middle;
}

wavegen::MaterialDisplacement displacement_at(elastic::BentCup const& cup, double z, double r_m)
{
    return wavegen::length_kept(cup.displacement(cup.bearing().middle + z, r_m), r_m);
}

}  // namespace hdconj::drive

namespace hdconj {
namespace {

/// To two digits, in plain figures.
std::string rounded(double value)
{
    if (!(value > 0))
        return "0";
    double const digit = std::pow(10.0, std::floor(std::log10(value)) - 1);
    return short_number(std::round(value / digit) * digit);
}

}  // namespace

std::shared_ptr<elastic::BentCup const> elastic_cup(Scene const& scene)
{
    Faults faults = check_scene(scene);
    if (!scene.is_elastic())
        faults.push_back({"coning.model", scene.coning ? scene.coning->line : 0, "", "the scene has no elastic cup",
                          "write model = \"elastic\" in [coning], with [flexspline.cup] and [bearing]; "
                          "data/scenes/type-50-elastic.toml is an example"});
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
    throw_if_any(faults);
    return drive::bent_cup(scene, drive::ring_geometry(scene, tooth).flexspline_inner_radius, shape,
                           thread_count(scene.solver.threads));
}

BentCupError elastic_cup_error(Scene const& scene, elastic::BentCup const& cup)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    return drive::cup_error(scene, cup, drive::wave_shape(scene, tooth, faults), drive::ring_geometry(scene, tooth).r_m,
                            drive::width_of_slices(scene), thread_count(scene.solver.threads));
}

std::string describe(elastic::BentCup const& cup, std::optional<BentCupError> const& error)
{
    elastic::WaveGeneratorContact const& contact = cup.contact();
    std::string text;
    if (error)
        text = "; coning of the whole toothed ring " + short_number(cup.coning(0) / deg) + " +- " +
               rounded(error->coning_major / deg) + " degrees at the major axis; force between bearing and cup " +
               short_number(contact.total_force) + " +- " + rounded(error->force) + " N";
    if (auto const widest = std::max_element(contact.ball_gap.begin(), contact.ball_gap.end());
        widest != contact.ball_gap.end() && *widest > 0)
        text += "; largest gap between outer ring and balls " + short_number(per_um * *widest) + " um";
    return text.empty() ? text : "elastic cup" + text.replace(0, 1, ":");
}

}  // namespace hdconj
