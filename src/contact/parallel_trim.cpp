// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/contact/parallel_trim.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace hdconj {
namespace {

/// How far the tangents of two neighbouring points go on until they meet: after the first and before the second.
struct TangentLengths
{
    double first, second;
};

/// @p turn sine of the angle between the tangents @p a and @p b
TangentLengths lengths(Vec2 const& chord, Vec2 const& a, Vec2 const& b, double turn)
{
    return {cross(chord, b) / turn, cross(a, chord) / turn};
}

/// A step between two points that has become an overlap, and how far its branches went on before.
struct Overlap
{
    std::size_t first, last;   ///< steps, by their first points
    double before, after;      ///< [mm]
};

/// Unit tangent in the order of the points.
Vec2 tangent(Vec2 const& normal, bool normals_left)
{
    return normals_left ? right_of(normal) : left_of(normal);
}

/// Steps that moving has turned round, those that touch each other together.
std::vector<Overlap> overlaps(std::vector<Vec2> const& bare, std::vector<Vec2> const& moved, std::vector<Vec2> const& normal, bool normals_left)
{
    constexpr double near_by = 1;   // chords by which the bare tangents may meet beside the step: normals of a ruled surface are off its sections'
    std::vector<Overlap> found;
    for (std::size_t i = 0; i + 1 < bare.size(); ++i)
    {
        Vec2 const a = tangent(normal[i], normals_left), b = tangent(normal[i + 1], normals_left);
        double const turn = cross(a, b);
        Vec2 const chord = bare[i + 1] - bare[i];
        double const reach = near_by * chord.norm();
        if (turn == 0 || reach == 0)
            continue;
        TangentLengths const was = lengths(chord, a, b, turn), is = lengths(moved[i + 1] - moved[i], a, b, turn);
        if (!(std::min(was.first, was.second) >= -reach && std::max(was.first, was.second) <= 2 * reach) || !(is.first < std::min(0.0, was.first) || is.second < std::min(0.0, was.second)))
            continue;
        double const before = std::max(0.0, was.first), after = std::max(0.0, was.second);
        if (!found.empty() && found.back().last + 1 == i)
        {
            found.back().last = i;
            found.back().after = after;
        }
        else
            found.push_back({i, i, before, after});
    }
    return found;
}

/// Where the segments a ... b and c ... d cross.
std::optional<Vec2> crossing(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    Vec2 const u = b - a, v = d - c;
    double const denominator = cross(u, v);
    if (denominator == 0)
        return std::nullopt;
    double const s = cross(c - a, v) / denominator, t = cross(c - a, u) / denominator;
    if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1))
        return std::nullopt;
    return Vec2(a + s * u);
}

/// The crossing of the branch that ends with the overlap and the one that begins with it: on which steps, counted from the overlap outward.
struct Crossing
{
    std::size_t before, after;
    Vec2 where;
};

std::optional<Crossing> crossing_of(std::vector<Vec2> const& moved, std::vector<Vec2> const& normal, bool normals_left, Overlap const& overlap)
{
    std::size_t const end = overlap.first, begin = overlap.last + 1;
    // the branch before, from the overlap outward, and the branch after
    double size = overlap.before + overlap.after;
    for (std::size_t i = end; i < begin; ++i)
        size += (moved[i + 1] - moved[i]).norm();
    constexpr double far = 8;   // an overlap that turns by up to 150 degrees ends nearer than this by its own length
    auto const branch = [&](std::size_t from, int step, Vec2 const& further) {
        std::vector<Vec2> points{further};
        for (auto i = static_cast<std::ptrdiff_t>(from); i >= 0 && i < static_cast<std::ptrdiff_t>(moved.size()); i += step)
        {
            points.push_back(moved[static_cast<std::size_t>(i)]);
            if (points.size() > 2 && (points.back() - moved[from]).norm() > far * size)
                break;
        }
        return points;
    };
    std::vector<Vec2> const before = branch(end, -1, moved[end] + overlap.before * tangent(normal[end], normals_left));
    std::vector<Vec2> const after = branch(begin, 1, moved[begin] - overlap.after * tangent(normal[begin], normals_left));
    for (std::size_t sum = 0; sum + 3 < before.size() + after.size(); ++sum)
        for (std::size_t i = 0; i <= sum; ++i)
            if (std::size_t const j = sum - i; i + 1 < before.size() && j + 1 < after.size())
                if (auto const where = crossing(before[i], before[i + 1], after[j], after[j + 1]))
                    return Crossing{i, j, *where};
    return std::nullopt;
}

}  // namespace

bool trim_overlaps(std::vector<Vec2> const& bare, std::vector<Vec2>& moved, std::vector<Vec2>& normal)
{
    bool cut = false;
    if (bare.size() < 2)
        return cut;
    // the side of the normals does not change along a flank
    double side = 0;
    for (std::size_t i = 0; i + 1 < bare.size(); ++i)
        side += cross(bare[i + 1] - bare[i], normal[i]);
    bool const normals_left = side > 0;
    for (Overlap const& overlap : overlaps(bare, moved, normal, normals_left))
    {
        auto const found = crossing_of(moved, normal, normals_left, overlap);
        if (!found)
            continue;
        std::size_t const first = overlap.first + 1 - found->before, last = overlap.last + found->after;   // points that come together
        Vec2 const before = normal[first - 1], after = normal[last + 1];
        for (std::size_t i = first; i <= last; ++i)
        {
            moved[i] = found->where;
            normal[i] = i <= overlap.first ? before : after;
            cut = true;
        }
    }
    return cut;
}

}  // namespace hdconj
