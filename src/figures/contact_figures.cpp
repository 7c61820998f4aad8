// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_figures.hpp"

#include <algorithm>
#include <array>

#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

/// How an error of a contact study is printed: as little of it as says how large it is.
constexpr auto one_digit = significant<1>;

}  // namespace

Rows<ContactStudy> contact_study_figures()
{
    using T = ContactStudy;
    static constexpr std::array rows = {
        figure<&T::contact_gap>("contact_gap", um, "gap up to which flanks count as in contact",
                                {"contact gap", significant<6>}),
        figure<&T::pitch_radius>("pitch_radius", mm, "radius at which backlash is given as a length",
                                 {"pitch circle", decimals<6>}),
        figure<&T::written_case>("written_case", one,
                                 "number of the case that the circular spline and the map belong to")
            .formerly("shown"),
        figure<&T::estimated>("estimated", one, "whether the errors are estimates")};
    return Rows<T>(rows);
}

Rows<ContactState> state_figures()
{
    using T = ContactState;
    static constexpr std::array rows = {
        figure<&T::wave_generator>("wave_generator", given_degree,
                                   "angle of the wave generator from a tooth space of the circular spline",
                                   {"wave generator", fixed<4>, nullptr, &degree}),
        pair<&T::turn_to_contact, &T::turn_to_contact_error>(
            "turn_to_contact", arcmin, "turn of the circular spline to first contact, counter-clockwise")
            .formerly("take_up"),
        pair<&T::reverse_turn_to_contact, &T::reverse_turn_to_contact_error>(
            "reverse_turn_to_contact", arcmin, "turn of the circular spline to first contact, clockwise")
            .formerly("take_up_back"),
        pair<&T::backlash, &T::backlash_error>("backlash", arcmin, "sum of both turns to first contact",
                                               {"backlash", fixed<2>, one_digit})
            .and_as_length(),
        pair<&T::contact_area, &T::contact_area_error>("contact_area", mm2,
                                                       "flank area whose gap is at most the contact gap"),
        pair<&T::contact_fraction, &T::contact_fraction_error>(
            "contact_fraction", one, "contact area as a fraction of all flanks on the driving side",
            {"contact area", significant<4>, significant<2>, &percent})
            .formerly("share"),
        pair<&T::smallest_gap, &T::smallest_gap_error>("smallest_gap", um,
                                                       "smallest gap before the turn, on either side"),
        figure<&T::smallest_z>("smallest_z", mm, "height of the slice with the smallest gap"),
        figure<&T::smallest_z_from>("smallest_z_from", mm, "lower end of where the smallest gap may lie").from_errors(),
        figure<&T::smallest_z_to>("smallest_z_to", mm, "upper end of where the smallest gap may lie").from_errors(),
        figure<&T::teeth>("teeth", one, "tooth spaces in contact on the driving side", {"teeth", whole}),
        figure<&T::teeth_least>("teeth_least", one, "tooth spaces in contact whatever the errors").from_errors(),
        figure<&T::teeth_most>("teeth_most", one, "tooth spaces that may be in contact within the errors")
            .from_errors(),
        figure<&T::smallest_space>("smallest_space", one, "tooth space with the smallest gap"),
        figure<&T::smallest_spaces>("smallest_spaces", one,
                                    "tooth spaces that may have the smallest gap within its error")
            .from_errors()};
    return Rows<T>(rows);
}

Rows<ContactCase> case_figures()
{
    using T = ContactCase;
    static constexpr std::array rows = {
        figure<&T::tilt>("tilt", given_degree, "tilt of the circular spline's teeth",
                         {"tilt", significant<3>, nullptr, &degree}),
        figure<&T::backlash_offset>("backlash_offset", um, "side clearance that the contact is computed with",
                                    {"offset", fixed<2>}),
        pair<&T::least_side_clearance, &T::least_side_clearance_error>(
            "least_side_clearance", um, "least side clearance without interference of the flanks over a full turn",
            {"offset", fixed<2>, one_digit})
            .formerly("clearing_offset"),
        figure<&T::tip>("tip_radius", mm, "tip circle at z = 0 that the contact is computed with",
                        {"tip circle", decimals<4>}),
        pair<&T::least_tip_radius, &T::least_tip_radius_error>(
            "least_tip_radius", mm, "tip circle at z = 0 that goes with the least side clearance",
            {"tip circle", decimals<4>, one_digit})
            .formerly("clearing_tip"),
        pair<&T::least_root_clearance, &T::least_root_clearance_error>(
            "least_root_clearance", um, "least root clearance without interference over a full turn",
            {"root clearance", significant<3>, one_digit})
            .formerly("clearing_root"),
        pair<&T::backlash_of_least_side_clearance, &T::backlash_of_least_side_clearance_error>(
            "backlash_of_least_side_clearance", arcmin, "backlash of the least side clearance alone",
            {"backlash", fixed<2>, one_digit})
            .formerly("backlash_of_clearing")
            .and_as_length(),
        figure<&T::state, &ContactState::flank_area>("flank_area", mm2, "area of all flanks on the driving side")
            .with_error<&T::state, &ContactState::flank_area_error>(),
        pair<&T::ruled_deviation, &T::ruled_deviation_error>(
            "ruled_deviation", um, "largest distance of a ruled surface from the slices' own outlines",
            {"deviation", significant<3>, one_digit}),
        FigureOf<T>{"flank_clearance", um, "clearance where the flanks come closest over a full turn",
                    [](T const& each) { return each.closest_flank().clearance; }}
            .with_error<&T::clearance_error>()
            .keyed("clearance")
            .without(hdf5 | json_value)  // the closest place has them
            .printed({"clearance", fixed<2>, one_digit}),
        FigureOf<T>{"root_clearance", um, "clearance where the roots come closest over a full turn",
                    [](T const& each) { return closest_root(each).root.clearance; }}
            .with_error<&T::root_clearance_error>()
            .without(hdf5_value | json_value),  // the slices have it
        figure<&T::closest_z_from>("flank_z_from", mm, "lower end of where the closest place may lie",
                                   {"from", fixed<3>})
            .keyed("closest_z_from")
            .from_errors(),
        figure<&T::closest_z_to>("flank_z_to", mm, "upper end of where the closest place may lie", {"to", fixed<3>})
            .keyed("closest_z_to")
            .from_errors(),
        figure<&T::side_clearance_increased>("side_clearance_increased", one,
                                             "whether the side clearance is more than the scene gives")
            .formerly("raised"),
        figure<&T::seconds>("seconds", second, "time to compute the case").keyed("time")};
    return Rows<T>(rows);
}

