// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_figures.hpp"

#include <algorithm>
#include <array>

#include "joined_tables.hpp"
#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

template <class Row>
constexpr Row json_only(Row const& row)
{
    return row.without(hdf5);
}

/// A figure whose error is the same member of the state that holds the errors.
template <auto member>
constexpr auto estimated(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    return figure<member>(name, unit, meaning, text).with_error_apart();
}

constexpr Text general(char const* label)
{
    return {label, table_number, two_digits};
}

constexpr auto twist_figures()
{
    using T = LoadedState;
    return std::array{
        figure<&T::torque>("torque", newton_metre, "torque on the circular spline"),
        estimated<&T::twist>("twist", arcmin, "of the circular spline, from the middle of the backlash",
                             {"twist", fixed<2>, significant<2>}),
        estimated<&T::stiffness>("stiffness", newton_metre_per_rad, "stiffness, dT/d(twist)",
                                 {"stiffness", table_number, two_digits, &newton_metre_per_degree}),
        json_only(estimated<&T::stiffness>("stiffness", newton_metre_per_degree, "the same")),
        estimated<&T::contact_area>("contact_area", mm2, "flank area under pressure"),
        estimated<&T::contact_fraction>("contact_fraction", one, "fraction of all flanks on the loaded side",
                                        {"contact", significant<3>, significant<2>, &percent})
            .formerly("contact_share"),
        estimated<&T::fraction_within_gap>("fraction_within_gap", one,
                                           "fraction of the flank with a gap up to the contact gap",
                                           {"within", significant<3>, significant<2>, &percent})
            .formerly("near_share"),
        estimated<&T::carrying_fraction>("carrying_fraction", one,
                                         "fraction of the pairs of tooth space and slice that carry")
            .formerly("node_share")};
}

constexpr auto force_figures()
{
    using T = LoadedState;
    return std::array{
        estimated<&T::largest_pressure>("largest_pressure", megapascal,
                                        "largest Hertz pressure, of edges with their radius",
                                        {"pressure", table_number, table_number}),
        figure<&T::pressure_z>("pressure_z", mm, "slice of the largest pressure", {"z", fixed<3>}),
        estimated<&T::largest_force>("largest_force", newton, "largest force on one tooth",
                                     {"force", table_number, two_digits}),
        estimated<&T::largest_line_load>("largest_line_load", newton_per_mm,
                                         "largest mean line load over half a millimetre of a flank's width",
                                         {"line load", table_number, two_digits}),
        estimated<&T::flank_pressure>("flank_pressure", megapascal,
                                      "largest Hertz pressure away from edges and ends of the face width",
                                      {"pressure", table_number, two_digits}),
        estimated<&T::edge_force>("edge_force", newton, "largest force that edges and ends of one flank carry",
                                  {"edges", table_number, two_digits}),
        estimated<&T::edge_fraction>("edge_fraction", one, "fraction of the force of all flanks on edges and ends",
                                     {"edges", significant<3>, significant<2>, &percent}),
        estimated<&T::flowing_fraction>("flowing_fraction", one,
                                        "fraction of the force of all flanks where the steel flows",
                                        {"flows", significant<3>, significant<2>, &percent})};
}

constexpr auto bearing_figures(Unit const& ball)
{
    using T = LoadedState;
    return std::array{
        estimated<&T::wave_generator_force>("wave_generator_force", newton,
                                            "sum of the bearing's forces on the cup, without direction"),
        estimated<&T::wave_generator_torque>("wave_generator_torque", newton_metre, "torque on the wave generator",
                                             {"wave generator", significant<4>, two_digits}),
        estimated<&T::lobe_force>("lobe_force", newton,
                                  "resultant of the bearing over the lobe at the major axis, along that axis",
                                  general("along")),
        estimated<&T::lobe_force_across>("lobe_force_across", newton,
                                         "resultant of the bearing over that lobe across its axis, clockwise",
                                         general("across")),
        estimated<&T::lobe_z>("lobe_z", mm, "height at which the resultant acts", {"at z", fixed<2>, two_digits}),
        figure<&T::ball_phi>("ball_phi", given_degree, "angle of the ball that is pressed most",
                             {"at", fixed<1>, nullptr, &degree}),
        estimated<&T::largest_stress>("largest_stress", megapascal, "largest von Mises stress of the cup",
                                      {"stress", table_number, table_number}),
        figure<&T::stress_z>("stress_z", mm, "height of the largest stress", {"z", fixed<2>}),
        figure<&T::stress_r>("stress_r", mm, "radius of the largest stress", {"r", fixed<2>}),
        figure<&T::stress_phi>("stress_phi", given_degree, "angle of the largest stress from the major axis",
                               {"phi", fixed<1>, nullptr, &degree}),
        figure<&T::gap_mismatch>("gap_mismatch", um, "gap solved for less that of the loaded shape, at contacts",
                                 {"gap", significant<2>})
            .formerly("residual"),
        figure<&T::complementarity>("complementarity", one, "largest product of force and gap, relative",
                                    {"force and gap", exponential<1>}),
        estimated<&T::ball_force>("ball_force", ball, "largest force of a ball, or per length of a continuous row",
                                  general("balls")),
        estimated<&T::balls>("balls", one, "single balls that carry", {"carry", whole, whole}),
        estimated<&T::teeth>("teeth", one, "tooth spaces that carry", {"teeth", whole, whole}),
        figure<&T::pressure_space>("pressure_space", one, "tooth space of the largest pressure"),
        figure<&T::iterations>("iterations", one, "of the loaded shape").formerly("rounds"),
        figure<&T::steps>("steps", one, "steps of the active set")};
}

