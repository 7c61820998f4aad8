// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wedm/offset_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hdconj {
namespace {

/// A vertex of one face: normals of its two edges towards the void, and the angle between them, positive to the left.
struct Vertex
{
    Vec2 before = Vec2::Zero();
    Vec2 after = Vec2::Zero();
    double turn = 0;
};

Vertex vertex(std::vector<Vec2> const& points, std::size_t i)
{
    Vec2 const before = left_of((points[i] - points[i - 1]).normalized());
    Vec2 const after = left_of((points[i + 1] - points[i]).normalized());
    return {before, after, std::atan2(cross(before, after), before.dot(after))};
}

Vec2 turned(Vec2 const& v, double angle)
{
    return std::cos(angle) * v + std::sin(angle) * left_of(v);
}

/// Points that vertex @p v at @p p becomes: where the parallels of its edges meet, or a fan of @p chords chords.
void add_fan(std::vector<Vec2>& out, Vec2 const& p, Vertex const& v, double offset, int chords)
{
    if (chords <= 1)
    {
        out.push_back(p + offset / (1 + v.before.dot(v.after)) * (v.before + v.after));
        return;
    }
    for (int i = 0; i <= chords; ++i)
        out.push_back(p + offset * turned(v.before, v.turn * i / chords));
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

/// Axis-parallel box of an edge.
struct Box
{
    Vec2 low, high;
    Box(Vec2 const& a, Vec2 const& b) : low(a.cwiseMin(b)), high(a.cwiseMax(b)) {}
    [[nodiscard]] bool meets(Box const& o) const { return (low.array() <= o.high.array()).all() && (o.low.array() <= high.array()).all(); }
};

std::vector<Jump> loops(std::vector<Vec2> const& c)
{
    std::vector<Box> boxes;
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
        boxes.emplace_back(c[i], c[i + 1]);
    std::vector<Jump> found;
    double done = 0;  // parameter up to which the path is settled
    for (std::size_t i = 0; i < boxes.size();)
    {
        std::optional<Jump> first;
        for (std::size_t j = i + 2; j < boxes.size(); ++j)
        {
            if (!boxes[i].meets(boxes[j]))
                continue;
            auto const shares = crossing(c[i], c[i + 1], c[j], c[j + 1]);
            double const from = shares ? static_cast<double>(i) + shares->first : 0;
            if (shares && from >= done && (!first || from <= first->from))
                first = Jump{from, static_cast<double>(j) + shares->second, c[i] + shares->first * (c[i + 1] - c[i])};
        }
        if (!first)
        {
            ++i;
            continue;
        }
        found.push_back(*first);
        done = first->to;
        i = static_cast<std::size_t>(first->to);
    }
    return found;
}

/// A stretch that is removed in both faces, and what each face itself would remove there.
struct Cut
{
    double from = 0, to = 0;
    std::optional<Jump> own[2];

    void unite(std::size_t face, Jump const& jump)
    {
        from = std::min(from, jump.from);
        to = std::max(to, jump.to);
        if (own[face])
            own[face]->to = std::max(own[face]->to, jump.to);
        else
            own[face] = jump;
    }
};

std::vector<Cut> common_cuts(std::vector<Jump> const& lower, std::vector<Jump> const& upper)
{
    std::vector<std::pair<std::size_t, Jump>> all;
    for (Jump const& jump : lower)
        all.emplace_back(0, jump);
    for (Jump const& jump : upper)
        all.emplace_back(1, jump);
    std::stable_sort(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.second.from < b.second.from; });
    std::vector<Cut> cuts;
    for (auto const& [face, jump] : all)
    {
        if (cuts.empty() || cuts.back().to < jump.from)
            cuts.push_back({jump.from, jump.to, {}});
        cuts.back().unite(face, jump);
    }
    return cuts;
}

/// Vertices of @p c from index @p first to before @p last.
std::vector<Vec2> stretch(std::vector<Vec2> const& c, std::size_t first, std::size_t last)
{
    return first < last ? std::vector<Vec2>(c.begin() + static_cast<std::ptrdiff_t>(first), c.begin() + static_cast<std::ptrdiff_t>(last)) : std::vector<Vec2>{};
}

/// As many points as @p count on the straight way from @p a to @p b, ends excluded, where there are none.
void fill(std::vector<Vec2>& points, std::size_t count, Vec2 const& a, Vec2 const& b)
{
    if (!points.empty())
        return;
    for (std::size_t i = 1; i <= count; ++i)
        points.push_back(a + static_cast<double>(i) / static_cast<double>(count + 1) * (b - a));
}

/// The point at parameter @p at.
Vec2 point_at(std::vector<Vec2> const& c, double at)
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
    for (Cut const& cut : common_cuts(loops(c.lower), loops(c.upper)))
    {
        // a vertex that is the point of crossing is not repeated
        auto const before = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(cut.from)));
        auto const behind = std::min(static_cast<std::size_t>(cut.to) + 1, c.size() - 1);
        for (; next < before; ++next)
            add(c.lower[next], c.upper[next], static_cast<double>(next));
        std::vector<Vec2> lead[2];
        std::vector<Vec2> trail[2];
        Jump own[2];
        for (std::size_t f = 0; f < 2; ++f)
        {
            double const middle = 0.5 * (cut.from + cut.to);
            // a face without a loop keeps the whole of its parallel
            own[f] = cut.own[f].value_or(Jump{middle, middle, point_at(*faces[f], middle)});
            lead[f] = stretch(*faces[f], before, static_cast<std::size_t>(std::ceil(own[f].from)));
            trail[f] = stretch(*faces[f], static_cast<std::size_t>(own[f].to) + 1, behind);
        }
        std::size_t const leads = std::max(lead[0].size(), lead[1].size());
        std::size_t const trails = std::max(trail[0].size(), trail[1].size());
        for (std::size_t f = 0; f < 2; ++f)
        {
            fill(lead[f], leads, (*faces[f])[before - 1], own[f].at);
            fill(trail[f], trails, own[f].at, (*faces[f])[behind]);
        }
        for (std::size_t i = 0; i < leads; ++i)
            add(lead[0][i], lead[1][i], -1);
        add(own[0].at, own[1].at, -1);
        for (std::size_t i = 0; i < trails; ++i)
            add(trail[0][i], trail[1][i], -1);
        next = behind;
    }
    for (; next < c.size(); ++next)
        add(c.lower[next], c.upper[next], static_cast<double>(next));
    return trimmed;
}

PairedPath offset_path(PairedPath const& nominal, double offset, double sagitta)
{
    double const step = 2 * std::acos(1 - std::min(0.5, sagitta / offset));
    PairedPath parallel;
    for (std::size_t i = 1; i + 1 < nominal.size(); ++i)
    {
        Vertex const low = vertex(nominal.lower, i);
        Vertex const up = vertex(nominal.upper, i);
        double const turn = std::max(std::abs(low.turn), std::abs(up.turn));
        auto const chords = static_cast<int>(std::ceil(turn / step));
        add_fan(parallel.lower, nominal.lower[i], low, offset, chords);
        add_fan(parallel.upper, nominal.upper[i], up, offset, chords);
    }
    return without_loops(parallel).path;
}

}  // namespace hdconj
