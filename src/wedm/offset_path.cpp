// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "hdconj/base/stop.hpp"
#include "lean.hpp"
#include "region/segment_tree.hpp"

namespace hdconj::wedm {
namespace {

/// A vertex of one face as the wire's ellipse there makes it a circle: normals of its two edges towards the void, and
/// the angle between them, positive to the left.
struct Vertex
{
    Lean lean;
    Vec2 before = Vec2::Zero();
    Vec2 after = Vec2::Zero();
    double turn = 0;
};

Vertex vertex(std::vector<Vec2> const& points, std::size_t i, Lean const& lean)
{
    Vec2 const before = lean.cast(left_of(points[i] - points[i - 1])).normalized();
    Vec2 const after = lean.cast(left_of(points[i + 1] - points[i])).normalized();
    return {lean, before, after, std::atan2(cross(before, after), before.dot(after))};
}

Vec2 turned(Vec2 const& v, double angle)
{
    return std::cos(angle) * v + std::sin(angle) * left_of(v);
}

/// Chords of at most @p sagitta that the wire takes around a vertex; 1: the parallels of its edges meet in a point.
int chords_around(Vertex const& v, double offset, double sagitta)
{
    double const step = 2 * std::acos(1 - std::min(0.5, sagitta / (offset * v.lean.secant())));
    return std::max(1, static_cast<int>(std::ceil(std::abs(v.turn) / step)));
}

/// Points that vertex @p v at @p p becomes: where the parallels of its edges meet as often as the other face has
/// points, or a fan of @p chords chords.
void add_fan(std::vector<Vec2>& out, Vec2 const& p, Vertex const& v, double offset, int chords, bool round)
{
    for (int i = 0; i <= (chords > 1 ? chords : 0); ++i)
        out.push_back(p + v.lean.cast(round ? Vec2(offset * turned(v.before, v.turn * i / chords))
                                            : Vec2(offset / (1 + v.before.dot(v.after)) * (v.before + v.after))));
}

/// One point as often as the other face has points: they are spread over the halves of the edges beside it, so that the
/// wire moves in both faces.
void spread(std::vector<Vec2>& points, std::size_t first, std::size_t last)
{
    if (first == 0 || last + 1 >= points.size())
        return;
    Vec2 const at = points[first], before = points[first - 1], behind = points[last + 1];
    std::size_t const middle = (first + last) / 2;
    for (std::size_t i = first; i <= last; ++i) {
        double const share =
            0.5 * (i < middle ? static_cast<double>(middle - i) / static_cast<double>(middle - first + 1)
                              : static_cast<double>(i - middle) / static_cast<double>(last - middle + 1));
        points[i] = at + share * ((i < middle ? before : behind) - at);
    }
}

/// Where the parallel leaves a loop out: from parameter `from` to `to`, vertex number plus share of the edge behind it.
struct Jump
{
    double from = 0;
    double to = 0;
    Vec2 at = Vec2::Zero();
};

/// Share of a b and of c d at which they cross; ends counted at one side only.
std::optional<std::pair<double, double>> crossing(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    Vec2 const r = b - a;
    Vec2 const s = d - c;
    double const area = cross(r, s);
    if (area == 0)
        return std::nullopt;
    double const t = cross(c - a, s) / area;
    double const u = cross(c - a, r) / area;
    bool const inside = t >= 0 && t < 1 && u >= 0 && u < 1;
    return inside ? std::optional(std::pair(t, u)) : std::nullopt;
}

std::vector<Jump> loops(std::vector<Vec2> const& c)
{
    region::SegmentTree const path(c);
    std::vector<Jump> found;
    double done = 0;  // parameter up to which the path is settled
    for (std::size_t i = 0; i + 1 < c.size();) {
        end_if_stopped();
        std::optional<Jump> first;
        for (std::size_t const j : path.near(i)) {
            if (j < i + 2)
                continue;
            auto const shares = crossing(c[i], c[i + 1], c[j], c[j + 1]);
            double const from = shares ? static_cast<double>(i) + shares->first : 0;
            if (shares && from >= done && (!first || from <= first->from))
                first = Jump{from, static_cast<double>(j) + shares->second, c[i] + shares->first * (c[i + 1] - c[i])};
        }
        if (!first) {
            ++i;
            continue;
        }
        found.push_back(*first);
        done = first->to;
        i = static_cast<std::size_t>(first->to);
    }
    return found;
}

/// A stretch that is removed in both faces, and what each face itself would remove there, in order.
struct Cut
{
    double from = 0, to = 0;
    std::vector<Jump> own[2];

    void unite(std::size_t face, Jump const& jump)
    {
        from = std::min(from, jump.from);
        to = std::max(to, jump.to);
        own[face].push_back(jump);
    }
};

std::vector<Cut> common_cuts(std::vector<Jump> const& lower, std::vector<Jump> const& upper)
{
    std::vector<std::pair<std::size_t, Jump>> all;
    for (Jump const& jump : lower)
        all.emplace_back(0, jump);
    for (Jump const& jump : upper)
        all.emplace_back(1, jump);
    std::ranges::stable_sort(all, {}, [](auto const& each) { return each.second.from; });
    std::vector<Cut> cuts;
    for (auto const& [face, jump] : all) {
        if (cuts.empty() || cuts.back().to < jump.from)
            cuts.push_back({jump.from, jump.to, {}});
        cuts.back().unite(face, jump);
    }
    return cuts;
}

/// Appends the vertices of @p c from index @p first to before @p last.
void append(std::vector<Vec2>& to, std::vector<Vec2> const& c, std::size_t first, std::size_t last)
{
    if (first < last)
        to.insert(to.end(), c.begin() + static_cast<std::ptrdiff_t>(first),
                  c.begin() + static_cast<std::ptrdiff_t>(last));
}

/// What a face keeps between two points that both faces have.
struct Between
{
    Vec2 first, last;          ///< the two
    std::vector<Vec2> points;  ///< on its exact line