Rows<ClosestPlace> closest_figures()
{
    using Row = FigureOf<ClosestPlace>;
    using Place = ClosestPlace const&;
    static constexpr std::array rows = {
        figure<&ClosestPlace::at, &Closest::clearance>("clearance", um, "smallest distance over a full turn",
                                                       {"clearance", fixed<2>, one_digit})
            .with_error<&ClosestPlace::error>(),
        Row{"x", mm, "where, on the circular spline", [](Place place) { return place.at.where.x(); }}
            .without(hdf5)  // a column of points
            .printed({"x", fixed<4>}),
        Row{"y", mm, "where, on the circular spline", [](Place place) { return place.at.where.y(); }}
            .without(hdf5)
            .printed({"y", fixed<4>}),
        figure<&ClosestPlace::at, &Closest::phi>("phi", degree, "undeformed angle of the tooth at the closest place",
                                                 {"phi", fixed<3>})};
    return Rows<ClosestPlace>(rows);
}

Rows<SliceClearance> slice_figures()
{
    static constexpr std::array rows = {
        figure<&SliceClearance::z>("z", mm, "height of the slice", {"z", fixed<3>}),
        figure<&SliceClearance::amplitude>("amplitude", mm, "radial deformation of the slice")};
    return Rows<SliceClearance>(rows);
}

Rows<BestTilt> best_tilt_figures()
{
    using T = BestTilt;
    constexpr Text bound = {"", significant<6>, nullptr, &degree};
    static constexpr std::array rows = {
        figure<&T::tilt>("tilt", given_degree, "the best tilt", {"tilt", decimals<4>, nullptr, &degree}),
        figure<&T::tolerance>("tolerance", degree, "tolerance of the best tilt", {"", one_digit}),
        figure<&T::on_bound>("on_bound", one, "whether the best tilt lies at an end of the interval searched"),
        figure<&T::refused>("refused", one, "tilts tried at which no surface can be made").without(hdf5),
        figure<&T::possible_from>("possible_from", given_degree, "least tilt tried that makes a surface", bound)
            .without(hdf5),
        figure<&T::possible_to>("possible_to", given_degree, "largest tilt tried that makes a surface", bound)
            .without(hdf5),
        figure<&T::from>("from", given_degree, "lower end of the interval searched", bound).without(hdf5),
        figure<&T::to>("to", given_degree, "upper end of the interval searched", bound).without(hdf5)};
    return Rows<T>(rows);
}

FigureOf<BestTilt> best_value_figure(BestTilt const& best)
{
    static constexpr auto fraction =
        pair<&BestTilt::value, &BestTilt::value_error>("value", one, "contact fraction at the best tilt",
                                                       {"contact area", significant<4>, one_digit, &percent})
            .keyed("contact_fraction")
            .formerly("share");
    static constexpr auto offset =
        pair<&BestTilt::value, &BestTilt::value_error>("value", um, "least side clearance at the best tilt",
                                                       {"least side clearance", significant<3>, one_digit})
            .keyed("least_side_clearance")
            .formerly("clearing_offset");
    return best.goal == TiltGoal::contact_area ? fraction : offset;
}

std::string surface_name(ToothSurface surface, std::optional<TiltKind> kind, double tilt)
{
    std::string const name(to_string(surface));
    return kind ? fmt::format("{}, {} {:g} deg", name, to_string(*kind), tilt * per_deg) : name;
}

std::string goal_name(BestTilt const& best)
{
    return best.goal == TiltGoal::contact_area ? "contact area" : "least side clearance";
}

std::string former_goal_name(BestTilt const& best)
{
    return best.goal == TiltGoal::contact_area ? "area" : "clearing offset";
}

SliceClearance const& closest_root(ContactCase const& each)
{
    return *std::min_element(each.slices.begin(), each.slices.end(),
                             [](auto const& a, auto const& b) { return a.root.clearance < b.root.clearance; });
}

}  // namespace hdconj::figures
