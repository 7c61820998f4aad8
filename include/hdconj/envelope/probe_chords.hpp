// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The first look at an arc that is to be sampled: how its chords' errors are spread over it.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hdconj/envelope/chord_measure.hpp"
#include "hdconj/envelope/envelope.hpp"

namespace hdconj::envelope {

/// Some twenty points, refined where neighbours turn too much for their chords' errors to be trusted, or lie much
/// farther apart than others.
/// @param at     EnvelopePoint at s in [0, 1]
/// @param chord  chord error wanted of the polygon [mm]
/// @param evaluations  is added to
template <class PointAt>
[[nodiscard]] ChordMeasure probe_chords(PointAt const& at, double chord, std::size_t& evaluations)
{
    constexpr std::size_t first_points = 17;
    constexpr double trusted_turn = 0.06;
    constexpr int deepest = 40;
    struct Station
    {
        double s;
        EnvelopePoint e;
        int depth;
    };
    std::vector<Station> found;
    for (std::size_t i = 0; i < first_points; ++i) {
        double const s = static_cast<double>(i) / (first_points - 1);
        found.push_back({s, at(s), 0});
    }
    double const whole = (found.back().e.p - found.front().e.p).norm();
    for (std::size_t i = 0; i + 1 < found.size();) {
        Station const& a = found[i];
        Station const& b = found[i + 1];
        double const turn = std::abs(std::atan2(cross(a.e.n, b.e.n), a.e.n.dot(b.e.n)));
        double const length = (b.e.p - a.e.p).norm();
        bool const uneven = length > whole / 4 && length > chord;
        if ((turn > trusted_turn || uneven) && chord_error(a.e, b.e) > chord && a.depth < deepest) {
            int const depth = a.depth + 1;
            double const s = 0.5 * (a.s + b.s);
            found[i].depth = depth;
            found.insert(found.begin() + static_cast<std::ptrdiff_t>(i) + 1, {s, at(s), depth});
        } else {
            ++i;
        }
    }
    evaluations += found.size();
    std::vector<double> stations;
    std::vector<double> errors;
    for (std::size_t i = 0; i < found.size(); ++i) {
        stations.push_back(found[i].s);
        if (i > 0)
            errors.push_back(chord_error(found[i - 1].e, found[i].e));
    }
    return {std::move(stations), errors, chord};
}

}  // namespace hdconj::envelope
