// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Samples an envelope arc so that its polygon stays within a chord error, with no more points than that needs.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hdconj/envelope/chord_bound.hpp"
#include "hdconj/envelope/contact_batch.hpp"
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

/// What is asked of the chords of a sampled arc.
enum class ChordTest
{
    estimate,  ///< from the ends of each chord alone, some per cent low where few chords make an arc: for polygons that nothing is promised of
    bound      ///< wherever curvature changes from chord to chord the arc is looked at between the ends: `chord` is not below the true error
};

namespace detail {

/// Points of the chords of @p points that are short enough, and of the others cut in halves until they are, into @p result.
/// @param at      s -> EnvelopePoint
/// @param errors  of the chords between @p stations
template<class At>
void cut_coarse_chords(At const& at, std::vector<double> const& stations, std::vector<EnvelopePoint> const& points, std::vector<double> const& errors, double chord,
                       ChordTest test, SampledArc& result)
{
    constexpr int deepest = 40;
    constexpr std::size_t few = 16;
    result.points.reserve(points.size() + points.size() / few);
    result.points.push_back(points.front());
    struct Open
    {
        double s0, s1;
        EnvelopePoint a, b;
        int depth;
        double error;
    };
    auto const error_of = [&](double s0, EnvelopePoint const& a, double s1, EnvelopePoint const& b) {
        constexpr double first_doubt = 1;
        return test == ChordTest::estimate ? chord_error(a, b) : chord_bound(at, s0, a, s1, b, first_doubt, result.evaluations);
    };
    std::vector<Open> stack;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
        double const first = errors[i];
        if (first <= chord)
        {
            result.chord = std::max(result.chord, first);
            result.points.push_back(points[i + 1]);
            continue;
        }
        stack.push_back({stations[i], stations[i + 1], points[i], points[i + 1], 0, first});
        while (!stack.empty())
        {
            Open const now = stack.back();
            stack.pop_back();
            if (now.error > chord && now.depth < deepest && now.s1 > now.s0)
            {
                double const s = 0.5 * (now.s0 + now.s1);
                EnvelopePoint const middle = at(s);
                ++result.evaluations;
                stack.push_back({s, now.s1, middle, now.b, now.depth + 1, error_of(s, middle, now.s1, now.b)});
                stack.push_back({now.s0, s, now.a, middle, now.depth + 1, error_of(now.s0, now.a, s, middle)});
                continue;
            }
            result.chord = std::max(result.chord, now.error);
            result.points.push_back(now.b);
        }
    }
}

}  // namespace detail

/// Points equidistributed in sqrt(turn * length): for a smooth curve each chord then has the same error, which is the fewest
/// points possible up to higher order. Places that a coarse look misjudges are cut again until every chord passes.
///
/// @param from, to  interval of u inside the arc; from > to gives the points in reverse order
/// Accuracy: every point is an exact contact (not interpolated); `chord` is within a few per cent of the true chord error, and by default not below it.
template<RelativeMotion Motion>
[[nodiscard]] SampledArc sample_arc(Envelope<Motion> const& envelope, ContactArc const& arc, double from, double to, double chord,
                                    int threads, ChordTest test = ChordTest::bound)
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
    auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(margin * chords.back())));
    // density of chords at the coarse stations, so that inside a cell it can vary linearly
    std::vector<double> density(coarse.size());
    for (std::size_t i = 0; i < coarse.size(); ++i)
    {
        std::size_t const low = i == 0 ? 0 : i - 1;
        std::size_t const high = std::min(i + 1, coarse.size() - 1);
        density[i] = (chords[high] - chords[low]) / (coarse[high].s - coarse[low].s);
    }
    std::vector<double> stations;
    std::vector<EnvelopePoint> points;
    std::optional<ContactBatch> const batch = contact_batch(envelope, arc);
    auto const place = [&] {
        stations.resize(count + 1);
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
        points.resize(stations.size());
        // blocks of fixed size; with a batch no point depends on its block
        constexpr std::size_t block = 256;
        std::size_t const blocks_worth_a_thread = batch ? 128 : 32;
        parallel_for((points.size() + block - 1) / block, threads, blocks_worth_a_thread, [&](std::size_t b) {
            std::size_t const first = b * block;
            std::size_t const end = std::min(points.size(), first + block);
            if (!batch)
            {
                for (std::size_t i = first; i < end; ++i)
                    points[i] = at(stations[i]);
                return;
            }
            std::array<double, block> u;
            for (std::size_t i = first; i < end; ++i)
                u[i - first] = arc_parameter_to_u(window, stations[i]);
            point_batch(envelope, arc, *batch, std::span(u).first(end - first), std::span(points).subspan(first, end - first));
        });
        result.evaluations += points.size();
    };
    detail::ChordLook look;
    std::vector<double> const& errors = look.errors;
    constexpr int attempts = 4;
    for (int attempt = 1;; ++attempt)
    {
        place();
        look(points, threads);
        if (test == ChordTest::estimate)
            break;
        detail::bound_chords(at, stations, points, look, result.evaluations);
        // where many chords are a little too coarse, a few more over the whole arc are fewer than a cut in each
        double const worst = *std::max_element(errors.begin(), errors.end());
        auto const failing = static_cast<std::size_t>(std::count_if(errors.begin(), errors.end(), [&](double error) { return error > chord; }));
        double const grown = std::max(static_cast<double>(count + 1), std::ceil(static_cast<double>(count) * std::sqrt(worst / chord)));
        if (failing == 0 || attempt == attempts || !(grown < static_cast<double>(count + failing)))
            break;
        count = static_cast<std::size_t>(grown);
    }

    double const worst = *std::max_element(errors.begin(), errors.end());
    if (worst <= chord)
    {
        result.chord = worst;
        result.points = std::move(points);
    }
    else
    {
        detail::cut_coarse_chords(at, stations, points, errors, chord, test, result);
    }
    for (EnvelopePoint const& e : result.points)
        result.error = std::max(result.error, e.error);
    if (from > to)
        std::reverse(result.points.begin(), result.points.end());
    return result;
}

}  // namespace hdconj
