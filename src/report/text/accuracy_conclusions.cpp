// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_conclusions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "accuracy/convergence_series.hpp"
#include "figures/accuracy_figures.hpp"
#include "hdconj/units.hpp"
#include "scene/tolerance_limits.hpp"

namespace hdconj::report {

ConvergenceSeries const* find(SeriesList const& series_list, std::string const& study, std::string const& method,
                              bool sample)
{
    for (auto const& series : series_list)
        if (series.study == study && series.method == method && (series.drive == accuracy::worst_of_sample) == sample)
            return &series;
    return nullptr;
}

namespace {

/// The level with the smallest error that was measured; else the first.
ConvergenceLevel const& best_of(ConvergenceSeries const& series)
{
    return *std::min_element(series.levels.begin(), series.levels.end(), [](auto const& a, auto const& b) {
        return a.error < b.error || (a.error == a.error && b.error != b.error);
    });
}

/// Another figure of a series where its error is @p error, between its levels on log-log lines, once for each time that
/// the errors fall past it.
std::vector<double> at_error(ConvergenceSeries const& series, double error, double ConvergenceLevel::*figure)
{
    std::vector<double> found;
    for (std::size_t i = 0; i + 1 < series.levels.size(); ++i) {
        auto const &a = series.levels[i], &b = series.levels[i + 1];
        if (a.error >= error && b.error <= error && a.error > b.error) {
            double const share = std::log(a.error / error) / std::log(a.error / b.error);
            found.push_back(a.*figure * std::pow(b.*figure / a.*figure, share));
        }
    }
    return found;
}

void conclude_tolerance(Page& page, SeriesList const& series_list)
{
    auto const* series = find(series_list, "tolerance", "solve");
    if (series == nullptr)
        return;
    auto const &first = series->levels.front(), &last = series->levels.back();
    double over = 0, under = 0;
    for (auto const& level : series->levels) {
        over = std::max(over, level.estimate / level.error);
        under = std::max(under, level.error / level.estimate);
    }
    std::string text =
        series->order == series->order
            ? fmt::format(
                  "The error follows the tolerance with order {:.2f}, down to {} mm, the error at the finest level.",
                  series->order, figures::scientific(last.error))
            : fmt::format("The error is {} mm with the coarsest tolerance and {} mm with the finest.",
                          figures::scientific(first.error), figures::scientific(last.error));
    text += fmt::format(
        " The program's own estimate is at most {:.2f} times the true error{}.", over,
        under > 1 ? fmt::format(", and where chords are long it may be {:.0f} % too small", (under - 1) * per_percent)
                  : " and never below it");
    if (has_median(first, last)) {
        text += fmt::format(" From {} to {} mm time {} from {} to {}.", figures::scientific(first.error),
                            figures::scientific(last.error), last.median > first.median ? "grows" : "goes",
                            figures::duration(first.median), figures::duration(last.median));
    }
    page.line("{}", text);
}

/// The order of a series against its number of points, in words; empty where there is none.
std::string order_in_points(ConvergenceSeries const& series)
{
    std::vector<ConvergenceLevel> levels = series.levels;
    for (auto& level : levels)
        level.value = level.points;
    double const order = accuracy::why_no_order(levels, series.floor).empty()
                             ? accuracy::observed_order(levels, series.floor)
                             : not_measured;
    return order == order ? fmt::format("{:.2f}", -order) : std::string();
}

void conclude_sampling(Page& page, SeriesList const& series_list)
{
    auto const* equal = find(series_list, "sampling", "equal steps of u");
    auto const* adaptive = find(series_list, "sampling", "adaptive");
    if (equal == nullptr || adaptive == nullptr)
        return;
    std::string ratios;
    for (auto const& level : adaptive->levels) {
        for (double const points : at_error(*equal, level.error, &ConvergenceLevel::points)) {
            ratios += fmt::format("{}{:.2g} at {} mm", ratios.empty() ? "" : ", ", points / level.points,
                                  figures::scientific(level.error));
        }
    }
    std::string const of_equal = order_in_points(*equal), of_adaptive = order_in_points(*adaptive);
    auto const told = [](std::string const& order) {
        return order.empty() ? std::string("no order that could be told") : "order " + order;
    };
    std::string const text = fmt::format(
        "Against the number of points the error falls with {} for equal steps of u, with {} for the adaptive sampler; "
        "chords of a smooth curve allow 2.",
        told(of_equal), told(of_adaptive));
    page.line(
        "{}{}", text,
        ratios.empty() ? "" : " Equal steps of u need this many times the points for the same error: " + ratios + ".");
}

void conclude_model(Page& page, SeriesList const& series_list)
{
    auto const* first = find(series_list, "motion-model", "first order");
    auto const* material = find(series_list, "motion-model", "material");
    auto const* exact = find(series_list, "motion-model", "exact");
    if (first == nullptr || exact == nullptr)
        return;
    auto const floor = [](ConvergenceSeries const* series) {
        return series->floor == series->floor
                   ? fmt::format("stays at {}, whatever the tolerance", figures::um_text(series->floor))
                   : fmt::format("comes no closer than {}", figures::um_text(best_of(*series).error));
    };
    auto const times = [&](ConvergenceSeries const* series) {
        return fmt::format("{:.2g}", series->levels.back().median / exact->levels.back().median);
    };
    std::string text = "First order " + floor(first) + (material == nullptr ? "" : "; material " + floor(material)) +
                       (material == nullptr ? ": a floor" : ": floors") + " of the model, not of the arithmetic.";
    if (has_median(first->levels.back(), exact->levels.back())) {
        text += " At equal tolerance " +
                (material == nullptr ? "it takes " + times(first)
                                     : "they take " + times(first) + " and " + times(material)) +
                " times the time of exact motion.";
    }
    page.line("{}", text);
}

int most_missed(ConvergenceSeries const& series)
{
    int most = 0;
    for (auto const& level : series.levels)
        most = std::max(most, level.missed);
    return most;
}

/// What a series of degrees came to. @param rounding  below which an error is one [mm]
std::string fit_words(ConvergenceSeries const& series, double rounding)
{
    auto const& best = best_of(series);
    auto const& last = series.levels.back();
    std::string const model = series.method.substr(series.method.find(',') + 2);
    if (best.error != best.error) {
        return fmt::format("With {} too few points of the grid have a contact on the flank for a fit.",
                           model == "first order" ? "first-order motion" : model);
    }
    std::string text =
        fmt::format("With {} the fit is best with degree {:.0f}, {} mm",
                    model == "first order" ? "first-order motion" : model, best.value, figures::scientific(best.error));
    if (best.error < rounding) {
        text += ", which is rounding";
    } else if (series.floor == series.floor) {
        text += ", and the highest degrees tried differ by less than a tenth";
    } else if (&best == &last) {
        text += ", the highest that was tried";
    } else {
        text += fmt::format("; degree {:.0f}, the highest that was tried, is off by {} mm", last.value,
                            figures::scientific(last.error));
    }
    if (int const missed = most_missed(series); missed > 0) {
        text += fmt::format(" ({} of {:.0f} points of the grid have no contact on the flank)", missed,
                            missed + last.points);
    }
    return text + ".";
}

void conclude_fit(Page& page, SeriesList const& series_list, Scene const& scene)
{
    constexpr double roundings = 100;  // of the pitch radius: what a fit by powers leaves
    double const rounding =
        roundings * std::numeric_limits<double>::epsilon() * scene::flexspline_pitch_radius(scene.drive);
    std::string text;
    for (auto const& series : series_list) {
        if (series.study != "polynomial-fit")
            continue;
        bool const of_sample = series.drive == accuracy::worst_of_sample,
                   fits = series.knob == accuracy::polynomial_degree;
        auto const& best = best_of(series);
        if (fits && !of_sample) {
            text += (text.empty() ? "" : " ") + fit_words(series, rounding);
        } else if (fits && best.error == best.error) {
            text += fmt::format(" Of the sample ({}) no degree fits all designs to better than {} mm.", series.method,
                                figures::scientific(best.error));
        } else if (auto const& finest = series.levels.back(); !of_sample && finest.error == finest.error) {
            text += fmt::format(" Points of a finer grid joined by straight lines, {:.0f} of them, are right to {} mm.",
                                finest.points, figures::scientific(finest.error));
        }
    }
    page.line("{}", text);
}

void conclude_union(Page& page, SeriesList const& series_list)
{
    auto const* united = find(series_list, "union", "union of positions");
    if (united == nullptr)
        return;
    auto const& last = united->levels.back();
    auto const* solve = find(series_list, "tolerance", "solve");
    auto const there =
        solve == nullptr ? std::vector<double>() : at_error(*solve, last.error, &ConvergenceLevel::median);
    page.line("{:.0f} positions leave {} of the flank uncut and take {} and {:.0f} MB.{}", last.value,
              figures::um_text(last.error), figures::duration(last.median), last.memory,
              !there.empty() && has_median(last, solve->levels.back()) && last.median > there.front()
                  ? fmt::format(" `solve` is there after {}, {:.2g} times sooner.", figures::duration(there.front()),
                                last.median / there.front())
                  : "");
}

}  // namespace

void conclude(Page& page, std::string const& name, SeriesList const& series_list, Scene const& scene)
{
    // two of the studies are told with what the scene asks for
    if (name == "polynomial-fit")
        return conclude_fit(page, series_list, scene);
    if (name == "number-type")
        return conclude_type(page, series_list, scene);
    static std::map<std::string, void (*)(Page&, SeriesList const&)> const others{
        {"tolerance", conclude_tolerance}, {"sampling", conclude_sampling}, {"motion-model", conclude_model},
        {"union", conclude_union},         {"roots", conclude_roots},       {"contact-area", conclude_contact},
        {"load", conclude_load},           {"threads", conclude_threads}};
    if (auto const one = others.find(name); one != others.end())
        one->second(page, series_list);
}

}  // namespace hdconj::report
