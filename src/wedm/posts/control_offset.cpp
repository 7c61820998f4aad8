// SPDX-License-Identifier: GPL-3.0-or-later
#include "control_offset.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "grid.hpp"
#include "hdconj/base/stop.hpp"
#include "wedm/seen_distance.hpp"

namespace hdconj::wedm {
namespace {

struct Line
{
    Vec2 at = Vec2::Zero();
    Vec2 along = Vec2::Zero();  ///< of length 1
};

/// Where two lines of the contour meet, in place of the points first ... last of the wire's path.
struct Corner
{
    Vec2 at = Vec2::Zero();
    std::size_t first = 0, last = 0;
    double deviation = 0;  ///< of the wire's path around the corner [mm]; 0 where the wire is inside of it
};

/// The path of the wire without its leads, and the line of the contour that belongs to each move: line k leads to the
/// wire's point k.
struct WireLines
{
    std::vector<Vec2> wire;
    std::vector<Line> lines;
    double offset = 0;
    double side = 1;  ///< 1: the wire is left of the contour, else -1

    explicit WireLines(WirePass const& pass) : offset(pass.offset), side(pass.reversed ? -1 : 1)
    {
        for (std::size_t i = 1; i + 1 < pass.moves.size(); ++i)
            wire.push_back(pass.moves[i].lower);
        // the leads' lines go through the start hole and keep the offset from the first and the last point of the wire
        lines.push_back(lead(pass.moves.front().lower, wire.front() - pass.moves.front().lower, -side));
        for (std::size_t k = 0; k + 1 < wire.size(); ++k) {
            Vec2 const along = (wire[k + 1] - wire[k]).normalized();
            lines.push_back({wire[k] - side * offset * left_of(along), along});
        }
        lines.push_back(lead(pass.moves.back().lower, pass.moves.back().lower - wire.back(), side));
    }

    [[nodiscard]] Line lead(Vec2 const& hole, Vec2 const& way, double turn) const
    {
        double const share = offset / way.norm();
        if (!(share < 1))
            throw no_room("lead-in",
                          "the start hole is nearer to the path than the offset; a larger wedm.lead_in helps");
        return {hole, Eigen::Rotation2Dd(turn * std::asin(share)) * way.normalized()};
    }

    /// The corner of two lines; nothing where there is none.
    [[nodiscard]] std::optional<Corner> corner(std::size_t i, std::size_t j) const
    {
        bool const next_to = j == i + 1, has_lead = i == 0 || j + 1 == lines.size();
        double const area = cross(lines[i].along, lines[j].along);
        Corner found{Vec2::Zero(), i, j - 1, 0};
        if (next_to && has_lead && area != 0)
            found.at = lines[i].at + cross(lines[j].at - lines[i].at, lines[j].along) / area * lines[i].along;
        else if (next_to && !has_lead)
            found.at = wire[i] - side * offset / (1 + lines[i].along.dot(lines[j].along)) *
                                     (left_of(lines[i].along) + left_of(lines[j].along));
        else if (has_lead || side * area >= 0 || !centre_of(found, lines[i], lines[j]))
            return {};  // points of a path that the wire is inside of may not be lost
        if (side * area < 0)
            found.deviation = deviation(found, lines[i], lines[j]);
        return found;
    }

    /// Moves @p corner to where the wire rolls around it from its first point to its last, and from there half as far
    /// into the part as its moves, which are chords, or the lines beside it are; false where it cannot.
    [[nodiscard]] bool centre_of(Corner& corner, Line const& before, Line const& after) const
    {
        Vec2 const half = 0.5 * (wire[corner.last] - wire[corner.first]);
        double const height = offset * offset - half.squaredNorm();
        if (!(height > 0))
            return false;
        Vec2 const inward = -side * left_of(half.normalized());
        corner.at = wire[corner.first] + half + std::sqrt(height) * inward;
        double depth = std::max(side_of(before, corner.at), side_of(after, corner.at));
        for (std::size_t k = corner.first; k < corner.last; ++k)
            depth = std::max(depth, offset - (0.5 * (wire[k] + wire[k + 1]) - corner.at).norm());
        corner.at += 0.5 * depth * inward;
        return true;
    }

    /// Distance of @p p from @p line, positive on the wire's side.
    [[nodiscard]] double side_of(Line const& line, Vec2 const& p) const
    {
        return side * cross(line.along, p - line.at);
    }

