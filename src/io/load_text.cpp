// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "load_figures.hpp"
#include "summary_figures.hpp"
#include "summary_page.hpp"

namespace hdconj {
namespace {

/// An error to two digits, whole numbers without an exponent.
std::string two_digits(double error)
{
    constexpr double whole = 99.5;
    return error >= whole ? fmt::format("{:.0f}", error) : fmt::format("{:.2g}", error);
}

constexpr double percent = 100;

/// Fixed decimals, and never "-0.00".
std::string fixed(double value, int decimals)
{
    std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

/// Three or four digits that count, as a length of text that suits a table.
std::string short_number(double value)
{
    constexpr double hundred = 100, ten = 10;
    double const size = std::abs(value);
    return fixed(value, size >= hundred ? 0 : size >= ten ? 1 : 2);
}

void write_setting(Page& page, LoadStudy const& study)
{
    auto const& cup = study.cup;
    page.line("\ncup on the wave generator, without torque");
    auto const worth = [&](double error, char const* units) { return cup.estimated ? fmt::format("+- {} {}", two_digits(error), units) : std::string(); };
    auto const and_worth = [&](std::string const& words, double error, char const* units) { return cup.estimated ? worth(error, units) + "; " + words : words; };
    page.figure("coning, major axis", fixed(cup.coning_major * degree_per_radian, 4) + " deg",
                and_worth("slope of the radial displacement over the toothed width", cup.coning_major_error * degree_per_radian, "deg"));
    page.figure("coning, minor axis", fixed(cup.coning_minor * degree_per_radian, 4) + " deg", worth(cup.coning_minor_error * degree_per_radian, "deg"));
    if (!cup.z.empty()) {
        auto const [first, last] = std::minmax_element(cup.z.begin(), cup.z.end());
        page.figure("slices", std::to_string(cup.z.size()), fmt::format("z {:g} ... {:g} mm", *first, *last));
    }
    page.figure("wave generator force", fmt::format("{:.1f} N", cup.wave_generator_force), and_worth(fmt::format("without direction, over {} places", cup.contacts), cup.wave_generator_force_error, "N"));
    if (cup.ball_force > 0) {
        page.figure(study.balls > 0 ? "largest force of a ball" : "largest force of the balls", fmt::format("{:.1f} {}", cup.ball_force, ball_units(study)),
                    and_worth(study.balls > 0 ? fmt::format("at {} deg; {} of {} balls carry", fixed(cup.ball_phi * degree_per_radian, 1), cup.balls, study.balls)
                                              : fmt::format("of their line, at {} deg", fixed(cup.ball_phi * degree_per_radian, 1)),
                              cup.ball_force_error, ball_units(study)));
    }
    if (cup.largest_stress > 0) {
        page.figure("largest stress", fmt::format("{:.1f} MPa", cup.largest_stress), and_worth("von Mises, inside the elements", cup.largest_stress_error, "MPa"));
    }
    page.figure("edges of the teeth", fmt::format("{:.4g} um", study.edge_radius * um_per_mm), "radius under load");
    if (study.tip_widened > 0) {
        page.figure("tip circle", fmt::format("{:.4f} mm", study.solution.geometry.circular_spline_inner_radius),
                    fmt::format("circular spline; {:.1f} um wider than the standard one, which leaves no land between spaces", study.tip_widened * um_per_mm));
    }
    page.figure("harmonics", fmt::format("up to {}", study.harmonics), study.sectors > 1 ? fmt::format("the solved sector repeats {} times", study.sectors) : "");
}

/// Surface, kind and tilt, as wide as in all tables.
std::string begin_row(LoadCase const& each)
{
    bool const tilted = !each.kind.empty();
    return fmt::format("  {:<10}{:<7}{:>6}", each.surface, tilted ? each.kind : "-",
                       tilted || each.surface == "tilted" ? fmt::format("{:.3g}", each.tilt * degree_per_radian) : "-");
}

void write_row(Page& page, LoadCase const& each)
{
    auto const& stages = each.stages;
    std::string const first = stages.first == 0 ? "-" : short_number(stages.first * nm_per_deg);
    std::string const second = stages.found ? short_number(stages.second * nm_per_deg) : stages.first == 0 ? "-" : "=";
    std::string const knee = stages.found ? short_number(stages.knee * nm_per_nmm) : "-";
    std::string row = fmt::format("{}{:>8}{}{:>9}{:>9}{:>9}{:>8}", begin_row(each), fixed(each.backlash_offset * um_per_mm, 2), each.raised || each.tip_change > 0 ? '*' : ' ', fixed(each.backlash * arcmin_per_radian, 2), first, second, knee);
    if (auto const* state = rated_state(each)) {
        row += fmt::format("{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", fixed(state->twist * arcmin_per_radian, 2), state->teeth, fmt::format("{:.3g}", state->contact_share * percent),
                           fmt::format("{:.3g}", state->near_share * percent), short_number(state->largest_pressure), short_number(state->largest_force),
                           state->largest_stress > 0 ? short_number(state->largest_stress) : "-");
    } else {
        row += "   not computed";
    }
    page.line("{}", row);
    if (!each.estimated) {
        page.line("    +-     no estimate: it takes three slices, and a balance on a grid half as fine");
        return;
    }
    auto const& error = each.error;
    auto const* state = rated_state(each);
    auto const of = [](double value) { return fmt::format("{:.2g}", value); };
    // a line through the branch is as uncertain as what it rises over
    double const elastic = state != nullptr ? std::abs(state->twist) - each.backlash / 2 : 0;
    double const relative = elastic > 0 ? (error.twist + each.backlash_error / 2) / elastic : 0;
    std::string const first_error = stages.first == 0 ? "-" : of((stages.first_error + relative * stages.first) * nm_per_deg);
    std::string const second_error = stages.found ? of((stages.second_error + relative * stages.second) * nm_per_deg) : "";
    page.line("{:<25}{:>8}{:>10}{:>9}{:>9}{:>8}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "    +-", "", of(each.backlash_error * arcmin_per_radian), first_error, second_error,
              stages.found ? of(stages.knee_error * nm_per_nmm) : "", of(error.twist * arcmin_per_radian), error.teeth, of(error.contact_share * percent), of(error.near_share * percent),
              each.pressure_at_edge ? "edge" : short_number(error.largest_pressure), of(error.largest_force), error.largest_stress > 0 ? short_number(error.largest_stress) : "-");
}

void write_table(Page& page, LoadStudy const& study)
{
    // Tilt ends in column 25; the columns of the stages follow, then those of the largest torque.
    page.line("\n{:<25}{:>44}{}", "", "", fmt::format("   at {:g} N m", study.rated_torque * nm_per_nmm));
    page.line("  {:<10}{:<7}{:>6}{:>8}{:>10}{:>18}{:>8}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "surface", "kind", "tilt", "offset", "backlash", "stiffness: stages", "bend", "twist", "teeth",
              "contact", "near", "pressure", "force", "stress");
    page.line("  {:<10}{:<7}{:>6}{:>8}{:>10}{:>9}{:>9}{:>8}{:>10}{:>7}{:>9}{:>9}{:>10}{:>8}{:>9}", "", "", "deg", "um", "arcmin", "N m/deg", "N m/deg", "N m", "arcmin", "", "%", "%", "MPa",
              "N", "MPa");
    for (auto const& each : study.cases) {
        write_row(page, each);
    }
    page.line("  contact: flank under pressure; near: gap no larger than {:g} um; of the area of all flanks of the loaded side", study.contact_gap * um_per_mm);
    page.line("  +-: four times the distance from a grid half as fine in slices, flank points, circles and harmonics, on another mesh (below nine slices twelve times); of stages with the standard error of their fit");
    if (std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return each.pressure_at_edge; })) {
        page.line("  edge: the largest pressure is at an end of the face width, where it does not converge; what it adds up to does");
    }
    if (study.sharp_steps) {
        page.line("  stress: the wall steps from barrel to ring in sharp corners, where it grows with the mesh; rear_fillet and front_fillet round them");
    }
    bool const any_moved = std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return each.raised || each.tip_change > 0; });
    if (any_moved) {
        page.line("  *: with what the scene gives the assembled teeth press on both flanks, and this surface has what clears over a full turn; or the side clearance leaves no land, and the tip circle follows:");
        for (auto const& each : study.cases) {
            if (each.raised || each.tip_change > 0) {
                page.line("    {}{:>9} um side clearance, tip circle {:.6f} mm, {:.2f} um wider than its own", begin_row(each), fixed(each.backlash_offset * um_per_mm, 2), each.tip,
                          each.tip_change * um_per_mm);
            }
        }
    }
    bool const one_line = std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return !each.stages.found && each.stages.first != 0; });
    if (one_line) {
        page.line("  =: one line, the curve has no bend that would make two stages of it");
    }
    if (std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return each.backlash < 0; })) {
        page.line("  backlash below zero: the assembled teeth press on both flanks");
    }
}

