// SPDX-License-Identifier: GPL-3.0-or-later
// Error against time, log-log: one line per method, floors as dashed lines, least and most time as whiskers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "accuracy_figures.hpp"
#include "hdconj/study/accuracy.hpp"
#include "picture_frame.hpp"
#include "picture_lines.hpp"

namespace hdconj {
namespace {

// Layout [px].
constexpr double top = 82;
constexpr double panel_height = 430;
constexpr double left_axis = 112;
constexpr double below_axis = 66;
constexpr double legend_row = 26;
constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#8c6d46"};

struct Curve
{
    StudyLadder const* ladder;
    std::vector<StudyRung const*> rungs;   ///< with an error and a time to draw
    std::string colour;
    bool sample = false;
};

std::vector<Curve> curves_of(std::vector<StudyLadder> const& ladders, std::string const& name)
{
    std::vector<Curve> curves;
    std::vector<std::string> methods;
    for (auto const& ladder : ladders) {
        if (ladder.study != name) {
            continue;
        }
        Curve curve{&ladder, {}, "", ladder.drive == worst_of_sample};
        for (auto const& rung : ladder.rungs) {
            if (rung.error > 0 && rung.median > 0) {
                curve.rungs.push_back(&rung);
            }
        }
        auto const known = std::find(methods.begin(), methods.end(), ladder.method + ladder.knob);
        std::size_t const number = static_cast<std::size_t>(known - methods.begin());
        if (known == methods.end()) {
            methods.push_back(ladder.method + ladder.knob);
        }
        curve.colour = colours[number % colours.size()];
        if (!curve.rungs.empty()) {
            curves.push_back(std::move(curve));
        }
    }
    return curves;
}

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

std::string look(Curve const& curve)
{
    // Widths differ as well: in SVG, gnuplot joins lines of one colour and width and forgets the second one's dashes.
    return fmt::format("linecolor rgb '{}' linewidth {} dashtype {}", curve.colour, curve.sample ? 1.4 : 2.2, curve.sample ? "(8,5)" : "solid");
}

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

}  // namespace

bool has_picture(std::vector<StudyLadder> const& ladders, std::string const& name)
{
    std::size_t points = 0;
    for (auto const& curve : curves_of(ladders, name)) {
        points += curve.rungs.size();
    }
    return points > 1;
}

std::string accuracy_script(StoredAccuracy const& study, std::vector<StudyLadder> const& ladders, std::string const& name, PictureFormat format)
{
    auto const curves = curves_of(ladders, name);
    double const height = top + panel_height + below_axis + legend_row * (static_cast<double>(curves.size()) + 1);
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
    std::string question;
    for (auto const& kind : study_kinds()) {
        if (kind.name == name) {
            question = kind.question;
        }
    }
    std::string const& unit = curves.front().ladder->unit;
    picture::Words const words{study.report.scene.drive.name + ": " + name, question + "; at the ends of a line its first and last setting", "", ""};
    std::string script = picture::terminal(format, height) + picture::title(height, words) +
                         picture::axes({.left = left_axis, .right = picture::width - picture::right_margin, .top = top, .bottom = top + panel_height}, height);
    script += fmt::format(
        "set logscale xy\nset xrange [{:.8g}:{:.8g}]\nset yrange [{:.8g}:{:.8g}]\n"
        "set format xy '10^{{%L}}'\nset grid linecolor rgb '#e0e0e0' linewidth 0.6\n"
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
        plot += fmt::format("{}$curve{} using 1:2 with linespoints {} pointtype {} pointsize 0.7 notitle", plot.empty() ? "plot " : ", \\\n    ", i, look(curve),
                            curve.sample ? 6 : 7);
        plot += fmt::format(", \\\n    $curve{} using 1:2:3:4 with xerrorbars linecolor rgb '{}' linewidth 0.7 pointtype -1 notitle", i, curve.colour);
        if (curve.ladder->floor > 0) {
            script += fmt::format("set arrow from graph 0, first {:.8g} to graph 1, first {:.8g} nohead back linecolor rgb '{}' linewidth 0.9 dashtype (2,3)\n",
                                  curve.ladder->floor, curve.ladder->floor, curve.colour);
        }
        if (!curve.sample) {
            script += ends_of(curve, middle);
        }
        constexpr double sample = 46, gap = 12;
        double const y = top + panel_height + below_axis + legend_row * (static_cast<double>(i) + 1);
        std::string const remark = ladder_remark(*curve.ladder);
        std::string const text = ladder_name(*curve.ladder) + " (" + curve.ladder->knob + ")" + (remark.empty() ? "" : ": " + remark);
        script += fmt::format("set arrow from {} to {} nohead {}\nset label {} at {} noenhanced\n", picture::screen(left_axis, y, height),
                              picture::screen(left_axis + sample, y, height), look(curve), gnuplot_quoted(text), picture::screen(left_axis + sample + gap, y, height));
    }
    return script + plot + "\n";
}

}  // namespace hdconj
