// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/schema.hpp"

#include <algorithm>
#include <limits>

namespace hdconj {
namespace {

using Q = Quantity;

constexpr double infinity = std::numeric_limits<double>::infinity();

double number(Parameter const& parameter)
{
    return std::get<double>(parameter.value);
}

int count(Parameter const& parameter)
{
    return static_cast<int>(number(parameter));
}

std::string const& word(Parameter const& parameter)
{
    return std::get<std::string>(parameter.value);
}

ParameterSpec required(std::string_view key, Q quantity, std::string_view meaning, double at_least = -infinity,
                       double at_most = infinity)
{
    return {key, quantity, meaning, true, {}, at_least, at_most};
}

ParameterSpec optional(std::string_view key, Q quantity, std::string_view meaning, double at_least = -infinity,
                       double at_most = infinity)
{
    return {key, quantity, meaning, false, {}, at_least, at_most};
}

ParameterSpec choice(std::string_view key, std::string_view meaning, std::vector<std::string_view> words,
                     bool is_required)
{
    return {key, Q::word, meaning, is_required, std::move(words)};
}

ParameterSpec backlash_offset()
{
    auto spec = optional("backlash_offset", Q::length_or_word,
                         "side clearance along the normal of the flank; \"auto\": the least that clears every slice over a full turn", 0);
    spec.words = {"auto"};
    return spec;
}

TableSpec drive()
{
    return {"drive",
            "the pair of gears",
            Presence::required,
            FamilyKind::none,
            {{optional("name", Q::text, "name of the drive, for results and file names"), "\"type-50\"",
              std::string("unnamed"), [](Scene& s, Parameter const& p) { s.drive.name = word(p); }},
             {required("module", Q::positive_length, "module, m", bounds::least_module, bounds::largest_module),
              "0.25",
              {},
              [](Scene& s, Parameter const& p) { s.drive.module = number(p); }},
             {required("flexspline_teeth", Q::count, "teeth of the flexspline, z_f", bounds::fewest_teeth,
                       bounds::most_teeth),
              "200",
              {},
              [](Scene& s, Parameter const& p) { s.drive.flexspline_teeth = count(p); }},
             {required("circular_spline_teeth", Q::count,
                       "teeth of the circular spline, z_c: flexspline_teeth plus a positive multiple of waves",
                       bounds::fewest_teeth, bounds::most_teeth),
              "202",
              {},
              [](Scene& s, Parameter const& p) { s.drive.circular_spline_teeth = count(p); }}},
            nullptr};
}

TableSpec flexspline()
{
    return {"flexspline",
            "the toothed ring of the flexspline",
            Presence::required,
            FamilyKind::none,
            {{required("wall", Q::positive_length, "wall thickness under the teeth, delta"),
              "0.7",
              {},
              [](Scene& s, Parameter const& p) { s.flexspline.wall = number(p); }},
             {optional("inner_radius", Q::positive_length,
                       "inner radius of the undeformed ring; absent: module * flexspline_teeth / 2 - dedendum - wall"),
              "23.997",
              {},
              [](Scene& s, Parameter const& p) { s.flexspline.inner_radius = number(p); }},
             {optional("neutral_offset", Q::length, "how far the neutral layer lies inside the middle of the wall"),
              "0.15", 0.0, [](Scene& s, Parameter const& p) { s.flexspline.neutral_offset = number(p); }},
             {optional("addendum", Q::positive_length,
                       "height of the solved tooth's tip above the pitch line, h_a; with [circular_spline.profile] only"),
              "0.225",
              {},
              [](Scene& s, Parameter const& p) { s.flexspline.addendum = number(p); }},
             {optional("dedendum", Q::positive_length,
                       "depth of its root below the pitch line, h_f; with [circular_spline.profile] only"),
              "0.303",
              {},
              [](Scene& s, Parameter const& p) { s.flexspline.dedendum = number(p); }}},
            nullptr};
}

TableSpec profile()
{
    return {"flexspline.profile",
            "the flexspline tooth",
            Presence::alternative,
            FamilyKind::profile,
            {{required("family", Q::word, "tooth family; decides the other keys of this table"),
              "\"double-circular-arc\"",
              {},
              [](Scene& s, Parameter const& p) {
                  s.flexspline.profile.family = word(p);
                  s.flexspline.profile.line = p.line;
              }}},
            [](Scene& s, int) { s.flexspline.profile.path = "flexspline.profile"; }};
}

TableSpec wave_generator()
{
    return {"wave_generator",
            "what deforms the flexspline",
            Presence::required,
            FamilyKind::wave_generator,
            {{required("family", Q::word, "wave generator family; decides the other keys of this table"),
              "\"cosine\"",
              {},
              [](Scene& s, Parameter const& p) {
                  s.wave_generator.shape.family = word(p);
                  s.wave_generator.shape.line = p.line;
              }},
             {optional("waves", Q::count, "waves around the circumference, n", 1, bounds::most_waves), "2", 2.0,
              [](Scene& s, Parameter const& p) { s.wave_generator.waves = count(p); }}},
            [](Scene& s, int) { s.wave_generator.shape.path = "wave_generator"; }};
}

TableSpec circular_spline()
{
    return {
        "circular_spline",
        "the circular spline",
        Presence::optional,
        FamilyKind::none,
        {{optional("width", Q::positive_length, "axial width of the toothing; needed by [slices] with count above 1"),
          "7.0",
          {},
          [](Scene& s, Parameter const& p) { s.circular_spline.width = number(p); }},
         {backlash_offset(), "0.02", 0.0,
          [](Scene& s, Parameter const& p) {
              bool const automatic = std::holds_alternative<std::string>(p.value);
              s.circular_spline.automatic_backlash = automatic;
              s.circular_spline.backlash_offset = automatic ? 0.0 : number(p);
          }},
         {optional("root_clearance", Q::nonnegative_length, "extra depth of the tooth space"), "0.02", 0.0,
          [](Scene& s, Parameter const& p) { s.circular_spline.root_clearance = number(p); }},
         {optional("inner_radius", Q::positive_length,
                   "tip circle; absent: neutral radius + height of the pitch line + radial deformation - addendum of the "
                   "given tooth"),
          "25.025",
          {},
          [](Scene& s, Parameter const& p) { s.circular_spline.inner_radius = number(p); }}},
        nullptr};
}

TableSpec circular_spline_profile()
{
    return {"circular_spline.profile",
            "the circular spline's tooth, when the flexspline's is solved for",
            Presence::alternative,
            FamilyKind::profile,
            {{required("family", Q::word, "tooth family; decides the other keys of this table"),
              "\"double-circular-arc\"",
              {},
              [](Scene& s, Parameter const& p) {
                  s.circular_spline.profile->family = word(p);
                  s.circular_spline.profile->line = p.line;
              }}},
            [](Scene& s, int) { s.circular_spline.profile.emplace().path = "circular_spline.profile"; }};
}

TableSpec solver()
{
    return {"solver",
            "how to compute",
            Presence::optional,
            FamilyKind::none,
            {{choice("kinematics", "relative motion: inextensible neutral curve, its first order, or the linear inextensional mode of "
                     "the points of the ring",
                     {"exact", "first-order", "material"}, false),
              "\"exact\"", std::string("exact"),
              [](Scene& s, Parameter const& p) {
                  s.solver.kinematics = *std::find_if(all_kinematics.begin(), all_kinematics.end(),
                                                      [&](Kinematics k) { return to_string(k) == word(p); });
              }},
             {optional("tolerance", Q::positive_length,
                       "largest distance between a written outline and the true one; at most module / 10",
                       bounds::least_tolerance),
              "1e-6", 1e-6, [](Scene& s, Parameter const& p) { s.solver.tolerance = number(p); }},
             {optional("threads", Q::count, "threads; 0: all cores", 0, bounds::most_threads), "0", 0.0,
              [](Scene& s, Parameter const& p) { s.solver.threads = count(p); }}},
            nullptr};
}

TableSpec coning()
{
    return {"coning",
            "effect: the cup cones along the axis",
            Presence::effect,
            FamilyKind::none,
            {{choice("model", "amplitude linear along the axis, or from the elastic cup", {"linear", "elastic"}, true),
              "\"linear\"",
              {},
              [](Scene& s, Parameter const& p) { s.coning->model = word(p); }},
             {optional("bottom_to_middle", Q::positive_length,
                       "from the cup's bottom to the middle of the bearing; needed by model \"linear\""),
              "9.0",
              {},
              [](Scene& s, Parameter const& p) { s.coning->bottom_to_middle = number(p); }},
             {optional("apex_height", Q::length, "of the point that does not move, above the cup's bottom"), "0.43", 0.0,
              [](Scene& s, Parameter const& p) { s.coning->apex_height = number(p); }},
             {choice("axial_shift", "whether gaps are looked up where the wall has moved to along the axis", {"mapped", "none"}, false),
              "\"mapped\"", std::string("mapped"), [](Scene& s, Parameter const& p) { s.coning->axial_shift = word(p); }}},
            [](Scene& s, int line) { s.coning.emplace().line = line; }};
}

TableSpec tilt()
{
    return {"tilt",
            "effect: tilted teeth of the circular spline",
            Presence::effect,
            FamilyKind::none,
            {{required("angle_deg", Q::angle_deg, "tilt angle, between -45 and 45 degrees"),
              "0.2",
              {},
              [](Scene& s, Parameter const& p) { s.tilt->angle = number(p) * rad_per_deg; }},
             {choice("kind", "outline moved radially, or offset along its normal", {"radial", "draft"}, false),
              "\"radial\"", std::string("radial"), [](Scene& s, Parameter const& p) { s.tilt->kind = word(p); }}},
            [](Scene& s, int line) { s.tilt.emplace().line = line; }};
}

TableSpec slices()
{
    return {"slices",
            "effect: slices across the face width",
            Presence::effect,
            FamilyKind::none,
            {{required("count", Q::count, "number of slices", 1, bounds::most_slices),
              "9",
              {},
              [](Scene& s, Parameter const& p) { s.slices->count = count(p); }},
             {choice("surface", "how the slices make the tooth surface", {"tilted", "ruled", "per-slice"}, false),
              "\"tilted\"", std::string("tilted"), [](Scene& s, Parameter const& p) { s.slices->surface = word(p); }}},
            [](Scene& s, int line) { s.slices.emplace().line = line; }};
}

TableSpec contact()
{
    return {"contact",
            "what the verb contact is asked for",
            Presence::effect,
            FamilyKind::none,
            {{optional("contact_gap", Q::positive_length, "flanks touch where the gap is no larger", bounds::least_length), "0.001", 0.001,
              [](Scene& s, Parameter const& p) { s.contact->gap = number(p); }},
             {optional("flank_points", Q::count, "points along each flank", bounds::fewest_flank_points, bounds::most_flank_points), "200",
              200.0, [](Scene& s, Parameter const& p) { s.contact->flank_points = count(p); }},
             {optional("wave_generator_angle_deg", Q::angle_deg, "from the centre line of a tooth space", -360, 360), "0", 0.0,
              [](Scene& s, Parameter const& p) { s.contact->wave_generator = number(p) * rad_per_deg; }}},
            [](Scene& s, int line) { s.contact.emplace().line = line; }};
}

}  // namespace

std::vector<TableSpec> const& scene_schema()
{
    static std::vector<TableSpec> const tables{drive(),  flexspline(), profile(), wave_generator(), circular_spline(),
                                               circular_spline_profile(), solver(), coning(), tilt(), slices(),
                                               contact()};
    return tables;
}

}  // namespace hdconj
