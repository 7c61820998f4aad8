// SPDX-License-Identifier: GPL-3.0-or-later
// What a program says of itself: numbers, pairing, machine, start.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "check_words.hpp"
#include "contour_path.hpp"
#include "hdconj/numeric/tolerance.hpp"
#include "hdconj/wedm/checks.hpp"
#include "segment_grid.hpp"

namespace hdconj {

using detail::contour_path;
using detail::name;
using detail::text;

WireFailures check_numbers(WireProgram const& program)
{
    WireFailures failures;
    WireMachine const& m = program.machine;
    auto const need = [&](bool good, std::string const& what, double value) {
        if (!good || !std::isfinite(value))
            failures.push_back({"numbers", what + " is " + text(value) + " mm"});
    };
    need(m.thickness > 0, "thickness of the workpiece", m.thickness);
    need(m.lower_guide >= 0, "lower guide", m.lower_guide);
    need(m.upper_guide >= 0, "upper guide", m.upper_guide);
    need(program.wire_diameter > 0, "wire diameter", program.wire_diameter);
    need(program.spark_gap >= 0, "spark gap", program.spark_gap);
    need(program.tolerance > 0, "tolerance", program.tolerance);
    for (WirePass const& pass : program.passes)
    {
        double const expected = program.wire_diameter / 2 + program.spark_gap + pass.stock;
        need(pass.stock >= 0, "stock of " + name(pass), pass.stock);
        need(std::abs(pass.offset - expected) <= 64 * unit_roundoff * expected, "offset of " + name(pass), pass.offset);
    }
    if (program.passes.empty() || program.passes.back().stock != 0)
        failures.push_back({"numbers", "no pass leaves the nominal part"});
    auto const finite = [](Vec2 const& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); };
    bool const contour = std::all_of(program.nominal.lower.begin(), program.nominal.lower.end(), finite)
                         && std::all_of(program.nominal.upper.begin(), program.nominal.upper.end(), finite);
    if (!contour)
        failures.push_back({"numbers", "a point of the nominal contour is not finite"});
    for (WirePass const& pass : program.passes)
        if (!std::all_of(pass.moves.begin(), pass.moves.end(), [&](WireMove const& move) { return finite(move.lower) && finite(move.upper); }))
            failures.push_back({"numbers", "a move of " + name(pass) + " is not finite"});
    return failures;
}

WireFailures check_pairing(WireProgram const& program)
{
    WireFailures failures;
    PairedContour const& nominal = program.nominal;
    if (nominal.lower.size() != nominal.upper.size())
        failures.push_back({"pairing", "the nominal contour has " + std::to_string(nominal.lower.size()) + " points below and " + std::to_string(nominal.upper.size()) + " above"});
    bool const rising = std::adjacent_find(nominal.sync.begin(), nominal.sync.end(), std::greater_equal<>()) == nominal.sync.end();
    if (!rising || (!nominal.sync.empty() && nominal.sync.back() >= nominal.lower.size()))
        failures.push_back({"pairing", "the sync marks of the nominal contour do not increase"});
    for (std::size_t i = 1; i < std::min(nominal.lower.size(), nominal.upper.size()); ++i)
        if (nominal.lower[i] == nominal.lower[i - 1] || nominal.upper[i] == nominal.upper[i - 1])
            failures.push_back({"pairing", "points " + std::to_string(i - 1) + " and " + std::to_string(i) + " of the nominal contour are one point in one face"});
    for (WirePass const& pass : program.passes)
    {
        if (pass.moves.size() < 2)
        {
            failures.push_back({"pairing", name(pass) + " has no moves"});
            continue;
        }
        WireMove const& first = pass.moves.front();
        WireMove const& last = pass.moves.back();
        bool const vertical = first.lower == first.upper && last.lower == last.upper;
        bool const apart = program.closed() && first.lower != last.lower;
        if (!vertical || apart || first.tag != WireTag::thread || last.tag != WireTag::lead_out)
            failures.push_back({"pairing", name(pass) + " does not begin and end in the start hole with the wire vertical"});
        for (std::size_t i = 1; i < pass.moves.size(); ++i)
            if (pass.moves[i].lower == pass.moves[i - 1].lower || pass.moves[i].upper == pass.moves[i - 1].upper)
                failures.push_back({"pairing", "move " + std::to_string(i) + " of " + name(pass) + " has length zero in one face, at " + text(pass.moves[i].lower)});
        std::vector<WireMove> const path = contour_path(pass);
        if (program.closed() && (path.front().lower != path.back().lower || path.front().upper != path.back().upper))
            failures.push_back({"pairing", name(pass) + " does not close: from " + text(path.front().lower) + " to " + text(path.back().lower)});
    }
    return failures;
}

