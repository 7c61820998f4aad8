// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law applied to a Solution: every point of the circular spline's flanks is touched by a
/// tooth (at the distance of the side clearance), and no point of the outline is entered.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "hdconj/solution.hpp"
#include "support/run/full_run.hpp"
#include "touch.hpp"

namespace oracle {

/// The law's own limit [mm].
inline constexpr double touch_limit = 1e-9;

using hdconj::test::full_run;

/// The law holds on pieces made by the tooth: touched, not only not entered.
inline bool must_be_touched(std::string const& kind)
{
    return kind == "flank" || kind == "corner" || kind == "rounding" || kind == "bottom";
}

inline Point<double> point_of(hdconj::Vec2 const& p)
{
    return {p.x(), p.y()};
}

/// The worst point of a law.
struct Worst
{
    double deviation = 0;  ///< [mm], absolute
    double distance = 0;   ///< smallest signed distance there, less the side clearance
    Point<double> point;
    std::string kind;
    std::size_t index = 0, slice = 0;
    std::size_t points = 0;  ///< looked at

    friend std::ostream& operator<<(std::ostream& out, Worst const& worst)
    {
        return out << worst.distance << " mm at outline point " << worst.index << " (" << worst.point.x << ", "
                   << worst.point.y << "), " << worst.kind << "; " << worst.points << " points looked at";
    }
    void take(double deviation_now, double distance_now, Point<double> const& p, std::string const& kind_now,
              std::size_t index_now)
    {
        ++points;
        // A NaN must win, and stay.
        if (deviation_now <= deviation || std::isnan(deviation))
            return;
        deviation = deviation_now;
        distance = distance_now;
        point = p;
        kind = kind_now;
        index = index_now;
    }
};

struct TouchReport
{
    Worst touched;  ///< |smallest distance - clearance| on flanks and corners
    Worst entered;  ///< how deep any point of the outline is entered

    [[nodiscard]] double worst() const { return std::max(touched.deviation, entered.deviation); }
    /// Also false for a NaN.
    [[nodiscard]] bool holds() const { return touched.deviation <= touch_limit && entered.deviation <= touch_limit; }

    friend std::ostream& operator<<(std::ostream& out, TouchReport const& report)
    {
        return out << "touched: " << report.touched << "\nentered: " << report.entered;
    }
};

/// Checks at most @p most points (both ends of every piece first, the rest drawn by @p seed).
inline TouchReport touch_law(hdconj::Solution const& solution, TouchScan& scan, std::size_t most,
                             std::uint64_t seed = 1)
{
    auto const& spline = solution.circular_spline;
    double const clearance = solution.scene.circular_spline.backlash_offset;
    struct Entry
    {
        std::size_t index;
        std::string const* kind;
    };
    std::vector<Entry> ends, inner;
    for (auto const& piece : spline.pieces)
        for (std::size_t i = piece.first; i <= piece.last; ++i)
            (i < piece.first + 2 || i + 2 > piece.last ? ends : inner).push_back({i, &piece.kind});
    std::mt19937_64 engine(seed);
    for (std::size_t i = inner.size(); i > 1; --i)
        std::swap(inner[i - 1], inner[engine() % i]);
    if (ends.size() + inner.size() > most)
        inner.resize(most > ends.size() ? std::min(most - ends.size(), inner.size()) : 0);
    ends.insert(ends.end(), inner.begin(), inner.end());

    TouchReport report;
    for (auto const& entry : ends) {
        auto const p = point_of(spline.outline.at(0).at(entry.index));
        double const distance = scan.nearest(p).distance - clearance;
        if (must_be_touched(*entry.kind))
            report.touched.take(std::abs(distance), distance, p, *entry.kind, entry.index);
        report.entered.take(distance < 0 ? -distance : 0, distance, p, *entry.kind, entry.index);
    }
    return report;
}

}  // namespace oracle
