// SPDX-License-Identifier: GPL-3.0-or-later
// Points along an envelope arc, and what was asked of the chords between them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "hdconj/envelope/chord_bound.hpp"
#include "hdconj/envelope/envelope.hpp"

namespace hdconj::envelope {

/// Points along an arc from u_from to u_to (in either direction), both included, and the chord error reached.
struct SampledArc
{
    std::vector<EnvelopePoint> points;
    double chord = 0;  ///< estimated largest distance of the polygon from the curve [mm]
    double error = 0;  ///< how far a point may be from the true curve by rounding, largest of all: an estimate [mm]
    std::size_t evaluations = 0;
};

/// What is asked of the chords of a sampled arc.
enum class ChordTest
{
    estimate,  ///< from the ends of each chord alone, some per cent low where few chords make an arc: for polygons that
               ///< nothing is promised of
    bound      ///< wherever curvature changes from chord to chord the arc is evaluated between the ends: `chord` is not
               ///< below the true error
};

/// Room in @p column for @p more and for some that are cut out of long chords.
template <class Column>
void make_room(Column& column, std::size_t more)
{
    constexpr std::size_t few = 16;
    if (column.size() + more > column.capacity())
        column.reserve(std::max(column.size() + more + more / few, 2 * column.capacity()));
}

/// Adds to @p result the ends of the chords of @p points that are short enough. The others are cut in halves until they
/// are. @p result holds the first of @p points.
/// @param at      s -> EnvelopePoint
/// @param errors  of the chords between @p stations
template <class At>
void cut_coarse_chords(At const& at, std::span<double const> stations, std::span<EnvelopePoint const> points,
                       std::span<double const> errors, double chord, ChordTest test, SampledArc& result)
{
    constexpr int deepest = 40;
    struct Open
    {
        double s0, s1;
        EnvelopePoint a, b;
        int depth;
        double error;
    };
    auto const error_of = [&](double s0, EnvelopePoint const& a, double s1, EnvelopePoint const& b) {
        constexpr double first_doubt = 1;
        return test == ChordTest::estimate ? chord_error(a, b)
                                           : chord_bound(at, s0, a, s1, b, first_doubt, result.evaluations);
    };
    std::vector<Open> stack;
    std::size_t const chords = points.empty() ? 0 : points.size() - 1;
    for (std::size_t i = 0; i < chords; ++i) {
        std::size_t const first = i;
        for (; i < chords && errors[i] <= chord; ++i)
            result.chord = std::max(result.chord, errors[i]);
        // A run of chords within the bound keeps its points as they are.
        auto const fine = points.subspan(first + 1, i - first);
        result.points.insert(result.points.end(), fine.begin(), fine.end());
        if (i == chords)
            return;
        stack.push_back({stations[i], stations[i + 1], points[i], points[i + 1], 0, errors[i]});
        while (!stack.empty()) {
            Open const now = stack.back();
            stack.pop_back();
            if (now.error > chord && now.depth < deepest && now.s1 > now.s0) {
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

}  // namespace hdconj::envelope