WireFailures check_machine(MachineLimits const& limits, WireProgram& program)
{
    program.figures = measured(program);
    WireFigures const& figures = program.figures;
    WireFailures failures;
    if (figures.tilt > limits.tilt)
        failures.push_back({"machine", "the wire would be tilted by " + text(figures.tilt) + " rad, and the machine tilts it by " + text(limits.tilt)
                                           + " rad at most (wedm.largest_tilt_deg)"});
    if (figures.travel > limits.travel)
        failures.push_back({"machine", "a guide would travel " + text(figures.travel) + " mm from the start hole, and the machine " + text(limits.travel)
                                           + " mm at most (wedm.largest_travel)"});
    if (figures.uv_travel > limits.uv_travel)
        failures.push_back({"machine", "the upper guide would stand " + text(figures.uv_travel) + " mm off the lower one along an axis, and the machine moves it by "
                                           + text(limits.uv_travel) + " mm at most (wedm.largest_uv_travel)"});
    return failures;
}

WireFailures check_start(WireProgram const& program)
{
    WireFailures failures;
    for (WirePass const& pass : program.passes)
    {
        Vec2 const hole = pass.moves.front().lower;
        Vec2 const out = pass.moves.back().lower;
        Vec2 const to[2] = {pass.moves[1].lower, pass.moves[1].upper};
        Vec2 const from[2] = {pass.moves[pass.moves.size() - 2].lower, pass.moves[pass.moves.size() - 2].upper};
        for (std::size_t f = 0; f < 2; ++f)
        {
            std::string const face = f == 0 ? " in the lower face" : " in the upper face";
            double clear = std::numeric_limits<double>::infinity();
            double way = clear;
            for (Vec2 const& p : f == 0 ? program.nominal.lower : program.nominal.upper)
            {
                clear = std::min({clear, (p - hole).norm(), (p - out).norm()});
                way = std::min({way, detail::distance_to_segment(p, hole, to[f]), detail::distance_to_segment(p, from[f], out)});
            }
            if (!(clear >= pass.offset + program.start_hole_radius))
                failures.push_back({"start", "the start hole's centre is " + text(clear) + " mm from the part" + face + ", and " + name(pass) + " needs "
                                                 + text(pass.offset + program.start_hole_radius) + " mm"});
            if (!(way >= pass.offset - program.tolerance))
                failures.push_back({"start", "lead-in or lead-out of " + name(pass) + " come within " + text(way) + " mm of the part" + face + ", and the offset is "
                                                 + text(pass.offset) + " mm"});
        }
    }
    return failures;
}

WireFailures check_untilted(WireProgram const& program)
{
    WireFailures failures;
    if (program.nominal.lower != program.nominal.upper)
        return failures;
    for (WirePass const& pass : program.passes)
        if (!std::all_of(pass.moves.begin(), pass.moves.end(), [](WireMove const& move) { return move.lower == move.upper; }))
            failures.push_back({"untilted", "both faces of the part are the same, but not those of " + name(pass)});
    return failures;
}

std::vector<std::string> skim_warnings(WireProgram const& program)
{
    std::vector<std::string> warnings;
    for (std::size_t k = 0; k + 1 < program.passes.size(); ++k)
    {
        WirePass const& pass = program.passes[k];
        double const layer = pass.stock - program.passes[k + 1].stock;
        double highest = 0;
        for (Residual const& residual : program.residuals)
            highest = std::max(highest, residual.pass == pass.number ? residual.height : 0);
        if (highest > layer)
            warnings.push_back(name(pass) + " leaves up to " + text(highest) + " mm on top of its stock where it cannot follow the contour, more than the layer of " + text(layer)
                               + " mm that " + name(program.passes[k + 1]) + " is to take: there it cuts " + text(highest + layer) + " mm deep");
    }
    return warnings;
}

}  // namespace hdconj