/// A figure whose error is another member of the record and stands apart.
template <auto member, auto error>
constexpr auto estimate_of(char const* name, Unit const& unit, char const* meaning, Text const& text)
{
    return figure<member>(name, unit, meaning, text).with_error_apart(path::number<error>);
}

constexpr auto cup_figures(Unit const& ball)
{
    using T = AssembledCup;
    return std::array{
        estimate_of<&T::coning_major, &T::coning_major_error>(
            "coning_major", given_degree, "slope of the radial displacement over the slices at the major axis",
            {"coning, major axis", fixed<4>, two_digits, &degree}),
        estimate_of<&T::coning_minor, &T::coning_minor_error>("coning_minor", given_degree,
                                                              "the same at the minor axis",
                                                              {"coning, minor axis", fixed<4>, two_digits, &degree}),
        estimate_of<&T::wave_generator_force, &T::wave_generator_force_error>(
            "wave_generator_force", newton, "sum of the bearing's forces on the cup, without direction",
            {"wave generator force", decimals<1>, two_digits}),
        estimate_of<&T::largest_stress, &T::largest_stress_error>(
            "largest_stress", megapascal, "largest von Mises stress", {"largest stress", decimals<1>, two_digits}),
        estimate_of<&T::ball_force, &T::ball_force_error>("ball_force", ball,
                                                          "largest force of a ball, or per length of a continuous row",
                                                          {"largest force of", decimals<1>, two_digits})
            .without(hdf5),  // an attribute without a unit in its name
        figure<&T::ball_phi>("ball_phi", degree, "angle of that ball", {"at", fixed<1>}).without(hdf5 | json),
        figure<&T::balls>("balls", one, "single balls that carry", {"carry", whole}).without(hdf5),
        figure<&T::contacts>("contacts", one, "places of the bearing that carry force", {"places", whole})};
}

}  // namespace

Rows<LoadStudy> load_study_figures()
{
    using T = LoadStudy;
    static constexpr std::array rows = {
        figure<&T::rated_torque>("rated_torque", newton_metre, "largest torque", {"at", significant<6>}),
        figure<&T::contact_gap>("contact_gap", um, "gap limit of fraction_within_gap", {"gap", significant<6>}),
        figure<&T::pitch_radius>("pitch_radius", mm, "half the module times the flexspline's teeth"),
        figure<&T::harmonics>("harmonics", one, "largest circumferential harmonic of the cup", {"harmonics", whole}),
        figure<&T::sectors>("sectors", one, "how often the solved sector repeats around the ring"),
        figure<&T::written_case>("written_case", one, "number of the case with the least line load").formerly("shown"),
        figure<&T::edge_radius>("edge_radius", um, "radius of the edges where teeth touch",
                                {"edges of the teeth", significant<4>}),
        json_only(figure<&T::standard_tip_increase>("standard_tip_increase", um,
                                                    "by how much the tip circle is wider than the standard one"))
            .formerly("tip_widened")
            .printed({"tip circle", decimals<1>}),
        figure<&T::balls>("balls", one, "balls of the bearing; 0: a continuous row, or a rigid bearing"),
        figure<&T::ball_constant>("ball_constant", newton_per_mm_to_3_2,
                                  "k of a ball in its grooves, F = k d^1.5 (Hertz); 0: not by Hertz",
                                  {"balls by Hertz", table_number}),
        json_only(figure<&T::sharp_steps>("sharp_steps", one,
                                          "whether the wall has sharp steps, where stress grows with the mesh"))};
    return Rows<T>(rows);
}

Rows<LoadedState> loaded_state_figures(int balls)
{
    static constexpr auto single = joined(twist_figures(), force_figures(), bearing_figures(newton)),
                          line = joined(twist_figures(), force_figures(), bearing_figures(newton_per_mm));
    return Rows<LoadedState>(balls > 0 ? single : line);
}

Rows<AssembledCup> assembled_cup_figures(int balls)
{
    static constexpr auto single = cup_figures(newton), line = cup_figures(newton_per_mm);
    return Rows<AssembledCup>(balls > 0 ? single : line);
}

std::vector<std::string> unconverged_figures(LoadCase const& each, int balls)
{
    std::vector<std::string> names;
    auto const add = [&names](auto const& rows, auto const& record, auto const& errors) {
        for (auto const& row : rows)  // some stand in two units
            if (is_unconverged(row, record, errors) && std::ranges::find(names, row.name) == names.end())
                names.emplace_back(row.name);
    };
    if (each.estimated)
        add(load_case_figures(), each, each);
    if (auto const* state = rated_state(each); each.estimated && state != nullptr)
        add(loaded_state_figures(balls), *state, each.error);
    if (each.catalogue && each.catalogue->estimated)
        add(catalogue_rows(), *each.catalogue, *each.catalogue);
    return names;
}

}  // namespace hdconj::figures
