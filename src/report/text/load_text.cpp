// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/load_files.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "figures/load_figures.hpp"
#include "hdconj/units.hpp"
#include "load_table.hpp"
#include "measured_text.hpp"

namespace hdconj::report {
namespace {

/// What the scene says of reliefs and errors; nothing where it gives none.
void write_deviations(Page& page, Scene const& scene)
{
    auto const in_um = [](double length) { return fmt::format("{:g} um", figures::unit::um.shown(length)); };
    if (scene.tip_relief)
        page.figure("tip relief", in_um(scene.tip_relief->amount),
                    fmt::format("at the tip, from {:g} mm above the pitch line on", scene.tip_relief->from_height));
    if (scene.end_relief)
        page.figure("end relief", in_um(scene.end_relief->amount),
                    fmt::format("at both ends, over {:g} mm", scene.end_relief->length));
    if (scene.flow)
        page.figure("flow pressure", fmt::format("{:g} MPa", scene.flow->pressure), "of the flanks");
    if (scene.bearing && scene.bearing->clearance != 0)
        page.figure("bearing clearance", in_um(scene.bearing->clearance), "on the diameter, under torque");
    if (!scene.errors)
        return;
    auto const of_flanks = [&](char const* name, double slope, scene::NumberRows const& form) {
        if (slope != 0)
            page.figure("profile slope", in_um(slope), fmt::format("{}, tip over root", name));
        if (!form.empty())
            page.figure("profile form", fmt::format("{} rows", form.size()), name);
    };
    auto const of_ring = [&](char const* name, std::optional<RingErrors> const& ring) {
        if (!ring)
            return;
        if (!ring->pitch.empty())
            page.figure("pitch errors", fmt::format("{} teeth", ring->pitch.size()), name);
        else if (ring->pitch_deviation != 0)
            page.figure("pitch errors", in_um(ring->pitch_deviation),
                        fmt::format("{}, standard deviation, seed {}", name, scene.errors->seed));
        if (ring->eccentricity != 0)
            page.figure("eccentricity", in_um(ring->eccentricity), name);
        if (ring->wobble != 0)
            page.figure("wobble", fmt::format("{:g} deg", to_deg(ring->wobble)), name);
        of_flanks(name, ring->profile_slope, ring->profile_form);
    };
    of_ring("flexspline", scene.errors->flexspline);
    of_ring("circular spline", scene.errors->circular_spline);
    of_flanks("flexspline", scene.errors->profile_slope, scene.errors->profile_form);
    if (auto const& generator = scene.errors->wave_generator) {
        if (generator->eccentricity != 0)
            page.figure("eccentricity", in_um(generator->eccentricity), "wave generator");
        if (!generator->cam_deviation.empty())
            page.figure("cam deviation", fmt::format("{} rows", generator->cam_deviation.size()), "wave generator");
    }
}

void write_load_setting(Page& page, LoadStudy const& study)
{
    auto const& cup = study.cup;
    auto const rows = figures::assembled_cup_figures(study.balls);
    Told const told(rows, cup);
    page.line("\ncup on the wave generator, without torque");
    auto const line = [&](char const* name, std::string const& label, std::string const& words) {
        std::string const error = cup.estimated ? told.error_with_unit(name) : "";
        page.figure(label, told.with_unit(name), error + (error.empty() || words.empty() ? "" : "; ") + words);
    };
    line("coning_major", rows["coning_major"].text.label, "slope of the radial displacement over the slices");
    line("coning_minor", rows["coning_minor"].text.label, "");
    write_slices(page, cup.z);
    line("wave_generator_force", rows["wave_generator_force"].text.label,
         "sum without direction, over " + told("contacts") + " contact points");
    if (cup.ball_force > 0) {
        bool const single = study.balls > 0;
        line("ball_force", single ? "largest force of a ball" : "largest force of the balls",
             single ? fmt::format("at {}; {} of {} balls carry", told.with_unit("ball_phi"), told("balls"), study.balls)
                    : "balls as a continuous row, at " + told.with_unit("ball_phi"));
    }
    auto const of_study = figures::load_study_figures();
    if (study.ball_constant > 0)
        page.figure(of_study["ball_constant"], study, "k of F = k d^1.5, both grooves");
    if (cup.largest_stress > 0)
        line("largest_stress", rows["largest_stress"].text.label,
             "von Mises, on the surface, but not under the bearing");
    Told const whole(of_study, study);
    page.figure(of_study["edge_radius"], study, "radius under load");
    write_deviations(page, study.solution.scene);
    if (study.standard_tip_increase > 0) {
        auto const tip = figures::geometry_figures()["tip_radius"];
        page.figure("tip circle", fmt::format("{:.4f} mm", tip.value(study.solution)),
                    fmt::format("circular spline; {} larger than the standard one, which would leave no land",
                                whole.with_unit("standard_tip_increase")));
    }
    page.figure("harmonics", "up to " + whole("harmonics"),
                study.sectors > 1 ? fmt::format("the solved sector repeats {} times", study.sectors) : "");
}

/// Pressure of the flanks where it is determined, and what edges and ends carry.
std::string pressure_words(LoadStudy const& study, LoadCase const& each, LoadedState const& state)
{
    auto const rows = figures::loaded_state_figures(study.balls);
    Told const told(rows, state);
    auto const with_error = [&](char const* name) {
        return with_marked_error(rows[name], state, each.estimated ? &each.error : nullptr);
    };
    bool const determined = each.estimated && !figures::is_unconverged(rows["flank_pressure"], state, each.error);
    std::string const pressure =
        state.flank_pressure == 0 ? "no force"
        : determined              ? with_error("flank_pressure") + " MPa"
                                  : fmt::format("pressure not determined (about {})", told.with_unit("flank_pressure"));
    return fmt::format("{} away from edges and ends, which carry {} of all force, up to {} N of a flank{}", pressure,
                       told.with_unit("edge_fraction"), with_error("edge_force"),
                       study.solution.scene.flow
                           ? fmt::format("; steel flows under {} of all force", told.with_unit("flowing_fraction"))
                           : "");
}

void write_largest(Page& page, LoadStudy const& study)
{
    page.line("\nlargest pressure and stress, at {}", largest_torque(study));
    for (auto const& each : study.cases) {
        auto const* state = figures::rated_state(each);
        if (state == nullptr)
            continue;
        Told const told(figures::loaded_state_figures(study.balls), *state);
        std::string text = fmt::format("  {}: {}", figures::case_name(each), pressure_words(study, each, *state));
        if (state->largest_stress > 0) {
            text += fmt::format("; stress {} at z = {}, r = {}, {}", told.with_unit("largest_stress"),
                                told.with_unit("stress_z"), told.with_unit("stress_r"), told.with_unit("stress_phi"));
        }
        page.line("{}", text);
    }
    page.line(
        "  edges and ends: rounded edges of the teeth, and half a millimetre at each end of the face width; the "
        "pressure there is not determined");
}

void write_bearing(Page& page, LoadStudy const& study, LoadCase const& each, LoadedState const& state)
{
    auto const rows = figures::loaded_state_figures(study.balls);
    Told const told(rows, state);
    auto const with_error = [&](char const* name) {
        return with_marked_error(rows[name], state, each.estimated ? &each.error : nullptr);
    };
    std::string const where = std::isnan(state.lobe_z) ? "at no height of the bearing, since the forces are a couple"
                                                       : "at z = " + with_error("lobe_z") + " mm";
    std::string text =
        fmt::format("  {}: lobe at the major axis {} N along it, {} N across it, {}; wave generator {} N m",
                    figures::case_name(each), with_error("lobe_force"), with_error("lobe_force_across"), where,
                    with_error("wave_generator_torque"));
    if (state.ball_force > 0) {
        text += fmt::format("; balls up to {} {} at {}", with_error("ball_force"), rows["ball_force"].unit.text,
                            told.with_unit("ball_phi"));
        text += study.balls > 0 ? fmt::format(", {} of {} carry", with_error("balls"), study.balls) : "";
    }
    page.line("{}", text);
}

void write_balls(Page& page, LoadStudy const& study, LoadCase const& each)
{
    std::string text;
    for (std::size_t b = 0; b < each.bearing.ball_angle.size(); ++b) {
        text += fmt::format("{}{:.1f} at {:.1f}", b > 0 ? ", " : "", each.bearing.ball_force[b],
                            figures::unit::degree.shown(each.bearing.ball_angle[b]));
    }
    page.line("  {}: balls of {}, N at deg: {}", figures::case_name(each),
              study.sectors > 1 ? fmt::format("1/{} of the ring", study.sectors) : "the ring", text);
}

/// How well the equations are solved: the worst of all states.
void write_convergence(Page& page, LoadStudy const& study)
{
    LoadedState worst;
    for (auto const& each : study.cases) {
        for (auto const& state : each.curve) {
            worst.gap_mismatch = std::max(worst.gap_mismatch, state.gap_mismatch);
            worst.complementarity = std::max(worst.complementarity, state.complementarity);
            worst.iterations = std::max(worst.iterations, state.iterations);
        }
    }
    Told const told(figures::loaded_state_figures(study.balls), worst);
    page.line(
        "  converged after at most {} iterations: gaps agree with the loaded shape to {}, force times gap is at most "
        "{} (relative)",
        worst.iterations, told.with_unit("gap_mismatch"), told("complementarity"));
}

void write_load_places(Page& page, LoadStudy const& study)
{
    write_largest(page, study);
    page.line("\nbearing, at {}", largest_torque(study));
    for (auto const& each : study.cases)
        if (auto const* state = figures::rated_state(each))
            write_bearing(page, study, each, *state);
    for (auto const& each : study.cases)
        if (study.balls > 0)
            write_balls(page, study, each);
    write_convergence(page, study);
}

}  // namespace

std::string rated_torque(LoadStudy const& study)
{
    return Told(figures::load_study_figures(), study).with_unit("rated_torque");
}

bool is_rated(LoadStudy const& study, LoadCase const& each)
{
    LoadedState const* const state = figures::rated_state(each);
    return state == nullptr || state->torque == study.rated_torque;
}

std::string torque_of(LoadCase const& each)
{
    LoadedState const* const state = figures::rated_state(each);
    return state != nullptr ? short_number(state->torque / newton_metre) + " N m" : "";
}

std::string largest_torque(LoadStudy const& study)
{
    bool const all = std::ranges::all_of(study.cases, [&](LoadCase const& each) { return is_rated(study, each); });
    return all ? rated_torque(study) : "the largest torque with a result";
}

}  // namespace hdconj::report

namespace hdconj {

std::string summary_text(LoadStudy const& study, std::vector<WrittenFile> const& written, Measurement const* measured)
{
    report::Page page;
    report::write_drive(page, study.solution);
    report::write_load_setting(page, study);
    report::write_load_table(page, study);
    report::write_catalogue(page, study);
    report::write_stiffness(page, study);
    report::write_members(page, study);
    report::write_load_places(page, study);
    if (measured != nullptr) {
        page.line("");
        report::write_measured(page, figures::shown_case(study), *measured);
    }
    report::write_notes(page, study.solution.notes);
    if (auto const* shown = figures::shown_case(study))
        page.line("\ncup and circular spline in the result file: {}", figures::case_name(*shown));
    report::write_end(page, study.solution, written);
    return page.text();
}

}  // namespace hdconj