void write_places(Page& page, LoadStudy const& study)
{
    page.line("\nwhere it is largest, at {:g} N m", study.rated_torque * nm_per_nmm);
    for (auto const& each : study.cases) {
        auto const* state = rated_state(each);
        if (state == nullptr) {
            continue;
        }
        auto const space = static_cast<std::size_t>(state->pressure_space);
        std::string const angle = space < each.map.angle.size() ? fmt::format("tooth space at {} deg, ", fixed(each.map.angle[space] * degree_per_radian, 2)) : "";
        std::string text = fmt::format("  {}: pressure {} MPa in the {}slice z = {} mm", case_name(each), short_number(state->largest_pressure), angle, fixed(state->pressure_z, 3));
        if (state->largest_stress > 0) {
            text += fmt::format("; stress {} MPa at z = {} mm, r = {} mm, {} deg", short_number(state->largest_stress), fixed(state->stress_z, 2), fixed(state->stress_r, 2),
                                fixed(state->stress_phi * degree_per_radian, 1));
        }
        page.line("{}", text);
    }
    page.line("\nbearing, at {:g} N m", study.rated_torque * nm_per_nmm);
    for (auto const& each : study.cases) {
        auto const* state = rated_state(each);
        if (state == nullptr) {
            continue;
        }
        auto const worth = [&](double error) { return each.estimated ? " +- " + two_digits(error) : std::string(); };
        std::string text = fmt::format("  {}: lobe at the major axis {}{} N along it, {}{} N across it, at z = {}{} mm; wave generator {:.4g}{} N m", case_name(each),
                                       short_number(state->lobe_force), worth(each.error.lobe_force), short_number(state->lobe_force_across), worth(each.error.lobe_force_across),
                                       fixed(state->lobe_z, 2), worth(each.error.lobe_z), state->wave_generator_torque * nm_per_nmm, worth(each.error.wave_generator_torque * nm_per_nmm));
        if (state->ball_force > 0) {
            text += fmt::format("; balls up to {}{} {} at {} deg", short_number(state->ball_force), worth(each.error.ball_force), ball_units(study),
                                fixed(state->ball_phi * degree_per_radian, 1));
            text += study.balls > 0 ? fmt::format(", {} of {} carry", state->balls, study.balls) : "";
        }
        page.line("{}", text);
    }
    if (study.balls > 0) {
        for (auto const& each : study.cases) {
            std::string text;
            for (std::size_t b = 0; b < each.bearing.ball_angle.size(); ++b) {
                text += fmt::format("{}{:.1f} at {:.1f}", b > 0 ? ", " : "", each.bearing.ball_force[b], each.bearing.ball_angle[b] * degree_per_radian);
            }
            page.line("  {}: balls of {}, N at deg: {}", case_name(each), study.sectors > 1 ? fmt::format("1/{} of the ring", study.sectors) : "the ring", text);
        }
    }
    LoadedState worst;
    int rounds = 0;
    for (auto const& each : study.cases) {
        for (auto const& state : each.curve) {
            worst.residual = std::max(worst.residual, state.residual);
            worst.complementarity = std::max(worst.complementarity, state.complementarity);
            rounds = std::max(rounds, state.rounds);
        }
    }
    page.line("  solved to: gap against the loaded shape {:.2g} um, force and gap {:.1e} relative; {} rounds of the geometry at most", worst.residual * um_per_mm,
              worst.complementarity, rounds);
}

