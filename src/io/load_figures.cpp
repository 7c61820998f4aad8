// SPDX-License-Identifier: GPL-3.0-or-later
#include "load_figures.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "summary_figures.hpp"

namespace hdconj {
namespace {

constexpr double as_stored = 1;
constexpr char const* json_only = nullptr;

struct StateRow
{
    FigureOf<LoadedState> figure;
    bool has_error;  ///< estimated in LoadCase::error
};

using State = LoadedState const&;
constexpr StateRow state_rows[] = {
    {{"torque", "N mm", "torque_Nm", nm_per_nmm, [](State s) { return s.torque; }}, false},
    {{"twist", "rad", "twist_arcmin", arcmin_per_radian, [](State s) { return s.twist; }}, true},
    {{"stiffness", "N mm/rad", "stiffness_Nm_per_rad", nm_per_nmm, [](State s) { return s.stiffness; }}, true},
    {{json_only, "", "stiffness_Nm_per_deg", nm_per_deg, [](State s) { return s.stiffness; }}, true},
    {{"contact_area", "mm^2", "contact_area_mm2", as_stored, [](State s) { return s.contact_area; }}, true},
    {{"contact_share", "1", "contact_share", as_stored, [](State s) { return s.contact_share; }}, true},
    {{"near_share", "1", "near_share", as_stored, [](State s) { return s.near_share; }}, true},
    {{"node_share", "1", "node_share", as_stored, [](State s) { return s.node_share; }}, true},
    {{"largest_pressure", "MPa", "largest_pressure_MPa", as_stored, [](State s) { return s.largest_pressure; }}, true},
    {{"pressure_z", "mm", "pressure_z_mm", as_stored, [](State s) { return s.pressure_z; }}, false},
    {{"largest_force", "N", "largest_force_N", as_stored, [](State s) { return s.largest_force; }}, true},
    {{"wave_generator_force", "N", "wave_generator_force_N", as_stored, [](State s) { return s.wave_generator_force; }}, true},
    {{"wave_generator_torque", "N mm", "wave_generator_torque_Nm", nm_per_nmm, [](State s) { return s.wave_generator_torque; }}, true},
    {{"lobe_force", "N", "lobe_force_N", as_stored, [](State s) { return s.lobe_force; }}, true},
    {{"lobe_force_across", "N", "lobe_force_across_N", as_stored, [](State s) { return s.lobe_force_across; }}, true},
    {{"lobe_z", "mm", "lobe_z_mm", as_stored, [](State s) { return s.lobe_z; }}, true},
    {{"ball_phi", "rad", "ball_phi_deg", degree_per_radian, [](State s) { return s.ball_phi; }}, false},
    {{"largest_stress", "MPa", "largest_stress_MPa", as_stored, [](State s) { return s.largest_stress; }}, true},
    {{"stress_z", "mm", "stress_z_mm", as_stored, [](State s) { return s.stress_z; }}, false},
    {{"stress_r", "mm", "stress_r_mm", as_stored, [](State s) { return s.stress_r; }}, false},
    {{"stress_phi", "rad", "stress_phi_deg", degree_per_radian, [](State s) { return s.stress_phi; }}, false},
    {{"residual", "mm", "residual_um", um_per_mm, [](State s) { return s.residual; }}, false},
    {{"complementarity", "1", "complementarity", as_stored, [](State s) { return s.complementarity; }}, false}};

constexpr auto estimated_rows = static_cast<std::size_t>(std::count_if(std::begin(state_rows), std::end(state_rows), [](StateRow const& row) { return row.has_error; }));

}  // namespace

std::span<FigureOf<LoadedState> const> loaded_state_figures()
{
    static constexpr auto figures = [] {
        std::array<FigureOf<LoadedState>, std::size(state_rows)> all{};
        std::transform(std::begin(state_rows), std::end(state_rows), all.begin(), [](StateRow const& row) { return row.figure; });
        return all;
    }();
    return figures;
}

std::span<FigureOf<LoadedState> const> loaded_error_figures()
{
    static constexpr auto figures = [] {
        std::array<FigureOf<LoadedState>, estimated_rows> some{};
        std::size_t i = 0;
        for (StateRow const& row : state_rows) {
            if (row.has_error) {
                some[i++] = row.figure;
            }
        }
        return some;
    }();
    return figures;
}

std::span<FigureOf<LoadCase> const> load_case_figures()
{
    using Row = FigureOf<LoadCase>;
    using Case = LoadCase const&;
    static constexpr std::array figures = {
        Row{"tilt", "rad", "tilt_deg", degree_per_radian, [](Case c) { return c.tilt; }},
        Row{"backlash_offset", "mm", "backlash_offset_um", um_per_mm, [](Case c) { return c.backlash_offset; }},
        Row{"tip_radius", "mm", "tip_radius_mm", as_stored, [](Case c) { return c.tip; }},
        Row{"tip_change", "mm", "tip_change_um", um_per_mm, [](Case c) { return c.tip_change; }},
        Row{"backlash", "rad", "backlash_arcmin", arcmin_per_radian, [](Case c) { return c.backlash; }},
        Row{"first_stage", "N mm/rad", "first_stage_Nm_per_rad", nm_per_nmm, [](Case c) { return c.stages.first; }},
        Row{json_only, "", "first_stage_Nm_per_deg", nm_per_deg, [](Case c) { return c.stages.first; }},
        Row{"first_stage_error", "N mm/rad", "first_stage_error_Nm_per_deg", nm_per_deg, [](Case c) { return c.stages.first_error; }},
        Row{"second_stage", "N mm/rad", "second_stage_Nm_per_rad", nm_per_nmm, [](Case c) { return c.stages.second; }},
        Row{json_only, "", "second_stage_Nm_per_deg", nm_per_deg, [](Case c) { return c.stages.second; }},
        Row{"second_stage_error", "N mm/rad", "second_stage_error_Nm_per_deg", nm_per_deg, [](Case c) { return c.stages.second_error; }},
        Row{"knee", "N mm", "knee_Nm", nm_per_nmm, [](Case c) { return c.stages.knee; }},
        Row{"knee_error", "N mm", "knee_error_Nm", nm_per_nmm, [](Case c) { return c.stages.knee_error; }},
        Row{"knee_twist", "rad", "knee_twist_arcmin", arcmin_per_radian, [](Case c) { return c.stages.knee_twist; }},
        Row{"stages_rms", "N mm", "stages_rms_Nm", nm_per_nmm, [](Case c) { return c.stages.rms; }},
        Row{"seconds", "s", "time_s", as_stored, [](Case c) { return c.seconds; }}};
    return figures;
}

std::span<FigureOf<AssembledCup> const> assembled_cup_figures()
{
    using Row = FigureOf<AssembledCup>;
    using Assembled = AssembledCup const&;
    static constexpr std::array figures = {
        Row{"coning_major_rad", "rad", "coning_major_deg", degree_per_radian, [](Assembled c) { return c.coning_major; }},
        Row{"coning_minor_rad", "rad", "coning_minor_deg", degree_per_radian, [](Assembled c) { return c.coning_minor; }},
        Row{"wave_generator_force_N", "N", "wave_generator_force_N", as_stored, [](Assembled c) { return c.wave_generator_force; }},
        Row{"largest_stress_MPa", "MPa", "largest_stress_MPa", as_stored, [](Assembled c) { return c.largest_stress; }}};
    return figures;
}

std::span<MeasuredFigure const> measured_figures()
{
    using Found = MeasuredStiffness const&;
    using Case = LoadCase const&;
    using Value = std::optional<double>;
    static constexpr std::array figures = {
        MeasuredFigure{"backlash", "backlash", "rad", "arcmin", "arcmin", arcmin_per_radian, [](Found f) -> Estimate const& { return f.backlash; }, 1,
                       [](Case c) { return Value(c.backlash); }},
        MeasuredFigure{"first_stage", "first stage", "N mm/rad", "Nm_per_deg", "N m/deg", nm_per_deg, [](Found f) -> Estimate const& { return f.first; }, -2,
                       [](Case c) { return c.stages.found ? Value(c.stages.first) : Value(); }},
        MeasuredFigure{"second_stage", "second stage", "N mm/rad", "Nm_per_deg", "N m/deg", nm_per_deg, [](Found f) -> Estimate const& { return f.second; }, -2,
                       [](Case c) { return c.stages.found ? Value(c.stages.second) : Value(); }},
        MeasuredFigure{"knee", "knee between them", "N mm", "Nm", "N m", nm_per_nmm, [](Found f) -> Estimate const& { return f.knee; }, -1,
                       [](Case c) { return c.stages.found ? Value(c.stages.knee) : Value(); }},
        MeasuredFigure{"whole", "one line", "N mm/rad", "Nm_per_deg", "N m/deg", nm_per_deg, [](Found f) -> Estimate const& { return f.whole; }, -2,
                       [](Case c) { return c.stages.found || c.stages.first == 0 ? Value() : Value(c.stages.first); }}};
    return figures;
}

}  // namespace hdconj
