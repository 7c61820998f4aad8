// SPDX-License-Identifier: GPL-3.0-or-later
// Error against time, log-log: one line per method, floors as dashed lines, least and most time as whiskers; beside the drive the worst of the sample, where there is one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy_curves.hpp"
#include "accuracy_labels.hpp"
#include "hdconj/study/ladder.hpp"
#include "picture_lines.hpp"

namespace hdconj {
namespace {

using study_picture::Curve;
using study_picture::Part;

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

/// From numbers to places on the picture.
struct Axes
{
    Range time, error;
    picture::Panel panel;

    [[nodiscard]] study_picture::Spot spot(double seconds, double off) const
    {
        double const across = std::log(seconds / time.low) / std::log(time.high / time.low), up = std::log(off / error.low) / std::log(error.high / error.low);
        return {panel.left + across * (panel.right - panel.left), panel.bottom + up * (panel.top - panel.bottom)};
    }
};

/// The knob's value beside the first and the last rung of every line, where there is one to turn.
std::string ends_of(std::vector<Curve> const& curves, Axes const& axes, double height)
{
    using study_picture::Spot;
    study_picture::LabelPlaces places({axes.panel.left, axes.panel.right, axes.panel.top, axes.panel.bottom});
    for (auto const& curve : curves) {
        for (std::size_t i = 0; i < curve.rungs.size(); ++i) {
            auto const& rung = *curve.rungs[i];
            Spot const at = axes.spot(rung.median, rung.error);
            places.add_point(at);
            places.add_line(axes.spot(rung.least, rung.error), axes.spot(rung.most, rung.error));
            if (i > 0) {
                places.add_line(axes.spot(curve.rungs[i - 1]->median, curve.rungs[i - 1]->error), at);
            }
        }
        if (curve.ladder->floor > 0) {
            places.add_line(axes.spot(axes.time.low, curve.ladder->floor), axes.spot(axes.time.high, curve.ladder->floor));
        }
    }
    std::string labels;
    auto const add = [&](Curve const& curve, StudyRung const& rung) {
        std::string const text = knob_text(rung.value);
        study_picture::Box const box = places.place(text, axes.spot(rung.median, rung.error));
        labels += fmt::format("set label {} at {} center noenhanced textcolor rgb '{}' front boxed\n", gnuplot_quoted(text),
                              picture::screen((box.left + box.right) / 2, (box.top + box.bottom) / 2, height), curve.colour);
    };
    for (auto const& curve : curves) {
        if (!curve.has_knob()) {
            continue;
        }
        add(curve, *curve.rungs.front());
        if (curve.rungs.size() > 1) {
            add(curve, *curve.rungs.back());
        }
    }
    return labels;
}

/// Whole decades, or 1, 2 and 5 of them where these would leave the axis with one number.
std::string time_tics(Range const& time)
{
    constexpr double plain_from = 1e-3, plain_to = 1e3;   // without a power of ten
    if (std::floor(std::log10(time.high)) > std::ceil(std::log10(time.low))) {
        return "set format x '10^{%L}'\n";
    }
    std::string tics;
    for (int power = static_cast<int>(std::floor(std::log10(time.low))); power <= static_cast<int>(std::ceil(std::log10(time.high))); ++power) {
        for (int const step : {1, 2, 5}) {
            if (double const at = step * std::pow(10.0, power); at >= time.low && at <= time.high) {
                std::string const said = at >= plain_from && at < plain_to ? fmt::format("{:g}", at) : fmt::format("{}·10^{{{}}}", step, power);
                tics += fmt::format("{}'{}' {:.8g}", tics.empty() ? "" : ", ", said, at);
            }
        }
    }
    return "set xtics (" + tics + ")\n";
}

/// All its lines have the same error: what they differ in is time.
bool is_of_threads(std::vector<Curve> const& curves)
{
    return !curves.empty() && curves.front().ladder->knob == "solver.threads";
}

/// Lines of a part, and what stands beside them.
std::string plot_of(Part const& part, Axes const& axes, double height)
{
    auto const& curves = part.curves;
    std::string script = fmt::format("set xrange [{:.8g}:{:.8g}]\nset yrange [{:.8g}:{:.8g}]\n{}set xlabel 'time [s], median; whiskers: least and most' noenhanced\n", axes.time.low,
                                     axes.time.high, axes.error.low, axes.error.high, time_tics(axes.time));
    std::string plot;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        auto const& curve = curves[i];
        std::string const data = (curve.sample ? "$sample" : "$drive") + std::to_string(i);
        script += data + " << END\n";
        for (auto const* rung : curve.rungs) {
            script += fmt::format("{:.8g} {:.8g} {:.8g} {:.8g}\n", rung->median, rung->error, rung->least, rung->most);
        }
        script += "END\n";
        plot += fmt::format("{}{} using 1:2:3:4 with xerrorbars linecolor rgb '{}' linewidth 0.7 pointtype -1 notitle", plot.empty() ? "plot " : ", \\\n    ", data, curve.colour);
        plot += fmt::format(", \\\n    {} using 1:2 with linespoints {} pointtype 7 pointsize 0.7 notitle", data, study_picture::look(curve));
        if (curve.ladder->floor > 0) {
            script += fmt::format("set arrow from graph 0, first {:.8g} to graph 1, first {:.8g} nohead back linecolor rgb '{}' linewidth 0.9 dashtype (2,3)\n", curve.ladder->floor,
                                  curve.ladder->floor, curve.colour);
        }
    }
    return script + ends_of(curves, axes, height) + plot + "\n";
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

    auto const parts = study_picture::parts_of(curves, study.report.scene.drive.name);
    study_picture::Legend const legend(curves, [](Curve const& curve) { return ladder_remark(*curve.ladder); });
    double const height = legend.height_below(parts.front().panel);
    bool const ends = std::any_of(curves.begin(), curves.end(), [](Curve const& curve) { return curve.has_knob(); });
    std::string const& unit = curves.front().ladder->unit;
    std::string script = study_picture::frame(study, name, ends ? "at the ends of a line its first and last setting" : "", legend.text(parts.front().panel, height), height, format) +
                         fmt::format("set style textbox opaque noborder fillcolor rgb '#ffffff' margins 0.2,0.2\n"
                                     "set ylabel 'error against the reference [{}]' noenhanced\nset format y '10^{{%L}}'\n",
                                     unit == "mm^2" ? "mm²" : unit);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        script += study_picture::axes_of(parts[i], i, height) + plot_of(parts[i], {time, error, parts[i].panel}, height);
    }
    return script + "unset multiplot\n";
}

}  // namespace hdconj
