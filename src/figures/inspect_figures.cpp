// SPDX-License-Identifier: GPL-3.0-or-later
#include "inspect_figures.hpp"

#include <array>

#include "number_text.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

/// A figure with the half width of its interval.
template <auto... members>
constexpr auto uncertain(char const* name, Unit const& unit, char const* meaning, char const* label,
                         std::string (*digits)(double) = decimals<3>)
{
    return figure<members..., &Uncertain::value>(name, unit, meaning, {label, digits, two_digits})
        .template with_error<members..., &Uncertain::error>();
}

}  // namespace

Rows<Inspection> inspection_figures()
{
    using T = Inspection;
    static constexpr std::array rows = {
        figure<&T::options, &InspectOptions::probe>("probe_radius", mm,
                                                    "of the ball whose centres were measured; negative: centres inside "
                                                    "the material",
                                                    {"probe radius", significant<6>}),
        FigureOf<T>{"points", one, "evaluated planes: points in all",
                    [](T const& of) { return static_cast<double>(of.points.size()); }, Kind::count}
            .printed({"points", whole}),
        figure<&T::beside>("points_beside", one, "points on no flank: tip land, root, beyond the ends",
                           {"beside the flanks", whole}),
        figure<&T::strays>("points_stray", one,
                           "points left out: they jump against their neighbours and the other flanks",
                           {"strays, left out", whole}),
        figure<&T::repeated>("points_repeated", one, "points that stand in the file before, not counted in points",
                             {"repeated", whole}),
        figure<&T::elsewhere>("points_elsewhere", one, "points of other planes than asked for, not counted in points",
                              {"in other planes", whole}),
        figure<&T::noise>("noise", um, "standard deviation of a point, from second differences along the flanks",
                          {"noise", decimals<3>}),
        figure<&T::freedom>("freedom", one, "degrees of freedom of the noise; 0: not estimated",
                            {"degrees of freedom", whole})};
    return Rows<T>(rows);
}

Rows<PartPlacement> placement_figures()
{
    using T = PartPlacement;
    static constexpr std::array rows = {
        uncertain<&T::turn>("turn", degree, "of the part, clockwise", "turn", decimals<6>),
        uncertain<&T::shift_x>("shift_x", um, "of the part's axis", "shift in x"),
        uncertain<&T::shift_y>("shift_y", um, "of the part's axis", "shift in y"),
        figure<&T::rms>("deviation_rms", um, "root mean square of the deviations", {"deviations, rms", decimals<3>}),
        figure<&T::least>("deviation_least", um, "smallest deviation", {"smallest", decimals<3>}),
        figure<&T::largest>("deviation_largest", um, "largest deviation", {"largest", decimals<3>}),
        figure<&T::deviation_error>("deviation_error", um, "of a single deviation, half width of its 95 % interval",
                                    {"of a point", two_digits})};
    return Rows<T>(rows);
}

Rows<NominalFigures> nominal_figures()
{
    using T = NominalFigures;
    static constexpr std::array rows = {
        figure<&T::z>("z", mm, "height of the plane", {"plane", significant<6>}),
        pair<&T::flank_length, &T::error>("flank_length", mm, "arc length of the evaluated flank, root to tip",
                                          {"flank length", decimals<6>, two_digits}),
        pair<&T::reference_radius, &T::error>("reference_radius", mm, "of the circle through the middles of the flanks",
                                              {"reference radius", decimals<6>, two_digits}),
        pair<&T::thickness, &T::error>("nominal_thickness", mm, "of tooth or space along the reference circle",
                                       {"nominal thickness", decimals<6>, two_digits})};
    return Rows<T>(rows);
}

Rows<FlankFigures> flank_rows()
{
    using T = FlankFigures;
    static constexpr std::array rows = {
        figure<&T::z>("z", mm, "height of the plane", {"plane", significant<6>}),
        figure<&T::tooth>("tooth", one, "number of the tooth, of the space on the circular spline", {"tooth", whole}),
        figure<&T::points>("points", one, "evaluated", {"points", whole}),
        uncertain<&T::position>("position", um, "arc by which the flank stands clockwise of its nominal place",
                                "position"),
        uncertain<&T::total>("profile_total", um, "largest less smallest deviation of the flank", "total"),
        uncertain<&T::slope>("profile_slope", um, "rise of the parabola from root to tip", "slope"),
        uncertain<&T::crowning>("profile_crowning", um, "height of the parabola at the middle above its chord",
                                "crowning"),
        uncertain<&T::form>("profile_form", um, "largest less smallest deviation from the parabola", "form")};
    return Rows<T>(rows);
}

