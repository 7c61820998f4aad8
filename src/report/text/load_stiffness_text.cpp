// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "figures/load_figures.hpp"
#include "hdconj/units.hpp"
#include "load_table.hpp"

namespace hdconj::report {
namespace {

/// The stiffness at some torques of a curve, a tenth of the largest apart or more.
std::string stiffness_along(LoadStudy const& study, LoadCase const& each)
{
    constexpr double apart = 0.1;
    auto const rows = figures::loaded_state_figures(study.balls);
    double const sign = study.rated_torque < 0 ? -1 : 1;
    double next = 0;
    std::string text;
    for (std::size_t n = 0; n < each.curve.size(); ++n) {
        std::size_t const i = sign > 0 ? n : each.curve.size() - 1 - n;
        auto const& state = each.curve[i];
        if (!(sign * state.torque > 0) || (sign * state.torque < next && i != each.rated))
            continue;
        next = sign * state.torque + apart * std::abs(study.rated_torque);
        text += fmt::format("{}{} at {:.4g}", text.empty() ? "" : ", ",
                            with_marked_error(rows["stiffness"], state, figures::error_of(each, i)),
                            state.torque / newton_metre);
    }
    return text;
}

}  // namespace

void write_catalogue(Page& page, LoadStudy const& study)
{
    bool first = true;
    for (auto const& each : study.cases) {
        if (!each.catalogue)
            continue;
        Told const told(figures::catalogue_rows(), *each.catalogue);
        if (std::exchange(first, false)) {
            page.line("\nas catalogues state it: K1 from 0 to {}, K2 from there to {}, K3 from there to {}",
                      told.with_unit("T1"), told.with_unit("T2"), rated_torque(study));
        }
        page.line("  {}: lost motion {} arcmin at +-{}", figures::case_name(each),
                  with_marked_error(figures::catalogue_rows()["lost_motion"], *each.catalogue,
                                    each.catalogue->estimated ? &*each.catalogue : nullptr),
                  told.with_unit("lost_motion_torque"));
    }
}

void write_members(Page& page, LoadStudy const& study)
{
    auto const rows = figures::twist_member_rows();
    for (auto const& each : study.cases) {
        if (each.members.empty())
            continue;
        page.line("\ntwist at {} of {}, member by member", torque_of(each), figures::case_name(each));
        constexpr auto columns = "  {:<28}{:>12}{:>10}{:>10}{:>10}{:>9}";
        page.line(columns, "", "N m/rad", "+-", "arcmin", "+-", "%");
        for (TwistMember const& member : each.members) {
            Told const told(rows, member);
            auto const error = [&](char const* name) { return each.estimated ? told.error(name) : "-"; };
            bool const yields = member.stiffness != 0;
            page.line(columns, member.name, yields ? told("stiffness") : "-", yields ? error("stiffness") : "-",
                      told("twist"), error("twist"), told("fraction"));
        }
    }
}

void write_stiffness(Page& page, LoadStudy const& study)
{
    auto const has_slopes = [](LoadCase const& each) { return each.stages.first != 0 && each.curve.size() > 1; };
    if (std::ranges::none_of(study.cases, has_slopes))
        return;
    page.line("\nstiffness along the curve, N m/deg at N m");
    for (auto const& each : study.cases)
        if (has_slopes(each))
            page.line("  {}: {}", figures::case_name(each), stiffness_along(study, each));
    for (auto const& each : study.cases) {
        if (!each.stages.found)
            continue;
        auto const rows = figures::load_case_figures();
        auto const with_error = [&](char const* name) {
            return with_marked_error(rows[name], each, each.estimated ? &each : nullptr);
        };
        page.line(
            "  {}: two straight lines instead: {} and {} N m/deg, knee at {} N m; they miss the curve by {} (rms)",
            figures::case_name(each), with_error("first_stage"), with_error("second_stage"), with_error("knee"),
            rows["stages_rms"].value_with_unit(each));
    }
}

}  // namespace hdconj::report
