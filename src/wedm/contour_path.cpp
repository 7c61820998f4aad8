// SPDX-License-Identifier: GPL-3.0-or-later
#include "contour_path.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "hdconj/wedm/checks.hpp"
#include "hdconj/wedm/planes.hpp"

namespace hdconj {
namespace detail {

std::vector<WireMove> contour_path(WirePass const& pass)
{
    std::vector<WireMove> path;
    for (WireMove const& move : pass.moves)
        if (move.tag == WireTag::lead_in || move.tag == WireTag::contour || move.tag == WireTag::stop)
            path.push_back(move);
    return path;
}

std::vector<WireMove> even_path(WirePass const& pass, int spaces)
{
    std::vector<WireMove> path = contour_path(pass);
    auto const count = static_cast<std::size_t>(spaces);
    auto const stop = std::find_if(path.begin(), path.end(), [](WireMove const& m) { return m.tag == WireTag::stop; });
    if (stop != path.end() && path.size() % count != 1 % count)
        path.erase(stop);
    if (spaces < 1 || path.size() < count + 1 || (path.size() - 1) % count != 0)
        throw std::invalid_argument("the moves of pass " + std::to_string(pass.number) + " are not those of " + std::to_string(spaces) + " equal tooth spaces");
    if (pass.reversed)
        std::reverse(path.begin(), path.end());
    return path;
}

std::vector<Vec2> section(PairedPath const& path, WireMachine const& machine, double share)
{
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < path.size(); ++i)
        points.push_back(at_height(machine, {path.lower[i], path.upper[i]}, share * machine.thickness));
    return points;
}

}  // namespace detail

PairedPath pitch_of(WirePass const& pass, WireProgram const& program)
{
    std::vector<WireMove> const path = detail::even_path(pass, program.spaces());
    std::size_t const steps = (path.size() - 1) / static_cast<std::size_t>(program.spaces());
    PairedPath pitch;
    // the point behind the first belongs to the first space either way round
    int const space = path[1].tooth;
    for (std::size_t i = 0; i <= steps; ++i)
        pitch.add(turned_to(path[i].lower, -space, program.teeth), turned_to(path[i].upper, -space, program.teeth));
    return pitch;
}

}  // namespace hdconj
