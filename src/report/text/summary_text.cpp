// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "figures/number_text.hpp"
#include "figures/summary_figures.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

std::string milliseconds(double seconds)
{
    return figures::decimals<3>(figures::unit::millisecond.shown(seconds)) + " " + figures::unit::millisecond.text;
}

void write_geometry(Page& page, Solution const& solution)
{
    auto const rows = figures::geometry_figures();
    Told const told(rows, solution);
    write_drive(page, solution);
    if (solution.scene.is_reverse())
        page.line("given: tooth of the circular spline; computed: tooth of the flexspline");
    page.line("\ngeometry");
    page.figure(rows["r_m"], solution, "undeformed");
    page.figure(rows["r_0"], solution,
                fmt::format("deformed, w is counted from it; r_0 - r_m = {} +- {}", told.with_unit("r_0_less_r_m"),
                            told.error("r_0")));
    page.figure(rows["w0"], solution);
    page.figure(rows["pitch_line"], solution, "above the neutral curve");
    page.figure(rows["flexspline_inner_radius"], solution);
    page.figure(rows["tip_radius"], solution, "circular spline");
    page.figure(rows["space_depth"], solution, "from the tip circle, " + told.error_with_unit("space_depth"));
    page.figure(rows["land_width"], solution, "along the tip circle, " + told.error_with_unit("land_width"));
}

void write_zones(Page& page, Solution const& solution, SummaryDetail detail)
{
    bool const listed = detail == SummaryDetail::zones;
    page.line("\nconjugate zones: {} on {} branches ({} regular, {} of corners){}", solution.zones.size(),
              solution.branches.size(), figures::branches_of_kind(solution, "regular"),
              figures::branches_of_kind(solution, "corner"), listed ? "" : "; --verbose lists them");
    if (!listed || solution.zones.empty())
        return;
    std::size_t widest = std::string("segment").size();
    for (auto const& zone : solution.zones)
        widest = std::max(widest, zone.segment_name.size());
    page.line("  {:<{}}  {:<8}{:>10}{:>12}{:>11}{:>9}   {:<6} {}", "segment", widest, "kind", "phi from", "to [deg]",
              "t from", "to", "side", "used");
    for (auto const& zone : solution.zones) {
        Told const told(figures::zone_figures(), zone);
        page.line("  {:<{}}  {:<8}{:>10}{:>12}{:>11}{:>9}   {:<6} {}", zone.segment_name, widest, zone.kind,
                  told("phi_begin"), told("phi_end"), told("t_begin"), told("t_end"), zone.outer ? "outer" : "inner",
                  zone.on_boundary ? "yes" : "-");
    }
    Told const errors(figures::error_figures(), solution);
    page.line("  rounding moves the ends of zones by at most {} of phi and {} of t", errors.with_unit("error_zone_phi"),
              errors("error_zone_t"));
}

/// What the smallest clearance means within the asked-for tolerance.
char const* pair_verdict(double clearance, double tolerance)
{
    return clearance < -tolerance   ? "the teeth interfere"
           : clearance <= tolerance ? "the teeth touch"
                                    : "the teeth are apart";
}

void write_certificate(Page& page, Solution const& solution)
{
    auto const& places = solution.certificate.undecided;
    if (places.empty()) {
        page.line("  certified: all {} roots found, none lost", solution.work.roots_isolated);
        return;
    }
    page.line("  not certified: {} place{} where rounding hides the number of contacts", places.size(),
              plural(places.size()));
    for (auto const& place : places) {
        Told const told(figures::undecided_figures(), place);
        page.line("    {} t {}, u {} +- {}, reach {}: {}", place.segment_name, told("t"), told("u"),
                  told.with_unit("u_width"), told.with_unit("reach"), place.what);
    }
}

void write_errors(Page& page, Solution const& solution)
{
    auto const rows = figures::error_figures();
    Told const told(rows, solution), drive(figures::drive_figures(), solution);
    auto const line = [&](char const* name, char const* sign, std::string const& note) {
        page.figure(rows[name].text.label, sign + told.with_unit(name), note);
    };
    line("error_point", "<= ", "");
    line("error_chord", "<= ", "asked for " + drive.with_unit("tolerance"));
    if (solution.error.cup > 0)
        line("error_cup", "+- ", "of the computed cup and bearing; the outline moves by as much");
    if (solution.scene.solver.kinematics == Kinematics::first_order && !solution.scene.is_elastic())
        page.line("  error of the first-order motion itself: hdconj accuracy --study motion-model");
    page.figure(rows["error_arc_length_relative"].text.label, told("error_arc_length_relative"));
}

