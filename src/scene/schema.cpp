// SPDX-License-Identifier: GPL-3.0-or-later
// Long: a table, one row for each key of a scene.
// One table of all keys of a scene. It stays in one file, longer than others, so that a key has one place: its name,
// meaning, unit, bounds, example, default and the member of Scene that holds it.
#include "hdconj/scene/schema.hpp"

#include <limits>
#include <type_traits>

#include "hdconj/units.hpp"
#include "usual_wire.hpp"

namespace hdconj::scene {
namespace {

using Q = Quantity;

constexpr double no_unit = 1;
constexpr double infinity = std::numeric_limits<double>::infinity();

double number(Parameter const& parameter)
{
    return std::get<double>(parameter.value);
}

std::string const& word(Parameter const& parameter)
{
    return std::get<std::string>(parameter.value);
}

/// Takes over a value that has been validated. @param unit  of its numbers, in that of the library
template <class Value>
void take(Value& value, Parameter const& parameter, double unit)
{
    if constexpr (Worded<Value>)
        value = from_word<Value>(word(parameter)).value();
    else if constexpr (std::is_same_v<Value, std::string>)
        value = word(parameter);
    else if constexpr (std::is_same_v<Value, NumberRows>)
        value = std::get<NumberRows>(parameter.value);
    else if constexpr (std::is_same_v<Value, std::vector<double>>)
        for (auto const& row : std::get<NumberRows>(parameter.value))
            value.push_back(row.front() * unit);
    else
        value = static_cast<Value>(number(parameter) * unit);
}

template <class Value>
void take(std::optional<Value>& value, Parameter const& parameter, double unit)
{
    take(value.emplace(), parameter, unit);
}

void take(FamilyChoice& choice, Parameter const& parameter, double /*unit*/)
{
    choice.family = word(parameter);
    choice.line = parameter.line;
}

/// The reverse of take(); nothing for an empty list, which is an absent one.
template <class Value>
std::optional<ParameterValue> give(Value const& value, double unit)
{
    if constexpr (Worded<Value>) {
        auto const at = static_cast<std::size_t>(value);
        return std::string(at < words_of<Value>.size() ? words_of<Value>[at] : "?");
    } else if constexpr (std::is_same_v<Value, NumberRows>) {
        return value.empty() ? std::nullopt : std::optional<ParameterValue>(value);
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
        NumberRows rows;
        for (double const each : value)
            rows.push_back({each / unit});
        return give(rows, unit);
    } else if constexpr (std::is_arithmetic_v<Value>) {
        return static_cast<double>(value) / unit;
    } else {
        return value;
    }
}

template <class Value>
std::optional<ParameterValue> give(std::optional<Value> const& value, double unit)
{
    return value ? give(*value, unit) : std::nullopt;
}

/// The name of a family is checked where the family is made.
std::optional<ParameterValue> give(FamilyChoice const& /*choice*/, double /*unit*/)
{
    return {};
}

/// The member of @p object at the end of the path @p first, @p rest; an object of its own on the way is there.
template <auto first, auto... rest>
auto& member(auto& object)
{
    auto& value = object.*first;
    if constexpr (sizeof...(rest) == 0)
        return value;
    else if constexpr (requires { value.has_value(); })
        return member<rest...>(*value);
    else
        return member<rest...>(value);
}

/// The same of an object that may be absent on the way; then null.
template <auto first, auto... rest>
auto const* member_if_any(auto const& object)
{
    auto const& value = object.*first;
    if constexpr (sizeof...(rest) == 0)
        return &value;
    else if constexpr (requires { value.has_value(); })
        return value ? member_if_any<rest...>(*value) : nullptr;
    else
        return member_if_any<rest...>(value);
}

/// Where the members @p path lead, those of Scene first. @tparam unit  of the key, in that of the library
template <double const& unit, auto... path>
constexpr SceneMember in_unit{
    [](Scene& scene, Parameter const& parameter) { take(member<path...>(scene), parameter, unit); },
    [](Scene const& scene) {
        auto const* const value = member_if_any<path...>(scene);
        return value != nullptr ? give(*value, unit) : std::nullopt;
    }};

template <auto... path>
constexpr SceneMember to = in_unit<no_unit, path...>;

template <auto... path>
constexpr SceneMember to_rad = in_unit<deg, path...>;

template <auto... path>
constexpr SceneMember to_torque = in_unit<newton_metre, path...>;

template <auto member_of_cup>
constexpr SceneMember to_cup = to<&Scene::flexspline, &Flexspline::cup, member_of_cup>;

/// The same of a number that is 0 where it is absent.
template <auto... path>
constexpr SceneMember to_unless_0{to<path...>.store, [](Scene const& scene) {
                                      auto const value = to<path...>.read(scene);
                                      return value == ParameterValue(0.0) ? std::nullopt : value;
                                  }};

/// Makes the object of an effect.
template <auto... path>
void begin(Scene& scene, int line)
{
    member<path...>(scene).emplace().line = line;
}

ParameterSpec required(std::string_view key, Q quantity, std::string_view meaning, double at_least = -infinity,
                       double at_most = infinity)
{
    return {key, quantity, meaning, true, at_least, at_most};
}

ParameterSpec optional(std::string_view key, Q quantity, std::string_view meaning, double at_least = -infinity,
                       double at_most = infinity)
{
    return {key, quantity, meaning, false, at_least, at_most};
}

ParameterSpec choice(std::string_view key, std::string_view meaning, std::vector<std::string_view> words,
                     bool is_required)
{
    return with_words({key, Q::word, meaning, is_required}, std::move(words));
}

/// A key whose value is one of an enumeration's words.
template <Worded Enumeration>
ParameterSpec choice(std::string_view key, std::string_view meaning, bool is_required)
{
    return choice(key, meaning, {words_of<Enumeration>.begin(), words_of<Enumeration>.end()}, is_required);
}

std::vector<KeySpec> drive()
{
    return {{optional("name", Q::text, "name of the drive, for results and file names"), "\"type-50\"",
             to<&Scene::drive, &Drive::name>, "unnamed"},
            {required("module", Q::positive_length, "module", bounds::least_module, bounds::largest_module), "0.25",
             to<&Scene::drive, &Drive::module>},
            {required("flexspline_teeth", Q::count, "teeth of the flexspline, z_f", bounds::fewest_teeth,
                      bounds::most_teeth),
             "200", to<&Scene::drive, &Drive::flexspline_teeth>},
            {required("circular_spline_teeth", Q::count,
                      "teeth of the circular spline, z_c: flexspline_teeth plus a positive multiple of waves",
                      bounds::fewest_teeth, bounds::most_teeth),
             "202", to<&Scene::drive, &Drive::circular_spline_teeth>}};
}

std::vector<KeySpec> flexspline()
{
    return {
        {required("wall", Q::positive_length, "wall thickness under the teeth, delta"), "0.7",
         to<&Scene::flexspline, &Flexspline::wall>},
        {optional("inner_radius", Q::positive_length,
                  "inner radius of the undeformed ring; absent: module * flexspline_teeth / 2 - dedendum - wall"),
         "23.997", to<&Scene::flexspline, &Flexspline::inner_radius>},
        {optional("neutral_offset", Q::length, "how far the neutral layer lies inside the middle of the wall"), "0.15",
         to<&Scene::flexspline, &Flexspline::neutral_offset>, 0.0},
        {optional("addendum", Q::positive_length,
                  "height of the solved tooth's tip above the pitch line, h_a; with [circular_spline.profile] only"),
         "0.225", to<&Scene::flexspline, &Flexspline::addendum>},
        {optional("dedendum", Q::positive_length,
                  "depth of its root below the pitch line, h_f; with [circular_spline.profile] only"),
         "0.303", to<&Scene::flexspline, &Flexspline::dedendum>}};
}

std::vector<KeySpec> cup()
{
    return {
        {required("length", Q::positive_length, "from the outer face of the bottom to the open end"), "15.0",
         to_cup<&Cup::length>},
        {required("barrel_wall", Q::positive_length,
                  "wall thickness of the barrel behind the teeth and of the land in front of them"),
         "0.4", to_cup<&Cup::barrel_wall>},
        {required("bottom", Q::positive_length, "thickness of the bottom"), "0.5", to_cup<&Cup::bottom>},
        {required("corner_radius", Q::positive_length, "outer fillet between bottom and barrel"), "2.0",
         to_cup<&Cup::corner_radius>},
        {required("flange_radius", Q::positive_length, "of the flange: inside it the bottom does not move"), "13.0",
         to_cup<&Cup::flange_radius>},
        {required("tooth_width", Q::positive_length, "width of the toothed ring"), "8.0", to_cup<&Cup::tooth_width>},
        {optional("front_land", Q::nonnegative_length, "from the teeth to the open end"), "2.0",
         to_cup<&Cup::front_land>, 0.0},
        {optional("rear_ramp", Q::nonnegative_length,
                  "length over which the barrel's wall grows to that under the teeth; absent: as long as it grows"),
         "0.4", to_cup<&Cup::rear_ramp>},
        {optional("front_ramp", Q::nonnegative_length, "the same in front of the teeth"), "0.4",
         to_cup<&Cup::front_ramp>},
        {optional("rear_fillet", Q::positive_length,
                  "radius of an arc in place of that ramp, tangent to the barrel; absent: the straight ramp"),
         "0.5", to_cup<&Cup::rear_fillet>},
        {optional("front_fillet", Q::positive_length, "the same in front of the teeth"), "0.5",
         to_cup<&Cup::front_fillet>},
        {optional("tooth_layer", Q::positive_length,
                  "effect: height of the teeth, which stiffen their ring along the axis as a layer on it; absent: they "
                  "do not"),
         "0.53", to_cup<&Cup::tooth_layer>},
        {optional("tooth_share", Q::number, "of that layer that is steel; with tooth_layer only",
                  bounds::least_tooth_share, 1),
         "0.5", to_cup<&Cup::tooth_share>, 0.5},
        {optional("youngs_modulus", Q::number, "of the flexspline's steel, in MPa", bounds::least_modulus,
                  bounds::largest_modulus),
         "206000", to_cup<&Cup::youngs_modulus>, 206000.0},
        {optional("poissons_ratio", Q::number, "of the flexspline's steel", 0, bounds::largest_poissons_ratio), "0.3",
         to_cup<&Cup::poissons_ratio>, 0.3},
        {optional("fatigue_strength", Q::number,
                  "alternating bending that the flexspline's steel endures, in MPa; for the judgement",
                  bounds::least_strength, bounds::largest_strength),
         "550", to_cup<&Cup::fatigue_strength>, usual_fatigue_strength}};
}

std::vector<KeySpec> profile()
{
    return {{required("family", Q::word, "tooth family; decides the other keys of this table"),
             "\"double-circular-arc\"", to<&Scene::flexspline, &Flexspline::profile>}};
}

std::vector<KeySpec> wave_generator()
{
    return {{required("family", Q::word, "wave generator family; decides the other keys of this table"), "\"cosine\"",
             to<&Scene::wave_generator, &WaveGenerator::shape>},
            {optional("waves", Q::count, "waves around the circumference, n", 1, bounds::most_waves), "2",
             to<&Scene::wave_generator, &WaveGenerator::waves>, 2.0}};
}

std::vector<KeySpec> circular_spline()
{
    return {
        {optional("width", Q::positive_length, "axial width of the toothing; needed by [slices] with count above 1"),
         "7.0", to<&Scene::circular_spline, &CircularSpline::width>},
        {with_words(optional("backlash_offset", Q::length_or_word,
                             "side clearance along the normal of the flank; \"auto\": the smallest without "
                             "interference in any slice over a full turn",
                             0),
                    {"auto"}),
         "0.02",
         {[](Scene& s, Parameter const& p) {
              bool const automatic = std::holds_alternative<std::string>(p.value);
              s.circular_spline.automatic_backlash = automatic;
              s.circular_spline.backlash_offset = automatic ? 0.0 : number(p);
          },
          [](Scene const& s) {
              return s.circular_spline.automatic_backlash ? "auto" : give(s.circular_spline.backlash_offset, no_unit);
          }},
         0.0},
        {optional("root_clearance", Q::nonnegative_length, "extra depth of the tooth space"), "0.02",
         to<&Scene::circular_spline, &CircularSpline::root_clearance>, 0.0},
        {optional("inner_radius", Q::positive_length,
                  "tip circle; absent: neutral radius + height of the pitch line + radial deformation - addendum of "
                  "the given tooth"),
         "25.025", to<&Scene::circular_spline, &CircularSpline::inner_radius>},
        {optional("youngs_modulus", Q::number, "of the circular spline's steel, in MPa; for load and run",
                  bounds::least_modulus, bounds::largest_modulus),
         "210000", to<&Scene::circular_spline, &CircularSpline::youngs_modulus>, 210000.0},
        {optional("poissons_ratio", Q::number, "of the circular spline's steel; for load and run", 0,
                  bounds::largest_poissons_ratio),
         "0.3", to<&Scene::circular_spline, &CircularSpline::poissons_ratio>, 0.3}};
}

std::vector<KeySpec> circular_spline_profile()
{
    return {{required("family", Q::word, "tooth family; decides the other keys of this table"),
             "\"double-circular-arc\"",
             {[](Scene& s, Parameter const& p) { take(*s.circular_spline.profile, p, no_unit); }}}};
}

std::vector<KeySpec> solver()
{
    return {{choice<Kinematics>("kinematics",
                                "relative motion: inextensible neutral curve, its first order, or the linear "
                                "inextensional mode of the points of the ring",
                                false),
             "\"exact\"", to<&Scene::solver, &Solver::kinematics>, "exact"},
            {optional("tolerance", Q::positive_length,
                      "largest distance between a written outline and the true one; at most module / 10",
                      bounds::least_tolerance),
             "1e-6", to<&Scene::solver, &Solver::tolerance>, 1e-6},
            {optional("threads", Q::count, "threads; 0: all cores, at most OMP_NUM_THREADS", 0, bounds::most_threads),
             "0", to<&Scene::solver, &Solver::threads>, 0.0}};
}

std::vector<KeySpec> coning()
{
    return {{choice<ConingModel>("model", "radial deformation linear along the axis, or that of the elastic cup", true),
             "\"linear\"", to<&Scene::coning, &Coning::model>},
            {optional("bottom_to_middle", Q::positive_length,
                      "from the cup's bottom to the middle of the bearing; needed by either model"),
             "9.0", to<&Scene::coning, &Coning::bottom_to_middle>},
            {optional("apex_height", Q::length,
                      "of the point that does not move, above the cup's bottom; model \"linear\" only"),
             "0.43", to<&Scene::coning, &Coning::apex_height>, 0.0},
            {choice<AxialShift>("axial_shift", "whether gaps take the wall's shift along the axis into account", false),
             "\"mapped\"", to<&Scene::coning, &Coning::axial_shift>, "mapped"}};
}

std::vector<KeySpec> joined(std::vector<KeySpec> keys, std::vector<KeySpec> const& more)
{
    keys.insert(keys.end(), more.begin(), more.end());
    return keys;
}

/// Keys of the balls and their grooves.
std::vector<KeySpec> ball_contact()
{
    return {{optional("ball_diameter", Q::positive_length,
                      "effect: each ball yields by Hertz between its grooves, F = k d^1.5; for load and run, with "
                      "balls; absent: as radial_stiffness says"),
             "3.0", to<&Scene::bearing, &BearingChoice::ball_diameter>},
            {optional("inner_conformity", Q::number,
                      "radius of the groove in the inner ring over the ball diameter; with ball_diameter only",
                      bounds::least_conformity, bounds::largest_conformity),
             "0.52", to<&Scene::bearing, &BearingChoice::inner_conformity>, 0.52},
            {optional("outer_conformity", Q::number, "the same of the outer ring; with ball_diameter only",
                      bounds::least_conformity, bounds::largest_conformity),
             "0.52", to<&Scene::bearing, &BearingChoice::outer_conformity>, 0.52},
            {optional("clearance", Q::nonnegative_length,
                      "effect: diametral play of the bearing by itself, as ISO 5753 counts it; for load and run; "
                      "type \"elastic\" only"),
             "0.005", to<&Scene::bearing, &BearingChoice::clearance>, 0.0},
            {optional("youngs_modulus", Q::number, "of the steel of both rings, in MPa; type \"elastic\" only",
                      bounds::least_modulus, bounds::largest_modulus),
             "206000", to<&Scene::bearing, &BearingChoice::youngs_modulus>, 206000.0},
            {optional("poissons_ratio", Q::number, "of the steel of both rings; type \"elastic\" only", 0,
                      bounds::largest_poissons_ratio),
             "0.3", to<&Scene::bearing, &BearingChoice::poissons_ratio>, 0.3},
            {optional("ball_youngs_modulus", Q::number, "of the balls, in MPa; with ball_diameter only",
                      bounds::least_modulus, bounds::largest_modulus),
             "206000", to<&Scene::bearing, &BearingChoice::ball_youngs_modulus>, 206000.0},
            {optional("ball_poissons_ratio", Q::number, "of the balls; with ball_diameter only", 0,
                      bounds::largest_poissons_ratio),
             "0.3", to<&Scene::bearing, &BearingChoice::ball_poissons_ratio>, 0.3}};
}

std::vector<KeySpec> bearing()
{
    return {{choice("type", "surface of the cam's shape, or outer ring that bends on its balls", {"rigid", "elastic"},
                    true),
             "\"elastic\"",
             {[](Scene& s, Parameter const& p) { s.bearing->elastic = word(p) == "elastic"; },
              [](Scene const& s) {
                  return s.bearing ? std::optional<ParameterValue>(s.bearing->elastic ? "elastic" : "rigid")
                                   : std::nullopt;
              }}},
            {required("width", Q::nonnegative_length,
                      "over which the cup may touch it, its middle at z = 0; 0: one line, type \"rigid\" only"),
             "6.0", to<&Scene::bearing, &BearingChoice::width>},
            {optional("ring_thickness", Q::positive_length, "of the outer ring; needed by type \"elastic\""), "1.2",
             to<&Scene::bearing, &BearingChoice::ring_thickness>},
            {optional("fit", Q::length, "interference: outer radius of the bearing less inner radius of the cup"),
             "0.005", to<&Scene::bearing, &BearingChoice::fit>, 0.0},
            {optional("cam_oversize", Q::length,
                      "how much larger the cam's radius is than the balls need, all round: their preload"),
             "0.002", to<&Scene::bearing, &BearingChoice::cam_oversize>, 0.0},
            {optional("radial_stiffness", Q::number,
                      "of the balls as a continuous row, in N/mm per mm of arc; absent: rigid; type \"elastic\" only",
                      bounds::least_stiffness, bounds::largest_stiffness),
             "2000", to<&Scene::bearing, &BearingChoice::radial_stiffness>},
            {choice("axially", "whether the groove holds the balls along the axis; type \"elastic\" only",
                    {"held", "free"}, false),
             "\"held\"",
             {[](Scene& s, Parameter const& p) { s.bearing->axially_held = word(p) == "held"; }},
             "held"},
            {optional("balls", Q::count,
                      "how many; for load and run, which press the ring outward at each of them; absent: a "
                      "continuous row; type \"elastic\" only",
                      1, bounds::most_balls),
             "23", to<&Scene::bearing, &BearingChoice::balls>},
            {optional("ball_phase_deg", Q::angle_deg, "angle of one ball from the major axis, clockwise"), "7.5",
             to_rad<&Scene::bearing, &BearingChoice::ball_phase>, 0.0},
            {optional("angles", Q::count, "points in a lobe where bearing and cup may touch, an even number",
                      bounds::fewest_angles, bounds::most_angles),
             "48", to<&Scene::bearing, &BearingChoice::angles>, 48.0},
            {optional("circles", Q::count, "circles of such points over the width, its edges included",
                      bounds::fewest_circles, bounds::most_circles),
             "13", to<&Scene::bearing, &BearingChoice::circles>, 13.0}};
}

/// A torsional stiffness in series with the teeth.
template <auto member_of_compliance>
KeySpec in_series(std::string_view key, std::string_view meaning, std::string_view example)
{
    return {optional(key, Q::number, meaning, bounds::least_torsional_stiffness, bounds::largest_torsional_stiffness),
            example, to_torque<&Scene::compliance, member_of_compliance>};
}

std::vector<KeySpec> compliance()
{
    return {
        in_series<&Compliance::flange>(
            "flange", "torsional stiffness of the cup's flange and its screws, in N m/rad; absent: rigid", "200000"),
        in_series<&Compliance::hub>("hub", "of the hub that the flange is fixed to, in N m/rad; absent: rigid",
                                    "300000"),
        in_series<&Compliance::shaft>("shaft", "of the shaft that carries the torque on, in N m/rad; absent: rigid",
                                      "60000"),
        {optional("outer_radius", Q::positive_length,
                  "where the circular spline is held: its body yields as a disc from the root circle to there; absent: "
                  "rigid"),
         "35.0", to<&Scene::compliance, &Compliance::outer_radius>}};
}

std::vector<KeySpec> tilt()
{
    return {{required("angle_deg", Q::angle_deg, "tilt angle, between -45 and 45 degrees"), "0.2",
             to_rad<&Scene::tilt, &Tilt::angle>},
            {choice<TiltKind>("kind", "outline moved radially, or offset along its normal", false), "\"radial\"",
             to<&Scene::tilt, &Tilt::kind>, "radial"}};
}

std::vector<KeySpec> slices()
{
    return {{required("count", Q::count, "number of slices", 1, bounds::most_slices), "9",
             to<&Scene::slices, &Slices::count>},
            {choice<ToothSurface>("surface", "how the tooth surface follows from the slices", false), "\"tilted\"",
             to<&Scene::slices, &Slices::surface>, "tilted"}};
}

std::vector<KeySpec> tip_relief()
{
    return {{required("amount", Q::nonnegative_length, "at the tip, along the normal of the flank"), "0.004",
             to<&Scene::tip_relief, &TipRelief::amount>},
            {required("from_height", Q::length,
                      "height above the pitch line at which it begins; from there it grows with the square"),
             "0.1", to<&Scene::tip_relief, &TipRelief::from_height>}};
}

std::vector<KeySpec> flow()
{
    return {
        {required("pressure", Q::number,
                  "mean over the strip in contact, in MPa: about three times the yield strength of the softer flank",
                  bounds::least_flow_pressure, bounds::largest_flow_pressure),
         "2700", to<&Scene::flow, &Flow::pressure>}};
}

std::vector<KeySpec> end_relief()
{
    return {{required("amount", Q::nonnegative_length, "at both ends, along the normal of the flank"), "0.004",
             to<&Scene::end_relief, &EndRelief::amount>},
            {required("length", Q::positive_length,
                      "of the face width at each end over which it grows with the square; at most half the width",
                      bounds::least_length),
             "2.0", to<&Scene::end_relief, &EndRelief::length>}};
}

std::vector<KeySpec> errors()
{
    return {{optional("seed", Q::count, "of the random places of teeth", 0, bounds::largest_seed), "1",
             to<&Scene::errors, &Errors::seed>, 0.0},
            {optional("profile_slope", Q::length,
                      "of the flexspline's flanks: how much more material the tip has than the root; none at the pitch "
                      "line"),
             "0.002", to<&Scene::errors, &Errors::profile_slope>, 0.0},
            {with_words(optional("profile_form", Q::rows,
                                 "of the flexspline's flanks: heights above the pitch line and the material there "
                                 "beyond the slope",
                                 bounds::fewest_form_rows, bounds::most_rows),
                        {"[height, excess]", row_file}),
             "[[-0.3, 0], [-0.1, 0.001], [0.1, 0.001], [0.2, 0]]", to<&Scene::errors, &Errors::profile_form>}};
}

/// What the heights of a ring's profile are, in words.
struct ProfileWords
{
    std::string_view slope, form;
};

constexpr ProfileWords flexspline_profile{
    "of its flanks: the same as errors.profile_slope",
    "of its flanks: the same as errors.profile_form",
};
constexpr ProfileWords spline_profile{
    "of its flanks: how much more material the tip has than the root; none at the pitch circle, m z_c/2",
    "of its flanks: heights from the pitch circle towards the axis and the material there beyond the slope",
};

template <auto ring>
std::vector<KeySpec> ring_errors(ProfileWords const& profile)
{
    return {
        {optional("pitch_deviation", Q::nonnegative_length,
                  "standard deviation of the random places of teeth along the pitch circle"),
         "0.002", to<&Scene::errors, ring, &RingErrors::pitch_deviation>, 0.0},
        {with_words(optional("pitch", Q::rows,
                             "the place of each tooth along the pitch circle, clockwise, from tooth 0 on; in place "
                             "of pitch_deviation",
                             1, bounds::most_rows),
                    {"[place]", row_file}),
         "[0.001, -0.002]", to<&Scene::errors, ring, &RingErrors::pitch>},
        {optional("eccentricity", Q::nonnegative_length, "of the ring of teeth against its axis"), "0.005",
         to<&Scene::errors, ring, &RingErrors::eccentricity>, 0.0},
        {optional("eccentricity_phase_deg", Q::angle_deg, "where the ring stands out, clockwise from its tooth 0"),
         "30", to_rad<&Scene::errors, ring, &RingErrors::eccentricity_phase>, 0.0},
        {optional("wobble_deg", Q::angle_deg,
                  "between the axis of the ring of teeth and that of the drive, which cross in the middle of the "
                  "face width",
                  0, bounds::largest_wobble_deg),
         "0.02", to_rad<&Scene::errors, ring, &RingErrors::wobble>, 0.0},
        {optional("wobble_phase_deg", Q::angle_deg,
                  "where the ring stands out at the cup's open end, clockwise from its tooth 0"),
         "30", to_rad<&Scene::errors, ring, &RingErrors::wobble_phase>, 0.0},
        {optional("profile_slope", Q::length, profile.slope), "0.002",
         to<&Scene::errors, ring, &RingErrors::profile_slope>, 0.0},
        {with_words(optional("profile_form", Q::rows, profile.form, bounds::fewest_form_rows, bounds::most_rows),
                    {"[height, excess]", row_file}),
         "[[-0.3, 0], [-0.1, 0.001], [0.1, 0.001], [0.2, 0]]", to<&Scene::errors, ring, &RingErrors::profile_form>}};
}

std::vector<KeySpec> wave_generator_errors()
{
    return {{optional("eccentricity", Q::nonnegative_length,
                      "of cam and bearing against the axis of the drive, which the shaft keeps"),
             "0.005", to<&Scene::errors, &Errors::wave_generator, &WaveGeneratorErrors::eccentricity>, 0.0},
            {optional("eccentricity_phase_deg", Q::angle_deg, "where it stands out, clockwise from its major axis"),
             "30", to_rad<&Scene::errors, &Errors::wave_generator, &WaveGeneratorErrors::eccentricity_phase>, 0.0},
            {with_words(optional("cam_deviation", Q::rows,
                                 "angles clockwise from the major axis, over a whole turn, and the radial excess there",
                                 bounds::fewest_form_rows, bounds::most_rows),
                        {"[angle_deg, excess]", row_file}),
             "[[0, 0.002], [90, 0], [180, -0.001], [270, 0]]",
             {[](Scene& s, Parameter const& p) {
                  for (auto const& row : std::get<NumberRows>(p.value))
                      s.errors->wave_generator->cam_deviation.push_back({row[0] * deg, row[1]});
              },
              to<&Scene::errors, &Errors::wave_generator, &WaveGeneratorErrors::cam_deviation>.read}}};
}

std::vector<KeySpec> contact()
{
    return {{optional("contact_gap", Q::positive_length, "gap up to which flanks count as in contact",
                      bounds::least_length),
             "0.001", to<&Scene::contact, &ContactRequest::gap>, 0.001},
            {optional("flank_points", Q::count, "points along each flank", bounds::fewest_flank_points,
                      bounds::most_flank_points),
             "200", to<&Scene::contact, &ContactRequest::flank_points>, 200.0},
            {optional("wave_generator_angle_deg", Q::angle_deg, "from the centre line of a tooth space", -360, 360),
             "0", to_rad<&Scene::contact, &ContactRequest::wave_generator>, 0.0}};
}

std::vector<KeySpec> load()
{
    return {
        {optional("torque", Q::number, "rated torque on the circular spline, in N m", bounds::least_torque,
                  bounds::largest_torque),
         "28.0", to_torque<&Scene::load, &LoadRequest::torque>},
        {optional("points", Q::count, "torques from 0 to the rated one; absent: as many as the stiffness needs", 1,
                  bounds::most_torques),
         "10", to_unless_0<&Scene::load, &LoadRequest::points>},
        {optional("first_torque", Q::number, "T1 in N m: K1 is the stiffness from 0 to T1; absent: 0.175 of the rated",
                  bounds::least_torque, bounds::largest_torque),
         "5.0", to_torque<&Scene::load, &LoadRequest::first_torque>},
        {optional("second_torque", Q::number,
                  "T2 in N m: K2 is the stiffness from T1 to T2, K3 from T2 on; absent: 0.625 of the rated",
                  bounds::least_torque, bounds::largest_torque),
         "17.5", to_torque<&Scene::load, &LoadRequest::second_torque>},
        {optional("harmonics", Q::count,
                  "highest harmonic around the circumference; not all drives resolve 400, and a message says how many",
                  bounds::fewest_harmonics, bounds::most_harmonics),
         "100", to<&Scene::load, &LoadRequest::harmonics>, 100.0},
        {optional("edge_radius", Q::positive_length,
                  "of the edges where teeth touch under load, at most a quarter of the module; absent: 1/25 of it",
                  bounds::least_length),
         "0.01", to<&Scene::load, &LoadRequest::edge_radius>}};
}

std::vector<KeySpec> running()
{
    auto const list = [](std::string_view key, std::string_view meaning, std::string_view form) {
        return with_words(optional(key, Q::rows, meaning, 1, bounds::most_running_values), {form});
    };
    return {
        {choice<RunningMember>("output", "the member that turns at the output; the other one is held", false),
         "\"flexspline\"", to<&Scene::running, &RunRequest::output>, "flexspline"},
        {optional("positions", Q::count, "of the wave generator over one tooth pitch; absent: 16",
                  bounds::fewest_positions, bounds::most_positions),
         "16", to_unless_0<&Scene::running, &RunRequest::positions>},
        {list("torques", "on the output in N m, of the efficiency; absent: 10, 25, 50 and 100 % of the largest torque",
              "[torque]"),
         "[5, 14, 28]", to_torque<&Scene::running, &RunRequest::torques>},
        {list("speeds", "of the wave generator in rpm, of the efficiency; absent: 500, 1000, 2000 and 3500", "[speed]"),
         "[500, 2000]", in_unit<rpm, &Scene::running, &RunRequest::speeds>},
        {list("temperatures", "of the lubricant in degrees Celsius, of the efficiency; absent: 40", "[temperature]"),
         "[0, 40]", to<&Scene::running, &RunRequest::temperatures>}};
}

std::vector<KeySpec> friction()
{
    return {
        {required("flanks", Q::number, "coefficient of sliding flanks", 0, bounds::largest_friction), "0.08",
         to<&Scene::friction, &Friction::flanks>},
        {optional("flanks_at_rest", Q::number,
                  "the same as the sliding speed goes to 0; absent: flanks, at every speed (Coulomb)", 0,
                  bounds::largest_friction),
         "0.12", to<&Scene::friction, &Friction::flanks_at_rest>},
        {optional("stribeck_speed", Q::number,
                  "sliding speed in mm/s at which the difference of both has fallen to 1/e; with flanks_at_rest", 0,
                  bounds::largest_speed),
         "20.0", to<&Scene::friction, &Friction::stribeck_speed>, 0.0},
        {optional("bearing_load", Q::number, "Palmgren's f1 of the wave generator's bearing: M1 = f1 P d_m", 0, 1),
         "0.0005", to<&Scene::friction, &Friction::bearing_load>, 0.0},
        {optional("bearing_speed", Q::number,
                  "Palmgren's f0 of the same: M0 = 1e-7 f0 (nu n)^(2/3) d_m^3, with both viscosities", 0,
                  bounds::largest_bearing_factor),
         "2.0", to<&Scene::friction, &Friction::bearing_speed>, 0.0},
        {optional("viscosity_40", Q::number, "kinematic, of the lubricant at 40 degrees Celsius, in mm^2/s",
                  bounds::least_viscosity, bounds::largest_viscosity),
         "100.0", to<&Scene::friction, &Friction::viscosity_40>},
        {optional("viscosity_100", Q::number, "the same at 100 degrees Celsius", bounds::least_viscosity,
                  bounds::largest_viscosity),
         "11.0", to<&Scene::friction, &Friction::viscosity_100>},
        {optional("seal", Q::number, "torque of the seals on the wave generator's shaft, in N m", 0,
                  bounds::largest_torque),
         "0.02", to_torque<&Scene::friction, &Friction::seal>, 0.0},
        {optional("churning", Q::number, "torque on that shaft for each 1000 rpm, in N m", 0, bounds::largest_torque),
         "0.004",
         {[](Scene& s, Parameter const& p) { s.friction->churning = number(p) * newton_metre / (1000 * rpm); },
          [](Scene const& s) {
              return s.friction ? give(s.friction->churning, newton_metre / (1000 * rpm)) : std::nullopt;
          }},
         0.0}};
}

std::vector<KeySpec> wedm()
{
    return {
        {required("wire_diameter", Q::positive_length, "of the wire; never assumed"), usual_wire,
         to<&Scene::wedm, &WireRequest::wire_diameter>},
        {required("spark_gap", Q::nonnegative_length, "between wire and part; never assumed"), usual_spark_gap,
         to<&Scene::wedm, &WireRequest::spark_gap>},
        {choice<WirePart>("part", "what is cut; the flexspline in two set-ups of half its teeth each", false),
         "\"circular-spline\"", to<&Scene::wedm, &WireRequest::part>, "circular-spline"},
        {optional(
             "thickness", Q::positive_length,
             "of the workpiece, its middle at z = 0; a thicker one has the same toothing, continued in straight lines; "
             "absent: circular_spline.width, for the flexspline flexspline.cup.tooth_width where there is a cup",
             -infinity, bounds::largest_workpiece),
         "7.0", to<&Scene::wedm, &WireRequest::thickness>},
        {optional("lower_guide", Q::nonnegative_length, "lower guide point of the wire below the lower face"), "20.0",
         to<&Scene::wedm, &WireRequest::lower_guide>, 20.0},
        {optional("upper_guide", Q::nonnegative_length, "upper guide point above the upper face"), "30.0",
         to<&Scene::wedm, &WireRequest::upper_guide>, 30.0},
        {with_words(
             optional(
                 "passes", Q::rows,
                 "stock that each pass leaves, in order; it decreases, and the last pass leaves 0; absent: one pass", 1,
                 bounds::most_passes),
             {"[length]"}),
         "[0.02, 0.005, 0]", to<&Scene::wedm, &WireRequest::stock>},
        {choice("direction", "whether every second pass runs against the first", {"same", "alternating"}, false),
         "\"same\"",
         {[](Scene& s, Parameter const& p) { s.wedm->alternating = word(p) == "alternating"; }},
         "same"},
        {optional(
             "start", Q::count,
             "tooth space where the path begins: the circular spline's in the middle of the tip land clockwise of it, "
             "the flexspline's in that counter-clockwise of it; 0 lies on the y axis, the others follow clockwise",
             0, bounds::most_teeth),
         "0", to<&Scene::wedm, &WireRequest::start>, 0.0},
        {optional("lead_in", Q::positive_length,
                  "from the centre of the start hole, inside the bore, to the tip land; for the flexspline from a "
                  "place outside the blank"),
         "3.0", to<&Scene::wedm, &WireRequest::lead_in>, 3.0},
        {optional("start_hole_radius", Q::positive_length, "of the hole that the wire is threaded through"), "0.5",
         to<&Scene::wedm, &WireRequest::start_hole_radius>, 0.5},
        {optional("overlap", Q::nonnegative_length,
                  "beyond the point where the contour closes, or where the other set-up takes over"),
         "0.0", to<&Scene::wedm, &WireRequest::overlap>, 0.0},
        {optional("stop_before", Q::nonnegative_length,
                  "first pass: stop this far before the contour ends and the slug drops; 0: no stop"),
         "1.0", to<&Scene::wedm, &WireRequest::stop_before>, 1.0},
        {choice<WireStop>("stop", "of stop_before: M0 always stops, M1 where the control's optional stop is on", false),
         "\"M0\"", to<&Scene::wedm, &WireRequest::stop>, "M0"},
        {optional("tolerance", Q::positive_length,
                  "largest distance of the cut from the nominal surface, apart from residual material",
                  bounds::least_tolerance),
         "0.0005", to<&Scene::wedm, &WireRequest::tolerance>, 0.0005},
        {optional("residual_limit", Q::nonnegative_length,
                  "material that the last pass may leave where the wire cannot follow, its error included: above the "
                  "tolerance"),
         "0.01", to<&Scene::wedm, &WireRequest::residual_limit>, 0.01},
        {optional("surface_limit", Q::nonnegative_length,
                  "accepted distance of the cut from the true surface between the faces, where that is not ruled or "
                  "too twisted for a straight wire; absent: tolerance"),
         "0.003", to<&Scene::wedm, &WireRequest::surface_limit>},
        {optional("largest_tilt_deg", Q::angle_deg, "of the wire that the machine can make", 0,
                  bounds::largest_tilt_deg),
         "30", to_rad<&Scene::wedm, &WireRequest::largest_tilt>, 30.0},
        {optional("largest_travel", Q::positive_length,
                  "of each axis of each guide from the start hole, either way; absent: not checked"),
         "100.0", to<&Scene::wedm, &WireRequest::largest_travel>},
        {optional("largest_uv_travel", Q::positive_length,
                  "of each axis of the upper guide against the lower one, either way; absent: not checked"),
         "20.0", to<&Scene::wedm, &WireRequest::largest_uv_travel>},
        {optional("decimals", Q::count, "of coordinates in mm in rounded files", bounds::fewest_decimals,
                  bounds::most_decimals),
         "4", to<&Scene::wedm, &WireRequest::decimals>, 4.0},
        {optional("dialects", Q::text, "files to write, names separated by blanks; empty: all that fit"), "\"\"",
         to<&Scene::wedm, &WireRequest::dialects>, ""}};
}

}  // namespace

std::vector<TableSpec> const& scene_schema()
{
    using enum Presence;
    static std::vector<TableSpec> const tables{
        {"drive", "the pair of gears", required, FamilyKind::none, nullptr, drive()},
        {"flexspline", "the toothed ring of the flexspline", required, FamilyKind::none, nullptr, flexspline()},
        {"flexspline.cup", "the cup that carries the toothed ring, for [coning] model \"elastic\"", effect,
         FamilyKind::none, begin<&Scene::flexspline, &Flexspline::cup>, cup()},
        {"flexspline.profile", "the flexspline tooth", alternative, FamilyKind::profile,
         [](Scene& s, int) { s.flexspline.profile.path = "flexspline.profile"; }, profile()},
        {"wave_generator", "what deforms the flexspline", required, FamilyKind::wave_generator,
         [](Scene& s, int) { s.wave_generator.shape.path = "wave_generator"; }, wave_generator()},
        {"circular_spline", "the circular spline", optional, FamilyKind::none, nullptr, circular_spline()},
        {"circular_spline.profile", "the circular spline's tooth, where the flexspline's is computed", alternative,
         FamilyKind::profile,
         [](Scene& s, int) { s.circular_spline.profile.emplace().path = "circular_spline.profile"; },
         circular_spline_profile()},
        {"solver", "how to compute", optional, FamilyKind::none, nullptr, solver()},
        {"coning", "effect: the cup cones along the axis", effect, FamilyKind::none, begin<&Scene::coning>, coning()},
        {"bearing", "the bearing between wave generator and cup, for [coning] model \"elastic\"", effect,
         FamilyKind::none, begin<&Scene::bearing>, joined(bearing(), ball_contact())},
        {"compliance", "effect: members in series with the teeth that yield in torsion, for the verb load", effect,
         FamilyKind::none, begin<&Scene::compliance>, compliance()},
        {"tilt", "effect: tilted teeth of the circular spline", effect, FamilyKind::none, begin<&Scene::tilt>, tilt()},
        {"slices", "effect: slices across the face width", effect, FamilyKind::none, begin<&Scene::slices>, slices()},
        {"tip_relief", "effect: the flexspline's flanks stand back towards the tips; for load and run", effect,
         FamilyKind::none, begin<&Scene::tip_relief>, tip_relief()},
        {"end_relief", "effect: flanks stand back towards both ends of the face width; for load and run", effect,
         FamilyKind::none, begin<&Scene::end_relief>, end_relief()},
        {"flow", "effect: the steel of the flanks flows under a contact pressure; for load and run", effect,
         FamilyKind::none, begin<&Scene::flow>, flow()},
        {"errors", "effect: errors of making and assembly; for load and run", effect, FamilyKind::none,
         begin<&Scene::errors>, errors()},
        {"errors.flexspline", "effect: errors of the flexspline's ring of teeth", effect, FamilyKind::none,
         begin<&Scene::errors, &Errors::flexspline>, ring_errors<&Errors::flexspline>(flexspline_profile)},
        {"errors.circular_spline", "effect: errors of the circular spline's ring of teeth", effect, FamilyKind::none,
         begin<&Scene::errors, &Errors::circular_spline>, ring_errors<&Errors::circular_spline>(spline_profile)},
        {"errors.wave_generator", "effect: errors of the wave generator", effect, FamilyKind::none,
         begin<&Scene::errors, &Errors::wave_generator>, wave_generator_errors()},
        {"contact", "settings of the verb contact", effect, FamilyKind::none, begin<&Scene::contact>, contact()},
        {"load", "settings of the verb load", effect, FamilyKind::none, begin<&Scene::load>, load()},
        {"running", "settings of the verb run", effect, FamilyKind::none, begin<&Scene::running>, running()},
        {"friction", "effect: what the drive loses while it runs; for the verb run", effect, FamilyKind::none,
         begin<&Scene::friction>, friction()},
        {"wedm", "settings of the verb wedm: a part cut by wire", effect, FamilyKind::none, begin<&Scene::wedm>,
         wedm()}};
    return tables;
}

}  // namespace hdconj::scene