std::string rig_text(MeasuredCurve const& curve)
{
    std::string text = curve.columns;
    if (curve.rig.torque_constant != 0) {
        text += fmt::format(", {:g} N m/A", curve.rig.torque_constant);
        text += curve.rig.efficiency != 1 ? fmt::format(", efficiency {:g}", curve.rig.efficiency) : "";
    }
    text += curve.rig.counts_per_turn != 0 ? fmt::format(", {:g} counts per turn", curve.rig.counts_per_turn) : "";
    text += curve.rig.torque_constant != 0 || curve.rig.counts_per_turn != 0 ? fmt::format(", ratio {:g}", curve.rig.ratio) : "";
    return text;
}

void write_measured(Page& page, LoadStudy const& study, Measurement const& measured)
{
    auto const& [curve, found] = measured;
    auto const* simulated = shown_case(study);
    page.line("\nmeasured: {} ({})", curve.file, rig_text(curve));
    page.line("  {} samples, {} load cycle{} up to {:.4g} N m, angles in steps of {:.3g} arcmin", curve.twist.size(), found.cycles, found.cycles == 1 ? "" : "s",
              found.largest_torque * nm_per_nmm, found.angle_step * arcmin_per_radian);
    page.line("  {:<26}{:>24}{:>12}{}", "", "measured", "of", simulated != nullptr ? "   simulated: " + case_name(*simulated) : "");
    for (auto const& figure : measured_figures()) {
        Estimate const& estimate = figure.value(found);
        auto value = simulated != nullptr ? figure.simulated(*simulated) : std::nullopt;
        if (value) {
            *value *= std::pow(curve.rig.angle_per_spline, figure.angles);
        }
        if (estimate.count == 0 && !value) {
            continue;
        }
        std::string const label = fmt::format("{} [{}]", figure.words, figure.text_units);
        std::string const text = estimate.count == 0 ? "-" : fmt::format("{:.4g} +- {:.2g}", estimate.value * figure.shown_per_stored, estimate.error * figure.shown_per_stored);
        page.line("  {:<26}{:>24}{:>12}   {}", label, text, estimate.count, value ? fmt::format("{:.4g}", *value * figure.shown_per_stored) : "-");
    }
    if (curve.rig.angle_per_spline != 1) {
        page.line("  at the output, the cup: it turns by {:.6g} times the angle of the circular spline, whose curve stands above", curve.rig.angle_per_spline);
    }
    if (found.straight > 0) {
        page.line("  {} of {} loading branches have no bend and are no part of the stages", found.straight, found.whole.count);
    }
}

}  // namespace

std::string summary_text(LoadStudy const& study, std::vector<WrittenFile> const& written, Measurement const* measured)
{
    Page page;
    write_drive(page, study.solution);
    write_setting(page, study);
    write_table(page, study);
    write_places(page, study);
    if (measured != nullptr) {
        write_measured(page, study, *measured);
    }
    for (auto const& note : study.missing) {
        page.line("  note: {}", note);
    }
    if (auto const* shown = shown_case(study)) {
        page.line("\ncup and circular spline, as written: {}", case_name(*shown));
    }
    write_end(page, study.solution, written);
    return page.text();
}

}  // namespace hdconj