void write_timing(Page& page, Solution const& solution)
{
    Told const work(figures::work_figures(), solution.work);
    page.line("\ntime, {} thread{}", solution.threads, plural(static_cast<std::size_t>(solution.threads)));
    for (auto const& entry : solution.timing)
        page.figure(entry.stage, milliseconds(entry.seconds));
    page.figure("total", milliseconds(figures::total_seconds(solution)),
                fmt::format("{} contacts, {} roots, {} edges", work("envelope_points"), work("roots_isolated"),
                            work("arrangement_edges")));
}

void write_files(Page& page, std::vector<WrittenFile> const& written)
{
    if (written.empty())
        return;
    page.line("\nwritten");
    for (auto const& file : written)
        page.figure(file.kind, milliseconds(file.seconds), file.file.string());
}

void write_clearance(Page& page, Solution const& solution)
{
    auto const rows = figures::clearance_figures();
    if (!solution.check) {
        page.line("  {:<{}}{:>14}", rows["smallest_clearance"].text.label, Page::label_width, "not computed");
        return;
    }
    Told const told(rows, solution);
    page.figure(
        rows["smallest_clearance"], solution,
        fmt::format("{}, {}: at ({}, {}) mm{}, tooth at phi {}", told.error_with_unit("smallest_clearance"),
                    pair_verdict(solution.check->smallest_clearance, solution.scene.solver.tolerance),
                    told("clearance_x"), told("clearance_y"),
                    solution.scene.is_reverse() ? " of the flexspline tooth" : "", told.with_unit("clearance_phi")));
    page.line("  {:<{}}{} points x {} positions over a full turn", "", Page::label_width, told("checked_points"),
              told("checked_positions"));
}

void write_outline(Page& page, Solution const& solution)
{
    auto const& spline = solution.circular_spline;
    bool const reverse = solution.scene.is_reverse();
    if (reverse) {
        page.line("\nflexspline tooth, computed: {} points, {} pieces", solution.flexspline_outline.size(),
                  solution.flexspline_pieces.size());
    }
    page.line("{}circular spline{}: {} slice{}, {} points, {} pieces", reverse ? "" : "\n", reverse ? ", given" : "",
              spline.outline.size(), plural(spline.outline.size()), figures::outline_points(solution),
              spline.pieces.size());
    write_clearance(page, solution);
    write_notes(page, solution.notes);
    write_errors(page, solution);
    write_judgement(page, solution.judgement);
}

}  // namespace

std::string surface_columns(ToothSurface surface, std::optional<TiltKind> kind, std::string const& tilt)
{
    return fmt::format("  {:<10}{:<7}{:>6}", to_string(surface), kind ? to_string(*kind) : "-",
                       kind || surface == ToothSurface::tilted ? tilt : "-");
}

void write_drive(Page& page, Solution const& solution)
{
    auto const& drive = solution.scene.drive;
    page.line("{}: module {:g} mm, teeth {}/{}, ratio {}, {} waves, kinematics {}", drive.name, drive.module,
              drive.flexspline_teeth, drive.circular_spline_teeth, Told(figures::geometry_figures(), solution)("ratio"),
              solution.scene.wave_generator.waves, figures::kinematics_name(solution));
}

void write_slices(Page& page, std::vector<double> const& z)
{
    if (z.empty())
        return;
    auto const [first, last] = std::minmax_element(z.begin(), z.end());
    page.figure("slices", std::to_string(z.size()), fmt::format("z {:g} ... {:g} mm", *first, *last));
}

void write_notes(Page& page, std::vector<std::string> const& notes)
{
    for (auto const& note : notes)
        page.line("  note: {}", note);
}

void write_judgement(Page& page, Notes const& notes)
{
    if (std::string const text = describe(notes); !text.empty())
        page.line("\n{}", std::string_view(text).substr(0, text.size() - 1));
}

void write_end(Page& page, Solution const& solution, std::vector<WrittenFile> const& written)
{
    write_certificate(page, solution);
    write_errors(page, solution);
    write_judgement(page, solution.judgement);
    write_timing(page, solution);
    write_files(page, written);
}

}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(Solution const& solution, std::vector<WrittenFile> const& written, SummaryDetail detail)
{
    report::Page page;
    report::write_geometry(page, solution);
    report::write_outline(page, solution);
    report::write_zones(page, solution, detail);
    report::write_certificate(page, solution);
    report::write_timing(page, solution);
    report::write_files(page, written);
    return page.text();
}

}  // namespace hdconj
