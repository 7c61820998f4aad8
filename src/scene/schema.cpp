// SPDX-License-Identifier: GPL-3.0-or-later
// Long: a table, one row for each key of a scene.
// One table of all keys of a scene. It stays in one file, longer than others, so that a key has one place: its name,
// meaning, unit, bounds, example, default and the member of Scene that it sets.
#include "hdconj/scene/schema.hpp"

#include <algorithm>
#include <limits>

#include "hdconj/units.hpp"

namespace hdconj::scene {
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

/// A key whose value is one of an enumeration's words.
template <Worded Enumeration>
ParameterSpec choice(std::string_view key, std::string_view meaning, bool is_required)
{
    return choice(key, meaning, {words_of<Enumeration>.begin(), words_of<Enumeration>.end()}, is_required);
}

/// Takes over a word that has been validated.
template <Worded Enumeration>
void take(Enumeration& value, Parameter const& parameter)
{
    value = from_word<Enumeration>(word(parameter)).value();
}

ParameterSpec backlash_offset()
{
    auto spec = optional(
        "backlash_offset", Q::length_or_word,
        "side clearance along the normal of the flank; \"auto\": the least that clears every slice over a full turn",
        0);
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
    return {
        "flexspline",
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
         {optional("neutral_offset", Q::length, "how far the neutral layer lies inside the middle of the wall"), "0.15",
          0.0, [](Scene& s, Parameter const& p) { s.flexspline.neutral_offset = number(p); }},
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

TableSpec cup()
{
    return {
        "flexspline.cup",
        "the cup that carries the toothed ring, for [coning] model \"elastic\"",
        Presence::effect,
        FamilyKind::none,
        {{required("length", Q::positive_length, "from the outer face of the bottom to the open end"),
          "15.0",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->length = number(p); }},
         {required("barrel_wall", Q::positive_length,
                   "wall thickness of the barrel behind the teeth and of the land in front of them"),
          "0.4",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->barrel_wall = number(p); }},
         {required("bottom", Q::positive_length, "thickness of the bottom"),
          "0.5",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->bottom = number(p); }},
         {required("corner_radius", Q::positive_length, "outer fillet between bottom and barrel"),
          "2.0",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->corner_radius = number(p); }},
         {required("flange_radius", Q::positive_length, "of the flange: inside it the bottom does not move"),
          "13.0",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->flange_radius = number(p); }},
         {required("tooth_width", Q::positive_length, "width of the toothed ring"),
          "8.0",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->tooth_width = number(p); }},
         {optional("front_land", Q::nonnegative_length, "from the teeth to the open end"), "2.0", 0.0,
          [](Scene& s, Parameter const& p) { s.flexspline.cup->front_land = number(p); }},
         {optional("rear_ramp", Q::nonnegative_length,
                   "length over which the barrel's wall grows to that under the teeth; absent: as long as it grows"),
          "0.4",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->rear_ramp = number(p); }},
         {optional("front_ramp", Q::nonnegative_length, "the same in front of the teeth"),
          "0.4",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->front_ramp = number(p); }},
         {optional("rear_fillet", Q::positive_length,
                   "radius of an arc in place of that ramp, tangent to the barrel; absent: the straight ramp"),
          "0.5",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->rear_fillet = number(p); }},
         {optional("front_fillet", Q::positive_length, "the same in front of the teeth"),
          "0.5",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->front_fillet = number(p); }},
         {optional("tooth_layer", Q::positive_length,
                   "effect: height of the teeth, which stiffen their ring along the axis as a layer on it; absent: "
                   "they do not"),
          "0.53",
          {},
          [](Scene& s, Parameter const& p) { s.flexspline.cup->tooth_layer = number(p); }},
         {optional("tooth_share", Q::number, "of that layer that is steel; with tooth_layer only",
                   bounds::least_tooth_share, 1),
          "0.5", 0.5, [](Scene& s, Parameter const& p) { s.flexspline.cup->tooth_share = number(p); }},
         {optional("youngs_modulus", Q::number, "of the flexspline's steel, in MPa", bounds::least_modulus,
                   bounds::largest_modulus),
          "206000", 206000.0, [](Scene& s, Parameter const& p) { s.flexspline.cup->youngs_modulus = number(p); }},
         {optional("poissons_ratio", Q::number, "of the flexspline's steel", 0, bounds::largest_poissons_ratio), "0.3",
          0.3, [](Scene& s, Parameter const& p) { s.flexspline.cup->poissons_ratio = number(p); }}},
        [](Scene& s, int line) { s.flexspline.cup.emplace().line = line; }};
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
         {optional(
              "inner_radius", Q::positive_length,
              "tip circle; absent: neutral radius + height of the pitch line + radial deformation - addendum of the "
              "given tooth"),
          "25.025",
          {},
          [](Scene& s, Parameter const& p) { s.circular_spline.inner_radius = number(p); }},
         {optional("youngs_modulus", Q::number, "of the circular spline's steel, in MPa; for the verb load",
                   bounds::least_modulus, bounds::largest_modulus),
          "210000", 210000.0, [](Scene& s, Parameter const& p) { s.circular_spline.youngs_modulus = number(p); }},
         {optional("poissons_ratio", Q::number, "of the circular spline's steel; for the verb load", 0,
                   bounds::largest_poissons_ratio),
          "0.3", 0.3, [](Scene& s, Parameter const& p) { s.circular_spline.poissons_ratio = number(p); }}},
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
            {{choice<Kinematics>(
                  "kinematics",
                  "relative motion: inextensible neutral curve, its first order, or the linear inextensional mode of "
                  "the points of the ring",
                  false),
              "\"exact\"", std::string("exact"), [](Scene& s, Parameter const& p) { take(s.solver.kinematics, p); }},
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
    return {
        "coning",
        "effect: the cup cones along the axis",
        Presence::effect,
        FamilyKind::none,
        {{choice<ConingModel>("model", "amplitude linear along the axis, or from the elastic cup", true),
          "\"linear\"",
          {},
          [](Scene& s, Parameter const& p) { take(s.coning->model, p); }},
         {optional("bottom_to_middle", Q::positive_length,
                   "from the cup's bottom to the middle of the bearing; needed by either model"),
          "9.0",
          {},
          [](Scene& s, Parameter const& p) { s.coning->bottom_to_middle = number(p); }},
         {optional("apex_height", Q::length,
                   "of the point that does not move, above the cup's bottom; model \"linear\" only"),
          "0.43", 0.0, [](Scene& s, Parameter const& p) { s.coning->apex_height = number(p); }},
         {choice<AxialShift>("axial_shift", "whether gaps are looked up where the wall has moved to along the axis",
                             false),
          "\"mapped\"", std::string("mapped"), [](Scene& s, Parameter const& p) { take(s.coning->axial_shift, p); }}},
        [](Scene& s, int line) { s.coning.emplace().line = line; }};
}

