// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary_figures.hpp"

#include <algorithm>
#include <array>

#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

using Geometry = PairGeometry;
using Errors = ErrorEstimate;

/// A derived dimension of the pair.
template <auto member>
constexpr FigureOf<Solution> dimension(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    return figure<&Solution::geometry, member>(name, unit, meaning, text);
}

/// An estimated error of the written data.
template <auto member>
constexpr FigureOf<Solution> estimate(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    return figure<&Solution::error, member>(name, unit, meaning, text);
}

/// Land of the circular spline between two tooth spaces, along the tip circle [mm].
double land_width(Solution const& solution)
{
    return 2 * solution.geometry.land_half_angle * solution.geometry.circular_spline_inner_radius;
}

double error_of_land_half_angle(Solution const& solution)
{
    return solution.error.land / (2 * solution.geometry.circular_spline_inner_radius);
}

/// Largest of an error of the zones' ends; 0 without zones.
template <double ConjugateZone::*error>
double largest_of_zones(Solution const& solution)
{
    double worst = 0;
    for (auto const& zone : solution.zones)
        worst = std::max(worst, zone.*error);
    return worst;
}

}  // namespace

Rows<Solution> drive_figures()
{
    static constexpr std::array rows = {
        figure<&Solution::scene, &Scene::drive, &Drive::module>("module", mm, "module"),
        figure<&Solution::scene, &Scene::drive, &Drive::flexspline_teeth>("flexspline_teeth", one,
                                                                          "teeth of the flexspline"),
        figure<&Solution::scene, &Scene::drive, &Drive::circular_spline_teeth>("circular_spline_teeth", one,
                                                                               "teeth of the circular spline"),
        figure<&Solution::scene, &Scene::wave_generator, &WaveGenerator::waves>("waves", one,
                                                                                "lobes of the wave generator"),
        figure<&Solution::scene, &Scene::solver, &Solver::tolerance>(
            "tolerance", mm, "largest distance of an outline from the true one that is asked for",
            {"asked for", significant<6>, nullptr, &um})};
    return Rows<Solution>(rows);
}

Rows<Solution> geometry_figures()
{
    using Row = FigureOf<Solution>;
    static constexpr std::array rows = {
        dimension<&Geometry::ratio>("ratio", one, "turns of the wave generator per turn of the flexspline",
                                    {"ratio", significant<6>}),
        dimension<&Geometry::r_m>("r_m", mm, "radius of the undeformed neutral curve",
                                  {"neutral radius r_m", decimals<6>}),
        dimension<&Geometry::r_0>("r_0", mm, "base radius of the deformed neutral curve",
                                  {"base radius r_0", decimals<6>, exponential<1>, nullptr, &um})
            .with_error<&Solution::error, &Errors::r_0>()
            .keyed("r_0", "error_r_0"),
        Row{"r_0_less_r_m", um, "their difference",
            [](Solution const& of) { return of.geometry.r_0 - of.geometry.r_m; }}
            .printed({"r_0 - r_m", signed_decimals<3>}),
        dimension<&Geometry::w0>("w0", mm, "largest radial deformation", {"radial deformation w0", decimals<6>}),
        dimension<&Geometry::pitch_line>("pitch_line", mm, "height of the pitch line above the neutral curve",
                                         {"pitch line", decimals<6>}),
        dimension<&Geometry::addendum>("addendum", mm, "addendum of the flexspline's tooth"),
        dimension<&Geometry::dedendum>("dedendum", mm, "dedendum of the flexspline's tooth"),
        dimension<&Geometry::flexspline_inner_radius>("flexspline_inner_radius", mm,
                                                      "inner radius of the undeformed flexspline",
                                                      {"flexspline inner radius", decimals<6>}),
        dimension<&Geometry::circular_spline_inner_radius>("tip_radius", mm, "tip circle of the circular spline",
                                                           {"tip radius", decimals<6>}),
        dimension<&Geometry::space_depth>("space_depth", mm, "depth of the tooth space from the tip circle",
                                          {"depth of tooth space", decimals<6>, significant<3>, nullptr, &um})
            .with_error<&Solution::error, &Errors::space_depth>()
            .keyed("space_depth", "error_space_depth"),
        dimension<&Geometry::land_half_angle>("land_half_angle", degree,
                                              "half the angle of the circular spline's tip land")
            .with_error(error_of_land_half_angle)
            .keyed("land_half_angle", "error_land_half_angle"),
        Row{"land_width", mm, "length of the tip land along the tip circle", land_width}
            .with_error<&Solution::error, &Errors::land>()
            .keyed("land_width", "error_land_width")
            .printed({"land between spaces", decimals<6>, significant<3>, nullptr, &um})};
    return Rows<Solution>(rows);
}

Rows<Solution> clearance_figures()
{
    using Row = FigureOf<Solution>;
    using Of = Solution const&;
    static constexpr std::array rows = {
        Row{"smallest_clearance", mm, "smallest distance of the finished pair over a full turn",
            [](Of of) { return of.check->smallest_clearance; }}
            .with_error<&Solution::error, &Errors::clearance>()
            .keyed("smallest_clearance", "clearance_error")
            .printed({"smallest clearance", significant<3>, significant<3>, &um}),
        Row{"clearance_x", mm, "where, on the outline that is solved for", [](Of of) { return of.check->where.x(); }}
            .printed({"x", decimals<4>}),
        Row{"clearance_y", mm, "where, on the outline that is solved for", [](Of of) { return of.check->where.y(); }}
            .printed({"y", decimals<4>}),
        Row{"clearance_phi", degree, "undeformed angle of the tooth there", [](Of of) { return of.check->at_phi; }}
            .printed({"phi", decimals<3>}),
        Row{"checked_points", one, "points of the outline looked at",
            [](Of of) { return static_cast<double>(of.check->points); }, Kind::count}
            .printed({"points", whole}),
        Row{"checked_positions", one, "positions of the tooth for each of them",
            [](Of of) { return static_cast<double>(of.check->positions); }, Kind::count}
            .printed({"positions", whole})};
    return Rows<Solution>(rows);
}

