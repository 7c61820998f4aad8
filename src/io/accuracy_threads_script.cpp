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

/// Lines of a part: whiskers first, since gnuplot keeps the place of their point white.
std::string plot_of(Part const& part)
{
    // Lines that would hide each other stand a little apart.
    constexpr double apart = 1.012;
    constexpr auto next = ", \\\n    ";
    std::string plot, data;
    double shift = 1;
    for (std::size_t i = 0; i < part.curves.size(); ++i) {
        auto const& curve = part.curves[i];
        std::string const block = (curve.sample ? "$sample" : "$drive") + std::to_string(i);
        data += block + " << END\n";
        for (auto const* rung : curve.rungs) {
            data += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", rung->value * shift, rung->median * ms, rung->least * ms, rung->most * ms);
        }
        data += "END\n";
        auto const& first = *curve.rungs.front();
        plot += fmt::format("{}{:.8g} / x with lines linecolor rgb '{}' linewidth 0.9 dashtype (2,4) notitle", plot.empty() ? "plot " : next, first.value * first.median * ms, curve.colour);
        plot += fmt::format("{}{} using 1:2:3:4 with yerrorbars linecolor rgb '{}' linewidth 0.7 pointtype -1 notitle", next, block, curve.colour);
        plot += fmt::format("{}{} using 1:2 with linespoints {} pointtype 7 pointsize 0.7 notitle", next, block, look(curve));
        shift *= apart;
    }
    return data + plot + "\n";
}

}  // namespace

std::string time_on_threads(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format)
{
    auto const curves = curves_of(ladders, name);
    double low = std::numeric_limits<double>::infinity(), high = 0, most = 1;
    for (auto const& curve : curves) {
        for (auto const* rung : curve.rungs) {
            low = std::min(low, rung->least * ms);
            high = std::max(high, rung->most * ms);
            most = std::max(most, rung->value);
        }
    }
    std::string tics;
    for (double threads = 1; threads <= most; threads *= 2) {
        tics += fmt::format("{}'{:.0f}' {:.0f}", tics.empty() ? "" : ", ", threads, threads);
    }
    auto const parts = parts_of(curves, study.report.scene.drive.name);
    Legend const legend(curves, gain_of);
    double const height = legend.height_below(parts.front().panel);
    constexpr double room = 1.15;
    std::string script = frame(study, name, "dotted: time of one thread over their number", legend.text(parts.front().panel, height), height, format) +
                         fmt::format("set xrange [{:.8g}:{:.8g}]\nset xtics ({})\nset yrange [{:.8g}:{:.8g}]\nset format y '%.3g'\n"
                                     "set ytics (1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 40, 50, 60, 80, 100, 150, 200, 300, 500, 1000)\n"
                                     "set xlabel 'threads' noenhanced\nset ylabel 'time [ms], median; whiskers: least and most' noenhanced\n",
                                     1 / room, most * room, tics, low / room, high * room);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        script += axes_of(parts[i], i, height) + plot_of(parts[i]);
    }
    return script + "unset multiplot\n";
}

}  // namespace hdconj::study_picture
