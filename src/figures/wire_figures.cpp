// SPDX-License-Identifier: GPL-3.0-or-later
#include "wire_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "number_text.hpp"
#include "wedm/program_words.hpp"

namespace hdconj::figures {

using namespace unit;

namespace {

constexpr double rounding = 1e-9;  ///< of the points that a surface is compared at [mm]

using Row = FigureOf<MeasuredProgram>;
using Of = MeasuredProgram const&;

/// A figure that the program itself has.
template <auto... members>
constexpr Row given(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    return Row{name, unit, meaning, [](Of of) { return path::number<members...>(of.program); },
               figure<members...>(name, unit, meaning).kind}
        .printed(text);
}

/// A figure that was measured.
template <auto member>
constexpr Row found(char const* name, Unit const& unit, char const* meaning, Text const& text = {})
{
    return figure<&MeasuredProgram::figures, member>(name, unit, meaning, text);
}

}  // namespace

Rows<MeasuredProgram> wire_figures()
{
    using Program = WireProgram;
    using Figures = WireFigures;
    static constexpr std::array rows = {
        given<&Program::teeth>("teeth", one, "tooth spaces around"),
        given<&Program::external>("external", one, "whether the teeth are outside"),
        given<&Program::wire_diameter>("wire_diameter", mm, "as the scene says", {"wire diameter", significant<6>}),
        given<&Program::spark_gap>("spark_gap", mm, "as the scene says", {"spark gap", significant<6>}),
        given<&Program::contour_error>("contour_error", um, "of the points of the nominal contours, and of the radii",
                                       {"error of the contours", significant<3>}),
        given<&Program::cup_error>("cup_error", um, "of the displacement of the sections of an elastic cup",
                                   {"error, bent sections", significant<3>}),
        given<&Program::machine, &WireMachine::thickness>("thickness", mm, "from the lower to the upper face",
                                                          {"workpiece", significant<6>}),
        given<&Program::machine, &WireMachine::lower_guide>("lower_guide", mm, "lower guide below the lower face",
                                                            {"lower guide", significant<6>}),
        given<&Program::machine, &WireMachine::upper_guide>("upper_guide", mm, "upper guide above the upper face",
                                                            {"upper guide", significant<6>}),
        given<&Program::machine, &WireMachine::guide_distance>("guide_distance", mm, "from guide to guide",
                                                               {"guides", significant<6>}),
        given<&Program::decimals>("decimals", one, "of every rounded output"),
        found<&Figures::face_shift>("face_shift", mm, "largest distance of matched points",
                                    {"face shift", decimals<6>}),
        found<&Figures::least_shift>("least_face_shift", mm, "smallest distance of matched points",
                                     {"least", decimals<6>}),
        found<&Figures::guide_shift>("guide_offset", mm, "largest distance of the guides seen along the axis",
                                     {"guide offset", decimals<6>}),
        found<&Figures::tilt>("largest_wire_tilt", degree, "largest angle of the wire from the axis",
                              {"wire tilt", decimals<6>}),
        found<&Figures::ellipse>("wire_ellipse", um, "how much longer than wide the wire cuts in the plane of a face",
                                 {"wire's ellipse", significant<3>}),
        found<&Figures::travel>("travel", mm, "largest way of a guide along an axis", {"travel", decimals<3>}),
        found<&Figures::uv_travel>("uv_travel", mm, "largest way of the upper guide against the lower one",
                                   {"upper against lower guide", decimals<3>}),
        Row{"sync_marks", one, "marks that CAM synchronises on, per face",
            [](Of of) { return static_cast<double>(of.program.nominal.sync.size()); }, Kind::count}
            .printed({"sync marks", whole})};
    return Rows<MeasuredProgram>(rows);
}

Rows<MeasuredProgram> wire_check_figures()
{
    using Figures = WireFigures;
    static constexpr std::array rows = {
        given<&WireProgram::tolerance>("tolerance", um, "of the surface that is cut", {"tolerance", significant<3>}),
        found<&Figures::face_error>("face_error", um, "of the cut from the nominal faces, apart from residual material",
                                    {"cut off the faces", significant<3>}),
        found<&Figures::guide_chord>("guide_chord", um, "chord error at the guides, of straight moves",
                                     {"chord at the guides", significant<3>}),
        found<&Figures::middle_error>("middle_error", um, "of the cut from the true sections between the faces",
                                      {"cut between the faces", significant<3>}),
        found<&Figures::ruling_error>(
            "ruling_error", um, "of straight lines from the true sections",
            {"rulings", [](double size) { return significant<3>(size > rounding * per_um ? size : 0); }}),
        found<&Figures::normal_angle>("matched_edges_turn", degree, "largest angle between matched edges",
                                      {"matched edges turn by", decimals<4>}),
        found<&Figures::constant_taper_error>("constant_taper_error", um,
                                              "what G51 would be wrong by on the walls of the upper face",
                                              {"constant taper", significant<3>}),
        Row{"constant_taper_known_to", um, "how well that is known",
            [](Of of) { return wedm::taper_known_to(of.program, of.figures); }}
            .printed({"+-", significant<3>})};
    return Rows<MeasuredProgram>(rows);
}

Rows<FaceRadii> face_figures()
{
    static constexpr std::array rows = {
        figure<&FaceRadii::inner>("inner_radius", mm, "smallest distance from the axis", {"radii", decimals<6>}),
        figure<&FaceRadii::outer>("outer_radius", mm, "largest distance from the axis", {"to", decimals<6>})};
    return Rows<FaceRadii>(rows);
}

Rows<MeasuredPass> pass_figures()
{
    using T = MeasuredPass;
    using Figures = PassFigures;
    static constexpr std::array rows = {
        figure<&T::pass, &WirePass::number>("pass", one, "number of the pass", {"pass", whole}),
        figure<&T::pass, &WirePass::offset>("offset", mm, "wire centre to nominal contour", {"offset", decimals<6>}),
        figure<&T::pass, &WirePass::stock>("stock", mm, "left for later passes", {"stock", decimals<6>}),
        figure<&T::pass, &WirePass::reversed>("reversed", one, "whether it runs against the first pass"),
        figure<&T::figures, &Figures::blocks>("blocks", one, "moves after the start hole", {"blocks", whole}),
        figure<&T::figures, &Figures::length>("length", mm, "of the path in the lower face", {"length", decimals<3>}),
        figure<&T::figures, &Figures::shortest>("shortest_block", mm, "in either face", {"shortest", decimals<6>}),
        figure<&T::figures, &Figures::residual>("residual", um, "highest material left; 0: no more than its error",
                                                {"residual", decimals<3>, significant<3>})
            .with_error<&T::figures, &Figures::residual_error>(),
        figure<&T::figures, &Figures::residuals>("residual_places", one, "places with material left")};
    return Rows<T>(rows);
}

Rows<Residual> residual_figures()
{
    using Coordinate = FigureOf<Residual>;
    static constexpr std::array rows = {
        figure<&Residual::pass>("pass", one, "number of the pass", {"pass", whole}),
        figure<&Residual::tooth>("tooth", one, "tooth space", {"tooth space", whole}),
        Coordinate{"x", mm, "nominal point", [](Residual const& of) { return of.where.x(); }}.printed(
            {"x", decimals<4>}),
        Coordinate{"y", mm, "nominal point", [](Residual const& of) { return of.where.y(); }}.printed(
            {"y", decimals<4>}),
        figure<&Residual::height>("height", um, "distance of that point from the cut, less the stock",
                                  {"highest", significant<3>}),
        figure<&Residual::meshing>("meshing", one, "whether it is on a flank")};
    return Rows<Residual>(rows);
}

Rows<WireFile> wire_file_figures()
{
    static constexpr std::array rows = {
        figure<&WireFile::set_up>("set_up", one, "number of the set-up"),
        figure<&WireFile::pass>("pass", one, "number of the pass; 0: all"),
        figure<&WireFile::blocks>("blocks", one, "straight moves", {"blocks", whole}),
        figure<&WireFile::bytes>("bytes", one, "size", {"bytes", whole}),
        figure<&WireFile::unit>("unit", um, "last digit; 0: not rounded"),
        figure<&WireFile::drift>("drift", um, "largest distance of the path read back from the exact one",
                                 {"drift", significant<2>}),
        figure<&WireFile::cut_error>("cut_error", um, "bound of the cut from the nominal faces, with the drift",
                                     {"cut", significant<3>})};
    return Rows<WireFile>(rows);
}

std::vector<std::string> wire_warnings(WireProgram const& program, std::vector<WireFile> const& files)
{
    std::vector<WireFile const*> worst;  // of each dialect
    for (WireFile const& file : files) {
        auto const same = std::ranges::find(worst, file.dialect, &WireFile::dialect);
        if (same == worst.end())
            worst.push_back(&file);
        else if (file.cut_error > (*same)->cut_error)
            *same = &file;
    }
    std::vector<std::string> warnings = program.warnings;
    if (std::isnan(program.figures.middle_error))
        warnings.emplace_back(
            "the cut between the faces was not checked: the outline has no slice between its ends; solve it with "
            "slices.count = 3 or more");
    else if (program.figures.middle_error > program.tolerance)
        warnings.push_back(fmt::format(
            "a straight wire cuts up to {} off the true sections between the faces, more than wedm.tolerance = {}: "
            "wedm.surface_limit accepts it",
            um_text(program.figures.middle_error), um_text(program.tolerance)));
    for (WireFile const* const file : worst)
        if (program.tolerance > 0 && file->cut_error > program.tolerance)
            warnings.push_back(fmt::format(
                "dialect {}: a cut by its files may be {} off the faces, more than wedm.tolerance = {}: the path in "
                "them is up to {} off the exact one, which is {} off the faces; the column cut shows which dialects "
                "keep the tolerance",
                file->dialect, um_text(file->cut_error), um_text(program.tolerance), um_text(file->drift),
                um_text(file->cut_error - file->drift)));
    return warnings;
}

}  // namespace hdconj::figures
