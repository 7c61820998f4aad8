// SPDX-License-Identifier: GPL-3.0-or-later
// How far an envelope arc runs from a chord between two of its points: estimated from the chord's ends, or looked at
// between them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "hdconj/envelope/envelope.hpp"

namespace hdconj::envelope {

/// The next order of the expansion, so that chord_error() is a bound.
inline constexpr double next_order = 1.02;

/// Largest distance from its chord of the cubic that has the given ends and end normals. For a circular arc this is
/// length times turn over 8. For any smooth curve, inflexions included, it is right to the next order, and 2 per cent
/// are added for that.
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
    return next_order * length * worst;
}

/// Largest distance from the chord first ... last of the curve that is a cubic with their normals between any two
/// neighbours of @p points. The chord's length where that is no graph over the chord.
[[nodiscard]] inline double distance_from_chord(std::span<EnvelopePoint const> points)
{
    Vec2 const origin = points.front().p;
    Vec2 const chord = points.back().p - origin;
    double const length = chord.norm();
    double worst = 0;
    if (length == 0) {
        for (EnvelopePoint const& e : points)
            worst = std::max(worst, (e.p - origin).norm());
        return worst;
    }
    Vec2 const along = chord / length;
    double const side = cross(along, points.front().n);
    double x0 = 0, y0 = 0, m0 = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        Vec2 const from_origin = points[i].p - origin;
        double const x = along.dot(from_origin);
        double const y = cross(along, from_origin);
        double const up = cross(along, points[i].n);
        if (!(up * side > 0) || (i > 0 && !(x > x0)))
            return length;
        double const m = -along.dot(points[i].n) / up;
        if (i > 0) {
            // y0 + c1 s + c2 s^2 + c3 s^3 over s in [0, 1]
            double const width = x - x0;
            double const c1 = width * m0;
            double const c2 = 3 * (y - y0) - width * (2 * m0 + m);
            double const c3 = width * (m0 + m) - 2 * (y - y0);
            double const root = std::sqrt(std::max(0.0, c2 * c2 - 3 * c3 * c1));
            double const w = -(c2 + std::copysign(root, c2));
            for (double const s : {c3 != 0 ? w / (3 * c3) : 0.0, w != 0 ? c1 / w : 0.0})
                if (s > 0 && s < 1)
                    worst = std::max(worst, std::abs(y0 + s * (c1 + s * (c2 + s * c3))));
        }
        worst = std::max(worst, std::abs(y));
        x0 = x;
        y0 = y;
        m0 = m;
    }
    return worst;
}

/// Upper bound of the distance of the arc s -> @p at(s) from its chord over [s0, s1], whose ends are @p a and @p b.
///
/// Cubics go through 2, 4, ... 16 parts. Their error is of fourth order: each halving divides it by sixteen. What is
/// left is therefore below the last change, and below a sixteenth of what was left before. The larger of both is added,
/// since a change may be small by chance. The search ends when it is a per cent.
/// @param first_doubt  relative error of the cubic over the whole chord, at most
template <class At>
[[nodiscard]] double chord_bound(At const& at, double s0, EnvelopePoint const& a, double s1, EnvelopePoint const& b,
                                 double first_doubt, std::size_t& evaluations)
{
    constexpr std::size_t most = 16;
    std::array<EnvelopePoint, most + 1> points;
    points.front() = a;
    points[most] = b;
    std::array<EnvelopePoint, most + 1> used;
    used[0] = a;
    used[1] = b;
    double fine = distance_from_chord(std::span(used).first(2));
    double doubt = first_doubt * fine;
    for (std::size_t parts = 2;; parts *= 2) {
        std::size_t const step = most / parts;
        for (std::size_t i = step; i < most; i += 2 * step) {
            points[i] = at(s0 + (s1 - s0) * (static_cast<double>(i) / most));
            ++evaluations;
        }
        for (std::size_t i = 0; i <= parts; ++i)
            used[i] = points[i * step];
        double const coarse = fine;
        fine = distance_from_chord(std::span(used).first(parts + 1));
        constexpr double order = 16;
        doubt = std::max(std::abs(fine - coarse), doubt / order);
        constexpr double settled = 0.01;
        if (doubt <= settled * fine || parts == most)
            return fine + doubt;
    }
}

/// chord_error() of every chord between neighbouring @p points, bit for bit, many at once, and its bend [1/mm]. The
/// bend is the turn of the normal over the length, and 0 where that is more than a quarter turn or there is no length.
/// Both outputs have one place less than @p points.
void chord_errors(std::span<EnvelopePoint const> points, std::span<double> errors, std::span<double> bends);

/// Errors and bends of chords; blocks of fixed size, whatever the number of threads.
struct ChordLook
{
    std::vector<double> errors;
    std::vector<double> bends;

    void operator()(std::vector<EnvelopePoint> const& points, int threads)
    {
        constexpr std::size_t block = 1024;
        constexpr std::size_t blocks_worth_a_thread = 32;
        std::size_t const count = points.size() - 1;
        errors.resize(count);
        bends.resize(count);
        parallel_for((count + block - 1) / block, threads, blocks_worth_a_thread, [&](std::size_t b) {
            std::size_t const first = b * block;
            std::size_t const size = std::min(block, count - first);
            chord_errors({points.data() + first, size + 1}, {errors.data() + first, size},
                         {bends.data() + first, size});
        });
    }
};

/// Whether chord @p i has neighbours on either side that bend as it does, so that chord_error() is not below its error.
///
/// Let the curvature change by a tenth from chord to chord. What the cubic over one chord leaves out is L^4 y''''/384
/// of L^2 y''/8. That is below half a per cent, a quarter of what chord_error() adds.
[[nodiscard]] inline bool bends_alike(std::span<double const> bends, std::size_t i)
{
    constexpr double alike = 1.1;
    auto const agree = [&](double a, double b) {
        return a * b > 0 && std::abs(a) <= alike * std::abs(b) && std::abs(b) <= alike * std::abs(a);
    };
    return i > 0 && i + 1 < bends.size() && agree(bends[i], bends[i - 1]) && agree(bends[i], bends[i + 1]);
}

/// The error of each chord between neighbouring @p points, at @p stations. Where the neighbours of a chord bend as it
/// does (bends_alike()), it is the estimate from its ends in @p look. Elsewhere its bound takes that place.
template <class At>
void bound_chords(At const& at, std::vector<double> const& stations, std::vector<EnvelopePoint> const& points,
                  ChordLook& look, std::size_t& evaluations)
{
    std::size_t const count = points.size() - 1;
    constexpr std::size_t many = 16;
    double const first_doubt = count < many ? 1 : 0.1;
    for (std::size_t i = 0; i < count; ++i) {
        if (!bends_alike(look.bends, i))
            look.errors[i] =
                chord_bound(at, stations[i], points[i], stations[i + 1], points[i + 1], first_doubt, evaluations);
    }
}

}  // namespace hdconj::envelope
