// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Samples an envelope arc so that its polygon stays within a chord error, with no more points than that needs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hdconj/envelope/envelope.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj {

/// Points along an arc from u_from to u_to (in either direction), both included, and the chord error reached.
struct SampledArc
{
    std::vector<EnvelopePoint> points;
    double chord = 0;              ///< estimated largest distance of the polygon from the curve [mm]
    double error = 0;              ///< estimated largest rounding error of a point [mm]
    std::size_t evaluations = 0;
};

namespace detail {

/// Largest distance from its chord of the cubic that has the given ends and end normals: for a circular arc length
/// times turn over 8; right to the next order for any smooth curve, inflexions included. Rounded up by 2 per cent for that.
[[nodiscard]] inline double chord_error(EnvelopePoint const& a, EnvelopePoint const& b)
{
    Vec2 const chord = b.p - a.p;
    double const length = chord.norm();
    double const across_a = cross(chord, a.n);
    double const across_b = cross(chord, b.n);
    if (length == 0)
        return 0;
    // normals along the chord: no cubic over the chord has these ends
    if (!(across_a * across_b > 0))
        return length;
    double const m0 = chord.dot(a.n) / across_a;  // slopes against the chord
    double const m1 = chord.dot(b.n) / across_b;
    // y = length (m0 (x - 2 x^2 + x^3) + m1 (x^3 - x^2)); y' = 0 is a quadratic in x
    double const p = 3 * (m0 + m1);
    double const q = -2 * (2 * m0 + m1);
    double const root = std::sqrt(std::max(0.0, q * q - 4 * p * m0));
    double const w = -0.5 * (q + std::copysign(root, q));
    double worst = 0;
    for (double const x : {p != 0 ? w / p : 0.0, w != 0 ? m0 / w : 0.0})
        if (x > 0 && x < 1)
            worst = std::max(worst, std::abs(m0 * x * (1 - x) * (1 - x) - m1 * x * x * (1 - x)));
    // the next order of the expansion, so that the estimate is a bound
    constexpr double next_order = 1.02;
    return next_order * length * worst;
}

}  // namespace detail