TableSpec bearing()
{
    return {"bearing",
            "the bearing between wave generator and cup, for [coning] model \"elastic\"",
            Presence::effect,
            FamilyKind::none,
            {{choice("type", "surface that keeps the cam's shape, or outer ring that bends on a line of balls",
                     {"rigid", "elastic"}, true),
              "\"elastic\"",
              {},
              [](Scene& s, Parameter const& p) { s.bearing->elastic = word(p) == "elastic"; }},
             {required("width", Q::nonnegative_length,
                       "over which the cup may touch it, its middle at z = 0; 0: one line, type \"rigid\" only"),
              "6.0",
              {},
              [](Scene& s, Parameter const& p) { s.bearing->width = number(p); }},
             {optional("ring_thickness", Q::positive_length, "of the outer ring; needed by type \"elastic\""),
              "1.2",
              {},
              [](Scene& s, Parameter const& p) { s.bearing->ring_thickness = number(p); }},
             {optional("fit", Q::length, "interference: outer radius of the bearing less inner radius of the cup"),
              "0.005", 0.0, [](Scene& s, Parameter const& p) { s.bearing->fit = number(p); }},
             {optional("cam_oversize", Q::length,
                       "of the cam's radius under the line of balls, all round: preload of the balls"),
              "0.002", 0.0, [](Scene& s, Parameter const& p) { s.bearing->cam_oversize = number(p); }},
             {optional("radial_stiffness", Q::number,
                       "of the line of balls, in N/mm per mm of arc; absent: rigid; type \"elastic\" only",
                       bounds::least_stiffness, bounds::largest_stiffness),
              "2000",
              {},
              [](Scene& s, Parameter const& p) { s.bearing->radial_stiffness = number(p); }},
             {choice("axially", "whether the groove holds the line of balls along the axis; type \"elastic\" only",
                     {"held", "free"}, false),
              "\"held\"", std::string("held"),
              [](Scene& s, Parameter const& p) { s.bearing->axially_held = word(p) == "held"; }},
             {optional("balls", Q::count,
                       "how many; for the verb load, which presses the ring outward at each of them; absent: a line "
                       "all round; type \"elastic\" only",
                       1, bounds::most_balls),
              "23",
              {},
              [](Scene& s, Parameter const& p) { s.bearing->balls = count(p); }},
             {optional("ball_phase_deg", Q::angle_deg, "angle of one ball from the major axis, clockwise"), "7.5", 0.0,
              [](Scene& s, Parameter const& p) { s.bearing->ball_phase = number(p) * deg; }},
             {optional("angles", Q::count, "points in a lobe where bearing and cup may touch, an even number",
                       bounds::fewest_angles, bounds::most_angles),
              "48", 48.0, [](Scene& s, Parameter const& p) { s.bearing->angles = count(p); }},
             {optional("circles", Q::count, "circles of such points over the width, its edges included",
                       bounds::fewest_circles, bounds::most_circles),
              "13", 13.0, [](Scene& s, Parameter const& p) { s.bearing->circles = count(p); }}},
            [](Scene& s, int line) { s.bearing.emplace().line = line; }};
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
              [](Scene& s, Parameter const& p) { s.tilt->angle = number(p) * deg; }},
             {choice<TiltKind>("kind", "outline moved radially, or offset along its normal", false), "\"radial\"",
              std::string("radial"), [](Scene& s, Parameter const& p) { take(s.tilt->kind, p); }}},
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
             {choice<ToothSurface>("surface", "how the slices make the tooth surface", false), "\"tilted\"",
              std::string("tilted"), [](Scene& s, Parameter const& p) { take(s.slices->surface, p); }}},
            [](Scene& s, int line) { s.slices.emplace().line = line; }};
}