    /// Where the share @p part / @p of of the way lies, its points being at even shares: one of them, or a point on the
    /// straight step between two.
    [[nodiscard]] Vec2 at(std::size_t part, std::size_t of) const
    {
        std::size_t const steps = points.size() + 1;
        std::size_t const step = part * steps / of;
        Vec2 const& a = step == 0 ? first : points[step - 1];
        if (part * steps == step * of)
            return a;
        Vec2 const& b = step == points.size() ? last : points[step];
        return a + static_cast<double>(part * steps - step * of) / static_cast<double>(of) * (b - a);
    }
};

/// Adds the points of both faces between their common ends, each with a partner in the other face.
template <class Add>
void add_pairs(Between const& low, Between const& up, Add const& add)
{
    std::size_t const n = low.points.size() + 1, m = up.points.size() + 1;
    for (std::size_t i = 1, k = 1; i < n || k < m;) {
        bool const by_low = i * m <= k * n, by_up = k * n <= i * m;
        std::size_t const part = by_low ? i : k, of = by_low ? n : m;
        add(low.at(part, of), up.at(part, of));
        i += by_low ? 1 : 0;
        k += by_up ? 1 : 0;
    }
}

/// The point at parameter @p at.
Vec2 at_parameter(std::vector<Vec2> const& c, double at)
{
    auto const i = std::min(static_cast<std::size_t>(at), c.size() - 2);
    return c[i] + (at - static_cast<double>(i)) * (c[i + 1] - c[i]);
}

}  // namespace

TrimmedPath without_loops(PairedPath const& c)
{
    std::vector<Vec2> const* const faces[2] = {&c.lower, &c.upper};
    TrimmedPath trimmed;
    auto const add = [&](Vec2 const& low, Vec2 const& up, double at) {
        trimmed.path.add(low, up);
        trimmed.at.push_back(at);
    };
    std::size_t next = 0;
    for (Cut const& cut : common_cuts(loops(c.lower), loops(c.upper))) {
        // a vertex that is the point of crossing is not repeated
        auto const before = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(cut.from)));
        auto const behind = std::min(static_cast<std::size_t>(cut.to) + 1, c.size() - 1);
        for (; next < before; ++next)
            add(c.lower[next], c.upper[next], static_cast<double>(next));
        Between lead[2], trail[2];
        for (std::size_t f = 0; f < 2; ++f) {
            std::vector<Vec2> const& face = *faces[f];
            std::vector<Jump> jumps = cut.own[f];
            double const middle = 0.5 * (cut.from + cut.to);
            // a face without a loop keeps the whole of its parallel
            if (jumps.empty())
                jumps.push_back({middle, middle, at_parameter(face, middle)});
            // of several loops in place of one of the other face's, the one in the middle is matched with it
            std::size_t const matched = jumps.size() / 2;
            std::size_t vertex = before;
            for (std::size_t i = 0; i < jumps.size(); ++i) {
                std::vector<Vec2>& kept = i <= matched ? lead[f].points : trail[f].points;
                append(kept, face, vertex, static_cast<std::size_t>(std::ceil(jumps[i].from)));
                if (i != matched)
                    kept.push_back(jumps[i].at);
                vertex = static_cast<std::size_t>(jumps[i].to) + 1;
            }
            append(trail[f].points, face, vertex, behind);
            lead[f].first = face[before - 1];
            lead[f].last = trail[f].first = jumps[matched].at;
            trail[f].last = face[behind];
        }
        auto const pair = [&](Vec2 const& low, Vec2 const& up) { add(low, up, -1); };
        add_pairs(lead[0], lead[1], pair);
        pair(lead[0].last, lead[1].last);
        add_pairs(trail[0], trail[1], pair);
        next = behind;
    }
    for (; next < c.size(); ++next)
        add(c.lower[next], c.upper[next], static_cast<double>(next));
    return trimmed;
}

PairedPath offset_path(PairedPath const& nominal, double offset, double sagitta, double height)
{
    PairedPath parallel;
    std::vector<std::tuple<std::vector<Vec2>*, std::size_t, std::size_t>> repeated;  // face, first, last
    for (std::size_t i = 1; i + 1 < nominal.size(); ++i) {
        Lean const lean(nominal.lower[i], nominal.upper[i], height);
        Vertex const low = vertex(nominal.lower, i, lean), up = vertex(nominal.upper, i, lean);
        int const of_low = chords_around(low, offset, sagitta), of_up = chords_around(up, offset, sagitta);
        int const chords = std::max(of_low, of_up);
        std::size_t const first = parallel.size();
        add_fan(parallel.lower, nominal.lower[i], low, offset, chords, of_low > 1);
        add_fan(parallel.upper, nominal.upper[i], up, offset, chords, of_up > 1);
        if (of_low == 1 && chords > 1)
            repeated.emplace_back(&parallel.lower, first, parallel.size() - 1);
        if (of_up == 1 && chords > 1)
            repeated.emplace_back(&parallel.upper, first, parallel.size() - 1);
    }
    for (auto const& [face, first, last] : repeated)
        spread(*face, first, last);
    return without_loops(parallel).path;
}

}  // namespace hdconj::wedm
