// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_table.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "figures/load_figures.hpp"
#include "hdconj/units.hpp"

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
    std::string row = fmt::format("{}{:>8}{}{:>9}", surface_columns(figures::load_case_figures(), each),
                                  told("backlash_offset"), is_changed(each) ? '*' : ' ', told("backlash"));
    for (char const* const name : {"K1", "K2", "K3"})
        row += fmt::format("{:>9}", each.catalogue ? Told(figures::catalogue_rows(), *each.catalogue)(name) : "-");
    if (auto const* state = figures::rated_state(each)) {
        Told const at(figures::loaded_state_figures(study.balls), *state);
        row += fmt::format("{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", at("twist"), at("teeth"), at("contact_fraction"),
                           at("fraction_within_gap"), at("largest_line_load"), at("largest_force"),
                           state->largest_stress > 0 ? at("largest_stress") : "-");
    } else {
        row += "   not computed";
    }
    page.line("{}", row);
}

void write_errors_of(Page& page, LoadStudy const& study, LoadCase const& each)
{
    if (!each.estimated) {
        page.line(
            "    +-     no error estimate: it needs three slices, equilibrium on a grid half as fine, and no "
            "--no-errors");
        return;
    }
    auto const of_case = [&, rows = figures::load_case_figures()](char const* name) {
        return marked_error(rows[name], each, each);
    };
    std::string row =
        fmt::format("{:<25}{:>8}{:>10}", "    +-", each.backlash_offset_error > 0 ? of_case("backlash_offset") : "",
                    of_case("backlash"));
    for (char const* const name : {"K1", "K2", "K3"})
        row += fmt::format(
            "{:>9}",
            each.catalogue ? marked_error(figures::catalogue_rows()[name], *each.catalogue, *each.catalogue) : "-");
    LoadedState const none;
    auto const* state = figures::rated_state(each);
    auto const error = [&, rows = figures::loaded_state_figures(study.balls)](char const* name) {
        return marked_error(rows[name], state != nullptr ? *state : none, each.error);
    };
    page.line("{}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", row, error("twist"), error("teeth"), error("contact_fraction"),
              error("fraction_within_gap"), error("largest_line_load"), error("largest_force"),
              each.error.largest_stress > 0 ? error("largest_stress") : "-");
}

/// The surfaces that are not as the scene gives them, those that were cleared or the others.
void write_changed(Page& page, LoadStudy const& study, bool cleared)
{
    auto const belongs = [&](LoadCase const& each) { return is_changed(each) && each.cleared == cleared; };
    if (std::ranges::none_of(study.cases, belongs))
        return;
    page.line("{}",
              cleared
                  ? "  *: with the side clearance and tip circle of the scene the assembled teeth would press on both "
                    "flanks, or their tips would interfere; computed with those that clear the unloaded cup's "
                    "teeth over a full turn:"
                  : "  *: with the tip circle of the scene a slice would have no land, or touch the rim; computed "
                    "with a wider one, clearance over a full turn not checked:");
    for (auto const& each : study.cases) {
        if (!belongs(each))
            continue;
        ToldLoad const told(figures::load_case_figures(), each);
        page.line("    {}{:>9} um side clearance, tip circle {}, enlarged by {}",
                  surface_columns(figures::load_case_figures(), each), told("backlash_offset"),
                  told.with_unit("tip_radius"), told.with_unit("tip_radius_increase"));
        if (each.given_tips)
            page.line(
                "      tips would interfere by {:.2f} um along the radius; with circular_spline.inner_radius = "
                "{} they pass",
                per_um * each.given_tips->depth, length_at_least(each.given_tips->least_tip));
    }
}

/// Whether a figure of a case, or the stiffness along its curve, has not converged.
bool has_unconverged(LoadStudy const& study, LoadCase const& each)
{
    auto const stiffness = figures::loaded_state_figures(study.balls)["stiffness"];
    for (std::size_t i = 0; i < each.curve.size(); ++i)
        if (auto const* error = figures::error_of(each, i);
            error != nullptr && figures::is_unconverged(stiffness, each.curve[i], *error))
            return true;
    return !figures::unconverged_figures(each, study.balls).empty();
}

/// What the signs in the table mean, of those that are there.
void write_legend(Page& page, LoadStudy const& study)
{
    auto const any = [&](auto condition) { return std::any_of(study.cases.begin(), study.cases.end(), condition); };
    page.line(
        "  offset: side clearance; contact: flank under pressure; within: flank with a gap up to {}; both of the area "
        "of all flanks on the loaded side",
        Told(figures::load_study_figures(), study).with_unit("contact_gap"));
    page.line("  line load: largest mean over half a millimetre of the face width");
    page.line(
        "  +-: four times the difference from a grid half as fine in slices, flank points, circles and harmonics, on "
        "another mesh (twelve times below nine slices)");
    if (any([&](auto const& each) { return has_unconverged(study, each); }))
        page.line("  ?: more than a third of the figure, which has not converged; try slices.count = 17 or 33");
    if (study.sharp_steps) {
        page.line(
            "  stress: largest in the sharp corners between barrel and toothed ring, where it grows with a finer mesh; "
            "write rear_fillet and front_fillet in [flexspline.cup]");
    }
    write_changed(page, study, true);
    write_changed(page, study, false);
    if (any([](auto const& each) { return each.backlash < 0 && !each.tips; }))
        page.line("  backlash below zero: the assembled teeth press on both flanks");
    if (any([](auto const& each) { return each.tips.has_value(); }))
        page.line("  backlash below zero: tips interfere along the radius, and no turn brings them apart");
}

}  // namespace

void write_load_table(Page& page, LoadStudy const& study)
{
    // Tilt ends in column 25; the columns of the whole curve follow, then those of the largest torque.
    page.line("\n{:<25}{:>45}   at {}", "", "", largest_torque(study));
    page.line("  {:<10}{:<7}{:>6}{:>8}{:>10}{:>9}{:>9}{:>9}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "surface", "kind",
              "tilt", "offset", "backlash", "K1", "K2", "K3", "twist", "teeth", "contact", "within", "line load",
              "force", "stress");
    page.line("  {:<10}{:<7}{:>6}{:>8}{:>10}{:>9}{:>9}{:>9}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "", "", "deg", "um",
              "arcmin", "N m/rad", "N m/rad", "N m/rad", "arcmin", "", "%", "%", "N/mm", "N", "MPa");
    for (auto const& each : study.cases) {
        write_values(page, study, each);
        write_errors_of(page, study, each);
        if (!is_rated(study, each))
            page.line("    at {}: no result at {}, see the notes", torque_of(each), rated_torque(study));
    }
    write_legend(page, study);
}

}  // namespace hdconj::report
