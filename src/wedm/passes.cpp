// SPDX-License-Identifier: GPL-3.0-or-later
#include "passes.hpp"

#include <stdexcept>
#include <string>

namespace hdconj::wedm {
namespace {

/// @p count spaces from @p start on, void on the left; the last point, where the next space begins, is not among them.
std::vector<WireMove> spaces(PairedPath const& pitch, WireFaces const& faces, int start, int count)
{
    std::vector<WireMove> moves;
    moves.reserve((pitch.size() - 1) * static_cast<std::size_t>(count) + 1);
    for (int k = 0; k < count; ++k) {
        int const space = faces.space_in_order(start, k);
        auto const lower = turned_to(pitch.lower, space, faces.teeth);
        auto const upper = turned_to(pitch.upper, space, faces.teeth);
        for (std::size_t i = 0; i + 1 < pitch.size(); ++i)
            moves.push_back({lower[i], upper[i], WireTag::contour, space});
    }
    return moves;
}

double length(WireMove const& a, WireMove const& b)
{
    return (b.lower - a.lower).norm();
}

/// Tags the point @p before the last one with `stop`; a new point where none lies within @p least.
void tag_stop(std::vector<WireMove>& moves, std::size_t first, double before, double least)
{
    double left = before;
    for (std::size_t i = moves.size() - 1; i > first; --i) {
        double const step = length(moves[i - 1], moves[i]);
        if (left >= step) {
            left -= step;
            continue;
        }
        bool const is_end = i + 1 == moves.size();
        if (i > first + 1 && step - left < least)
            --i;
        else if (left > 0 && (is_end || left >= least))
            moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(i),
                         between(moves[i - 1], moves[i], 1 - left / step));
        moves[i].tag = WireTag::stop;
        return;
    }
    throw std::invalid_argument("stop_before is longer than the path");
}

}  // namespace

double shortest_plane(WireMachine const& machine, WirePoints const& a, WirePoints const& b)
{
    WirePoints const from = guides_of(machine, a), to = guides_of(machine, b);
    return std::min({(b.lower - a.lower).norm(), (b.upper - a.upper).norm(), (to.lower - from.lower).norm(),
                     (to.upper - from.upper).norm()});
}

PairedContour whole_contour(WireFaces const& faces, std::vector<std::size_t> const& indices)
{
    PairedContour contour;
    PairedPath const few = taken(faces.pitch, indices);
    for (int k = 0; k < faces.teeth; ++k) {
        int const space = faces.space_in_order(0, k);
        std::size_t const first = contour.lower.size();
        for (std::size_t const mark : faces.marks) {
            auto const at = std::lower_bound(indices.begin(), indices.end(), mark);
            contour.sync.push_back(first + static_cast<std::size_t>(at - indices.begin()));
        }
        auto const lower = turned_to(few.lower, space, faces.teeth);
        auto const upper = turned_to(few.upper, space, faces.teeth);
        contour.lower.insert(contour.lower.end(), lower.begin(), lower.end() - 1);
        contour.upper.insert(contour.upper.end(), upper.begin(), upper.end() - 1);
    }
    return contour;
}

namespace {

/// The whole way of a pass, and what follows behind its end.
struct Way
{
    std::vector<WireMove> path;    ///< closing point, or end of the last space, included
    std::vector<WireMove> beyond;  ///< does not repeat the end
};

Way closed_way(PairedPath const& pitch, WireFaces const& faces, WireRun const& run)
{
    Way way;
    way.path = spaces(pitch, faces, run.start, faces.teeth);
    if (run.reversed)
        std::reverse(way.path.begin() + 1, way.path.end());
    way.beyond.assign(way.path.begin() + 1, way.path.end());
    WireMove closing = way.path.front();
    closing.tooth = way.path.back().tooth;
    way.path.push_back(closing);
    return way;
}

Way open_way(PairedPath const& pitch, WireFaces const& faces, WireRun const& run)
{
    Way way;
    int const rest = faces.teeth - run.spaces;
    way.path = spaces(pitch, faces, run.start, run.spaces);
    int const last = faces.space_in_order(run.start, run.spaces - 1);
    way.path.push_back({turned_to(pitch.lower.back(), last, faces.teeth),
                        turned_to(pitch.upper.back(), last, faces.teeth), WireTag::contour, last});
    way.beyond = spaces(pitch, faces, faces.space_in_order(run.start, run.spaces), rest);
    if (run.reversed) {
        std::reverse(way.path.begin(), way.path.end());
        std::reverse(way.beyond.begin(), way.beyond.end());
    } else if (!way.beyond.empty())
        way.beyond.erase(way.beyond.begin());
    return way;
}

}  // namespace

