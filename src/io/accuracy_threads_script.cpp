// SPDX-License-Identifier: GPL-3.0-or-later
// Time against threads, log-log: one line per method, what time over threads would be as dotted lines, least and most time as whiskers.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "accuracy_curves.hpp"

namespace hdconj::study_picture {
namespace {

constexpr double ms = 1e3;

/// "1.83 times on 2 threads", or empty, also where the times are of single runs.
std::string gain_of(Curve const& curve)
{
    auto const &first = *curve.rungs.front(), &last = *curve.rungs.back();
    return last.value > first.value && first.runs > 1 && last.runs > 1 ? fmt::format("{:.2f} times on {:.0f} threads", first.median / last.median, last.value) : "";
}

}  // namespace

std::string time_on_threads(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format)
{
    auto const curves = curves_of(ladders, name);
    double const height = height_of(curves.size());
    double low = std::numeric_limits<double>::infinity(), high = 0, most = 1;
    std::string plot, data, legends, tics;
    // Lines that would hide each other stand a little apart.
    constexpr double apart = 1.012;
    double shift = 1;
    constexpr auto next = ", \\\n    ";
    for (std::size_t i = 0; i < curves.size(); ++i) {
        auto const& curve = curves[i];
        std::string rows;
        for (auto const* rung : curve.rungs) {
            low = std::min(low, rung->least * ms);
            high = std::max(high, rung->most * ms);
            most = std::max(most, rung->value);
            rows += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", rung->value * shift, rung->median * ms, rung->least * ms, rung->most * ms);
        }
        data += fmt::format("$curve{} << END\n{}END\n", i, rows);
        // Whiskers first: gnuplot keeps the place of their point white.
        auto const& first = *curve.rungs.front();
        plot += fmt::format("{}{:.8g} / x with lines linecolor rgb '{}' linewidth 0.9 dashtype (2,4) notitle", plot.empty() ? "plot " : next, first.value * first.median * ms, curve.colour);
        plot += fmt::format("{}$curve{} using 1:2:3:4 with yerrorbars linecolor rgb '{}' linewidth 0.7 pointtype -1 notitle", next, i, curve.colour);
        plot += fmt::format("{}$curve{} using 1:2 with linespoints {} pointtype {} pointsize 0.7 notitle", next, i, look(curve), curve.sample ? 6 : 7);
        legends += legend(curve, i, gain_of(curve), height);
        shift *= apart;
    }
    for (double threads = 1; threads <= most; threads *= 2) {
        tics += fmt::format("{}'{:.0f}' {:.0f}", tics.empty() ? "" : ", ", threads, threads);
    }
    constexpr double room = 1.15;
    return frame(study, name, "dotted: time of one thread over their number", height, format) + data +
           fmt::format("set xrange [{:.8g}:{:.8g}]\nset xtics ({})\nset yrange [{:.8g}:{:.8g}]\nset format y '%.3g'\n"
                       "set ytics (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 500, 1000)\n"
                       "set xlabel 'threads' noenhanced\nset ylabel 'time [ms], median; whiskers: least and most' noenhanced\n",
                       1 / room, most * room, tics, low / room, high * room) +
           legends + plot + "\n";
}

}  // namespace hdconj::study_picture
