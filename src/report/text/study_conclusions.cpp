// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_conclusions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accuracy/convergence_series.hpp"
#include "figures/accuracy_figures.hpp"
#include "scene/tolerance_limits.hpp"

namespace hdconj::report {

void conclude_roots(Page& page, SeriesList const& series_list)
{
    auto const* closed = find(series_list, "roots", "closed form (arcs)");
    auto const* proved = find(series_list, "roots", "certified (spline)");
    auto const* scan = find(series_list, "roots", "scan and bracket (spline)");
    if (proved == nullptr || scan == nullptr)
        return;
    auto const& sure = proved->levels.front();
    auto const complete =
        std::find_if(scan->levels.begin(), scan->levels.end(), [](auto const& level) { return level.missed == 0; });
    auto const times = [&](ConvergenceLevel const& level) {
        return has_median(level, sure) ? fmt::format(", in {:.2g} times the time", level.median / sure.median)
                                       : std::string();
    };
    std::string text;
    if (closed != nullptr) {
        text = fmt::format("In closed form a contact costs {}. ",
                           figures::duration(closed->levels.front().median / closed->levels.front().evaluations));
    }
    text += fmt::format("All certified roots of a polynomial piece at one instant cost {}. ",
                        figures::duration(sure.median / sure.evaluations));
    if (complete == scan->levels.end()) {
        auto const& last = scan->levels.back();
        text += fmt::format("The scan still misses {} of {:.0f} roots with {:.0f} steps a piece{}.", last.missed,
                            sure.points, last.value, times(last));
    } else {
        bool const stays =
            std::all_of(complete, scan->levels.end(), [](auto const& level) { return level.missed == 0; });
        text += fmt::format(
            "The scan finds all {:.0f} roots {} {:.0f} steps a piece{} ({} missed with {:.0f}){}, and cannot say so.",
            sure.points, stays ? "from" : "with", complete->value, stays ? " on" : "", scan->levels.front().missed,
            scan->levels.front().value, times(*complete));
    }
    page.line("{}", text);
}

void conclude_type(Page& page, SeriesList const& series_list, Scene const& scene)
{
    auto const* wide = find(series_list, "number-type", "long double");
    auto const* narrow = find(series_list, "number-type", "float");
    auto const* usual = find(series_list, "number-type", "double");
    if (wide == nullptr || narrow == nullptr || usual == nullptr)
        return;
    auto const& f = narrow->levels.front();
    auto const& d = usual->levels.front();
    auto const& l = wide->levels.front();
    std::string text =
        fmt::format("Points of a flank's arc are right to {} mm in float, {} mm in double and {} mm in long double.",
                    figures::scientific(f.error), figures::scientific(d.error), figures::scientific(l.error));
    if (has_median(f, d) && has_median(l, d)) {
        text += fmt::format(" Long double takes {:.2g} times the time of double, float {:.2g} times.",
                            l.median / d.median, f.median / d.median);
    }
    page.line(
        "{}{}", text,
        d.error < scene::least_tolerance(scene.drive) ? " Double is below any tolerance that can be asked for." : "");
}

void conclude_contact(Page& page, SeriesList const& series_list)
{
    auto const* slices = find(series_list, "contact-area", "slices");
    auto const* points = find(series_list, "contact-area", "flank points");
    if (slices == nullptr || points == nullptr)
        return;
    std::string reference;
    if (auto const* own = find(series_list, "contact-area", "reference: lengths in planes"); own != nullptr) {
        auto const& level = own->levels.back();
        double const finest = slices->levels.back().error;
        reference = fmt::format(
            " Slices are measured against lengths of contact in {:.0f} exact planes, another path whose own error is "
            "{} mm^2, {}; a table of a reference has its own error in place of a distance from it.",
            level.value, figures::scientific(level.error),
            finest > level.error
                ? fmt::format("1/{:.0f} of that of the most slices tested", std::floor(finest / level.error))
                : "no less than what the most slices tested are off by");
    }
    auto const* sample = find(series_list, "contact-area", "slices", true);
    auto const* of_sample = find(series_list, "contact-area", "reference: lengths in planes", true);
    if (sample != nullptr && of_sample != nullptr) {
        reference += fmt::format(
            " The worst of {} designs of the sample is right to {} mm^2 with {:.0f} slices, against {:.0f} planes with "
            "errors of {} mm^2 or less.",
            sample->levels.back().drives, figures::scientific(sample->levels.back().error), sample->levels.back().value,
            of_sample->levels.back().value, figures::scientific(of_sample->levels.back().error));
    }
    double const of_slices = slices->levels.back().error, of_points = points->levels.back().error;
    page.line(
        "The contact area is right to {} mm^2 with {:.0f} slices and to {} mm^2 with {:.0f} flank points{}. "
        "This is no distance from a reference in 50 digits, see the notes below.{}",
        figures::scientific(of_slices), slices->levels.back().value, figures::scientific(of_points),
        points->levels.back().value,
        of_slices > of_points   ? "; the number of slices counts most"
        : of_points > of_slices ? "; the number of flank points counts most"
                                : "",
        reference);
}

void conclude_load(Page& page, SeriesList const& series_list)
{
    std::string found, of_sample;
    double widest = 0, least = std::numeric_limits<double>::infinity();  // what the finest levels leave open, and the
                                                                         // smallest distance from one
    for (char const* knob : {"harmonics", "slices", "flank points", "circles"}) {
        std::string const method = std::string(knob) + ": twist";
        if (auto const* series = find(series_list, "load", method); series != nullptr) {
            auto const& level = series->levels.back();
            found += fmt::format("{}{:.0f} {} ({}, {})", found.empty() ? "" : ", ", level.value, knob,
                                 figures::scientific(level.error), figures::duration(level.median));
            least = std::min(least, level.error);
        }
        if (auto const* finest = find(series_list, "load", "reference: " + method); finest != nullptr)
            widest = std::max(widest, finest->levels.back().estimate);
        if (auto const* series = find(series_list, "load", method, true); series != nullptr) {
            auto const& level = series->levels.back();
            of_sample += fmt::format("{}{} with {:.0f} {}",
                                     of_sample.empty() ? " The worst of the sample, from the standard grid: " : ", ",
                                     figures::scientific(level.error), level.value, knob);
        }
    }
    if (found.empty())
        return;
    std::string own;
    if (widest > 0) {
        own = fmt::format(
            " The finest levels themselves are right to {} of the twist or better, as the program estimates them "
            "(tables \"reference\"){}.",
            figures::scientific(widest),
            widest > least
                ? ": these distances say how the twist converges as one count grows, not how far it is from the truth"
                : "");
    }
    page.line(
        "How far the twist at the rated torque is from that of the finest level, relative to it, and what it takes: "
        "{}.{} This is no distance from a reference in 50 digits, see the notes below.{}",
        found, own, of_sample.empty() ? of_sample : of_sample + ".");
}

void conclude_threads(Page& page, SeriesList const& series_list)
{
    auto const* threads = find(series_list, "threads", "solve");
    if (threads == nullptr || threads->levels.size() < 2)
        return;
    auto const& one = threads->levels.front();
    auto const& last = threads->levels.back();
    auto const* sample = find(series_list, "threads", "solve", true);
    int differ = last.extra;
    for (std::size_t i = 0; sample != nullptr && i < sample->levels.size(); ++i)
        differ = std::max(differ, sample->levels[i].extra);
    auto const* apart = find(series_list, "threads", "solves side by side");
    std::string const same = differ > 0
                                 ? fmt::format("{} points differ", differ)
                                 : fmt::format("no bit of the outline differs{}",
                                               sample == nullptr ? "" : ", of this drive or any design of the sample");
    if (!has_median(one, last)) {
        page.line("On 1 thread and on {:.0f}, of single runs, whose times are not compared: {}.", last.value, same);
        return;
    }
    std::string const given = apart == nullptr || apart->levels.size() < 2
                                  ? std::string()
                                  : fmt::format(
                                        ", where the machine gave {:.2f}: so much more was done in the same minutes by "
                                        "{:.0f} solves side by side, which have nothing else in common",
                                        apart->levels.front().median / apart->levels.back().median, last.value);
    page.line("{:.0f} threads are {:.2f} times as fast as one{}; {}.", last.value, one.median / last.median, given,
              same);
}

}  // namespace hdconj::report