Rows<ToothFigures> tooth_rows()
{
    using T = ToothFigures;
    static constexpr std::array rows = {
        figure<&T::z>("z", mm, "height of the plane", {"plane", significant<6>}),
        figure<&T::tooth>("tooth", one, "number of the tooth, of the space on the circular spline", {"tooth", whole}),
        uncertain<&T::thickness>("thickness", mm, "of tooth or space along the reference circle", "thickness",
                                 decimals<6>),
        uncertain<&T::radial>("radial_shift", um, "outward shift of tooth or space", "radial")};
    return Rows<T>(rows);
}

Rows<SideFigures> side_rows()
{
    using T = SideFigures;
    static constexpr std::array rows = {
        figure<&T::z>("z", mm, "height of the plane", {"plane", significant<6>}),
        figure<&T::flanks>("flanks", one, "evaluated", {"flanks", whole}),
        uncertain<&T::slope>("mean_profile_slope", um, "mean over the flanks", "slope, mean"),
        uncertain<&T::crowning>("mean_profile_crowning", um, "mean over the flanks", "crowning, mean"),
        uncertain<&T::form>("largest_profile_form", um, "of the flanks", "form, largest"),
        figure<&T::form_tooth>("form_tooth", one, "where the form deviates most", {"tooth", whole}),
        uncertain<&T::total>("largest_profile_total", um, "of the flanks", "total, largest"),
        figure<&T::total_tooth>("total_tooth", one, "where the total deviation is largest", {"tooth", whole})};
    return Rows<T>(rows);
}

Rows<SideFigures> pitch_rows()
{
    using T = SideFigures;
    static constexpr std::array rows = {
        figure<&T::pitches>("pitches", one, "between measured neighbours", {"pitches", whole}),
        uncertain<&T::single_pitch>("single_pitch_deviation", um, "f_pt: largest size of a single pitch deviation",
                                    "f_pt, single pitch"),
        figure<&T::pitch_tooth>("single_pitch_tooth", one, "second tooth of that pitch", {"tooth", whole}),
        uncertain<&T::total_pitch>("total_pitch_deviation", um, "F_p: largest less smallest position of the flanks",
                                   "F_p, total pitch"),
        figure<&T::from_tooth>("total_pitch_from", one, "tooth with the smallest position", {"from tooth", whole}),
        figure<&T::to_tooth>("total_pitch_to", one, "tooth with the largest position", {"to tooth", whole})};
    return Rows<T>(rows);
}

Rows<PlaneFigures> plane_rows()
{
    using T = PlaneFigures;
    static constexpr std::array rows = {
        figure<&T::z>("z", mm, "height of the plane", {"plane", significant<6>}),
        figure<&T::teeth>("teeth", one, "with both flanks", {"teeth", whole}),
        uncertain<&T::thickness>("mean_thickness", mm, "mean of the teeth along the reference circle",
                                 "thickness, mean", decimals<6>),
        uncertain<&T::runout>("runout", um, "largest less smallest radial shift of the teeth", "runout"),
        figure<&T::near_tooth>("runout_from", one, "tooth with the smallest radial shift", {"from tooth", whole}),
        figure<&T::far_tooth>("runout_to", one, "tooth with the largest radial shift", {"to tooth", whole})};
    return Rows<T>(rows);
}

Rows<PlaneFigures> eccentricity_rows()
{
    using T = PlaneFigures;
    static constexpr std::array rows = {
        uncertain<&T::eccentricity>("eccentricity", um, "amplitude of the first harmonic of the radial shifts",
                                    "eccentricity"),
        figure<&T::direction>("eccentricity_direction", degree, "clockwise from +y", {"towards", decimals<2>})};
    return Rows<T>(rows);
}

Rows<PointDeviation> point_rows()
{
    using T = PointDeviation;
    static constexpr std::array rows = {
        figure<&T::line>("line", one, "of the file"), figure<&T::z>("z", mm, "height of the plane"),
        figure<&T::tooth>("tooth", one, "number of the tooth, of the space on the circular spline"),
        figure<&T::arc_length>("arc_length", mm, "of the foot, from the root end of the flank"),
        figure<&T::deviation>("deviation", um, "along the nominal normal, positive outside the material")};
    return Rows<T>(rows);
}

}  // namespace hdconj::figures
