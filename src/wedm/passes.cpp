// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm/passes.hpp"

#include <algorithm>
#include <stdexcept>

namespace hdconj {
namespace {

/// All spaces, counter-clockwise from the tip land clockwise of @p start; the closing point is not repeated.
std::vector<WireMove> ring(PairedPath const& pitch, int teeth, int start)
{
    std::vector<WireMove> moves;
    moves.reserve((pitch.size() - 1) * static_cast<std::size_t>(teeth));
    for (int k = 0; k < teeth; ++k)
    {
        int const space = space_in_order(start, k, teeth);
        auto const lower = turned_to(pitch.lower, space, teeth);
        auto const upper = turned_to(pitch.upper, space, teeth);
        for (std::size_t i = 0; i + 1 < pitch.size(); ++i)
            moves.push_back({lower[i], upper[i], WireTag::contour, space});
    }
    return moves;
}

/// The point on the way from @p a to @p b at @p share of it.
WireMove between(WireMove const& a, WireMove const& b, double share)
{
    return {a.lower + share * (b.lower - a.lower), a.upper + share * (b.upper - a.upper), b.tag, b.tooth};
}

double length(WireMove const& a, WireMove const& b)
{
    return (b.lower - a.lower).norm();
}

/// Tags the point @p before the last one with `stop`; a new point where none lies there.
void tag_stop(std::vector<WireMove>& moves, std::size_t first, double before)
{
    double left = before;
    for (std::size_t i = moves.size() - 1; i > first; --i)
    {
        double const step = length(moves[i - 1], moves[i]);
        if (left >= step)
        {
            left -= step;
            continue;
        }
        WireMove stop = between(moves[i - 1], moves[i], 1 - left / step);
        stop.tag = WireTag::stop;
        bool const there = left == 0;
        if (there)
            moves[i].tag = WireTag::stop;
        else
            moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(i), stop);
        return;
    }
    throw std::invalid_argument("stop_before is longer than the path");
}

}  // namespace

PairedContour whole_contour(WireFaces const& faces, std::vector<std::size_t> const& indices)
{
    PairedContour contour;
    PairedPath const few = taken(faces.pitch, indices);
    for (int k = 0; k < faces.teeth; ++k)
    {
        int const space = space_in_order(0, k, faces.teeth);
        std::size_t const first = contour.lower.size();
        for (std::size_t const mark : faces.marks)
        {
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

Vec2 start_hole(WireFaces const& faces, int start, double lead_in)
{
    Vec2 const& low = faces.pitch.lower.front();
    Vec2 const& up = faces.pitch.upper.front();
    double const land = std::min(low.norm(), up.norm());
    return turned_to(Vec2(low.normalized() * (land - lead_in)), start, faces.teeth);
}

WirePass wire_pass(PairedPath const& pitch, int teeth, WireRun const& run)
{
    std::vector<WireMove> around = ring(pitch, teeth, run.start);
    if (run.reversed)
        std::reverse(around.begin() + 1, around.end());
    WirePass pass;
    pass.reversed = run.reversed;
    pass.moves.push_back({run.hole, run.hole, WireTag::thread, -1});
    pass.moves.push_back({around.front().lower, around.front().upper, WireTag::lead_in, around.front().tooth});
    pass.moves.insert(pass.moves.end(), around.begin() + 1, around.end());
    WireMove closing = around.front();
    closing.tooth = around.back().tooth;
    pass.moves.push_back(closing);
    if (run.stop_before > 0)
        tag_stop(pass.moves, 1, run.stop_before);
    double left = run.overlap;
    for (std::size_t i = 1; left > 0; ++i)
    {
        if (i == around.size())
            throw std::invalid_argument("overlap is longer than the path");
        double const step = length(around[i - 1], around[i]);
        WireMove move = left < step ? between(around[i - 1], around[i], left / step) : around[i];
        move.tag = WireTag::overlap;
        pass.moves.push_back(move);
        left -= step;
    }
    pass.moves.push_back({run.hole, run.hole, WireTag::lead_out, -1});
    return pass;
}

}  // namespace hdconj
