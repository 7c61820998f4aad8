// SPDX-License-Identifier: GPL-3.0-or-later
#include "pitch_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"
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

/// Path of the wire's centre at @p offset from the faces, before it is thinned.
PairedPath fine_path(WireJob const& job, double offset)
{
    WireFaces const& faces = job.faces;
    PairedPath const contour{with_neighbours(faces.pitch.lower, faces, 1),
                             with_neighbours(faces.pitch.upper, faces, 1)};
    return offset_path(contour, offset, share_of_arcs * job.wire.tolerance, job.machine.thickness);
}

double offset_of(WireJob const& job, double wire_diameter, double stock)
{
    return wire_diameter / 2 + job.wire.spark_gap + stock;
}

double height_of(Uncut const& uncut)
{
    Residual const* const worst = uncut.highest();
    return worst == nullptr ? 0 : worst->height;
}

/// Height of what the last pass by a wire of @p wire_diameter leaves, to the tolerance: lengthening short moves may
/// take most of the time of a pass, and is left out.
double left_about(WireJob const& job, double wire_diameter)
{
    double const offset = offset_of(job, wire_diameter, 0);
    PairedPath const fine = fine_path(job, offset);
    PairedPath const path = taken(fine, thinned(fine, share_of_moves * job.wire.tolerance));
    return height_of(uncut_of(job.faces, path, cut_radius(job, offset)));
}

bool is_too_much(WireJob const& job, double height)
{
    return height + job.residual_error() > job.wire.residual_limit;
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
    PitchPass pass;
    pass.stock = stock;
    pass.offset = offset_of(job, wire_diameter, stock);
    PairedPath const fine = fine_path(job, pass.offset);
    std::vector<std::size_t> const kept = moves_along(job, fine).kept;
    pass.path = taken(fine, kept);
    pass.guide_chord = guide_chord_error(fine, kept, job.machine);
    pass.uncut = uncut_of(job.faces, pass.path, cut_radius(job, pass.offset));
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

bool leaves_too_much(WireJob const& job, PitchPass const& pass)
{
    return is_too_much(job, height_of(pass.uncut));
}

std::optional<double> fitting_wire(WireJob const& job)
{
    double const given = job.wire.wire_diameter, thinnest = std::max(thinnest_wire, job.wire.spark_gap);
    auto const diameter = [&](int step) { return std::min(step * wire_step, given); };
    auto const fits = [&](int step) { return !leaves_too_much(job, pitch_pass(job, diameter(step), 0)); };
    int const first = static_cast<int>(std::ceil(thinnest / wire_step));
    int const last = static_cast<int>(std::ceil(given / wire_step)) - 1;
    // a thinner wire reaches all that a thicker one does
    int fitting = first - 1;
    for (int wide = last + 1; wide - fitting > 1;) {
        int const step = (fitting + wide) / 2;
        (is_too_much(job, left_about(job, diameter(step))) ? wide : fitting) = step;
    }
    for (fitting = std::min(fitting + 1, last); fitting >= first; --fitting)
        if (fits(fitting))
            return diameter(fitting);
    return {};
}

bool fits_well(WireJob const& job)
{
    double const left = left_about(job, job.wire.wire_diameter), tolerance = job.wire.tolerance;
    return !is_too_much(job, std::max(left, tolerance) + 2 * share_of_moves * tolerance);
}

Fault residual_fault(WireJob const& job, std::vector<PitchPass> const& passes, std::optional<WireFaces> const& reached)
{
    Residual const* const worst = passes.back().uncut.highest();
    auto const wire = fitting_wire(job);
    auto const way = reached ? way_of_teeth(job, passes.back(), *reached) : std::nullopt;
    Fault fault = job.wire_key;
    fault.reason = fmt::format(
        "wire and gap are too wide to follow the contour: they leave {:.6g} +- {:.3g} mm at ({:f}, {:f}) mm of the {} "
        "face, {} of every tooth space, and residual_limit is {:.6g} mm",
        worst->height, job.residual_error(), worst->where.x(), worst->where.y(), worst->upper ? "upper" : "lower",
        worst->meshing ? "on a flank" : "in the root", job.wire.residual_limit);
    fault.remedy = fmt::format(
        "{} residual_limit = {:.6g}{}",
        wire ? fmt::format("write wire_diameter = {:.6g}, a thinner wire that leaves no more than that, or", *wire)
             : "no thinner wire that is sold leaves so little; write",
        std::ceil((worst->height + job.residual_error()) * told_per_mm) / told_per_mm,
        way ? fmt::format(": the teeth of the unloaded flexspline keep a distance of {:.6g} mm from what is left", *way)
            : "");
    return fault;
}

}  // namespace hdconj::wedm
