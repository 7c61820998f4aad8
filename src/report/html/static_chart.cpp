// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

#include "hdconj/units.hpp"
#include "static_axes.hpp"

namespace hdconj::report {
namespace static_svg {  // many sources are one translation unit
namespace {

struct Curve
{
    std::string name;
    std::vector<double> x, y, error = {};  ///< error empty: none is stated
};

/// Least and greatest of the values, each with @p share of its error on either side.
std::array<double, 2> range_of(std::vector<Curve> const& curves, std::vector<double> Curve::*values, double share)
{
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (Curve const& curve : curves)
        for (std::size_t i = 0; i < (curve.*values).size(); ++i) {
            double const value = (curve.*values)[i], error = curve.error.empty() ? 0 : share * curve.error[i];
            if (!std::isfinite(value + error))
                continue;
            low = std::min(low, value - error);
            high = std::max(high, value + error);
        }
    return low <= high ? std::array{low, high} : std::array{0.0, 1.0};
}

/// The axis of places along the curves.
Axis across(std::vector<Curve> const& curves)
{
    auto const [low, high] = range_of(curves, &Curve::x, 0);
    return horizontal_axis(low, high);
}

/// The axis of values with their bands; a few large errors shall not hide the curve, as in web/src/chart.js.
Axis upward(std::vector<Curve> const& curves)
{
    constexpr double most_of_band = 0.75;  // on either side, of the span of the values
    auto const values = range_of(curves, &Curve::y, 0), bounds = range_of(curves, &Curve::y, 1);
    double const span = values[1] - values[0];
    double low = bounds[0], high = bounds[1];
    if (span > 0) {
        low = std::max(low, values[0] - most_of_band * span);
        high = std::min(high, values[1] + most_of_band * span);
    }
    if (low > 0 && low < high / 2)
        low = 0;
    return vertical_axis(low, high);
}

std::string points_text(Curve const& curve, Axis const& x, Axis const& y, double share)
{
    std::string text;
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (double const value = curve.y[i] + (share == 0 ? 0 : share * curve.error[i]); std::isfinite(value))
            fmt::format_to(std::back_inserter(text), "{:.1f},{:.1f} ", x(curve.x[i]),
                           y(std::clamp(value, y.low, y.high)));
    return text;
}

/// The curves whose values are all there, with errors where these are: a result may have been edited.
std::vector<Curve> complete(std::vector<Curve> curves)
{
    std::erase_if(curves, [](Curve const& each) { return each.y.size() != each.x.size(); });
    for (Curve& each : curves)
        if (each.error.size() != each.x.size())
            each.error.clear();
    return curves;
}

/// Curves with bands of error, in the classes of web/style.css, as web/src/chart.js draws them.
std::string chart(std::string_view title, std::string_view x_label, std::string_view y_label,
                  std::vector<Curve> const& stored)
{
    constexpr int styles = 4;
    std::vector<Curve> const curves = complete(stored);
    if (curves.empty())
        return "";
    Axis const x = across(curves), y = upward(curves);
    std::string lines, names;
    for (std::size_t n = 0; n < curves.size(); ++n) {
        Curve const& curve = curves[n];
        if (!curve.error.empty()) {
            Curve back = curve;
            for (auto* const list : {&back.x, &back.y, &back.error})
                std::reverse(list->begin(), list->end());
            lines += fmt::format("<polygon class=\"band s{}\" points=\"{}{}\"/>", n % styles,
                                 points_text(curve, x, y, 1), points_text(back, x, y, -1));
        }
        lines += fmt::format("<polyline class=\"line s{}\" points=\"{}\"/>", n % styles, points_text(curve, x, y, 0));
        names += fmt::format("<span class=\"key s{}\">{}</span>", n % styles, curve.name);
    }
    return static_figure(title, axes_svg(x, y, x_label, y_label) + lines, names);
}

/// Values less their mean.
std::vector<double> about_mean(std::vector<double> values)
{
    double const mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (double& value : values)
        value -= mean;
    return values;
}

std::string errors_of_transmission(Json const& running)
{
    std::string html;
    for (Json const& sequence : groups_of(running, "sequence_")) {
        double const torque = attribute_of(sequence, "torque_Nmm") / newton_metre;
        std::string const name = torque == 0 ? "unloaded" : fmt::format("{:.4g} N m", torque),
                          span = sequence.at("attributes").value("span", "");
        html += chart(fmt::format("Transmission error, {}, over {}", name,
                                  span == "tooth_pitch"  ? "one tooth pitch"
                                  : span == "input_turn" ? "a turn of the wave generator"
                                                         : "all places of both rings"),
                      "angle of the wave generator [deg]", "output ahead, mean left out [arcsec]",
                      {{name, column_of(sequence, "angle", deg), about_mean(column_of(sequence, "error", arcsec)),
                        column_of(sequence, "error_error", arcsec)}});
    }
    return html;
}

std::string efficiencies(Json const& losses)
{
    constexpr double percent = 0.01;
    std::vector<double> const torque = column_of(losses, "torque", newton_metre),
                              speed = column_of(losses, "speed", rpm),
                              temperature = column_of(losses, "temperature", 1),
                              value = column_of(losses, "efficiency", percent),
                              error = column_of(losses, "efficiency_error", percent);
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < std::min({torque.size(), speed.size(), temperature.size(), value.size()}); ++i) {
        std::string const name = fmt::format("{:.4g} rpm, {:.4g} °C", speed[i], temperature[i]);
        if (curves.empty() || curves.back().name != name)
            curves.push_back({name, {}, {}});
        curves.back().x.push_back(torque[i]);
        curves.back().y.push_back(value[i]);
        if (i < error.size() && attribute_of(losses, "estimated") != 0)
            curves.back().error.push_back(error[i]);
    }
    return curves.empty() ? "" : chart("Efficiency", "torque on the output [N m]", "efficiency [%]", curves);
}

std::string curves_of_load(Json const& load)
{
    Json const curve = group_at(
                   load, {fmt::format("case_{:03}", static_cast<int>(attribute_of(load, "written_case"))), "curve"}),
               error = group_at(curve, {"error"});
    std::vector<double> const torque = column_of(curve, "torque", newton_metre);
    if (torque.size() < 2)
        return "";
    std::vector<double> const known = column_of(error, "estimated", 1);
    auto const of = [&](char const* title, char const* name, char const* label, double unit) {
        std::vector<double> band = column_of(error, name, unit);
        for (std::size_t i = 0; i < band.size() && i < known.size(); ++i)
            band[i] = known[i] != 0 ? band[i] : 0;
        bool const any = std::any_of(known.begin(), known.end(), [](double each) { return each != 0; });
        return chart(title, "torque [N m]", label,
                     {{title, torque, column_of(curve, name, unit), any ? band : std::vector<double>()}});
    };
    return of("Stiffness", "stiffness", "stiffness [N m/arcmin]", newton_metre / arcmin) +
           of("Twist", "twist", "twist [arcmin]", arcmin);
}

}  // namespace
}  // namespace static_svg

std::string static_charts(Json const& results)
{
    using namespace static_svg;
    std::string charts;
    if (results.contains("load"))
        charts += curves_of_load(group_at(results.at("load"), {"load"}));
    if (results.contains("run")) {
        Json const running = group_at(results.at("run"), {"running"});
        charts += errors_of_transmission(running) + efficiencies(group_at(running, {"losses"}));
    }
    return charts;
}

}  // namespace hdconj::report
