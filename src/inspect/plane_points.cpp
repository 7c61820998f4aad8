// SPDX-License-Identifier: GPL-3.0-or-later
#include "plane_points.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "base/text.hpp"
#include "file/listed_faults.hpp"
#include "flank_fit.hpp"
#include "hdconj/error.hpp"
#include "registration.hpp"

namespace hdconj::inspect {
namespace {

/// Remainder from 0 on.
int remainder(int number, int teeth)
{
    return (number % teeth + teeth) % teeth;
}

/// @param places  the tooth of the part at which each number of the file stands
/// @throws InputError where the numbers do not count the teeth clockwise
void refuse_other_order(std::map<int, int> const& places, NominalPart const& part, std::string const& file)
{
    std::map<int, std::size_t> clockwise, counter;  // how many numbers go with each number of the part's first tooth
    for (auto const& [number, place] : places) {
        ++clockwise[remainder(number - place, part.teeth)];
        ++counter[remainder(number + place, part.teeth)];
    }
    if (clockwise.size() < 2)
        return;
    auto const usual = *std::ranges::max_element(clockwise, {}, [](auto const& each) { return each.second; });
    auto const odd = std::ranges::find_if(
        places, [&](auto const& each) { return remainder(each.first - each.second, part.teeth) != usual.first; });
    char const *const one = part.space ? "space" : "tooth", *const several = part.space ? "spaces" : "teeth";
    Fault fault{"column tooth", 0, std::to_string(odd->first), "", "", file};
    if (counter.size() == 1) {
        fault.reason = fmt::format("the numbers run counter-clockwise, and {} are counted clockwise", several);
        fault.remedy = fmt::format("write {} less each number, or leave the column out", part.teeth + 1);
    } else {
        fault.reason = fmt::format("{} of {} numbers do not count the {} clockwise", places.size() - usual.second,
                                   places.size(), several);
        if (2 * usual.second > places.size())
            fault.reason += fmt::format(": by the others this {} is number {}", one,
                                        1 + remainder(usual.first + odd->second - 1, part.teeth));
        fault.remedy = fmt::format(
            "count every {} clockwise, those that were not measured too, or leave the column "
            "out",
            one);
    }
    throw InputError(std::move(fault));
}

}  // namespace

PointFile of_own_layer(PointFile const& measured, InspectedPart part)
{
    if (measured.layers.size() < 2)
        return measured;
    std::string const own = part == InspectedPart::circular_spline ? "CIRCULAR_SPLINE" : flexspline_layer;
    auto const found = std::ranges::find(measured.layers, own);
    if (found == measured.layers.end()) {
        constexpr std::size_t most_named = 8;
        std::span const named(measured.layers.data(), std::min(most_named, measured.layers.size()));
        throw InputError(
            Fault{"DXF", 0, "",
                  fmt::format("has points on {} layers: {}{}", measured.layers.size(), fmt::join(named, ", "),
                              named.size() < measured.layers.size() ? ", ..." : ""),
                  "keep the layer of the measured points alone, or name it " + own, measured.file});
    }
    PointFile chosen{measured.file, {}, false, {own}};
    for (PartPoint point : measured.points) {
        if (point.layer != static_cast<std::size_t>(found - measured.layers.begin()))
            continue;
        point.layer = 0;
        chosen.has_z = chosen.has_z || point.z != 0;
        chosen.points.push_back(point);
    }
    return chosen;
}

void refuse_numbers(PointFile const& measured, NominalPart const& part)
{
    file::ListedFaults faults(measured.file);
    for (PartPoint const& point : measured.points)
        if (point.tooth > part.teeth)
            faults.add({"column tooth", point.line, std::to_string(point.tooth),
                        fmt::format("the part has {} {}", part.teeth, part.space ? "spaces" : "teeth"),
                        fmt::format("write a number from 1 to {}", part.teeth), measured.file});
    faults.refuse();
}

void refuse_exchanged_flanks(PlanePoints const& on, PointReader const& read, std::string const& file, int threads)
{
    constexpr double clearly = 0.5;  // of the distance to the flank that is named: deviations may be wide
    Registered bare{read, on.points, Registration::turn, threads};
    for (PlanePoint& point : bare.points)
        point.right.reset();
    Placement const at{near_turn(bare), Vec2::Zero()};
    auto const views = views_of(read, bare.points, at, threads);
    std::size_t named = 0, opposite = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        auto const& right = on.points[i].right;
        named += right ? 1U : 0U;
        if (!right || *right == views[i].right)
            continue;
        double const own = std::abs(read.on_flank(on.points[i], at, views[i].tooth, *right).deviation);
        opposite += std::abs(views[i].deviation) < clearly * own ? 1U : 0U;
    }
    if (2 * opposite > named)
        throw InputError(
            Fault{"column flank", 0, "",
                  fmt::format("{} of {} points stand on the flank opposite to the one that they name", opposite, named),
                  fmt::format("exchange left and right: with the axis below, the right flank of a {} is "
                              "the clockwise one",
                              read.part().space ? "space" : "tooth"),
                  file});
}

