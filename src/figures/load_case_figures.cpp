// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of a surface under torque: its curve, catalogue stiffness and members in series.
#include <array>
#include <optional>

#include "load_figures.hpp"
#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

constexpr FigureOf<LoadCase> in_json_only(FigureOf<LoadCase> const& row)
{
    return row.without(hdf5);
}

/// Depth of the interference that the member of a case holds, if any.
template <std::optional<TipInterference> LoadCase::*tips>
constexpr FigureOf<LoadCase> depth_of_tips(char const* name, char const* meaning)
{
    return {name, um, meaning, [](LoadCase const& each) { return (each.*tips).value_or(TipInterference()).depth; }};
}

/// Slope of one of two lines through the curve, per radian.
template <auto slope, auto error>
constexpr FigureOf<LoadCase> stage(char const* name, char const* meaning, char const* label)
{
    return figure<&LoadCase::stages, slope>(name, newton_metre_per_rad, meaning,
                                            {label, table_number, two_digits, &newton_metre_per_degree})
        .template with_error<&LoadCase::stages, error>()
        .without(json_error);
}

/// The same per degree, in JSON.
template <auto slope, auto error>
constexpr FigureOf<LoadCase> stage_per_degree(char const* name)
{
    return in_json_only(figure<&LoadCase::stages, slope>(name, newton_metre_per_degree, "the same")
                            .template with_error<&LoadCase::stages, error>());
}

template <auto member>
constexpr FigureOf<CatalogueFigures> catalogue_stiffness(char const* name, char const* meaning)
{
    return figure<member, &Stiffness::value>(name, newton_metre_per_rad, meaning, {name, table_number, two_digits})
        .template with_error<member, &Stiffness::error>();
}

}  // namespace

Rows<LoadCase> load_case_figures()
{
    using T = LoadCase;
    using Stages = StiffnessStages;
    static constexpr std::array rows = {
        figure<&T::tilt>("tilt", given_degree, "tilt of the circular spline's teeth",
                         {"tilt", significant<3>, nullptr, &degree}),
        pair<&T::backlash_offset, &T::backlash_offset_error>("backlash_offset", um, "side clearance",
                                                             {"offset", fixed<2>, significant<2>})
            .without(hdf5_error),  // with the estimates of the case
        figure<&T::tip>("tip_radius", mm, "tip circle at z = 0", {"tip circle", decimals<6>}),
        figure<&T::tip_radius_increase>("tip_radius_increase", um,
                                        "how much wider the tip circle is than the scene gives", {"wider", decimals<2>})
            .formerly("tip_change"),
        figure<&T::cleared>("cleared", one,
                            "whether the teeth of the scene interfere when assembled, and others are computed"),
        depth_of_tips<&T::tips>("tip_interference", "how deep tips interfere along the radius; 0: they pass"),
        depth_of_tips<&T::given_tips>("given_tip_interference",
                                      "the same of the teeth of the scene, where others are computed"),
        pair<&T::backlash, &T::backlash_error>("backlash", arcmin, "backlash of the circular spline, without torque",
                                               {"backlash", fixed<2>, significant<2>})
            .without(hdf5_error),  // with the estimates of the case
        stage<&Stages::first, &Stages::first_error>("first_stage", "slope of the first of two lines through the curve",
                                                    "first"),
        stage_per_degree<&Stages::first, &Stages::first_error>("first_stage"),
        stage<&Stages::second, &Stages::second_error>("second_stage",
                                                      "slope of the second of two lines through the curve", "second"),
        stage_per_degree<&Stages::second, &Stages::second_error>("second_stage"),
        figure<&T::stages, &Stages::knee>("knee", newton_metre, "torque where the lines meet",
                                          {"knee", table_number, two_digits})
            .with_error<&T::stages, &Stages::knee_error>(),
        figure<&T::stages, &Stages::knee_twist>("knee_twist", arcmin, "twist where the lines meet")
            .with_error<&T::stages, &Stages::knee_twist_error>(),
        figure<&T::stages, &Stages::rms>("stages_rms", newton_metre,
                                         "root mean square of the distance between curve and lines, in torque",
                                         {"off the curve", significant<2>}),
        figure<&T::side_clearance_increased>("side_clearance_increased", one,
                                             "whether the side clearance is more than the scene gives")
            .formerly("raised"),
        figure<&T::stages, &Stages::found>("stages_found", one, "whether two lines were found"),
        figure<&T::seconds>("seconds", second, "time to compute the case").keyed("time")};
    return Rows<T>(rows);
}

Rows<CatalogueFigures> catalogue_rows()
{
    using T = CatalogueFigures;
    using Torque = CatalogueTorques;
    static constexpr std::array rows = {
        figure<&T::torque, &Torque::first>("T1", newton_metre, "torque on the circular spline up to which K1 reaches",
                                           {"T1", significant<4>}),
        figure<&T::torque, &Torque::second>("T2", newton_metre, "torque on the circular spline up to which K2 reaches",
                                            {"T2", significant<4>}),
        figure<&T::torque, &Torque::lost_motion>("lost_motion_torque", newton_metre,
                                                 "torque on the circular spline, of either sign, of the lost motion",
                                                 {"at +-", significant<4>}),
        catalogue_stiffness<&T::k1>("K1", "stiffness of the circular spline from zero torque to T1"),
        catalogue_stiffness<&T::k2>("K2", "stiffness of the circular spline from T1 to T2"),
        catalogue_stiffness<&T::k3>("K3", "stiffness of the circular spline from T2 to the rated torque"),
        pair<&T::lost_motion, &T::lost_motion_error>("lost_motion", arcmin,
                                                     "turn of the circular spline between both signs of that torque",
                                                     {"lost motion", fixed<2>, significant<2>}),
        figure<&T::estimated>("estimated", one, "whether the errors are estimates")};
    return Rows<T>(rows);
}

Rows<TwistMember> twist_member_rows()
{
    using T = TwistMember;
    static constexpr std::array rows = {
        pair<&T::stiffness, &T::stiffness_error>("stiffness", newton_metre_per_rad,
                                                 "torque over its twist; 0: it has none",
                                                 {"stiffness", table_number, two_digits}),
        pair<&T::twist, &T::twist_error>("twist", arcmin, "its part of the twist", {"twist", fixed<2>, two_digits}),
        pair<&T::fraction, &T::fraction_error>("fraction", one, "of the whole twist",
                                               {"share", significant<3>, two_digits, &percent})};
    return Rows<T>(rows);
}

}  // namespace hdconj::figures
