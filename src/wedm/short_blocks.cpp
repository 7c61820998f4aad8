// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks that rounding turns, and which key of [wedm] makes them longer.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "checks.hpp"
#include "hdconj/units.hpp"
#include "passes.hpp"

namespace hdconj::wedm {
namespace {

/// Largest angle by which rounding turns a block of @p length whose ends are each half a @p unit off along both axes
/// [rad]: then they are off by sqrt(2) units against each other, and a block that is no longer may point anywhere.
double largest_turn(double length, double unit)
{
    double const off = std::numbers::sqrt2 * unit;
    return off < length ? std::asin(off / length) : std::numbers::pi;
}

/// Length in the plane of all where it is shortest, and in the lower face, as keys state lengths [mm].
struct BlockLength
{
    double shortest = 0, lower = 0;
};

/// The blocks of a pass between the points @p from and @p to.
BlockLength length_between(WireProgram const& program, WirePass const& pass, std::size_t from, std::size_t to)
{
    BlockLength sum;
    for (std::size_t i = from + 1; i <= to; ++i) {
        WireMove const &a = pass.moves[i - 1], &b = pass.moves[i];
        sum.shortest += shortest_plane(program.machine, {a.lower, a.upper}, {b.lower, b.upper});
        sum.lower += (b.lower - a.lower).norm();
    }
    return sum;
}

/// The first or, where none is, the last move of @p pass of which @p is_so holds.
template <class Is>
std::size_t find_move(WirePass const& pass, Is const& is_so)
{
    auto const found = std::ranges::find_if(pass.moves, is_so, &WireMove::tag);
    return std::min(static_cast<std::size_t>(found - pass.moves.begin()), pass.moves.size() - 1);
}

/// The remedy for the @p end of a path that @p key makes too short.
std::string longer_end(char const* key, BlockLength const& end, int decimals)
{
    if (!(end.shortest > 0))
        return fmt::format("write {} = 0", key);
    double const units = std::floor(least_units * end.lower / end.shortest) + 1;
    return fmt::format("write {} = 0 or at least {:.{}f}", key, units * std::pow(10.0, -decimals), decimals);
}

/// What makes the blocks of @p pass long that end at the moves @p shorts.
std::vector<std::string> remedies(WireProgram const& program, WirePass const& pass,
                                  std::vector<std::size_t> const& shorts, FittingDecimals const& fitting)
{
    double const least = least_block(program.decimals);
    std::size_t const last = pass.moves.size() - 1;
    std::size_t const stop = find_move(pass, [](WireTag tag) { return tag == WireTag::stop; });
    std::size_t const beyond =
        find_move(pass, [](WireTag tag) { return tag == WireTag::overlap || tag == WireTag::lead_out; });
    BlockLength const stopped = length_between(program, pass, stop, beyond - 1),
                      overlap = length_between(program, pass, beyond - 1, last - 1);
    bool of_lead = false, of_stop = false, of_overlap = false, of_contour = false;
    for (std::size_t const i : shorts) {
        WireTag const tag = pass.moves[i].tag;
        bool& key = tag == WireTag::lead_in || tag == WireTag::lead_out   ? of_lead
                    : i > stop && i < beyond && stopped.shortest < least  ? of_stop
                    : tag == WireTag::overlap && overlap.shortest < least ? of_overlap
                                                                          : of_contour;
        key = true;
    }
    std::vector<std::string> all;
    if (of_lead)
        all.emplace_back("write a longer wedm.lead_in");
    if (of_stop)
        all.push_back(longer_end("wedm.stop_before", stopped, program.decimals));
    if (of_overlap)
        all.push_back(longer_end("wedm.overlap", overlap, program.decimals));
    if (of_contour) {
        auto const decimals = fitting ? fitting(pass) : std::nullopt;
        all.push_back((decimals ? fmt::format("write wedm.decimals = {}, or", *decimals) : std::string("write")) +
                      " a coarser wedm.tolerance where wedm.surface_limit leaves room for it");
    }
    return all;
}

}  // namespace

std::vector<std::string> short_block_warnings(WireProgram const& program, FittingDecimals const& fitting)
{
    double const least = least_block(program.decimals), unit = least / least_units;
    std::vector<std::string> warnings;
    for (WirePass const& pass : program.passes) {
        std::vector<std::size_t> shorts;
        double shortest = least;
        for (std::size_t i = 1; i < pass.moves.size(); ++i) {
            double const length = length_between(program, pass, i - 1, i).shortest;
            if (length < least)
                shorts.push_back(i);
            shortest = std::min(shortest, length);
        }
        if (shorts.empty())
            continue;
        bool const one = shorts.size() == 1;
        warnings.push_back(
            fmt::format("{} block{} of pass {} {} shorter than {:g} units of the last digit in a face or at a guide, "
                        "{}{:.3g} mm: rounding turns {} by up to {:.3g} deg; {}",
                        shorts.size(), one ? "" : "s", pass.number, one ? "is" : "are", least_units,
                        one ? "" : "down to ", shortest, one ? "it" : "that one", largest_turn(shortest, unit) / deg,
                        fmt::join(remedies(program, pass, shorts, fitting), "; ")));
    }
    return warnings;
}

}  // namespace hdconj::wedm
