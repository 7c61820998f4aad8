// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/convergence_series.hpp"
#include "accuracy_curves.hpp"
#include "hdconj/units.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

struct LogRange
{
    double low = std::numeric_limits<double>::infinity(), high = 0;

    void take(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    void widen(double factor)
    {
        low /= factor;
        high *= factor;
    }
    /// Whole decades around what was taken.
    void widen_to_decades()
    {
        constexpr double room = 1.25;
        low = std::pow(10.0, std::floor(std::log10(low / room)));
        high = std::pow(10.0, std::ceil(std::log10(high * room)));
    }
    [[nodiscard]] double share(double value) const { return std::log(value / low) / std::log(high / low); }
    void set_in(PlotData& data, std::string const& axis) const
    {
        data.set(axis + "_low", low);
        data.set(axis + "_high", high);
    }
};

/// Adds the knob's value beside the first and the last level of every line that has a knob to turn.
void add_labels(PlotColumns& labels, std::size_t panel_number, StudyPanel const& panel, LogRange const& time,
                LogRange const& error)
{
    auto const& axes = panel.axes;
    auto const spot = [&](double seconds, double off) -> Spot {
        return {axes.left + time.share(seconds) * (axes.right - axes.left),
                axes.bottom + error.share(off) * (axes.top - axes.bottom)};
    };
    LabelPlaces places(axes);
    for (auto const& curve : panel.curves) {
        for (std::size_t i = 0; i < curve.levels.size(); ++i) {
            auto const &level = *curve.levels[i], &last = *curve.levels[i > 0 ? i - 1 : 0];
            places.add_point(spot(level.median, level.error));
            places.add_line(spot(level.least, level.error), spot(level.most, level.error));
            places.add_line(spot(last.median, last.error), spot(level.median, level.error));
        }
        if (curve.series->floor > 0)
            places.add_line(spot(time.low, curve.series->floor), spot(time.high, curve.series->floor));
    }
    for (auto const& curve : panel.curves) {
        auto const add = [&](ConvergenceLevel const& level) {
            std::string const text = figures::knob_text(level.value);
            LabelBox const box = places.place(text, spot(level.median, level.error));
            labels.named_row(text, panel_number, (box.left + box.right) / 2, (box.top + box.bottom) / 2, curve.colour);
        };
        if (curve.has_knob())
            add(*curve.levels.front());
        if (curve.has_knob() && curve.levels.size() > 1)
            add(*curve.levels.back());
    }
}

/// 1, 2 and 5 of the decades where whole ones would leave the axis with one number; else nothing.
PlotColumns time_tics(LogRange const& time)
{
    constexpr double plain_from = 1e-3, plain_to = 1e3;  // without a power of ten
    PlotColumns tics;
    int const first = static_cast<int>(std::floor(std::log10(time.low))),
              last = static_cast<int>(std::ceil(std::log10(time.high)));
    if (std::floor(std::log10(time.high)) > std::ceil(std::log10(time.low)))
        return tics;
    for (int power = first; power <= last; ++power) {
        for (int const step : {1, 2, 5}) {
            double const at = step * std::pow(10.0, power);
            bool const plain = at >= plain_from && at < plain_to;
            if (at >= time.low && at <= time.high)
                tics.named_row(plain ? fmt::format("{:g}", at) : fmt::format("{}·10^{{{}}}", step, power), at);
        }
    }
    return tics;
}

/// Time on threads has equal errors: what its lines differ in is time.
bool is_of_threads(std::vector<StudyCurve> const& curves)
{
    return !curves.empty() && curves.front().series->knob == "solver.threads";
}

/// "1.83 times on 2 threads", or empty, also where the times are of single runs.
std::string thread_gain(StudyCurve const& curve)
{
    auto const &first = *curve.levels.front(), &last = *curve.levels.back();
    return last.value > first.value && first.runs > 1 && last.runs > 1
               ? fmt::format("{:.2f} times on {:.0f} threads", first.median / last.median, last.value)
               : "";
}

std::string threads_script(StoredAccuracy const& study, std::string const& name, std::vector<StudyPanel> const& panels)
{
    LogRange time;
    double most_threads = 1;
    PlotColumns columns, series;
    for (auto const& panel : panels) {
        // Lines that would hide each other stand a little apart.
        constexpr double apart = 1.012;
        double shift = 1;
        for (auto const& curve : panel.curves) {
            for (auto const* level : curve.levels) {
                time.take(level->least * per_ms);
                time.take(level->most * per_ms);
                most_threads = std::max(most_threads, level->value);
                columns.row(level->value * shift, level->median * per_ms, level->least * per_ms, level->most * per_ms);
            }
            columns.end_index();
            auto const& first = *curve.levels.front();
            series.row(curve.colour, first.value * first.median * per_ms);
            shift *= apart;
        }
    }
    constexpr double room = 1.15;
    time.widen(room);
    PlotData data = study_data(study, name, panels, thread_gain);
    data.set("most_threads", most_threads);
    time.set_in(data, "time");
    data.set("curves", columns);
    data.set("series", series);
    return plot_script("accuracy_threads", data);
}

std::string error_script(StoredAccuracy const& study, std::string const& name, std::vector<StudyPanel> const& panels)
{
    LogRange time, error;
    PlotColumns columns, series, labels;
    for (auto const& panel : panels) {
        for (auto const& curve : panel.curves) {
            for (auto const* level : curve.levels) {
                time.take(level->least);
                time.take(level->most);
                error.take(level->error);
                columns.row(level->median, level->error, level->least, level->most);
            }
            columns.end_index();
            series.row(curve.colour, std::max(0.0, curve.series->floor));
        }
    }
    constexpr double room = 1.6;
    time.widen(room);
    error.widen_to_decades();
    for (std::size_t i = 0; i < panels.size(); ++i)
        add_labels(labels, i + 1, panels[i], time, error);
    PlotData data =
        study_data(study, name, panels, [](StudyCurve const& curve) { return figures::series_remark(*curve.series); });
    std::string const& unit = panels.front().curves.front().series->unit;
    time.set_in(data, "time");
    error.set_in(data, "error");
    data.set("unit", unit == "mm^2" ? "mm²" : unit);
    data.set("tics", time_tics(time));
    data.set("curves", columns);
    data.set("series", series);
    data.set("labels", labels);
    return plot_script("accuracy", data);
}

}  // namespace

std::string picture_words(std::vector<ConvergenceSeries> const& series_list, std::string const& name)
{
    return is_of_threads(study_curves(series_list, name)) ? "time against threads" : "error against time";
}

bool has_picture(std::vector<ConvergenceSeries> const& series_list, std::string const& name)
{
    std::size_t points = 0;
    for (auto const& curve : study_curves(series_list, name))
        points += curve.levels.size();
    return points > 1;
}

std::string accuracy_script(StoredAccuracy const& study, std::vector<ConvergenceSeries> const& series_list,
                            std::string const& name)
{
    auto const curves = study_curves(series_list, name);
    auto const panels = study_panels(curves, study.report.scene.drive.name);
    return is_of_threads(curves) ? threads_script(study, name, panels) : error_script(study, name, panels);
}

}  // namespace hdconj::report
