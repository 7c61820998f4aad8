// SPDX-License-Identifier: GPL-3.0-or-later
#include "wanted_figures.hpp"

#include <array>

#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

inline constexpr Unit per_mm{"1/mm", "per_mm", "1/mm"};

}  // namespace

Rows<WantedCurve> wanted_figures()
{
    using T = WantedCurve;
    static constexpr std::array rows = {
        figure<&T::geometry, &PairGeometry::r_m>("r_m", mm, "radius of the undeformed neutral curve",
                                                 {"neutral radius r_m", decimals<6>}),
        pair<&T::touch_begin, &T::touch_begin_error>("touch_begin", degree, "angle from which on flanks touch",
                                                     {"flanks touch from", decimals<6>, two_digits}),
        pair<&T::touch_end, &T::touch_end_error>("touch_end", degree, "angle up to which flanks touch",
                                                 {"to", decimals<6>, two_digits}),
        pair<&T::parting, &T::parting_error>("parting", degree,
                                             "angle at which the flanks part, were the curve not to be closed",
                                             {"flanks part at", decimals<6>, two_digits}),
        pair<&T::residual, &T::residual_error>(
            "residual", um, "largest gap or overlap of the flanks on the closed curve, where they touch",
            {"residual", significant<3>, two_digits}),
        pair<&T::major_displacement, &T::major_error>(
            "major_displacement", mm, "displacement of the neutral curve on the major axis, rho(0) - r_m",
            {"on the major axis", decimals<6>, two_digits}),
        figure<&T::geometry, &PairGeometry::r_0>("r_0", mm, "mean radius of the closed curve",
                                                 {"base radius r_0", decimals<6>, two_digits})
            .with_error<&T::error>(),
        figure<&T::geometry, &PairGeometry::w0>("w0", mm, "largest radial deformation, from r_0",
                                                {"radial deformation w0", decimals<6>, two_digits})
            .with_error<&T::error>(),
        figure<&T::error>("displacement_error", um,
                          "largest error of the displacement where flanks touch, if the given flanks are as exact as "
                          "flank_error says",
                          {"error of the curve", two_digits}),
        figure<&T::flank_error>("flank_error", um, "error of the given flanks: solver.tolerance",
                                {"error of the flanks", significant<3>}),
        figure<&T::growth>("growth", one, "error of the curve at the end of the mesh over the error of a flank",
                           {"growth of errors", significant<3>}),
        figure<&T::length_error>("length_error", um, "length of the closed curve less that of the ring, over a turn",
                                 {"error of its length", two_digits}),
        pair<&T::least_curvature, &T::curvature_error>("least_curvature", per_mm, "least curvature of the closed curve",
                                                       {"least curvature", decimals<6>, two_digits}),
        pair<&T::largest_curvature, &T::curvature_error>("largest_curvature", per_mm,
                                                         "largest curvature of the closed curve",
                                                         {"largest curvature", decimals<6>, two_digits}),
        pair<&T::bending_stress, &T::stress_error>("bending_stress", megapascal,
                                                   "largest stress in the wall by bending of the ring alone",
                                                   {"bending stress", decimals<1>, two_digits}),
        pair<&T::smallest_clearance, &T::clearance_error>(
            "smallest_clearance", um, "smallest distance of both teeth over a turn, negative: they overlap",
            {"smallest clearance", significant<3>, two_digits}),
        figure<&T::clearance_u>("clearance_u", degree, "angle of the smallest clearance", {"at u", decimals<3>}),
        figure<&T::inner_distance>("inner_distance", mm, "from the neutral curve inward to the surface of the cam",
                                   {"cam's surface inside by", decimals<6>})};
    return Rows<T>(rows);
}

Rows<WantedCurveRow> wanted_rows()
{
    using T = WantedCurveRow;
    static constexpr std::array rows = {
        figure<&T::u>("u", degree, "polar angle from the major axis; undeformed angle in the first-order motion"),
        figure<&T::displacement>("displacement", mm, "rho - r_m").with_error<&T::error>(),
        figure<&T::slope>("slope", mm_per_rad, "of rho against the angle"),
        figure<&T::curvature>("curvature", per_mm, "of the closed neutral curve"),
        figure<&T::touching>("touching", one, "whether flanks touch here")};
    return Rows<T>(rows);
}

}  // namespace hdconj::figures
