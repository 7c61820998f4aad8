// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel_trim.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "base/segments.hpp"
#include "numeric/least_between.hpp"

namespace hdconj::contact {
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
    std::size_t first, last;  ///< steps, by their first points
    double before, after;     ///< [mm]
};

/// Unit tangent in the order of the points.
Vec2 tangent(Vec2 const& normal, bool normals_left)
{
    return normals_left ? right_of(normal) : left_of(normal);
}

/// Steps that moving has turned round, and corners whose branches it has laid over each other; those that touch each
/// other together.
std::vector<Overlap> overlaps(std::vector<Vec2> const& bare, std::vector<Vec2> const& moved,
                              std::vector<Vec2> const& normal, bool normals_left)
{
    constexpr double corner = 4;    // times as much as beside it a step turns there
    constexpr double beside = 0.1;  // steps by which bare tangents may meet beside it, where a branch bends back
    auto const turn_of = [&](std::size_t i) {
        return i + 1 < normal.size() ? std::abs(cross(normal[i], normal[i + 1])) : 0.0;
    };
    std::vector<Overlap> found;
    for (std::size_t i = 0; i + 1 < bare.size(); ++i) {
        Vec2 const a = tangent(normal[i], normals_left), b = tangent(normal[i + 1], normals_left);
        double const turn = cross(a, b);
        Vec2 const chord = bare[i + 1] - bare[i], now = moved[i + 1] - moved[i];
        double const length = chord.norm();
        if (turn == 0 || length == 0)
            continue;
        TangentLengths const was = lengths(chord, a, b, turn), is = lengths(now, a, b, turn);
        bool const between = std::min(was.first, was.second) >= -beside * length &&
                             std::max(was.first, was.second) <= (1 + beside) * length;
        bool const sharp = between && std::abs(turn) > corner * std::max(i > 0 ? turn_of(i - 1) : 0.0, turn_of(i + 1));
        bool const laid_over = sharp && (is.first < std::min(0.0, was.first) || is.second < std::min(0.0, was.second));
        if (!laid_over && now.dot(a + b) >= 0)
            continue;
        double const before = std::clamp(was.first, 0.0, length), after = std::clamp(was.second, 0.0, length);
        if (!found.empty() && found.back().last + 1 == i) {
            found.back().last = i;
            found.back().after = after;
        } else
            found.push_back({i, i, before, after});
    }
    return found;
}

/// The crossing of the branch that ends with the overlap and the one that begins with it: on which steps, counted from
/// the overlap outward.
struct Crossing
{
    std::size_t before, after;
    Vec2 where;
};

/// Points of a branch from the overlap outward, with their normals.
struct Branch
{
    std::vector<Vec2> point, normal;

    [[nodiscard]] Vec2 between(std::size_t i, double t) const
    {
        return hermite_between(point[i], normal[i], point[i + 1], normal[i + 1], t);
    }
};

/// Where the steps @p i and @p j of the two branches cross as curves: their chords, moved by as much as the curves
/// bulge from them there.
Vec2 as_curves(Branch const& before, std::size_t i, Branch const& after, std::size_t j, Vec2 where)
{
    constexpr int rounds = 8;  // the bulge of a step hardly changes along it
    Vec2 const a = before.point[i], u = before.point[i + 1] - a, c = after.point[j], v = after.point[j + 1] - c;
    double s = (where - a).dot(u) / u.squaredNorm(), t = (where - c).dot(v) / v.squaredNorm();
    for (int round = 0; round < rounds; ++round) {
        Vec2 const from = before.between(i, s) - s * u, to = after.between(j, t) - t * v;
        double const denominator = cross(u, v);
        s = cross(to - from, v) / denominator;
        t = cross(to - from, u) / denominator;
    }
    Vec2 const found = before.between(i, s);
    return found.allFinite() && (found - where).norm() <= u.norm() + v.norm() ? found : where;
}

/// The tangent's normal at the other end of a smooth step along @p chord that has the normal @p n at one.
Vec2 mirrored(Vec2 const& n, Vec2 const& chord)
{
    return n - 2 * n.dot(chord) / chord.squaredNorm() * chord;
}

