// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <stdexcept>

#include "base/segments.hpp"
#include "plot_templates.hpp"

namespace hdconj::report {
namespace {

/// The text without control characters, and with @p replacement in place of @p quote.
std::string one_line(std::string_view text, char quote, std::string_view replacement)
{
    constexpr unsigned char first_printable = ' ', del = 0x7f;
    std::string line;
    for (char const c : text) {
        auto const code = static_cast<unsigned char>(c);
        if (c == quote)
            line += replacement;
        else
            line += code < first_printable || code == del ? ' ' : c;
    }
    return line;
}

/// As gnuplot writes a number, or one that is not there.
std::string gnuplot_number(double value)
{
    return std::isfinite(value) ? fmt::format("{:.8g}", value) : "NaN";
}

std::string_view template_text(std::string_view name)
{
    for (auto const& each : plot_templates)
        if (each.name == name)
            return each.text;
    throw std::logic_error(fmt::format("there is no plot template {}", name));
}

}  // namespace

PlotColumns::PlotColumns(Polylines const& lines)
{
    for (auto const& line : lines) {
        for (auto const& point : line)
            row(point.x(), point.y());
        if (!line.empty())
            end_line();
    }
}

void PlotColumns::add(std::initializer_list<double> values)
{
    char const* between = "";
    for (double const value : values) {
        std::string number = gnuplot_number(value);
        // of data gnuplot takes no number from a text such as 5e-06, but from 5.0e-06
        if (auto const exponent = number.find('e'); exponent != std::string::npos && number.find('.') > exponent)
            number.insert(exponent, ".0");
        text_ += between + number;
        between = " ";
    }
}

void PlotColumns::add(std::string_view text)
{
    text_ += fmt::format(" \"{}\"\n", one_line(text, '"', "'"));
}

void PlotData::set(std::string_view name, double value)
{
    commands_ += fmt::format("{} = {}\n", name, gnuplot_number(value));
}

void PlotData::set(std::string_view name, std::string_view text)
{
    commands_ += fmt::format("{} = '{}'\n", name, one_line(text, '\'', "''"));
}

void PlotData::set(std::string_view name, PlotColumns const& columns)
{
    commands_ += fmt::format("${} << EOD\n{}EOD\n", name, columns.text());
}

std::string plot_script(std::string_view name, PlotData const& data)
{
    return fmt::format("{}{}{}", data.commands(), template_text("common"), template_text(name));
}

std::vector<Vec2> thinned(std::vector<Vec2> const& polyline, double tolerance)
{
    if (polyline.size() < 3)
        return polyline;
    std::vector<std::size_t> kept = {0};
    keep_between({&polyline, 1}, 0, polyline.size() - 1, tolerance, kept);
    kept.push_back(polyline.size() - 1);
    std::vector<Vec2> points;
    for (std::size_t const i : kept)
        points.push_back(polyline[i]);
    return points;
}

Polylines thinned(Polylines lines, double tolerance)
{
    for (auto& line : lines)
        line = thinned(line, tolerance);
    return lines;
}

}  // namespace hdconj::report
