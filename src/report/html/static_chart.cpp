// SPDX-License-Identifier: GPL-3.0-or-later
#include "static_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "hdconj/units.hpp"

namespace hdconj::report {
namespace static_svg {  // many sources are one translation unit
namespace {

constexpr double width = 520, height = 300, left = 64, right = 12, top = 12, bottom = 44;

struct Curve
{
    std::string name;
    std::vector<double> x, y, error = {};  ///< error empty: none is stated
};

/// An axis: values from low to high, on the page from one place to another.
struct Axis
{
    double low, high, from, to;
    [[nodiscard]] double operator()(double value) const { return from + (value - low) / (high - low) * (to - from); }
    [[nodiscard]] std::vector<double> ticks() const
    {
        constexpr int about = 6;
        double const raw = (high - low) / about, power = std::pow(10, std::floor(std::log10(raw)));
        double step = 10 * power;
        for (double const digit : {5.0, 2.0, 1.0})
            if (digit * power >= raw)
                step = digit * power;
        std::vector<double> all;
        for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i)
            all.push_back(i * step + 0.0);  // no -0
        return all;
    }
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
    return {low, high > low ? high : low + 1, left, width - right};
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
    return {low, high > low ? high : low + 1, height - bottom, top};
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

std::string axes_svg(Axis const& x, Axis const& y, std::string_view x_label, std::string_view y_label)
{
    std::string svg = "<g class=\"axes\">";
    auto out = std::back_inserter(svg);
    for (double const value : x.ticks())
        fmt::format_to(out,
                       "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" "
                       "text-anchor=\"middle\">{4:.6g}</text>",
                       x(value), top, height - bottom, height - bottom + 16, value);
    for (double const value : y.ticks())
        fmt::format_to(out,
                       "<line x1=\"{1}\" x2=\"{2}\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
                       "text-anchor=\"end\">{5:.6g}</text>",
                       y(value), left, width - right, left - 6, y(value) + 4, value);
    double const middle_x = (left + width - right) / 2, middle_y = (top + height - bottom) / 2;
    fmt::format_to(out,
                   "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text><text x=\"14\" y=\"{}\" "
                   "text-anchor=\"middle\" transform=\"rotate(-90 14 {})\">{}</text></g>",
                   middle_x, height - 6, x_label, middle_y, middle_y, y_label);
    return svg;
}

/// Curves with bands of error, in the classes of web/style.css, as web/src/chart.js draws them.
std::string chart(std::string_view title, std::string_view x_label, std::string_view y_label,
                  std::vector<Curve> const& curves)
{
    constexpr int styles = 4;
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
    return fmt::format(
        "<figure><figcaption>{0}</figcaption><svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
        "viewBox=\"0 0 {1} {2}\"><title>{0}</title>{3}{4}</svg><div class=\"names\">{5}</div></figure>",
        title, width, height, axes_svg(x, y, x_label, y_label), lines, names);
}

std::vector<double> column(Json const& group, char const* name, double unit, double less = 0)
{
    Json const sets = group.value("datasets", Json::object());
    if (!sets.contains(name))
        return {};
    std::vector<double> values = array_values(sets.at(name));
    for (double& value : values)
        value = value / unit - less;
    return values;
}

/// The group at the end of a path; empty where there is none.
Json group_at(Json const& root, std::initializer_list<std::string> path)
{
    Json const* group = &root;
    for (std::string const& name : path) {
        if (!group->contains("groups") || !group->at("groups").contains(name))
            return Json::object();
        group = &group->at("groups").at(name);
    }
    return *group;
}

double attribute(Json const& group, char const* name)
{
    Json const attributes = group.value("attributes", Json::object());
    return attributes.contains(name) && attributes.at(name).is_number() ? attributes.at(name).get<double>() : 0;
}

std::string errors_of_transmission(Json const& running)
{
    std::string html;
    Json const sequences = running.value("groups", Json::object());
    for (auto const& each : sequences.items()) {
        if (!each.key().starts_with("sequence_"))
            continue;
        Json const& sequence = each.value();
        std::vector<double> const error = column(sequence, "error", arcsec);
        double const mean = std::accumulate(error.begin(), error.end(), 0.0) / static_cast<double>(error.size()),
                     torque = attribute(sequence, "torque_Nmm") / newton_metre;
        std::string const name = torque == 0 ? "unloaded" : fmt::format("{:.4g} N m", torque),
                          span = sequence.at("attributes").value("span", "");
        html += chart(fmt::format("Transmission error, {}, over {}", name,
                                  span == "tooth_pitch"  ? "one tooth pitch"
                                  : span == "input_turn" ? "a turn of the wave generator"
                                                         : "all places of both rings"),
                      "angle of the wave generator [deg]", "output ahead, mean left out [arcsec]",
                      {{name, column(sequence, "angle", deg), column(sequence, "error", arcsec, mean)}});
    }
    return html;
}

std::string efficiencies(Json const& losses)
{
    constexpr double percent = 0.01, rpm = 2 * std::numbers::pi / 60;
    std::vector<double> const torque = column(losses, "torque", newton_metre), speed = column(losses, "speed", rpm),
                              temperature = column(losses, "temperature", 1),
                              value = column(losses, "efficiency", percent),
                              error = column(losses, "efficiency_error", percent);
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < torque.size(); ++i) {
        std::string const name = fmt::format("{:.4g} rpm, {:.4g} °C", speed[i], temperature[i]);
        if (curves.empty() || curves.back().name != name)
            curves.push_back({name, {}, {}});
        curves.back().x.push_back(torque[i]);
        curves.back().y.push_back(value[i]);
        if (!error.empty() && attribute(losses, "estimated") != 0)
            curves.back().error.push_back(error[i]);
    }
    return curves.empty() ? "" : chart("Efficiency", "torque on the output [N m]", "efficiency [%]", curves);
}

std::string curves_of_load(Json const& load)
{
    Json const curve = group_at(
                   load, {fmt::format("case_{:03}", static_cast<int>(attribute(load, "written_case"))), "curve"}),
               error = group_at(curve, {"error"});
    std::vector<double> const torque = column(curve, "torque", newton_metre);
    if (torque.size() < 2)
        return "";
    std::vector<double> const known = column(error, "estimated", 1);
    auto const of = [&](char const* title, char const* name, char const* label, double unit) {
        std::vector<double> band = column(error, name, unit);
        for (std::size_t i = 0; i < band.size() && i < known.size(); ++i)
            band[i] = known[i] != 0 ? band[i] : 0;
        bool const any = std::any_of(known.begin(), known.end(), [](double each) { return each != 0; });
        return chart(title, "torque [N m]", label,
                     {{title, torque, column(curve, name, unit), any ? band : std::vector<double>()}});
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
    return charts.empty() ? "" : "<div class=\"figures\">" + charts + "</div>";
}

}  // namespace hdconj::report