void refuse_foreign_points(PlanePoints const& on, std::vector<PointView> const& views, NominalPart const& part,
                           std::string const& file)
{
    double const near = part.pitch() * part.planes.front().reference_radius / 4;
    auto const count = std::count_if(views.begin(), views.end(),
                                     [&](PointView const& view) { return view.on && std::abs(view.deviation) < near; });
    if (2 * count >= std::ptrdiff_t(views.size()))
        return;
    double low = on.points.front().where.norm(), high = low;
    for (PlanePoint const& point : on.points) {
        low = std::min(low, point.where.norm());
        high = std::max(high, point.where.norm());
    }
    throw InputError(Fault{"POINTS", 0, file,
                           fmt::format("{} of {} points stand on a flank of the part: they lie {} ... {} mm from the "
                                       "axis, the middle of the nominal flanks {} mm",
                                       count, views.size(), short_number(low), short_number(high),
                                       short_number(part.planes.front().reference_radius)),
                           "give points in mm about the axis of the part, most of them on its flanks, and the part by "
                           "--part"});
}

void refuse_mixed_teeth(PlanePoints const& on, std::vector<PointView> const& views, PointFile const& measured,
                        NominalPart const& part)
{
    std::map<int, std::map<int, std::size_t>> places;  // by the number in the file, then by the tooth of the part
    for (std::size_t i = 0; i < views.size(); ++i)
        if (int const named = measured.points[on.origin[i]].tooth; named > 0 && views[i].on)
            ++places[named][views[i].tooth];
    char const *const one = part.space ? "space" : "tooth", *const several = part.space ? "spaces" : "teeth";
    file::ListedFaults faults(measured.file);
    std::map<int, int> known, place_of;
    for (auto const& [named, teeth] : places) {
        auto const most = std::ranges::max_element(teeth, {}, [](auto const& each) { return each.second; });
        std::size_t all = 0;
        for (auto const& [tooth, count] : teeth)
            all += count;
        std::string reason;
        if (2 * most->second < all)
            reason = fmt::format("the points of this {} stand on {} {} of the part", one, teeth.size(), several);
        else if (auto const [there, is_new] = known.emplace(most->first, named);
                 !is_new && most->second >= fewest_points)
            reason = fmt::format("the points of this {} stand on that of number {}", one, there->second);
        else if (most->second >= fewest_points)
            place_of.emplace(named, most->first);
        if (!reason.empty())
            faults.add({"column tooth", 0, std::to_string(named), reason,
                        fmt::format("write into each line the number of its {}, or leave the column out", one),
                        measured.file});
    }
    faults.refuse();
    refuse_other_order(place_of, part, measured.file);
}

}  // namespace hdconj::inspect