WireMove between(WireMove const& a, WireMove const& b, double share)
{
    return {a.lower + share * (b.lower - a.lower), a.upper + share * (b.upper - a.upper), b.tag, b.tooth};
}

Vec2 hole_beside(WireFaces const& faces, int space, bool at_end, double lead_in)
{
    auto const& [lower, upper] = faces.pitch;
    Vec2 const low = at_end ? lower.back() : lower.front(), up = at_end ? upper.back() : upper.front();
    double const land =
        faces.external ? std::max(low.norm(), up.norm()) + lead_in : std::min(low.norm(), up.norm()) - lead_in;
    return turned_to(Vec2(low.normalized() * land), space, faces.teeth);
}

WirePass wire_pass(PairedPath const& pitch, WireFaces const& faces, WireRun const& run)
{
    bool const closed = run.spaces == 0;
    Way const way = closed ? closed_way(pitch, faces, run) : open_way(pitch, faces, run);
    Vec2 const first = !closed && run.reversed ? run.end : run.hole;
    Vec2 const last = closed || run.reversed ? run.hole : run.end;
    WirePass pass;
    pass.reversed = run.reversed;
    pass.moves.push_back({first, first, WireTag::thread, -1});
    pass.moves.insert(pass.moves.end(), way.path.begin(), way.path.end());
    pass.moves[1].tag = WireTag::lead_in;
    if (run.stop_before > 0)
        tag_stop(pass.moves, 1, run.stop_before, run.least);
    double left = run.overlap;
    WireMove from = way.path.back();
    for (std::size_t i = 0; left > 0; ++i) {
        if (i == way.beyond.size())
            throw std::invalid_argument("overlap is longer than the path");
        double const step = length(from, way.beyond[i]);
        if (i > 0 && left < run.least)
            break;
        WireMove move = left < step - run.least ? between(from, way.beyond[i], left / step) : way.beyond[i];
        move.tag = WireTag::overlap;
        move.tooth = way.beyond[i].tooth;
        pass.moves.push_back(move);
        left -= step;
        from = way.beyond[i];
    }
    pass.moves.push_back({last, last, WireTag::lead_out, -1});
    return pass;
}

std::vector<WireMove> contour_path(WirePass const& pass)
{
    std::vector<WireMove> path;
    for (WireMove const& move : pass.moves)
        if (move.tag == WireTag::lead_in || move.tag == WireTag::contour || move.tag == WireTag::stop)
            path.push_back(move);
    return path;
}

PairedPath points_of(std::vector<WireMove> const& moves, std::size_t left_out)
{
    PairedPath path;
    for (std::size_t i = 0; i + left_out < moves.size(); ++i)
        path.add(moves[i].lower, moves[i].upper);
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
        throw std::invalid_argument("the moves of pass " + std::to_string(pass.number) + " are not those of " +
                                    std::to_string(spaces) + " equal tooth spaces");
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

PairedPath pitch_of(WirePass const& pass, WireProgram const& program)
{
    std::vector<WireMove> const path = even_path(pass, program.spaces());
    std::size_t const steps = (path.size() - 1) / static_cast<std::size_t>(program.spaces());
    PairedPath pitch;
    // the point behind the first belongs to the first space either way round
    int const space = path[1].tooth;
    for (std::size_t i = 0; i <= steps; ++i)
        pitch.add(turned_to(path[i].lower, -space, program.teeth), turned_to(path[i].upper, -space, program.teeth));
    return pitch;
}

}  // namespace hdconj::wedm
