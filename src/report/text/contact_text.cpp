// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "figures/contact_figures.hpp"
#include "figures/number_text.hpp"
#include "hdconj/contact_files.hpp"
#include "summary_page.hpp"

namespace hdconj::report {
namespace {

using ToldCase = Told<ContactCase>;

void write_contact_setting(Page& page, ContactStudy const& study)
{
    auto const& coning = study.solution.scene.coning;
    Told const told(figures::contact_study_figures(), study);
    page.line("\ncontact where the gap is {} or less", told.with_unit("contact_gap"));
    write_slices(page, study.solution.circular_spline.z);
    page.figure("coning", std::string(coning ? to_string(coning->model) : "none"));
    page.figure(figures::contact_study_figures()["pitch_radius"], study, "radius at which backlash is a length");
    if (!study.cases.empty()) {
        page.figure(figures::state_figures()["wave_generator"], study.cases.front().state,
                    "from a tooth space of the circular spline");
    }
}

std::string with_sign(std::string const& error)
{
    return "+- " + error;
}

/// An angle and its error as backlash at the pitch circle [um].
std::string length_text(double angle, ContactStudy const& study)
{
    return figures::fixed<2>(figures::unit::um.shown(figures::at_pitch_circle(angle, study)));
}
std::string length_error(double angle, ContactStudy const& study)
{
    return with_sign(figures::significant<1>(figures::unit::um.shown(figures::at_pitch_circle(angle, study))));
}

void write_contact_row(Page& page, ContactStudy const& study, ContactCase const& each)
{
    auto const& state = each.state;
    ToldCase const told(figures::case_figures(), each);
    Told const at(figures::state_figures(), state);
    page.line("{}{:>11}{:>10}{:>10}{:>10}{}{:>10}{:>10}{:>7}{:>10}{}", surface_columns(figures::case_figures(), each),
              each.slices.empty() ? "-" : told("flank_clearance"), told("least_side_clearance"),
              told("backlash_of_least_side_clearance"), told("backlash_offset"),
              each.side_clearance_increased ? '*' : ' ', at("backlash"), length_text(state.backlash(), study),
              at("teeth"), at("contact_fraction"), study.estimated ? " +- " + at.error("contact_fraction") : "");
    if (!study.estimated)
        return;
    std::string teeth;
    if (state.teeth_least != state.teeth || state.teeth_most != state.teeth)
        teeth = fmt::format("{}-{}", state.teeth_least, state.teeth_most);
    page.line("{:<25}{:>11}{:>10}{:>10}{:>10} {:>10}{:>10}{:>7}", "", with_sign(told.error("flank_clearance")),
              with_sign(told.error("least_side_clearance")), with_sign(told.error("backlash_of_least_side_clearance")),
              "", with_sign(at.error("backlash")), length_error(state.backlash_error(), study), teeth);
}

void write_contact_table(Page& page, ContactStudy const& study)
{
    // Tilt ends in column 25, then clearance 11 wide, twice offset and backlash 10 wide, the latter also as a length.
    page.line("\n{:<25}{:>10}{:>21}{:>31}", "", "as given", "least side clearance", "as computed:");
    page.line("  {:<10}{:<7}{:>6}{:>11}{:>20}{:>31}{:>7}{:>14}", "surface", "kind", "tilt", "clearance",
              "and its backlash", "clearance, backlash", "teeth", "contact area");
    page.line("  {:<10}{:<7}{:>6}{:>11}{:>10}{:>10}{:>10}{:>11}{:>10}{:>7}{:>14}", "", "", "deg", "um", "um", "arcmin",
              "um", "arcmin", "um", "", "%");
    for (auto const& each : study.cases)
        write_contact_row(page, study, each);
    auto const any = [&](auto condition) { return std::any_of(study.cases.begin(), study.cases.end(), condition); };
    if (!study.estimated)
        page.line("  no error estimates: they need a run without --no-errors");
    if (any([](auto const& each) { return each.side_clearance_increased; }))
        page.line("  *: more side clearance than the scene gives, with which the flanks would interfere");
    double const tolerance = study.solution.scene.solver.tolerance;
    bool const pressed =
        any([&](auto const& each) { return figures::at_pitch_circle(each.state.backlash(), study) < -tolerance; });
    if (pressed)
        page.line("  backlash below zero: the teeth press on both flanks and would interfere by as much");
}

char const* verdict(double clearance, double tolerance)
{
    return clearance < -tolerance ? "interfere" : clearance <= tolerance ? "touch" : "apart";
}

void write_closest(Page& page, std::string const& begin, char const* what, figures::ClosestPlace const& closest,
                   SliceClearance const& slice, double tolerance, bool estimated)
{
    Told const told(figures::closest_figures(), closest);
    page.line("{:<25}   {:<7}{:>10}{:>10}{:>10}{:>9}{:>10}   {}{}", begin, what, told("clearance"), told("x"),
              told("y"), Told(figures::slice_figures(), slice)("z"), told("phi"),
              verdict(closest.at.clearance, tolerance), estimated ? " " + told.error_with_unit("clearance") : "");
}

/// One line, where the case needs something or deviates.
void write_needs(Page& page, ContactStudy const& study, ContactCase const& each)
{
    double const tip = study.solution.geometry.circular_spline_inner_radius;
    std::vector<std::string> needs;
    double const tolerance = study.solution.scene.solver.tolerance;
    ToldCase const told(figures::case_figures(), each);
    auto const with_error = [&](char const* name) {
        return study.estimated ? fmt::format("{} {}", told(name), told.error_with_unit(name)) : told.with_unit(name);
    };
    if (each.tip > tip + tolerance) {
        // where moved flanks meet is known as well as they are
        std::string const error =
            each.tip == each.least_tip_radius ? told.error("least_tip_radius") : figures::significant<1>(tolerance);
        needs.push_back(fmt::format("needs a tip circle of {}{} mm instead of {} mm", told("tip_radius"),
                                    study.estimated ? " +- " + error : "", figures::decimals<4>(tip)));
    }
    if (each.least_root_clearance > 0)
        needs.push_back(fmt::format("needs {} more root clearance", with_error("least_root_clearance")));
    if (each.surface == ToothSurface::ruled)
        needs.push_back(
            fmt::format("up to {} off the conjugate outlines of the slices", with_error("ruled_deviation")));
    // a place that one plane decides lies between its neighbours
    if (study.estimated && each.slices.size() > 3 &&
        each.closest_z_to - each.closest_z_from > 2.5 * (each.slices[1].z - each.slices[0].z)) {
        needs.push_back(fmt::format("the flanks are equally close, within the error, from z = {} to {}",
                                    told("flank_z_from"), told.with_unit("flank_z_to")));
    }
    if (!needs.empty())
        page.line("  {}: {}", figures::case_name(each), fmt::join(needs, ", "));
}

void write_contact_places(Page& page, ContactStudy const& study)
{
    double const tolerance = study.solution.scene.solver.tolerance;
    page.line("\nwhere the teeth come closest over a full turn, {}",
              study.solution.scene.circular_spline.automatic_backlash ? "without side clearance"
                                                                      : "with the side clearance of the scene");
    page.line("  {:<10}{:<7}{:>6}   {:<7}{:>10}{:>10}{:>10}{:>9}{:>10}", "surface", "kind", "tilt", "", "clearance",
              "x", "y", "z", "phi");
    page.line("  {:<10}{:<7}{:>6}   {:<7}{:>10}{:>10}{:>10}{:>9}{:>10}", "", "", "deg", "", "um", "mm", "mm", "mm",
              "deg");
    for (auto const& each : study.cases) {
        if (each.slices.empty()) {
            page.line("{}   not computed", surface_columns(figures::case_figures(), each));
            continue;
        }
        auto const& root = figures::closest_root(each);
        write_closest(page, surface_columns(figures::case_figures(), each), "flanks",
                      {each.closest_flank(), each.clearance_error}, each.closest_slice(), tolerance, study.estimated);
        write_closest(page, "", "root", {root.root, each.root_clearance_error}, root, tolerance, study.estimated);
    }
    for (auto const& each : study.cases)
        write_needs(page, study, each);
    write_notes(page, study.solution.notes);
}

/// "12 ... 14", as the values of a figure over the states.
std::string range(std::vector<ContactState> const& states, char const* name)
{
    auto const figure = figures::state_figures()[name];
    auto const [low, high] = std::minmax_element(
        states.begin(), states.end(), [&](auto const& a, auto const& b) { return figure.value(a) < figure.value(b); });
    auto const shown = [&](auto const& state) { return figure.text_unit().shown(figure.value(state)); };
    return fmt::format("{:.4g} ... {:.4g}", shown(*low), shown(*high));
}

/// The largest error of a figure over the states.
std::string largest_error(std::vector<ContactState> const& states, char const* name)
{
    auto const figure = figures::state_figures()[name];
    double high = 0;
    for (auto const& state : states)
        high = std::max(high, figure.error(state));
    return with_sign(figures::significant<1>(figure.text_unit().shown(high)));
}

void write_revolutions(Page& page, ContactStudy const& study)
{
    auto const error = [&](std::vector<ContactState> const& states, char const* name) {
        return study.estimated ? " " + largest_error(states, name) : "";
    };
    for (auto const& each : study.cases) {
        auto const& states = each.revolution;
        if (states.empty())
            continue;
        page.line("\nover a revolution, {} angles: {}", states.size(), figures::case_name(each));
        page.line("  contact area {} %{}, teeth {}, backlash {} arcmin{}", range(states, "contact_fraction"),
                  error(states, "contact_fraction"), range(states, "teeth"), range(states, "backlash"),
                  error(states, "backlash"));
    }
}

void write_best(Page& page, ContactStudy const& study)
{
    if (study.best.empty())
        return;
    page.line("\nbest tilt");
    for (auto const& each : study.best) {
        Told const told(figures::best_tilt_figures(), each);
        auto const value = figures::best_value_figure(each);
        page.figure(std::string(to_string(each.kind)) + ", for " + figures::goal_name(each), told.with_unit("tilt"),
                    fmt::format("+- {}, {} {}{}; searched {} ... {}{}", told.with_unit("tolerance"), value.text.label,
                                value.value_with_unit(each), study.estimated ? " +- " + value.error_text(each) : "",
                                told("from"), told.with_unit("to"),
                                each.on_bound ? "; an end of this interval: the best tilt may lie outside" : ""));
        if (each.refused > 0) {
            page.line("    no surface exists at {} of the tilts tried, only from {} to {}: {}", each.refused,
                      told("possible_from"), told.with_unit("possible_to"), each.refusal);
        }
    }
}

}  // namespace
}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(ContactStudy const& study, std::vector<WrittenFile> const& written)
{
    report::Page page;
    report::write_drive(page, study.solution);
    report::write_contact_setting(page, study);
    report::write_contact_table(page, study);
    report::write_contact_places(page, study);
    report::write_revolutions(page, study);
    report::write_best(page, study);
    if (study.written_case < study.cases.size())
        page.line("\ncircular spline in the result file: {}", figures::case_name(study.cases[study.written_case]));
    report::write_end(page, study.solution, written);
    return page.text();
}

}  // namespace hdconj
