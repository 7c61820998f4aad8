// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_figures.hpp"

#include <fmt/format.h>

#include <array>

#include "summary_figures.hpp"

namespace hdconj {
namespace {

constexpr double as_stored = 1;

}  // namespace

std::span<FigureOf<ContactState> const> state_figures()
{
    using State = ContactState const&;
    static constexpr std::array figures = {
        FigureOf<ContactState>{"wave_generator", "rad", "wave_generator_deg", degree_per_radian,
                               [](State state) { return state.wave_generator; }},
        FigureOf<ContactState>{"take_up", "rad", "take_up_arcmin", arcmin_per_radian,
                               [](State state) { return state.take_up; }},
        FigureOf<ContactState>{"take_up_back", "rad", "take_up_back_arcmin", arcmin_per_radian,
                               [](State state) { return state.take_up_back; }},
        FigureOf<ContactState>{"take_up_error", "rad", "take_up_error_arcmin", arcmin_per_radian,
                               [](State state) { return state.take_up_error; }},
        FigureOf<ContactState>{"take_up_back_error", "rad", "take_up_back_error_arcmin", arcmin_per_radian,
                               [](State state) { return state.take_up_back_error; }},
        FigureOf<ContactState>{"backlash", "rad", "backlash_arcmin", arcmin_per_radian,
                               [](State state) { return state.backlash(); }},
        FigureOf<ContactState>{"backlash_error", "rad", "backlash_error_arcmin", arcmin_per_radian,
                               [](State state) { return state.backlash_error(); }},
        FigureOf<ContactState>{"contact_area", "mm^2", "contact_area_mm2", as_stored,
                               [](State state) { return state.contact_area; }},
        FigureOf<ContactState>{"contact_area_error", "mm^2", "contact_area_error_mm2", as_stored,
                               [](State state) { return state.contact_area_error; }},
        FigureOf<ContactState>{"share", "1", "share", as_stored, [](State state) { return state.share; }},
        FigureOf<ContactState>{"share_error", "1", "share_error", as_stored,
                               [](State state) { return state.share_error; }},
        FigureOf<ContactState>{"smallest_gap", "mm", "smallest_gap_um", um_per_mm,
                               [](State state) { return state.smallest_gap; }},
        FigureOf<ContactState>{"smallest_gap_error", "mm", "smallest_gap_error_um", um_per_mm,
                               [](State state) { return state.smallest_gap_error; }},
        FigureOf<ContactState>{"smallest_z", "mm", "smallest_z_mm", as_stored,
                               [](State state) { return state.smallest_z; }},
        FigureOf<ContactState>{"smallest_z_from", "mm", "smallest_z_from_mm", as_stored,
                               [](State state) { return state.smallest_z_from; }},
        FigureOf<ContactState>{"smallest_z_to", "mm", "smallest_z_to_mm", as_stored,
                               [](State state) { return state.smallest_z_to; }}};
    return figures;
}

std::span<FigureOf<ContactCase> const> case_figures()
{
    using Case = ContactCase const&;
    static constexpr std::array figures = {
        FigureOf<ContactCase>{"tilt", "rad", "tilt_deg", degree_per_radian, [](Case each) { return each.tilt; }},
        FigureOf<ContactCase>{"backlash_offset", "mm", "backlash_offset_um", um_per_mm,
                              [](Case each) { return each.backlash_offset; }},
        FigureOf<ContactCase>{"clearing_offset", "mm", "clearing_offset_um", um_per_mm,
                              [](Case each) { return each.clearing_offset; }},
        FigureOf<ContactCase>{"clearing_offset_error", "mm", "clearing_offset_error_um", um_per_mm,
                              [](Case each) { return each.clearing_offset_error; }},
        FigureOf<ContactCase>{"tip_radius", "mm", "tip_radius_mm", as_stored,
                              [](Case each) { return each.tip; }},
        FigureOf<ContactCase>{"clearing_tip", "mm", "clearing_tip_mm", as_stored,
                              [](Case each) { return each.clearing_tip; }},
        FigureOf<ContactCase>{"clearing_tip_error", "mm", "clearing_tip_error_mm", as_stored,
                              [](Case each) { return each.clearing_tip_error; }},
        FigureOf<ContactCase>{"clearing_root", "mm", "clearing_root_um", um_per_mm,
                              [](Case each) { return each.clearing_root; }},
        FigureOf<ContactCase>{"clearing_root_error", "mm", "clearing_root_error_um", um_per_mm,
                              [](Case each) { return each.clearing_root_error; }},
        FigureOf<ContactCase>{"backlash_of_clearing", "rad", "backlash_of_clearing_arcmin", arcmin_per_radian,
                              [](Case each) { return each.backlash_of_clearing; }},
        FigureOf<ContactCase>{"backlash_of_clearing_error", "rad", "backlash_of_clearing_error_arcmin", arcmin_per_radian,
                              [](Case each) { return each.backlash_of_clearing_error; }},
        FigureOf<ContactCase>{"flank_area", "mm^2", "flank_area_mm2", as_stored,
                              [](Case each) { return each.state.flank_area; }},
        FigureOf<ContactCase>{"flank_area_error", "mm^2", "flank_area_error_mm2", as_stored,
                              [](Case each) { return each.state.flank_area_error; }},
        FigureOf<ContactCase>{"ruled_deviation", "mm", "ruled_deviation_um", um_per_mm,
                              [](Case each) { return each.ruled_deviation; }},
        FigureOf<ContactCase>{"ruled_deviation_error", "mm", "ruled_deviation_error_um", um_per_mm,
                              [](Case each) { return each.ruled_deviation_error; }},
        FigureOf<ContactCase>{"flank_clearance_error", "mm", "clearance_error_um", um_per_mm,
                              [](Case each) { return each.clearance_error; }},
        FigureOf<ContactCase>{"root_clearance_error", "mm", "root_clearance_error_um", um_per_mm,
                              [](Case each) { return each.root_clearance_error; }},
        FigureOf<ContactCase>{"flank_z_from", "mm", "closest_z_from_mm", as_stored,
                              [](Case each) { return each.closest_z_from; }},
        FigureOf<ContactCase>{"flank_z_to", "mm", "closest_z_to_mm", as_stored,
                              [](Case each) { return each.closest_z_to; }},
        FigureOf<ContactCase>{"seconds", "s", "time_s", as_stored, [](Case each) { return each.seconds; }}};
    return figures;
}

std::string surface_name(std::string const& surface, std::string const& kind, double tilt)
{
    return kind.empty() ? surface : fmt::format("{}, {} {:g} deg", surface, kind, tilt * degree_per_radian);
}

}  // namespace hdconj
