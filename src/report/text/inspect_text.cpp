// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "figures/inspect_figures.hpp"
#include "hdconj/inspect_files.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

/// Flanks and teeth that a summary lists one by one; of more only the worst are named.
constexpr std::size_t most_listed = 8;

/// A row with its interval, "12.345 um   +- 0.021 um"; the interval is not known without an estimate of the noise.
template <class Record>
void with_interval(Page& page, figures::Rows<Record> const& rows, Record const& record, char const* name,
                   std::string const& note = "")
{
    auto const& row = rows[name];
    std::string const error = std::isfinite(row.error(record)) ? row.error_with_unit(record) : "+- not known";
    page.figure(row.text.label, row.value_with_unit(record), note.empty() ? error : error + "   " + note);
}

void write_placement(Page& page, Inspection const& inspection)
{
    auto const rows = figures::placement_figures();
    auto const& placement = inspection.placement;
    Told const of_all(figures::inspection_figures(), inspection);
    page.line("\nregistration: {}", to_string(inspection.options.registration));
    if (inspection.options.registration != Registration::datum)
        with_interval(page, rows, placement, "turn", "clockwise");
    if (inspection.options.registration != Registration::datum &&
        inspection.options.registration != Registration::turn) {
        with_interval(page, rows, placement, "shift_x");
        with_interval(page, rows, placement, "shift_y");
    }
    page.figure(rows["deviation_rms"], placement);
    page.figure("smallest, largest", rows["deviation_least"].value_with_unit(placement),
                rows["deviation_largest"].value_with_unit(placement));
    bool const known = inspection.freedom > 0;
    page.figure("noise of a point", known ? of_all.with_unit("noise") : "not known",
                known ? "standard deviation; a deviation is +- " + rows["deviation_error"].value_with_unit(placement)
                      : "too few points on each flank");
    if (inspection.beside + inspection.strays > 0)
        page.figure("not evaluated", of_all("points_beside"),
                    "beside the flanks; " + of_all("points_stray") + " strays left out");
    if (inspection.repeated + inspection.elsewhere > 0)
        page.figure("not read", of_all("points_repeated"),
                    "repeated; " + of_all("points_elsewhere") + " in other planes");
}

void write_nominal(Page& page, Inspection const& inspection)
{
    for (auto const& each : inspection.nominal) {
        auto const rows = figures::nominal_figures();
        Told const told(rows, each);
        page.line("\nnominal outline at z = {}", told.with_unit("z"));
        for (char const* name : {"flank_length", "reference_radius", "nominal_thickness"})
            page.figure(rows[name], each, told.error_with_unit(name));
    }
}

void write_side(Page& page, SideFigures const& side)
{
    auto const rows = figures::side_rows();
    Told const told(rows, side);
    page.line("\n{} flanks at z = {}: {} evaluated", figures::flank_word(side.right), told.with_unit("z"),
              told("flanks"));
    with_interval(page, rows, side, "mean_profile_slope");
    with_interval(page, rows, side, "mean_profile_crowning");
    with_interval(page, rows, side, "largest_profile_form", "tooth " + told("form_tooth"));
    with_interval(page, rows, side, "largest_profile_total", "tooth " + told("total_tooth"));
    if (side.pitches == 0)
        return;
    auto const pitch = figures::pitch_rows();
    Told const of_pitch(pitch, side);
    with_interval(page, pitch, side, "single_pitch_deviation", "up to tooth " + of_pitch("single_pitch_tooth"));
    with_interval(page, pitch, side, "total_pitch_deviation",
                  "from tooth " + of_pitch("total_pitch_from") + " to " + of_pitch("total_pitch_to"));
}

void write_plane(Page& page, InspectedPart part, PlaneFigures const& plane)
{
    auto const rows = figures::plane_rows();
    Told const told(rows, plane);
    page.line("\n{} at z = {}: {} with both flanks", part == InspectedPart::flexspline ? "teeth" : "tooth spaces",
              told.with_unit("z"), told("teeth"));
    with_interval(page, rows, plane, "mean_thickness");
    if (plane.teeth > 1)
        with_interval(page, rows, plane, "runout", "from tooth " + told("runout_from") + " to " + told("runout_to"));
    if (!plane.circle)
        return;
    auto const circle = figures::eccentricity_rows();
    with_interval(page, circle, plane, "eccentricity",
                  "towards " + Told(circle, plane).with_unit("eccentricity_direction"));
}

void write_flanks(Page& page, std::vector<FlankFigures> const& flanks)
{
    if (flanks.empty() || flanks.size() > most_listed)
        return;
    page.line("\nflanks, um\n  {:>6}{:>8}{:>8}{:>12}{:>10}{:>10}{:>10}{:>10}", "tooth", "flank", "points", "position",
              "total", "slope", "crowning", "form");
    for (auto const& flank : flanks) {
        Told const told(figures::flank_rows(), flank);
        page.line("  {:>6}{:>8}{:>8}{:>12}{:>10}{:>10}{:>10}{:>10}", told("tooth"), figures::flank_word(flank.right),
                  told("points"), told("position"), told("profile_total"), told("profile_slope"),
                  told("profile_crowning"), told("profile_form"));
    }
}

void write_definitions(Page& page, Inspection const& inspection)
{
    page.line("\ndefinitions");
    if (inspection.options.part == InspectedPart::circular_spline)
        page.line("  tooth       a tooth space of the circular spline; its thickness is the width of the space");
    page.line("  deviation   signed distance to the nominal flank along its normal, less the probe's radius; positive");
    page.line("              outside the material; the parabola is that of least squares against arc length");
    page.line(
        "  position    arc along the reference circle by which the flank is turned clockwise: there the parabola is");
    page.line("              0 at the middle of the flank. Profile figures are those of the flank so turned");
    page.line(
        "  slope       rise of the parabola from the root end of the flank to its tip end, positive: too much material "
        "there");
    page.line("  crowning    height of the parabola at the middle above its chord");
    page.line("  form, total largest less smallest deviation from the parabola; from the nominal flank");
    page.line("  f_pt, F_p   largest pitch deviation; largest less smallest position");
    page.line("  runout      largest less smallest radial shift; thickness is an arc of the reference circle");
    page.line(
        "  +-          holds the figure of the part without noise in 95 of 100 measurements; of largest figures in");
    page.line("              at least 95");
    page.line("  These are no f_Ha, f_fa and F_a of ISO 1328, which are an involute's.");
    for (auto const& note : inspection.notes)
        page.line("  note: {}", note);
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(Inspection const& inspection, std::vector<WrittenFile> const& written)
{
    using namespace report;
    Page page;
    auto const& options = inspection.options;
    Told const told(figures::inspection_figures(), inspection);
    page.line("{}: inspection of the {}, {} points of {}", inspection.scene.drive.name, to_string(options.part),
              told("points"), inspection.file);
    if (options.probe != 0)
        page.figure("probe radius", told.with_unit("probe_radius"),
                    options.probe > 0 ? "centres outside the material" : "centres inside the material");
    write_nominal(page, inspection);
    write_placement(page, inspection);
    for (auto const& side : inspection.sides)
        write_side(page, side);
    for (auto const& plane : inspection.planes)
        write_plane(page, options.part, plane);
    write_flanks(page, inspection.flanks);
    write_definitions(page, inspection);
    for (auto const& file : written)
        page.figure(file.kind, file.file.string());
    return page.text();
}

}  // namespace hdconj