/// Points equidistributed in sqrt(turn * length): for a smooth curve each chord then has the same error, which is the fewest
/// points possible up to higher order. Places that a coarse look misjudges are cut again until every chord passes.
///
/// @param from, to  interval of u inside the arc; from > to gives the points in reverse order
/// Accuracy: every point is an exact contact (not interpolated); `chord` is within a few per cent of the true chord error.
template<RelativeMotion Motion>
[[nodiscard]] SampledArc sample_arc(Envelope<Motion> const& envelope, ContactArc const& arc, double from, double to, double chord,
                                    int threads)
{
    SampledArc result;
    // the share of the smooth parameter that [from, to] covers is not needed: a parameter that is smooth at both of its own
    // ends is enough, and it is only at true ends that the arc's speed has a root singularity
    ContactArc window = arc;
    window.u_begin = std::min(from, to);
    window.u_end = std::max(from, to);
    if (window.u_begin != arc.u_begin)
        window.begins = BranchEnd::continues;
    if (window.u_end != arc.u_end)
        window.ends = BranchEnd::continues;
    auto const at = [&](double s) { return envelope.point(arc, arc_parameter_to_u(window, s)); };

    // a coarse look, refined where neighbours turn too much for the measure to be trusted
    constexpr std::size_t first_look = 17;
    constexpr double trusted_turn = 0.06;
    constexpr int deepest = 40;
    struct Station
    {
        double s;
        EnvelopePoint e;
        int depth;
    };
    std::vector<Station> coarse;
    for (std::size_t i = 0; i < first_look; ++i)
    {
        double const s = static_cast<double>(i) / (first_look - 1);
        coarse.push_back({s, at(s), 0});
    }
    double const whole = (coarse.back().e.p - coarse.front().e.p).norm();
    for (std::size_t i = 0; i + 1 < coarse.size();)
    {
        auto const& a = coarse[i];
        auto const& b = coarse[i + 1];
        double const turn = std::abs(std::atan2(cross(a.e.n, b.e.n), a.e.n.dot(b.e.n)));
        double const length = (b.e.p - a.e.p).norm();
        bool const uneven = length > whole / 4 && length > chord;
        if ((turn > trusted_turn || uneven) && detail::chord_error(a.e, b.e) > chord && a.depth < deepest)
        {
            int const depth = a.depth + 1;
            double const s = 0.5 * (a.s + b.s);
            coarse[i].depth = depth;
            coarse.insert(coarse.begin() + static_cast<std::ptrdiff_t>(i) + 1, {s, at(s), depth});
        }
        else
        {
            ++i;
        }
    }
    result.evaluations += coarse.size();

    // cumulative number of chords, then equal shares of it
    std::vector<double> chords(coarse.size(), 0);
    for (std::size_t i = 1; i < coarse.size(); ++i)
        chords[i] = chords[i - 1] + std::sqrt(detail::chord_error(coarse[i - 1].e, coarse[i].e) / chord);
    constexpr double margin = 1.02;
    auto const count = static_cast<std::size_t>(std::max(1.0, std::ceil(margin * chords.back())));
    // density of chords at the coarse stations, so that inside a cell it can vary linearly
    std::vector<double> density(coarse.size());
    for (std::size_t i = 0; i < coarse.size(); ++i)
    {
        std::size_t const low = i == 0 ? 0 : i - 1;
        std::size_t const high = std::min(i + 1, coarse.size() - 1);
        density[i] = (chords[high] - chords[low]) / (coarse[high].s - coarse[low].s);
    }
    std::vector<double> stations(count + 1);
    std::size_t cell = 1;
    for (std::size_t k = 0; k <= count; ++k)
    {
        double const wanted = chords.back() * static_cast<double>(k) / static_cast<double>(count);
        while (cell + 1 < chords.size() && chords[cell] < wanted)
            ++cell;
        double const width = chords[cell] - chords[cell - 1];
        double const filled = width > 0 ? std::clamp((wanted - chords[cell - 1]) / width, 0.0, 1.0) : 0.0;
        double const r0 = density[cell - 1];
        double const r1 = density[cell];
        double const half_full = filled * 0.5 * (r0 + r1);
        double const below = r0 + std::sqrt(std::max(0.0, r0 * r0 + 2 * (r1 - r0) * half_full));
        double const share = below > 0 ? std::clamp(2 * half_full / below, 0.0, 1.0) : filled;
        stations[k] = coarse[cell - 1].s + share * (coarse[cell].s - coarse[cell - 1].s);
    }
    stations.front() = 0;
    stations.back() = 1;
    std::vector<EnvelopePoint> points(stations.size());
    constexpr std::size_t grain = 8192;
    parallel_for(points.size(), threads, grain, [&](std::size_t i) { points[i] = at(stations[i]); });
    result.evaluations += points.size();

    // cut again what is still too coarse
    result.points.push_back(points.front());
    struct Open
    {
        double s0, s1;
        EnvelopePoint a, b;
        int depth;
    };
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
        std::vector<Open> stack{{stations[i], stations[i + 1], points[i], points[i + 1], 0}};
        while (!stack.empty())
        {
            Open const now = stack.back();
            stack.pop_back();
            double const error = detail::chord_error(now.a, now.b);
            if (error > chord && now.depth < deepest && now.s1 > now.s0)
            {
                double const s = 0.5 * (now.s0 + now.s1);
                EnvelopePoint const middle = at(s);
                ++result.evaluations;
                stack.push_back({s, now.s1, middle, now.b, now.depth + 1});
                stack.push_back({now.s0, s, now.a, middle, now.depth + 1});
                continue;
            }
            result.chord = std::max(result.chord, error);
            result.points.push_back(now.b);
        }
    }
    for (EnvelopePoint const& e : result.points)
        result.error = std::max(result.error, e.error);
    if (from > to)
        std::reverse(result.points.begin(), result.points.end());
    return result;
}

}  // namespace hdconj
