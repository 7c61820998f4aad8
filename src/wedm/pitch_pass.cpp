// SPDX-License-Identifier: GPL-3.0-or-later
#include "pitch_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "checks.hpp"
#include "hdconj/scene/schema.hpp"
#include "offset_path.hpp"
#include "passes.hpp"

namespace hdconj::wedm {
namespace {

/// Wires on sale: multiples of this, none thinner than that [mm].
constexpr double wire_step = 0.01;
constexpr double thinnest_wire = 0.02;

CutRadius cut_radius(WireJob const& job, double offset)
{
    return {offset, job.wire.tolerance, job.machine.thickness};
}

/// The thickest wire on sale, thinner than the one of @p job, that leaves no more than the limit.
std::optional<double> fitting_wire(WireJob const& job)
{
    double const given = job.wire.wire_diameter;
    for (int k = static_cast<int>(std::ceil(given / wire_step)) - 1; k * wire_step >= thinnest_wire; --k) {
        double const diameter = std::min(k * wire_step, given);
        if (job.wire.spark_gap > diameter)
            break;
        Uncut const uncut = pitch_pass(job, diameter, 0).uncut;
        if (uncut.highest() == nullptr || uncut.highest()->height <= job.wire.residual_limit)
            return diameter;
    }
    return {};
}

/// The pass at @p offset, in points far closer than the wire needs.
PairedPath fine_path(WireJob const& job, double offset)
{
    PairedPath const contour{with_neighbours(job.faces.pitch.lower, job.faces, 1),
                             with_neighbours(job.faces.pitch.upper, job.faces, 1)};
    return offset_path(contour, offset, share_of_arcs * job.wire.tolerance, job.machine.thickness);
}

/// Points of a path that the wire moves between.
struct Moves
{
    std::vector<std::size_t> kept;
    bool are_long = true;  ///< none is shorter than least_block()
};

/// Those of @p fine, no shorter than least_block() where the tolerance allows it.
Moves moves_along(WireJob const& job, PairedPath const& fine)
{
    double const tolerance = share_of_moves * job.wire.tolerance, least = least_block(job.wire.decimals);
    auto const is_short = [&](std::size_t a, std::size_t b) {
        return shortest_plane(job.machine, {fine.lower[a], fine.upper[a]}, {fine.lower[b], fine.upper[b]}) < least;
    };
    auto const are_long = [&](std::vector<std::size_t> const& kept) {
        return std::ranges::adjacent_find(kept, is_short) == kept.end();
    };
    std::vector<std::size_t> kept = thinned(fine, tolerance);
    if (are_long(kept))
        return {std::move(kept)};
    kept = thinned_to_long_moves(fine, tolerance, is_short);
    bool const all = are_long(kept);
    return {std::move(kept), all};
}

/// Least distance of what @p pass leaves from where the teeth come, if it is above the tolerance.
std::optional<double> way_of_teeth(WireJob const& job, PitchPass const& pass, WireFaces const& reached)
{
    double const way = way_to_uncut(job.faces, pass.path, cut_radius(job, pass.offset), reached);
    double const told = std::floor(way * told_per_mm) / told_per_mm;
    return told > job.wire.tolerance ? std::optional(told) : std::nullopt;
}

}  // namespace

PitchPass pitch_pass(WireJob const& job, double wire_diameter, double stock)
{
    WireFaces const& faces = job.faces;
    PitchPass pass;
    pass.stock = stock;
    pass.offset = wire_diameter / 2 + job.wire.spark_gap + stock;
    PairedPath const fine = fine_path(job, pass.offset);
    std::vector<std::size_t> const kept = moves_along(job, fine).kept;
    pass.path = taken(fine, kept);
    pass.guide_chord = guide_chord_error(fine, kept, job.machine);
    pass.uncut = uncut_of(faces, pass.path, cut_radius(job, pass.offset));
    return pass;
}

std::vector<PitchPass> pitch_passes(WireJob const& job)
{
    std::vector<PitchPass> passes;
    for (double const stock : job.wire.stock)
        passes.push_back(pitch_pass(job, job.wire.wire_diameter, stock));
    return passes;
}

std::optional<int> fitting_decimals(WireJob job, double offset)
{
    PairedPath const fine = fine_path(job, offset);
    while (++job.wire.decimals <= scene::bounds::most_decimals)
        if (moves_along(job, fine).are_long)
            return job.wire.decimals;
    return {};
}

bool leaves_too_much(WireJob const& job, std::vector<PitchPass> const& passes)
{
    Residual const* const worst = passes.back().uncut.highest();
    return worst != nullptr && worst->height > job.wire.residual_limit;
}

Fault residual_fault(WireJob const& job, std::vector<PitchPass> const& passes, std::optional<WireFaces> const& reached)
{
    Residual const* const worst = passes.back().uncut.highest();
    auto const wire = fitting_wire(job);
    auto const way = reached ? way_of_teeth(job, passes.back(), *reached) : std::nullopt;
    Fault fault = job.wire_key;
    fault.reason = fmt::format(
        "wire and gap are too wide to follow the contour: they leave {:.6g} mm at ({:f}, {:f}) mm of the {} face, {} "
        "of every tooth space, and residual_limit is {:.6g} mm",
        worst->height, worst->where.x(), worst->where.y(), worst->upper ? "upper" : "lower",
        worst->meshing ? "on a flank" : "in the root", job.wire.residual_limit);
    fault.remedy = fmt::format(
        "{} residual_limit = {:.6g}{}",
        wire ? fmt::format("write wire_diameter = {:.6g}, a thinner wire that leaves no more than that, or", *wire)
             : "no thinner wire that is sold leaves so little; write",
        std::ceil(worst->height * told_per_mm) / told_per_mm,
        way ? fmt::format(": the teeth of the unloaded flexspline keep a distance of {:.6g} mm from what is left", *way)
            : "");
    return fault;
}

}  // namespace hdconj::wedm