TableSpec contact()
{
    return {
        "contact",
        "what the verb contact is asked for",
        Presence::effect,
        FamilyKind::none,
        {{optional("contact_gap", Q::positive_length, "flanks touch where the gap is no larger", bounds::least_length),
          "0.001", 0.001, [](Scene& s, Parameter const& p) { s.contact->gap = number(p); }},
         {optional("flank_points", Q::count, "points along each flank", bounds::fewest_flank_points,
                   bounds::most_flank_points),
          "200", 200.0, [](Scene& s, Parameter const& p) { s.contact->flank_points = count(p); }},
         {optional("wave_generator_angle_deg", Q::angle_deg, "from the centre line of a tooth space", -360, 360), "0",
          0.0, [](Scene& s, Parameter const& p) { s.contact->wave_generator = number(p) * deg; }}},
        [](Scene& s, int line) { s.contact.emplace().line = line; }};
}

TableSpec load()
{
    return {"load",
            "what the verb load is asked for",
            Presence::effect,
            FamilyKind::none,
            {{optional("torque", Q::number, "rated torque on the circular spline, in N m", bounds::least_torque,
                       bounds::largest_torque),
              "28.0",
              {},
              [](Scene& s, Parameter const& p) { s.load->torque = number(p) * newton_metre; }},
             {optional("points", Q::count, "torques from 0 to the rated one", 1, bounds::most_torques), "10", 10.0,
              [](Scene& s, Parameter const& p) { s.load->points = count(p); }},
             {optional("harmonics", Q::count, "highest harmonic around the circumference", bounds::fewest_harmonics,
                       bounds::most_harmonics),
              "100", 100.0, [](Scene& s, Parameter const& p) { s.load->harmonics = count(p); }},
             {optional("edge_radius", Q::positive_length,
                       "of the edges where teeth touch under load; absent: 1/25 of the module", bounds::least_length),
              "0.01",
              {},
              [](Scene& s, Parameter const& p) { s.load->edge_radius = number(p); }}},
            [](Scene& s, int line) { s.load.emplace().line = line; }};
}

ParameterSpec passes()
{
    auto spec =
        optional("passes", Q::rows,
                 "stock that each pass leaves, in order; it decreases, and the last pass leaves 0; absent: one pass", 1,
                 bounds::most_passes);
    spec.words = {"[length]"};
    return spec;
}

