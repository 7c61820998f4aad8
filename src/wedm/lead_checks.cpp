// SPDX-License-Identifier: GPL-3.0-or-later
// The start hole, and the leads between it and the path.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checks.hpp"
#include "passes.hpp"
#include "region/segment_tree.hpp"

namespace hdconj::wedm {
namespace {

/// The closed contour of the part in a face.
std::vector<Vec2> const& contour_in(WireProgram const& program, bool upper)
{
    return upper ? program.nominal.upper : program.nominal.lower;
}

Vec2 place_in(WireMove const& move, bool upper)
{
    return upper ? move.upper : move.lower;
}

/// Distance of the straight way between @p a and @p b from the edges of a closed contour [mm].
double distance_of_way(Vec2 const& a, Vec2 const& b, std::vector<Vec2> const& contour)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contour.size(); ++i)
        least = std::min(least,
                         region::distance_of_segments(a, b, contour[i], contour[i + 1 == contour.size() ? 0 : i + 1]));
    return least;
}

double distance_of_point(Vec2 const& p, std::vector<Vec2> const& contour)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contour.size(); ++i)
        least =
            std::min(least, region::segment_foot(p, contour[i], contour[i + 1 == contour.size() ? 0 : i + 1]).squared);
    return std::sqrt(least);
}

/// Distance that a lead has to keep from the part, off which the path and the edges of the contour may each be [mm].
double least_distance(WireProgram const& program, WirePass const& pass)
{
    return pass.offset - 2 * program.tolerance;
}

/// Index of the move at whose end the overlap of @p pass begins.
std::size_t overlap_begin(WirePass const& pass)
{
    std::size_t i = pass.moves.size() - 2;
    while (pass.moves[i].tag == WireTag::overlap)
        --i;
    return i;
}

/// Where @p pass would end with an overlap of @p length [mm], at most its own.
WireMove end_of_overlap(WirePass const& pass, double length)
{
    std::size_t i = overlap_begin(pass);
    for (; i + 2 < pass.moves.size(); ++i) {
        WireMove const &a = pass.moves[i], &b = pass.moves[i + 1];
        double const step = (b.lower - a.lower).norm();
        if (length < step)
            return between(a, b, length / step);
        length -= step;
    }
    return pass.moves[i];
}

/// Whether the way out from an overlap of @p length [mm] keeps clear of the part, in all passes and both faces.
bool is_free(WireProgram const& program, double length)
{
    return std::ranges::all_of(program.passes, [&](WirePass const& pass) {
        WireMove const end = end_of_overlap(pass, length);
        return std::ranges::all_of(std::array{false, true}, [&](bool upper) {
            return distance_of_way(place_in(end, upper), place_in(pass.moves.back(), upper),
                                   contour_in(program, upper)) >= least_distance(program, pass);
        });
    });
}

/// The longest overlap below that of the program whose way out is free, to a 64th of it; none where no shorter one
/// helps. A pass may end by up to a shortest block before or behind the end of its overlap, where the way is free too.
std::optional<double> free_overlap(WireProgram const& program)
{
    constexpr int parts = 64;
    WirePass const& pass = program.passes.front();
    double given = 0;
    for (std::size_t i = overlap_begin(pass); i + 2 < pass.moves.size(); ++i)
        given += (pass.moves[i + 1].lower - pass.moves[i].lower).norm();
    if (is_free(program, given))
        return std::nullopt;  // it is the lead-in that is too near
    double const digit = std::pow(10.0, -program.decimals), least = least_block(program.decimals);
    for (int part = parts - 1; part >= 0; --part) {
        double const length = std::floor(given * part / parts / digit) * digit;
        if (is_free(program, length) && is_free(program, std::max(0.0, length - least)) &&
            is_free(program, std::min(given, length + least)))
            return length;
    }
    return std::nullopt;
}

/// @param overlap  whose way out is free [mm]; none where no shorter one helps
WireFailure lead_failure(std::string cause, std::optional<double> overlap)
{
    if (!overlap)
        return {std::move(cause), "write a shorter wedm.lead_in"};
    return {std::move(cause),
            fmt::format("write wedm.overlap = {:.6g}, from whose end the way to the start hole is free", *overlap),
            fmt::format("wedm.overlap={:.6g}", *overlap)};
}

}  // namespace

WireFailures check_start(WireProgram const& program)
{
    WireFailures failures;
    std::vector<std::string> near;
    for (WirePass const& pass : program.passes) {
        Vec2 const hole = pass.moves.front().lower, out = pass.moves.back().lower;
        WireMove const &to = pass.moves[1], &from = pass.moves[pass.moves.size() - 2];
        for (bool const upper : {false, true}) {
            char const* const face = upper ? "upper" : "lower";
            std::vector<Vec2> const& part = contour_in(program, upper);
            double const clear = std::min(distance_of_point(hole, part), distance_of_point(out, part));
            double const way = std::min(distance_of_way(hole, place_in(to, upper), part),
                                        distance_of_way(place_in(from, upper), out, part));
            double const room = pass.offset + program.start_hole_radius;
            if (!(clear >= room))
                failures.push_back(
                    fmt::format("start: the start hole's centre is {:.6g} mm from the part in the {} face, and pass {} "
                                "needs {:.6g} mm",
                                clear, face, pass.number, room));
            if (!(way >= least_distance(program, pass)))
                near.push_back(
                    fmt::format("start: the lead-in or lead-out of pass {} comes within {:.6g} mm of the part in the "
                                "{} face, and the offset is {:.6g} mm",
                                pass.number, way, face, pass.offset));
        }
    }
    if (near.empty())
        return failures;
    std::optional<double> const overlap = free_overlap(program);
    for (std::string& cause : near)
        failures.push_back(lead_failure(std::move(cause), overlap));
    return failures;
}

}  // namespace hdconj::wedm
