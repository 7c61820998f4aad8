// SPDX-License-Identifier: GPL-3.0-or-later
#include "convergence_series.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/moments.hpp"

namespace hdconj::accuracy {
namespace {

double median_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    std::size_t const half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// The larger of two numbers, one of which may not be measured.
double worse(double a, double b)
{
    return std::isnan(a) || b > a ? b : a;
}

ConvergenceLevel level_of(std::vector<StudyRecord const*> const& records)
{
    StudyRecord const& first = *records.front();
    ConvergenceLevel level{first.study, first.drive, first.method, first.knob, first.unit, first.value};
    std::vector<double> seconds;
    for (StudyRecord const* record : records) {
        level.error = worse(level.error, record->largest_error());
        level.estimate = worse(level.estimate, record->estimate);
        level.normal_speed = worse(level.normal_speed, record->normal_speed);
        level.memory = worse(level.memory, record->memory);
        level.missed = std::max(level.missed, record->missed);
        level.extra = std::max(level.extra, record->extra);
        level.evaluations = std::max(level.evaluations, record->evaluations);
        level.points = std::max(level.points, record->points);
        level.threads = std::max(level.threads, record->threads);
        seconds.push_back(record->seconds);
    }
    level.median = median_of(seconds);
    level.least = *std::min_element(seconds.begin(), seconds.end());
    level.most = *std::max_element(seconds.begin(), seconds.end());
    return level;
}

/// Collects records by drive or sample, study, method, knob and value, all in the order of their first record.
std::vector<ConvergenceSeries> collected(std::vector<StudyRecord> const& records, std::string const& scene)
{
    struct Open
    {
        ConvergenceSeries series;
        std::vector<std::vector<StudyRecord const*>> levels;
    };
    std::vector<Open> open;
    for (StudyRecord const& record : records) {
        std::string const drive = record.drive == scene ? scene : worst_of_sample;
        auto series = std::find_if(open.begin(), open.end(), [&](Open const& known) {
            return known.series.study == record.study && known.series.drive == drive &&
                   known.series.method == record.method && known.series.knob == record.knob;
        });
        if (series == open.end()) {
            open.push_back({{record.study, drive, record.method, record.knob, record.unit, {}}, {}});
            series = open.end() - 1;
        }
        auto level = std::find_if(series->levels.begin(), series->levels.end(),
                                  [&](auto const& known) { return known.front()->value == record.value; });
        if (level == series->levels.end()) {
            series->levels.emplace_back();
            level = series->levels.end() - 1;
        }
        level->push_back(&record);
    }
    std::vector<ConvergenceSeries> series_list;
    for (Open& each : open) {
        for (auto const& level : each.levels) {
            each.series.levels.push_back(level_of(level));
            ConvergenceLevel& made = each.series.levels.back();
            made.drive = each.series.drive;
            std::vector<std::string> names;
            for (StudyRecord const* record : level)
                names.push_back(record->drive);
            std::sort(names.begin(), names.end());
            for (StudyRecord const* record : level)
                made.runs = std::max(made.runs, record->repeat + 1);
            made.drives = static_cast<int>(std::unique(names.begin(), names.end()) - names.begin());
        }
        series_list.push_back(std::move(each.series));
    }
    return series_list;
}

ConvergenceLevel const* same_setting(std::vector<ConvergenceSeries> const& series_list, ConvergenceLevel const& level)
{
    for (ConvergenceSeries const& series : series_list)
        if (series.drive == worst_of_sample && series.study == level.study && series.method == level.method &&
            series.knob == level.knob)
            for (ConvergenceLevel const& other : series.levels)
                if (other.value == level.value)
                    return &other;
    return nullptr;
}

/// Levels of the whole program on the scene itself: settings that a user can make.
std::vector<Recommendation> settings(std::vector<ConvergenceSeries> const& series_list)
{
    std::vector<Recommendation> all;
    for (ConvergenceSeries const& series : series_list) {
        if (series.study != "tolerance" || series.drive == worst_of_sample)
            continue;
        for (ConvergenceLevel const& level : series.levels) {
            ConvergenceLevel const* sample = same_setting(series_list, level);
            all.push_back({level, false, sample == nullptr ? not_measured : sample->error});
        }
    }
    return all;
}

double worst_error(Recommendation const& setting)
{
    return worse(setting.sample_error, setting.level.error);
}

double seconds_of(Recommendation const& setting)
{
    return setting.level.median;
}

/// Of the settings whose @p bounded is @p most or less the one with the least @p other; where none is, the one whose
/// @p bounded is least.
template <class Figure>
std::optional<Recommendation> best_within(std::vector<ConvergenceSeries> const& series_list, Figure const& bounded,
                                          double most, Figure const& other)
{
    std::optional<Recommendation> best;
    for (Recommendation setting : settings(series_list)) {
        setting.reaches = bounded(setting) <= most;
        Figure const& figure = setting.reaches ? other : bounded;
        if (!best || (setting.reaches && !best->reaches) ||
            (setting.reaches == best->reaches && figure(setting) < figure(*best)))
            best = setting;
    }
    return best;
}

/// Levels whose order counts.
std::vector<ConvergenceLevel const*> above(std::vector<ConvergenceLevel> const& levels, double floor)
{
    constexpr double clear_of_floor = 3;
    std::vector<ConvergenceLevel const*> clear;
    for (ConvergenceLevel const& level : levels)
        if (level.value > 0 && level.error > 0 && (std::isnan(floor) || level.error > clear_of_floor * floor))
            clear.push_back(&level);
    return clear;
}

/// Whether the error of @p b is below that of @p a, and not by a hair.
bool falls(ConvergenceLevel const& a, ConvergenceLevel const& b)
{
    constexpr double hair = 0.95;  // why_no_order() says so
    return b.error < hair * a.error;
}

}  // namespace

double observed_order(std::vector<ConvergenceLevel> const& levels, double floor)
{
    constexpr std::size_t least = 3;
    std::vector<double> x, y;
    for (ConvergenceLevel const* level : above(levels, floor)) {
        x.push_back(std::log(level->value));
        y.push_back(std::log(level->error));
    }
    numeric::Moments const line = numeric::moments(x, y);
    return x.size() < least || !(line.xx > 0) ? not_measured : line.xy / line.xx;
}

std::string why_no_order(std::vector<ConvergenceLevel> const& levels, double floor)
{
    std::vector<ConvergenceLevel const*> const clear = above(levels, floor);
    constexpr std::size_t least = 3;
    bool const fall = std::ranges::adjacent_find(clear, [](ConvergenceLevel const* a, ConvergenceLevel const* b) {
                          return !falls(*a, *b);
                      }) == clear.end();
    return clear.size() < least || fall ? std::string() : "errors do not fall by 5 % at every level";
}

std::optional<ErrorPerStep> error_per_step(std::vector<ConvergenceLevel> const& levels)
{
    std::vector<ConvergenceLevel const*> const all = above(levels, not_measured);
    auto const best = std::ranges::min_element(
        all, [](ConvergenceLevel const* a, ConvergenceLevel const* b) { return a->error < b->error; });
    auto last = all.begin();  // until a hair is left
    while (last != best && falls(**last, **(last + 1)))
        ++last;
    if (last == all.begin() || all.empty() || falls(**last, **best))
        return {};
    ConvergenceLevel const &from = **all.begin(), &to = **last;
    return ErrorPerStep{std::pow(from.error / to.error, 1 / (to.value - from.value)), to.value};
}

double floor_of(std::vector<ConvergenceLevel> const& levels)
{
    if (levels.size() < 3)
        return not_measured;
    double const last = levels.back().error, before = levels[levels.size() - 2].error;
    constexpr double tenth = 0.1;
    if (!(last > 0) || !(before > 0) || std::abs(last - before) > tenth * last)
        return not_measured;
    double least = last;
    for (ConvergenceLevel const& level : levels)
        if (level.error > 0)
            least = std::min(least, level.error);
    return least;
}

std::vector<ConvergenceSeries> convergence_series(AccuracyReport const& report)
{
    std::vector<ConvergenceSeries> series_list = collected(report.records, report.scene.drive.name);
    for (ConvergenceSeries& series : series_list) {
        series.floor = floor_of(series.levels);
        if (series.knob == polynomial_degree)  // which has no power law
            continue;
        series.no_order = why_no_order(series.levels, series.floor);
        if (series.no_order.empty())
            series.order = observed_order(series.levels, series.floor);
    }
    return series_list;
}

/// Errors are told with three digits: chords that are exactly as long as allowed, and the rounding of their ends, still
/// keep what was asked.
constexpr double as_printed = 1.005;

std::optional<Recommendation> fastest_within(std::vector<ConvergenceSeries> const& series_list, double error)
{
    return best_within(series_list, worst_error, as_printed * error, seconds_of);
}

std::optional<Recommendation> finest_within(std::vector<ConvergenceSeries> const& series_list, double seconds)
{
    return best_within(series_list, seconds_of, seconds, worst_error);
}

}  // namespace hdconj::accuracy
