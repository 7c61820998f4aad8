// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "contact_figures.hpp"
#include "hdconj/io/contact_files.hpp"
#include "summary_figures.hpp"
#include "summary_page.hpp"

namespace hdconj {
namespace {

constexpr double percent = 100;

double degrees(double angle)
{
    return angle * degree_per_radian;
}

/// Fixed decimals, and never "-0.00".
std::string fixed(double value, int decimals)
{
    std::string text = fmt::format("{:.{}f}", value, decimals);
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

void write_setting(Page& page, ContactStudy const& study)
{
    auto const& z = study.solution.circular_spline.z;
    auto const& coning = study.solution.scene.coning;
    page.line("\ncontact where the gap is {:g} um or less", study.contact_gap * um_per_mm);
    if (!z.empty()) {
        auto const [first, last] = std::minmax_element(z.begin(), z.end());
        page.figure("slices", std::to_string(z.size()), fmt::format("z {:g} ... {:g} mm", *first, *last));
    }
    page.figure("coning", coning ? coning->model : "none");
    page.figure("pitch circle", fmt::format("{:.6f} mm", study.pitch_radius), "radius, for play as a length");
    if (!study.cases.empty()) {
        page.figure("wave generator", fixed(degrees(study.cases.front().state.wave_generator), 4) + " deg",
                    "from a tooth space of the circular spline");
    }
}

/// Surface, kind and tilt, as wide as in both tables.
std::string begin_row(ContactCase const& each)
{
    bool const tilted = !each.kind.empty();
    return fmt::format("  {:<10}{:<7}{:>6}", each.surface, tilted ? each.kind : "-",
                       tilted || each.surface == "tilted" ? fmt::format("{:.3g}", degrees(each.tilt)) : "-");
}

/// An error: as little of it as says how large it is.
std::string error_text(double error)
{
    return fmt::format("+- {:.1g}", error);
}

void write_row(Page& page, ContactStudy const& study, ContactCase const& each)
{
    auto const& state = each.state;
    std::string const clearance = each.slices.empty() ? "-" : fixed(each.closest_flank().clearance * um_per_mm, 2);
    page.line("{}{:>11}{:>10}{:>10}{:>10}{}{:>10}{:>10}{:>7}{:>10.4g} +- {:.2g}", begin_row(each), clearance,
              fixed(each.clearing_offset * um_per_mm, 2), fixed(each.backlash_of_clearing * arcmin_per_radian, 2),
              fixed(each.backlash_offset * um_per_mm, 2), each.raised ? '*' : ' ',
              fixed(state.backlash() * arcmin_per_radian, 2),
              fixed(at_pitch_circle(state.backlash(), study) * um_per_mm, 2), state.teeth, state.share * percent,
              state.share_error * percent);
    std::string teeth;
    if (state.teeth_least != state.teeth || state.teeth_most != state.teeth) {
        teeth = fmt::format("{}-{}", state.teeth_least, state.teeth_most);
    }
    page.line("{:<25}{:>11}{:>10}{:>10}{:>10} {:>10}{:>10}{:>7}", "", error_text(each.clearance_error * um_per_mm),
              error_text(each.clearing_offset_error * um_per_mm), error_text(each.backlash_of_clearing_error * arcmin_per_radian), "",
              error_text(state.backlash_error() * arcmin_per_radian), error_text(at_pitch_circle(state.backlash_error(), study) * um_per_mm), teeth);
}

void write_table(Page& page, ContactStudy const& study)
{
    // Tilt ends in column 25, then clearance 11 wide, twice offset and backlash 10 wide, the latter also as a length.
    page.line("\n{:<25}{:>11}{:>20}{:>31}", "", "as made", "to clear: offset", "as computed: offset,");
    page.line("  {:<10}{:<7}{:>6}{:>11}{:>20}{:>31}{:>7}{:>14}", "surface", "kind", "tilt", "clearance", "and its backlash",
              "and backlash", "teeth", "contact area");
    page.line("  {:<10}{:<7}{:>6}{:>11}{:>10}{:>10}{:>10}{:>11}{:>10}{:>7}{:>14}", "", "", "deg", "um", "um", "arcmin",
              "um", "arcmin", "um", "", "%");
    for (auto const& each : study.cases) {
        write_row(page, study, each);
    }
    bool const raised =
        std::any_of(study.cases.begin(), study.cases.end(), [](auto const& each) { return each.raised; });
    if (raised) {
        page.line("  *: more than the scene gives, because with that the teeth enter the flanks");
    }
    double const tolerance = study.solution.scene.solver.tolerance;
    bool const wedged = std::any_of(study.cases.begin(), study.cases.end(), [&](auto const& each) {
        return at_pitch_circle(each.state.backlash(), study) < -tolerance;
    });
    if (wedged) {
        page.line("  backlash below zero: the flexspline is wedged, it would have to enter by as much");
    }
}

char const* verdict(double clearance, double tolerance)
{
    return clearance < -tolerance ? "interfere" : clearance <= tolerance ? "touch" : "apart";
}

void write_closest(Page& page, std::string const& begin, char const* what, Closest const& closest, double z,
                   double tolerance, double error)
{
    page.line("{:<25}   {:<7}{:>10}{:>10}{:>10}{:>9}{:>10}   {} {} um", begin, what, fixed(closest.clearance * um_per_mm, 2),
              fixed(closest.where.x(), 4), fixed(closest.where.y(), 4), fixed(z, 3), fixed(degrees(closest.phi), 3),
              verdict(closest.clearance, tolerance), error_text(error * um_per_mm));
}

/// One line, where the case needs something or deviates.
void write_needs(Page& page, ContactStudy const& study, ContactCase const& each)
{
    double const tip = study.solution.geometry.circular_spline_inner_radius;
    std::vector<std::string> needs;
    double const tolerance = study.solution.scene.solver.tolerance;
    if (each.tip > tip + tolerance) {
        // where moved flanks meet is known as well as they are
        double const error = each.tip == each.clearing_tip ? each.clearing_tip_error : tolerance;
        needs.push_back(fmt::format("needs the tip circle {:.4f} {} mm instead of {:.4f} mm", each.tip, error_text(error), tip));
    }
    if (each.clearing_root > 0) {
        needs.push_back(fmt::format("needs {:.3g} {} um more root clearance", each.clearing_root * um_per_mm, error_text(each.clearing_root_error * um_per_mm)));
    }
    if (each.surface == "ruled") {
        needs.push_back(fmt::format("up to {:.3g} {} um from the slices' own conjugate outlines", each.ruled_deviation * um_per_mm, error_text(each.ruled_deviation_error * um_per_mm)));
    }
    // a place that one plane decides lies between its neighbours
    if (each.slices.size() > 3 && each.closest_z_to - each.closest_z_from > 2.5 * (each.slices[1].z - each.slices[0].z)) {
        needs.push_back(fmt::format("the flanks come as close, within that error, anywhere from z = {} to {} mm", fixed(each.closest_z_from, 3), fixed(each.closest_z_to, 3)));
    }
    if (!needs.empty()) {
        page.line("  {}: {}", case_name(each), fmt::join(needs, ", "));
    }
}

void write_places(Page& page, ContactStudy const& study)
{
    double const tolerance = study.solution.scene.solver.tolerance;
    page.line("\nwhere the teeth come closest over a full turn, with the side clearance that the scene gives");
    page.line("  {:<10}{:<7}{:>6}   {:<7}{:>10}{:>10}{:>10}{:>9}{:>10}", "surface", "kind", "tilt", "", "clearance", "x",
              "y", "z", "phi");
    page.line("  {:<10}{:<7}{:>6}   {:<7}{:>10}{:>10}{:>10}{:>9}{:>10}", "", "", "deg", "", "um", "mm", "mm", "mm", "deg");
    for (auto const& each : study.cases) {
        if (each.slices.empty()) {
            page.line("{}   not computed", begin_row(each));
            continue;
        }
        auto const root = std::min_element(each.slices.begin(), each.slices.end(), [](auto const& a, auto const& b) {
            return a.root.clearance < b.root.clearance;
        });
        write_closest(page, begin_row(each), "flanks", each.closest_flank(), each.closest_slice().z, tolerance, each.clearance_error);
        write_closest(page, "", "root", root->root, root->z, tolerance, each.root_clearance_error);
    }
    for (auto const& each : study.cases) {
        write_needs(page, study, each);
    }
    for (auto const& note : study.solution.notes) {
        page.line("  note: {}", note);
    }
}

/// "12 ... 14", in the unit of @p scale.
template <class Take>
std::string range(std::vector<ContactState> const& states, double scale, Take take)
{
    double low = take(states.front()), high = low;
    for (auto const& state : states) {
        low = std::min<double>(low, take(state));
        high = std::max<double>(high, take(state));
    }
    return fmt::format("{:.4g} ... {:.4g}", low * scale, high * scale);
}

template <class Take>
double largest(std::vector<ContactState> const& states, Take take)
{
    double high = 0;
    for (auto const& state : states) {
        high = std::max<double>(high, take(state));
    }
    return high;
}

void write_revolutions(Page& page, std::vector<ContactCase> const& cases)
{
    constexpr double whole = 1;
    for (auto const& each : cases) {
        auto const& states = each.revolution;
        if (states.empty()) {
            continue;
        }
        page.line("\nover a revolution, {} angles: {}", states.size(), case_name(each));
        page.line("  contact area {} % {}, teeth {}, backlash {} arcmin {}",
                  range(states, percent, [](auto const& state) { return state.share; }),
                  error_text(percent * largest(states, [](auto const& state) { return state.share_error; })),
                  range(states, whole, [](auto const& state) { return state.teeth; }),
                  range(states, arcmin_per_radian, [](auto const& state) { return state.backlash(); }),
                  error_text(arcmin_per_radian * largest(states, [](auto const& state) { return state.backlash_error(); })));
    }
}

void write_best(Page& page, std::vector<BestTilt> const& best)
{
    if (best.empty()) {
        return;
    }
    page.line("\nbest tilt");
    for (auto const& each : best) {
        std::string const value = each.what == "area"
                                      ? fmt::format("contact area {:.4g} % {}", each.value * percent, error_text(each.value_error * percent))
                                      : fmt::format("clearing offset {} {}", um(each.value), error_text(each.value_error * um_per_mm));
        page.figure(each.kind + ", by " + each.what, fmt::format("{:.4f} deg", degrees(each.tilt)),
                    fmt::format("+- {:.1g} deg, {}; searched {:g} ... {:g} deg{}", degrees(each.tolerance), value,
                                degrees(each.from), degrees(each.to),
                                each.on_bound ? ", and on the bound: it may lie beyond" : ""));
        if (each.refused > 0) {
            page.line("    {} of the tilts tried make no surface, those from {:g} to {:g} deg do: {}", each.refused, degrees(each.possible_from), degrees(each.possible_to), each.refusal);
        }
    }
}

}  // namespace

std::string summary_text(ContactStudy const& study, std::vector<WrittenFile> const& written)
{
    Page page;
    write_drive(page, study.solution);
    write_setting(page, study);
    write_table(page, study);
    write_places(page, study);
    write_revolutions(page, study.cases);
    write_best(page, study.best);
    if (study.shown < study.cases.size()) {
        page.line("\ncircular spline, as written: {}", case_name(study.cases[study.shown]));
    }
    write_end(page, study.solution, written);
    return page.text();
}

}  // namespace hdconj