    /// How far the moves that @p corner stands for are off the arc around it, and how far it is off the lines beside
    /// it.
    [[nodiscard]] double deviation(Corner const& corner, Line const& before, Line const& after) const
    {
        double most = std::max(std::abs(side_of(before, corner.at)), std::abs(side_of(after, corner.at)));
        auto const measure = [&](Vec2 const& p) { most = std::max(most, std::abs((p - corner.at).norm() - offset)); };
        for (std::size_t k = corner.first; k <= corner.last; ++k) {
            measure(wire[k]);
            if (k < corner.last)
                measure(0.5 * (wire[k] + wire[k + 1]));
        }
        return most;
    }
};

/// The place half way along a lead. Over half of it the offset is switched on or off, the other half leads to the part.
Vec2 half_way(Vec2 const& hole, Vec2 const& corner, double offset)
{
    constexpr double room = 1.25;  // of the least length that a control takes, the offset
    Vec2 const half = 0.5 * (corner - hole);
    if (!(half.norm() > room * offset))
        throw no_room("lead-in", fmt::format("half of the way in is {:.6g} mm, and the control needs more than {:.6g} "
                                             "mm to switch on the offset; a larger wedm.lead_in helps",
                                             half.norm(), room * offset));
    return hole + half;
}

/// The cheapest contour up to a corner of lines i < j, which leaves out the lines between.
struct CornerChain
{
    std::size_t from = 0;    ///< i
    std::size_t before = 0;  ///< number of the way to line i that it goes on from
    Corner corner;
    std::size_t shorts = std::numeric_limits<std::size_t>::max();
    double deviations = 0;  ///< sum [mm]
};

/// The best way from one of @p chains to line i on to @p corner of the lines i and another one.
CornerChain best_chain(std::vector<CornerChain> const& chains, Corner const& corner, Vec2 const& along, double least)
{
    CornerChain best{corner.first, 0, corner};
    for (std::size_t k = 0; k < chains.size(); ++k) {
        double const length = (corner.at - chains[k].corner.at).dot(along);
        if (!(length > 0))
            continue;
        std::size_t const shorts = chains[k].shorts + (length < least ? 1 : 0);
        double const deviations = chains[k].deviations + corner.deviation;
        if (std::pair(shorts, deviations) < std::pair(best.shorts, best.deviations)) {
            best.before = k;
            best.shorts = shorts;
            best.deviations = deviations;
        }
    }
    return best;
}

/// The corners of the contour: those with the fewest short moves between, and then the least deviations. Leads are
/// never left out.
std::vector<Corner> corners_of(WireLines const& lines, double least, double allowed)
{
    std::size_t const last = lines.lines.size() - 1;
    std::vector<std::vector<CornerChain>> chains(last + 1);  // to each line
    if (auto const first = lines.corner(0, 1))
        chains[1].push_back({0, 0, *first, 0, first->deviation});
    for (std::size_t i = 1; i < last; ++i) {
        end_if_stopped();
        if (chains[i].empty())
            continue;
        for (std::size_t j = i + 1; j <= last; ++j) {
            auto const corner = lines.corner(i, j);
            if (!corner)
                break;
            if (j > i + 1 && corner->deviation > allowed)
                continue;
            CornerChain const chain = best_chain(chains[i], *corner, lines.lines[i].along, least);
            if (chain.shorts < last)
                chains[j].push_back(chain);
        }
    }
    if (chains[last].empty())
        throw no_room("contour", "what the wire can cut has a corner that no control can offset");
    std::vector<Corner> corners;
    for (std::size_t line = last, chain = 0; line > 0;) {
        CornerChain const& each = chains[line][chain];
        corners.push_back(each.corner);
        chain = each.before;
        line = each.from;
    }
    std::reverse(corners.begin(), corners.end());
    return corners;
}

}  // namespace

OffsetContour offset_contour(WirePass const& pass, double least, double allowed)
{
    WireLines const lines(pass);
    auto const corners = corners_of(lines, least, allowed);
    OffsetContour contour;
    contour.points = {pass.moves.front().lower, half_way(pass.moves.front().lower, corners.front().at, pass.offset)};
    for (auto const& corner : corners) {
        for (std::size_t k = corner.first; k <= corner.last; ++k)
            if (pass.moves[k + 1].tag == WireTag::stop)
                contour.stops.push_back(contour.points.size());
        contour.points.push_back(corner.at);
        contour.deviation = std::max(contour.deviation, corner.deviation);
    }
    contour.points.push_back(half_way(pass.moves.back().lower, corners.back().at, pass.offset));
    contour.points.push_back(pass.moves.back().lower);
    return contour;
}

std::vector<Vec2> path_of_control(std::vector<Vec2> const& points, double offset, bool wire_left, double sagitta)
{
    double const side = wire_left ? 1 : -1;
    double const step = 2 * std::acos(1 - std::min(0.5, sagitta / offset));
    std::vector<Vec2> normals;  // of each move, towards the wire
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
        normals.emplace_back(side * left_of((points[k + 1] - points[k]).normalized()));
    std::vector<Vec2> path;
    Vec2 begin = points.at(1) + offset * normals.at(1);
    auto const require_forward = [&](std::size_t move, Vec2 const& end) {
        if (!((end - begin).dot(points[move + 1] - points[move]) > 0))
            throw no_room(fmt::format("block {}", move + 1),
                          "a control with an offset would go backwards there, once coordinates are rounded");
    };
    for (std::size_t k = 2; k + 2 < points.size(); ++k) {
        Vec2 const &before = normals[k - 1], &after = normals[k];
        double const turn = std::atan2(cross(before, after), before.dot(after));
        std::size_t const first = path.size();
        if (side * turn > 0) {
            path.emplace_back(points[k] + offset / (1 + before.dot(after)) * (before + after));
        } else {
            int const chords = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / step)));
            for (int i = 0; i <= chords; ++i)
                path.emplace_back(points[k] + offset * (Eigen::Rotation2Dd(turn * i / chords) * before));
        }
        require_forward(k - 1, path[first]);
        begin = path.back();
    }
    require_forward(points.size() - 3, points[points.size() - 2] + offset * normals[points.size() - 3]);
    return path;
}

double distance_of_lines(std::vector<Vec2> const& a, std::vector<Vec2> const& b)
{
    double most = 0;
    auto const measure = [&](std::vector<Vec2> const& from, std::vector<Vec2> const& to) {
        region::SegmentTree const line(to);
        for (std::size_t i = 0; i < from.size(); ++i) {
            most = std::max(most, seen_distance(line, from[i]));
            if (i > 0)
                most = std::max(most, seen_distance(line, 0.5 * (from[i] + from[i - 1])));
        }
    };
    measure(a, b);
    measure(b, a);
    return most;
}

}  // namespace hdconj::wedm
