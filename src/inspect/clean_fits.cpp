// SPDX-License-Identifier: GPL-3.0-or-later
#include "clean_fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/text.hpp"
#include "strays.hpp"

namespace hdconj::inspect {
namespace {

FlankRun run_of(FlankFit const& fit, double length)
{
    FlankRun run{{}, fit.parabola.deviation};
    for (double const s : fit.parabola.arc_length)
        run.xi.push_back(2 * s / length - 1);
    return run;
}

/// Fits a flank again without the strays that are found among its points.
/// @param strays  indices into the points of its parabola
std::optional<FlankFit> fit_without(PointReader const& read, std::vector<PlanePoint> const& points,
                                    Placement const& placement, FlankFit fit, std::vector<std::size_t> const& strays)
{
    std::vector<std::size_t> gone = std::move(fit.strays);
    for (std::size_t const i : strays)
        gone.push_back(fit.parabola.points[i]);
    std::erase_if(fit.group.points, [&](std::size_t p) { return std::ranges::find(gone, p) != gone.end(); });
    auto next = flank_fit(read, points, std::move(fit.group), placement);
    if (next)
        next->strays = std::move(gone);
    return next;
}

}  // namespace

std::vector<FlankFit> fits_without_strays(PointReader const& read, std::vector<PlanePoint> const& points,
                                          std::vector<FlankGroup> groups, Placement const& placement)
{
    std::vector<std::optional<FlankFit>> fits;
    std::map<std::pair<std::size_t, bool>, std::vector<std::size_t>> sides;
    for (FlankGroup& group : groups) {
        sides[{group.plane, group.right}].push_back(fits.size());
        fits.push_back(flank_fit(read, points, std::move(group), placement));
    }
    for (auto& [key, flanks] : sides) {
        double const length = read.part().planes[key.first].flank(key.second).length();
        for (bool again = true; again;) {
            std::erase_if(flanks, [&](std::size_t k) { return !fits[k]; });
            std::vector<FlankRun> side;
            for (std::size_t const k : flanks)
                side.push_back(run_of(*fits[k], length));
            auto const strays = strays_of(side);
            again = false;
            for (std::size_t i = 0; i < flanks.size(); ++i)
                if (!strays[i].empty()) {
                    auto& fit = fits[flanks[i]];
                    fit = fit_without(read, points, placement, std::move(*fit), strays[i]);
                    again = true;
                }
        }
    }
    std::vector<FlankFit> found;
    for (auto& fit : fits)
        if (fit)
            found.push_back(std::move(*fit));
    return found;
}

void add_note_of_strays(Inspection& result)
{
    constexpr int parts = 10;                // of a flank
    constexpr double many = 0.25, some = 3;  // share of the flanks, and least number
    std::map<std::tuple<double, bool, int>, double> gathered;
    for (PointDeviation const& point : result.points) {
        auto const nominal = std::ranges::find(result.nominal, point.z, &NominalFigures::z);
        if (point.fate == PointFate::stray && nominal != result.nominal.end())
            ++gathered[{point.z, point.right,
                        std::clamp(static_cast<int>(parts * point.arc_length / nominal->flank_length), 0, parts - 1)}];
    }
    for (auto const& [place, count] : gathered) {
        auto const& [z, right, part] = place;
        auto const side = std::ranges::find_if(result.sides, [&there = place](SideFigures const& each) {
            return each.z == std::get<0>(there) && each.right == std::get<1>(there);
        });
        if (side == result.sides.end() || count < std::max(some, many * static_cast<double>(side->flanks)))
            continue;
        result.notes.push_back(
            fmt::format("{} strays of {} {} flanks at z = {} mm stand between {} and {} % of the flank from its root "
                        "end: what stands at one place of so many flanks is more than dust",
                        count, side->flanks, right ? "right" : "left", short_number(z), 100 / parts * part,
                        100 / parts * (part + 1)));
    }
}

}  // namespace hdconj::inspect