TableSpec wedm()
{
    return {
        "wedm",
        "what the verb wedm is asked for: a part cut by wire",
        Presence::effect,
        FamilyKind::none,
        {{required("wire_diameter", Q::positive_length, "of the wire; never assumed"),
          "0.10",
          {},
          [](Scene& s, Parameter const& p) { s.wedm->wire_diameter = number(p); }},
         {required("spark_gap", Q::nonnegative_length, "between wire and part; never assumed"),
          "0.006",
          {},
          [](Scene& s, Parameter const& p) { s.wedm->spark_gap = number(p); }},
         {choice<WirePart>("part", "what is cut; the flexspline in two set-ups of half its teeth each", false),
          "\"circular-spline\"", std::string("circular-spline"),
          [](Scene& s, Parameter const& p) { take(s.wedm->part, p); }},
         {optional("thickness", Q::positive_length,
                   "of the workpiece, its middle at z = 0; absent: circular_spline.width"),
          "7.0",
          {},
          [](Scene& s, Parameter const& p) { s.wedm->thickness = number(p); }},
         {optional("lower_guide", Q::nonnegative_length, "lower guide point of the wire below the lower face"), "20.0",
          20.0, [](Scene& s, Parameter const& p) { s.wedm->lower_guide = number(p); }},
         {optional("upper_guide", Q::nonnegative_length, "upper guide point above the upper face"), "30.0", 30.0,
          [](Scene& s, Parameter const& p) { s.wedm->upper_guide = number(p); }},
         {passes(),
          "[[0.02], [0.005], [0]]",
          {},
          [](Scene& s, Parameter const& p) {
              for (auto const& row : std::get<NumberRows>(p.value))
                  s.wedm->stock.push_back(row.front());
          }},
         {choice("direction", "whether every second pass runs against the first", {"same", "alternating"}, false),
          "\"same\"", std::string("same"),
          [](Scene& s, Parameter const& p) { s.wedm->alternating = word(p) == "alternating"; }},
         {optional(
              "start", Q::count,
              "tooth space where the path begins: the circular spline's in the middle of the tip land clockwise of it, "
              "the flexspline's in that counter-clockwise of it; 0 lies on the y axis, the others follow clockwise",
              0, bounds::most_teeth),
          "0", 0.0, [](Scene& s, Parameter const& p) { s.wedm->start = count(p); }},
         {optional("lead_in", Q::positive_length,
                   "from the centre of the start hole, inside the bore, to the tip land; for the flexspline from a "
                   "place outside the blank"),
          "3.0", 3.0, [](Scene& s, Parameter const& p) { s.wedm->lead_in = number(p); }},
         {optional("start_hole_radius", Q::positive_length, "of the hole that the wire is threaded through"), "0.5",
          0.5, [](Scene& s, Parameter const& p) { s.wedm->start_hole_radius = number(p); }},
         {optional("overlap", Q::nonnegative_length,
                   "beyond the point where the contour closes, or where the other set-up takes over"),
          "0.0", 0.0, [](Scene& s, Parameter const& p) { s.wedm->overlap = number(p); }},
         {optional("stop_before", Q::nonnegative_length,
                   "first pass: stop this far before the contour ends and the slug drops; 0: no stop"),
          "1.0", 1.0, [](Scene& s, Parameter const& p) { s.wedm->stop_before = number(p); }},
         {optional("tolerance", Q::positive_length,
                   "largest distance of the surface that is cut from the nominal one, residuals apart",
                   bounds::least_tolerance),
          "0.0005", 0.0005, [](Scene& s, Parameter const& p) { s.wedm->tolerance = number(p); }},
         {optional("residual_limit", Q::nonnegative_length,
                   "material that the last pass may leave where the wire cannot follow"),
          "0.01", 0.01, [](Scene& s, Parameter const& p) { s.wedm->residual_limit = number(p); }},
         {optional("surface_limit", Q::nonnegative_length,
                   "accepted distance of the cut from the true surface between the faces, where that is not ruled or "
                   "too twisted for a straight wire; absent: tolerance"),
          "0.003",
          {},
          [](Scene& s, Parameter const& p) { s.wedm->surface_limit = number(p); }},
         {optional("largest_tilt_deg", Q::angle_deg, "of the wire that the machine can make", 0,
                   bounds::largest_tilt_deg),
          "30", 30.0, [](Scene& s, Parameter const& p) { s.wedm->largest_tilt = number(p) * deg; }},
         {optional("largest_travel", Q::positive_length,
                   "of each axis of each guide from the start hole, either way; absent: not checked"),
          "100.0",
          {},
          [](Scene& s, Parameter const& p) { s.wedm->largest_travel = number(p); }},
         {optional("largest_uv_travel", Q::positive_length,
                   "of each axis of the upper guide against the lower one, either way; absent: not checked"),
          "20.0",
          {},
          [](Scene& s, Parameter const& p) { s.wedm->largest_uv_travel = number(p); }},
         {optional("decimals", Q::count, "of coordinates in mm in rounded files", bounds::fewest_decimals,
                   bounds::most_decimals),
          "4", 4.0, [](Scene& s, Parameter const& p) { s.wedm->decimals = count(p); }},
         {optional("dialects", Q::text, "files to write, names separated by blanks; empty: all that fit"), "\"\"",
          std::string(), [](Scene& s, Parameter const& p) { s.wedm->dialects = word(p); }}},
        [](Scene& s, int line) { s.wedm.emplace().line = line; }};
}

}  // namespace

std::vector<TableSpec> const& scene_schema()
{
    static std::vector<TableSpec> const tables{
        drive(),  flexspline(), cup(),     profile(), wave_generator(), circular_spline(), circular_spline_profile(),
        solver(), coning(),     bearing(), tilt(),    slices(),         contact(),         load(),
        wedm()};
    return tables;
}

}  // namespace hdconj::scene