std::optional<Crossing> crossing_of(std::vector<Vec2> const& bare, std::vector<Vec2> const& moved,
                                    std::vector<Vec2> const& normal, bool normals_left, double distance,
                                    Overlap const& overlap)
{
    std::size_t const end = overlap.first, begin = overlap.last + 1;
    // the branch before, from the overlap outward, and the branch after
    double size = overlap.before + overlap.after;
    for (std::size_t i = end; i < begin; ++i)
        size += (moved[i + 1] - moved[i]).norm();
    constexpr double far = 8;  // an overlap that turns by up to 150 degrees ends nearer than this by its own length
    auto const branch = [&](std::size_t from, int step, Vec2 const& further, Vec2 const& normal_there) {
        Branch result{{further}, {normal_there}};
        for (auto i = static_cast<std::ptrdiff_t>(from); i >= 0 && i < static_cast<std::ptrdiff_t>(moved.size());
             i += step) {
            result.point.push_back(moved[static_cast<std::size_t>(i)]);
            result.normal.push_back(normal[static_cast<std::size_t>(i)]);
            if (result.point.size() > 2 && (result.point.back() - moved[from]).norm() > far * size)
                break;
        }
        return result;
    };
    // the corner of a step is one of its points, and that of both branches: the one whose normal it does not have goes
    // on to it as smoothly as it comes; a bend is carried on straight
    constexpr double corner = 4;
    Vec2 const first = bare[end + 1] - bare[end], last = bare[begin] - bare[begin - 1];
    bool const corner_after = overlap.before > corner * overlap.after,
               corner_before = overlap.after > corner * overlap.before;
    bool const one = end + 1 == begin;
    Vec2 const ends = one && corner_after ? mirrored(normal[end], first) : normal[end],
               begins = one && corner_before ? mirrored(normal[begin], last) : normal[begin];
    Branch const before =
        branch(end, -1,
               one && corner_after ? Vec2(bare[end + 1] + distance * ends)
                                   : Vec2(moved[end] + overlap.before * tangent(normal[end], normals_left)),
               ends);
    Branch const after =
        branch(begin, 1,
               one && corner_before ? Vec2(bare[begin - 1] + distance * begins)
                                    : Vec2(moved[begin] - overlap.after * tangent(normal[begin], normals_left)),
               begins);
    for (std::size_t sum = 0; sum + 3 < before.point.size() + after.point.size(); ++sum)
        for (std::size_t i = 0; i <= sum; ++i)
            if (std::size_t const j = sum - i; i + 1 < before.point.size() && j + 1 < after.point.size())
                if (auto const where =
                        crossing_of_segments(before.point[i], before.point[i + 1], after.point[j], after.point[j + 1]))
                    return Crossing{i, j, as_curves(before, i, after, j, *where)};
    return std::nullopt;
}

}  // namespace

double trim_overlaps(std::vector<Vec2> const& bare, std::vector<Vec2>& moved, std::vector<Vec2>& normal)
{
    double sharpest = 0;
    if (bare.size() < 2)
        return sharpest;
    // the side of the normals does not change along a flank
    double side = 0;
    for (std::size_t i = 0; i + 1 < bare.size(); ++i)
        side += cross(bare[i + 1] - bare[i], normal[i]);
    bool const normals_left = side > 0;
    double const distance = (moved.front() - bare.front()).dot(normal.front());
    for (Overlap const& overlap : overlaps(bare, moved, normal, normals_left)) {
        auto const found = crossing_of(bare, moved, normal, normals_left, distance, overlap);
        if (!found)
            continue;
        std::size_t const first = overlap.first + 1 - found->before,
                          last = overlap.last + found->after;  // points that come together
        Vec2 const before = normal[first - 1], after = normal[last + 1];
        for (std::size_t i = first; i <= last; ++i) {
            moved[i] = found->where;
            normal[i] = i <= overlap.first ? before : after;
        }
        if (last >= first)
            sharpest = std::max(sharpest, std::atan2(std::abs(cross(before, after)), before.dot(after)));
    }
    return sharpest;
}

double overlap_at_ends(FlankGrid const& bare, double distance, std::vector<double> const& clearance)
{
    std::vector<numeric::BetweenPlaces> const between = numeric::between_places(clearance);
    double const least = clearance.empty() ? 0 : std::ranges::min(clearance);
    double left = 0;
    for (std::size_t f = 0; f < 2 && distance != 0; ++f) {
        std::vector<double> turns;
        for (std::size_t k = 0; k < bare.slices(); ++k) {
            auto const& line = bare.line[f].empty() ? bare.point[f][k] : bare.line[f][k];
            std::vector<Vec2> moved = line, normal = bare.line[f].empty() ? bare.normal[f][k] : bare.line_normal[f][k];
            for (std::size_t i = 0; i < moved.size(); ++i)
                moved[i] += distance * normal[i];
            turns.push_back(trim_overlaps(line, moved, normal));
        }
        double const most = std::abs(distance) * (1 - std::cos(std::ranges::max(turns)));
        for (std::size_t k = 1; k < turns.size(); ++k)
            if ((turns[k] == 0) != (turns[k - 1] == 0))
                left = std::max(left, most - std::max(0.0, between.empty() ? 0 : between[k - 1].least - least));
    }
    return left;
}

}  // namespace hdconj::contact