Rows<Solution> error_figures()
{
    using Row = FigureOf<Solution>;
    static constexpr std::array rows = {
        estimate<&Errors::chord>("error_chord", mm, "of the written polygon against the true curve",
                                 {"error, chords", significant<3>, nullptr, &um}),
        estimate<&Errors::point>("error_point", mm, "of the written points against the true curve",
                                 {"error, written points", significant<3>, nullptr, &um}),
        estimate<&Errors::largest>("error_largest", mm, "the larger of the two"),
        estimate<&Errors::cup>("error_cup", mm, "of the displacement of the sections of an elastic cup",
                               {"error, bent sections", significant<3>, nullptr, &um}),
        estimate<&Errors::arc_length>("error_arc_length_relative", one, "of the neutral curve's closed length",
                                      {"closed length, relative", exponential<1>}),
        estimate<&Errors::side_clearance>("error_side_clearance", mm, "of an automatic side clearance"),
        Row{"error_zone_phi", degree, "of the ends of conjugate zones", largest_of_zones<&ConjugateZone::phi_error>}
            .printed({"off by", exponential<1>}),
        Row{"error_zone_t", one, "of the profile parameters there", largest_of_zones<&ConjugateZone::t_error>}.printed(
            {"off by", exponential<1>})};
    return Rows<Solution>(rows);
}

Rows<WorkCount> work_figures()
{
    static constexpr std::array rows = {
        figure<&WorkCount::envelope_points>("envelope_points", one, "contacts evaluated", {"contacts", whole}),
        figure<&WorkCount::roots_isolated>("roots_isolated", one, "roots found by isolation", {"roots", whole}),
        figure<&WorkCount::arrangement_edges>("arrangement_edges", one, "segments of the planar arrangement",
                                              {"edges", whole})};
    return Rows<WorkCount>(rows);
}

/// In HDF5 each interval is a row of two numbers.
Rows<ConjugateZone> zone_figures()
{
    using T = ConjugateZone;
    static constexpr std::array rows = {
        figure<&T::u_begin>("u_begin", degree, "polar angle on the neutral curve where the zone begins").without(hdf5),
        figure<&T::u_end>("u_end", degree, "polar angle where it ends").without(hdf5),
        figure<&T::phi_begin>("phi_begin", degree, "undeformed angle of the tooth where the zone begins",
                              {"phi from", decimals<4>})
            .without(hdf5),
        figure<&T::phi_end>("phi_end", degree, "undeformed angle where it ends", {"to", decimals<4>}).without(hdf5),
        figure<&T::t_begin>("t_begin", one, "profile parameter where the zone begins", {"t from", decimals<4>})
            .without(hdf5),
        figure<&T::t_end>("t_end", one, "profile parameter where it ends", {"to", decimals<4>}).without(hdf5),
        figure<&T::phi_error>("phi_error", degree, "error of both undeformed angles").without(hdf5),
        figure<&T::t_error>("t_error", one, "error of both profile parameters").without(hdf5),
        figure<&T::outer>("outer", one, "whether the given tooth touches from outside"),
        figure<&T::on_boundary>("on_boundary", one, "whether some of it bounds the solved member")};
    return Rows<T>(rows);
}

Rows<UndecidedPlace> undecided_figures()
{
    using T = UndecidedPlace;
    static constexpr std::array rows = {
        figure<&T::t>("t", one, "profile parameter, 0 to 1 along the segment", {"t", decimals<6>}),
        figure<&T::u>("u", degree, "polar angle on the neutral curve", {"u", decimals<6>}),
        figure<&T::u_width>("u_width", degree, "interval that an unseen branch would live in",
                            {"+-", [](double width) { return exponential<1>(width / 2); }}),
        figure<&T::reach>("reach", mm, "how far such a branch could stand out",
                          {"reach", exponential<1>, nullptr, &um})};
    return Rows<T>(rows);
}

std::size_t branches_of_kind(Solution const& solution, std::string const& kind)
{
    return static_cast<std::size_t>(std::count_if(solution.branches.begin(), solution.branches.end(),
                                                  [&](auto const& branch) { return branch.kind == kind; }));
}

std::string given_member(Solution const& solution)
{
    return solution.scene.is_reverse() ? "circular spline" : "flexspline";
}

std::string kinematics_name(Solution const& solution)
{
    return std::string(
        to_string(solution.scene.is_elastic() ? Kinematics::material : solution.scene.solver.kinematics));
}

double total_seconds(Solution const& solution)
{
    double total = 0;
    for (auto const& entry : solution.timing)
        total += entry.seconds;
    return total;
}

std::size_t outline_points(Solution const& solution)
{
    auto const& slices = solution.circular_spline.outline;
    return slices.empty() ? 0 : slices.front().size();
}

}  // namespace hdconj::figures
