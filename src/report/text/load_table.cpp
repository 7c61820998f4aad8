// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_table.hpp"

#include <algorithm>

#include "figures/load_figures.hpp"

namespace hdconj::report {
namespace {

using ToldLoad = Told<LoadCase>;

bool is_changed(LoadCase const& each)
{
    return each.side_clearance_increased || each.tip_radius_increase > 0;
}

void write_values(Page& page, LoadStudy const& study, LoadCase const& each)
{
    ToldLoad const told(figures::load_case_figures(), each);
    auto const& stages = each.stages;
    bool const any = stages.first != 0;
    std::string row = fmt::format("{}{:>8}{}{:>9}{:>9}{:>9}{:>8}", surface_columns(figures::load_case_figures(), each),
                                  told("backlash_offset"), is_changed(each) ? '*' : ' ', told("backlash"),
                                  any ? told("first_stage") : "-",
                                  stages.found ? told("second_stage")
                                  : any        ? "="
                                               : "-",
                                  stages.found ? told("knee") : "-");
    if (auto const* state = figures::rated_state(each)) {
        Told const at(figures::loaded_state_figures(study.balls), *state);
        row += fmt::format("{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", at("twist"), at("teeth"), at("contact_fraction"),
                           at("fraction_within_gap"), at("largest_pressure"), at("largest_force"),
                           state->largest_stress > 0 ? at("largest_stress") : "-");
    } else {
        row += "   not computed";
    }
    page.line("{}", row);
}

void write_errors_of(Page& page, LoadStudy const& study, LoadCase const& each)
{
    if (!each.estimated) {
        page.line("    +-     no error estimate: it needs three slices, and equilibrium on a grid half as fine");
        return;
    }
    ToldLoad const told(figures::load_case_figures(), each);
    Told const at(figures::loaded_state_figures(study.balls), each.error);
    bool const bend = each.stages.found;
    page.line("{:<25}{:>8}{:>10}{:>9}{:>9}{:>8}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "    +-", "",
              told.error("backlash"), each.stages.first != 0 ? told.error("first_stage") : "-",
              bend ? told.error("second_stage") : "", bend ? told.error("knee") : "", at.error("twist"),
              at.error("teeth"), at.error("contact_fraction"), at.error("fraction_within_gap"),
              each.pressure_at_edge ? "edge" : at.error("largest_pressure"), at.error("largest_force"),
              each.error.largest_stress > 0 ? at.error("largest_stress") : "-");
}

/// The surfaces that are not as the scene gives them.
void write_changed(Page& page, LoadStudy const& study)
{
    page.line(
        "  *: with the side clearance and tip circle of the scene the assembled teeth would press on both flanks, or "
        "no land would be left; computed with:");
    for (auto const& each : study.cases) {
        ToldLoad const told(figures::load_case_figures(), each);
        if (is_changed(each)) {
            page.line("    {}{:>9} um side clearance, tip circle {}, enlarged by {}",
                      surface_columns(figures::load_case_figures(), each), told("backlash_offset"),
                      told.with_unit("tip_radius"), told.with_unit("tip_radius_increase"));
        }
    }
}

/// What the signs in the table mean, of those that are there.
void write_legend(Page& page, LoadStudy const& study)
{
    auto const any = [&](auto condition) { return std::any_of(study.cases.begin(), study.cases.end(), condition); };
    page.line(
        "  offset: side clearance; contact: flank under pressure; within: flank with a gap up to {}; both of the area "
        "of all flanks on the loaded side",
        Told(figures::load_study_figures(), study).with_unit("contact_gap"));
    page.line(
        "  +-: four times the difference from a grid half as fine in slices, flank points, circles and harmonics, on "
        "another mesh (twelve times below nine slices); for the stages with the standard error of their fit");
    if (any([](auto const& each) { return each.pressure_at_edge; })) {
        page.line(
            "  edge: the largest pressure is at an end of the face width and grows with the number of slices; forces "
            "converge");
    }
    if (study.sharp_steps) {
        page.line(
            "  stress: largest in the sharp corners between barrel and toothed ring, where it grows with a finer mesh; "
            "write rear_fillet and front_fillet in [flexspline.cup]");
    }
    if (any(is_changed))
        write_changed(page, study);
    if (any([](auto const& each) { return !each.stages.found && each.stages.first != 0; }))
        page.line("  =: one straight line fits the curve as well as two");
    if (any([](auto const& each) { return each.backlash < 0; }))
        page.line("  backlash below zero: the assembled teeth press on both flanks");
}

}  // namespace

void write_load_table(Page& page, LoadStudy const& study)
{
    // Tilt ends in column 25; the columns of the stages follow, then those of the largest torque.
    page.line("\n{:<25}{:>44}   at {}", "", "", rated_torque(study));
    page.line("  {:<10}{:<7}{:>6}{:>8}{:>10}{:>18}{:>8}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "surface", "kind",
              "tilt", "offset", "backlash", "stiffness: stages", "knee", "twist", "teeth", "contact", "within",
              "pressure", "force", "stress");
    page.line("  {:<10}{:<7}{:>6}{:>8}{:>10}{:>9}{:>9}{:>8}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "", "", "deg", "um",
              "arcmin", "N m/deg", "N m/deg", "N m", "arcmin", "", "%", "%", "MPa", "N", "MPa");
    for (auto const& each : study.cases) {
        write_values(page, study, each);
        write_errors_of(page, study, each);
    }
    write_legend(page, study);
}

}  // namespace hdconj::report
