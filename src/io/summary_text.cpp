// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "summary_figures.hpp"
#include "summary_page.hpp"

namespace hdconj {
namespace {

constexpr double ms_per_s = 1000;

std::string mm(double value)
{
    return fmt::format("{:.6f} mm", value);
}

double degrees(double angle)
{
    return angle * degree_per_radian;
}

void write_geometry(Page& page, Solution const& solution)
{
    auto const& geometry = solution.geometry;
    auto const& error = solution.error;
    write_drive(page, solution);
    if (solution.scene.is_reverse()) {
        page.line("given: the circular spline's tooth; solved for: the flexspline's");
    }
    page.line("\ngeometry");
    page.figure("neutral radius r_m", mm(geometry.r_m), "undeformed");
    page.figure("base radius r_0", mm(geometry.r_0),
                fmt::format("deformed, w is counted from it; r_0 - r_m = {:+.3f} um +- {:.1e}", (geometry.r_0 - geometry.r_m) * um_per_mm, error.r_0 * um_per_mm));
    page.figure("radial deformation w0", mm(geometry.w0));
    page.figure("pitch line", mm(geometry.pitch_line), "above the neutral curve");
    page.figure("flexspline inner radius", mm(geometry.flexspline_inner_radius));
    page.figure("tip radius", mm(geometry.circular_spline_inner_radius), "circular spline");
    page.figure("depth of tooth space", mm(geometry.space_depth), "from the tip circle, +- " + um(error.space_depth));
    page.figure("land between spaces", mm(land_width(geometry)), "along the tip circle, +- " + um(error.land));
}

void write_zones(Page& page, Solution const& solution)
{
    auto const kinds = [&](char const* kind) {
        return std::count_if(solution.branches.begin(), solution.branches.end(),
                             [&](auto const& branch) { return branch.kind == kind; });
    };
    page.line("\nconjugate zones: {} on {} branches ({} regular, {} of corners)", solution.zones.size(),
              solution.branches.size(), kinds("regular"), kinds("corner"));
    if (solution.zones.empty()) {
        return;
    }
    std::size_t widest = std::string("segment").size();
    for (auto const& zone : solution.zones) {
        widest = std::max(widest, zone.segment_name.size());
    }
    page.line("  {:<{}}  {:<8}{:>10}{:>12}{:>11}{:>9}   {:<6} {}", "segment", widest, "kind", "phi from", "to [deg]",
              "t from", "to", "side", "used");
    for (auto const& zone : solution.zones) {
        page.line("  {:<{}}  {:<8}{:>10.4f}{:>12.4f}{:>11.4f}{:>9.4f}   {:<6} {}", zone.segment_name, widest, zone.kind,
                  degrees(zone.phi_begin), degrees(zone.phi_end), zone.t_begin, zone.t_end,
                  zone.outer ? "outer" : "inner", zone.on_boundary ? "yes" : "-");
    }
    page.line("  by rounding the ends of zones are off by at most {:.1e} deg and {:.1e} of t", degrees(largest(solution.zones, &ConjugateZone::phi_error)),
              largest(solution.zones, &ConjugateZone::t_error));
}

/// What the smallest clearance means within the asked-for tolerance.
char const* verdict(double clearance, double tolerance)
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
    page.line("  not certified: {} place{} where rounding hides the number of contacts", places.size(), places.size() == 1 ? "" : "s");
    for (auto const& place : places) {
        page.line("    {} t {:.6f}, u {:.6f} +- {:.1e} deg, reach {:.1e} um: {}", place.segment_name, place.t, degrees(place.u),
                  degrees(place.u_width / 2), place.reach * um_per_mm, place.what);
    }
}

void write_errors(Page& page, Solution const& solution)
{
    page.figure("error, written points", um(solution.error.point, "<= "));
    page.figure("error, chords", um(solution.error.chord, "<= "),
                fmt::format("asked for {:g} um", solution.scene.solver.tolerance * um_per_mm));
    if (solution.error.cup > 0) {
        page.figure("error, bent sections", um(solution.error.cup, "+- "), "as cup and bearing are resolved; the outline moves with them");
    }
    if (solution.scene.solver.kinematics == Kinematics::first_order && !solution.scene.is_elastic()) {
        page.line("  of the first-order motion itself: hdconj accuracy --study motion-model");
    }
    page.figure("closed length, relative", fmt::format("{:.1e}", solution.error.arc_length));
}

void write_timing(Page& page, Solution const& solution)
{
    page.line("\ntime, {} thread{}", solution.threads, solution.threads == 1 ? "" : "s");
    for (auto const& entry : solution.timing) {
        page.figure(entry.stage, fmt::format("{:.3f} ms", entry.seconds * ms_per_s));
    }
    page.figure("total", fmt::format("{:.3f} ms", total_seconds(solution) * ms_per_s),
                fmt::format("{} contacts, {} roots, {} edges", solution.work.envelope_points,
                            solution.work.roots_isolated, solution.work.arrangement_edges));
}

void write_files(Page& page, std::vector<WrittenFile> const& written)
{
    if (written.empty()) {
        return;
    }
    page.line("\nwritten");
    for (auto const& file : written) {
        page.figure(file.kind, fmt::format("{:.3f} ms", file.seconds * ms_per_s), file.file.string());
    }
}

void write_outline(Page& page, Solution const& solution)
{
    auto const& spline = solution.circular_spline;
    bool const reverse = solution.scene.is_reverse();
    if (reverse) {
        page.line("\nflexspline tooth, solved for: {} points, {} pieces", solution.flexspline_outline.size(),
                  solution.flexspline_pieces.size());
    }
    page.line("{}circular spline{}: {} slice{}, {} points, {} pieces", reverse ? "" : "\n", reverse ? ", given" : "",
              spline.outline.size(), spline.outline.size() == 1 ? "" : "s", outline_points(solution),
              spline.pieces.size());
    if (solution.check) {
        auto const& check = *solution.check;
        page.figure("smallest clearance", um(check.smallest_clearance),
                    fmt::format("+- {}, {}: at ({:.4f}, {:.4f}) mm{}, tooth at phi {:.3f} deg", um(solution.error.clearance),
                                verdict(check.smallest_clearance, solution.scene.solver.tolerance), check.where.x(),
                                check.where.y(), reverse ? " of the flexspline tooth" : "", degrees(check.at_phi)));
        page.line("  {:<{}}{} points x {} positions over a full turn", "", Page::label_width, check.points, check.positions);
    } else {
        page.line("  {:<{}}{:>14}", "smallest clearance", Page::label_width, "not computed");
    }
    for (auto const& note : solution.notes) {
        page.line("  note: {}", note);
    }
    write_errors(page, solution);
}

}  // namespace

std::string um(double value_mm, char const* sign)
{
    return fmt::format("{}{:.3g} um", sign, value_mm * um_per_mm);
}

void write_drive(Page& page, Solution const& solution)
{
    auto const& drive = solution.scene.drive;
    page.line("{}: m {:g} mm, z_f/z_c {}/{}, ratio {:g}, {} waves, kinematics {}", drive.name, drive.module,
              drive.flexspline_teeth, drive.circular_spline_teeth, solution.geometry.ratio,
              solution.scene.wave_generator.waves, to_string(solution.scene.is_elastic() ? Kinematics::material : solution.scene.solver.kinematics));
}

void write_end(Page& page, Solution const& solution, std::vector<WrittenFile> const& written)
{
    write_certificate(page, solution);
    write_errors(page, solution);
    write_timing(page, solution);
    write_files(page, written);
}

std::string summary_text(Solution const& solution, std::vector<WrittenFile> const& written)
{
    Page page;
    write_geometry(page, solution);
    write_zones(page, solution);
    write_certificate(page, solution);
    write_outline(page, solution);
    write_timing(page, solution);
    write_files(page, written);
    return page.text();
}

}  // namespace hdconj
