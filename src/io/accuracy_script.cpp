// SPDX-License-Identifier: GPL-3.0-or-later
// Error against time, log-log: one line per method, floors as dashed lines, least and most time as whiskers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy_curves.hpp"
#include "picture_lines.hpp"

namespace hdconj {
namespace {

using study_picture::Curve;

struct Range
{
    double low = std::numeric_limits<double>::infinity(), high = 0;

    void take(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    /// Whole decades around what was taken.
    void widen()
    {
        constexpr double room = 1.25;
        low = std::pow(10.0, std::floor(std::log10(low / room)));
        high = std::pow(10.0, std::ceil(std::log10(high * room)));
    }
};

/// The knob's value beside the first and the last rung.
std::string ends_of(Curve const& curve, double middle)
{
    std::string labels;
    auto const add = [&](StudyRung const& rung, double rise) {
        bool const right = rung.median > middle;
        labels += fmt::format("set label {} at first {:.8g}, first {:.8g} {} offset {},{} noenhanced textcolor rgb '{}' front boxed\n", gnuplot_quoted(knob_text(rung.value)),
                              rung.median, rung.error, right ? "right" : "left", right ? -0.6 : 0.6, rise, curve.colour);
    };
    add(*curve.rungs.front(), 0.8);
    if (curve.rungs.size() > 1) {
        add(*curve.rungs.back(), -0.8);
    }
    return labels;
}

/// All its lines have the same error: what they differ in is time.
bool is_of_threads(std::vector<Curve> const& curves)
{
    return !curves.empty() && curves.front().ladder->knob == "solver.threads";
}

}  // namespace

std::string picture_words(std::vector<StudyLadder> const& ladders, std::string const& name)
{
    return is_of_threads(study_picture::curves_of(ladders, name)) ? "time against threads" : "error against time";
}

bool has_picture(std::vector<StudyLadder> const& ladders, std::string const& name)
{
    std::size_t points = 0;
    for (auto const& curve : study_picture::curves_of(ladders, name)) {
        points += curve.rungs.size();
    }
    return points > 1;
}

std::string accuracy_script(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format)
{
    auto const curves = study_picture::curves_of(ladders, name);
    if (is_of_threads(curves)) {
        return study_picture::time_on_threads(study, ladders, name, format);
    }
    double const height = study_picture::height_of(curves.size());
    Range time, error;
    for (auto const& curve : curves) {
        for (auto const* rung : curve.rungs) {
            time.take(rung->least);
            time.take(rung->most);
            error.take(rung->error);
        }
    }
    constexpr double room = 1.6;
    time.low /= room;
    time.high *= room;
    error.widen();
    std::string const& unit = curves.front().ladder->unit;
    std::string script = study_picture::frame(study, name, "at the ends of a line its first and last setting", height, format);
    script += fmt::format(
        "set xrange [{:.8g}:{:.8g}]\nset yrange [{:.8g}:{:.8g}]\nset format xy '10^{{%L}}'\n"
        "set xlabel 'time [s], median; whiskers: least and most' noenhanced\n"
        "set ylabel 'error against the reference [{}]' noenhanced\n",
        time.low, time.high, error.low, error.high, unit == "mm^2" ? "mm²" : unit);
    script += "set style textbox opaque noborder fillcolor rgb '#ffffff' margins 0.2,0.2\n";
    double const middle = std::sqrt(time.low * time.high);
    std::string plot;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        auto const& curve = curves[i];
        std::string rows;
        for (auto const* rung : curve.rungs) {
            rows += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", rung->median, rung->error, rung->least, rung->most);
        }
        script += fmt::format("$curve{} << END\n{}END\n", i, rows);
        plot += fmt::format("{}$curve{} using 1:2 with linespoints {} pointtype {} pointsize 0.7 notitle", plot.empty() ? "plot " : ", \\\n    ", i, study_picture::look(curve),
                            curve.sample ? 6 : 7);
        plot += fmt::format(", \\\n    $curve{} using 1:2:3:4 with xerrorbars linecolor rgb '{}' linewidth 0.7 pointtype -1 notitle", i, curve.colour);
        if (curve.ladder->floor > 0) {
            script += fmt::format("set arrow from graph 0, first {:.8g} to graph 1, first {:.8g} nohead back linecolor rgb '{}' linewidth 0.9 dashtype (2,3)\n",
                                  curve.ladder->floor, curve.ladder->floor, curve.colour);
        }
        if (!curve.sample) {
            script += ends_of(curve, middle);
        }
        script += study_picture::legend(curve, i, ladder_remark(*curve.ladder), height);
    }
    return script + plot + "\n";
}

}  // namespace hdconj
