// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/study/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hdconj {
namespace {

bool is_number(double value)
{
    return value == value;
}

/// The larger of two numbers, one of which may not be measured.
double worse(double a, double b)
{
    return !is_number(a) || b > a ? b : a;
}

double median_of(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    std::size_t const half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

StudyRung rung_of(std::vector<StudyRecord const*> const& records)
{
    StudyRecord const& first = *records.front();
    StudyRung rung{first.study, first.drive, first.method, first.knob, first.unit, first.value};
    std::vector<double> seconds;
    for (StudyRecord const* record : records)
    {
        rung.error = worse(rung.error, record->largest_error());
        rung.estimate = worse(rung.estimate, record->estimate);
        rung.residual = worse(rung.residual, record->residual);
        rung.memory = worse(rung.memory, record->memory);
        rung.missed = std::max(rung.missed, record->missed);
        rung.extra = std::max(rung.extra, record->extra);
        rung.evaluations = std::max(rung.evaluations, record->evaluations);
        rung.points = std::max(rung.points, record->points);
        rung.threads = std::max(rung.threads, record->threads);
        seconds.push_back(record->seconds);
    }
    rung.median = median_of(seconds);
    rung.least = *std::min_element(seconds.begin(), seconds.end());
    rung.most = *std::max_element(seconds.begin(), seconds.end());
    return rung;
}

/// Collects records by drive or sample, study, method, knob and value, all in the order of their first record.
std::vector<StudyLadder> collected(std::vector<StudyRecord> const& records, std::string const& scene)
{
    struct Open
    {
        StudyLadder ladder;
        std::vector<std::vector<StudyRecord const*>> rungs;
    };
    std::vector<Open> open;
    for (StudyRecord const& record : records)
    {
        std::string const drive = record.drive == scene ? scene : worst_of_sample;
        auto ladder = std::find_if(open.begin(), open.end(), [&](Open const& known) {
            return known.ladder.study == record.study && known.ladder.drive == drive && known.ladder.method == record.method && known.ladder.knob == record.knob;
        });
        if (ladder == open.end())
        {
            open.push_back({{record.study, drive, record.method, record.knob, record.unit, {}}, {}});
            ladder = open.end() - 1;
        }
        auto rung = std::find_if(ladder->rungs.begin(), ladder->rungs.end(), [&](auto const& known) { return known.front()->value == record.value; });
        if (rung == ladder->rungs.end())
        {
            ladder->rungs.emplace_back();
            rung = ladder->rungs.end() - 1;
        }
        rung->push_back(&record);
    }
    std::vector<StudyLadder> ladders;
    for (Open& each : open)
    {
        for (auto const& rung : each.rungs)
        {
            each.ladder.rungs.push_back(rung_of(rung));
            StudyRung& made = each.ladder.rungs.back();
            made.drive = each.ladder.drive;
            std::vector<std::string> names;
            for (StudyRecord const* record : rung)
                names.push_back(record->drive);
            std::sort(names.begin(), names.end());
            for (StudyRecord const* record : rung)
                made.runs = std::max(made.runs, record->repeat + 1);
            made.drives = static_cast<int>(std::unique(names.begin(), names.end()) - names.begin());
        }
        ladders.push_back(std::move(each.ladder));
    }
    return ladders;
}

StudyRung const* same_setting(std::vector<StudyLadder> const& ladders, StudyRung const& rung)
{
    for (StudyLadder const& ladder : ladders)
        if (ladder.drive == worst_of_sample && ladder.study == rung.study && ladder.method == rung.method && ladder.knob == rung.knob)
            for (StudyRung const& other : ladder.rungs)
                if (other.value == rung.value)
                    return &other;
    return nullptr;
}

/// Rungs of the whole program on the scene itself: settings that a user can make.
std::vector<Recommendation> settings(std::vector<StudyLadder> const& ladders)
{
    std::vector<Recommendation> all;
    for (StudyLadder const& ladder : ladders)
    {
        if (ladder.study != "tolerance" || ladder.drive == worst_of_sample)
            continue;
        for (StudyRung const& rung : ladder.rungs)
        {
            StudyRung const* sample = same_setting(ladders, rung);
            all.push_back({rung, false, sample == nullptr ? not_measured : sample->error});
        }
    }
    return all;
}

double worst_error(Recommendation const& setting)
{
    return worse(setting.sample_error, setting.rung.error);
}

}  // namespace

namespace {

/// Rungs whose order counts.
std::vector<StudyRung const*> above(std::vector<StudyRung> const& rungs, double floor)
{
    constexpr double clear_of_floor = 3;
    std::vector<StudyRung const*> clear;
    for (StudyRung const& rung : rungs)
        if (rung.value > 0 && rung.error > 0 && !(is_number(floor) && !(rung.error > clear_of_floor * floor)))
            clear.push_back(&rung);
    return clear;
}

/// Whether the error of @p b is below that of @p a, and not by a hair.
bool falls(StudyRung const& a, StudyRung const& b)
{
    constexpr double hair = 0.95;  // why_no_order() says so
    return b.error < hair * a.error;
}

/// Knobs that an error falls with exponentially have no order.
bool has_power_law(std::string const& knob)
{
    return knob != polynomial_degree;
}

}  // namespace

double observed_order(std::vector<StudyRung> const& rungs, double floor)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (StudyRung const* rung : above(rungs, floor))
    {
        double const x = std::log(rung->value), y = std::log(rung->error);
        ++n;
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    double const spread = n * sxx - sx * sx;
    return n < 3 || !(spread > 0) ? not_measured : (n * sxy - sx * sy) / spread;
}

std::string why_no_order(std::vector<StudyRung> const& rungs, double floor)
{
    std::vector<StudyRung const*> const clear = above(rungs, floor);
    constexpr std::size_t least = 3;
    bool const fall = std::adjacent_find(clear.begin(), clear.end(), [](StudyRung const* a, StudyRung const* b) { return !falls(*a, *b); }) == clear.end();
    return clear.size() < least || fall ? std::string() : "errors do not fall by 5 % at every rung";
}

std::optional<ErrorPerStep> error_per_step(std::vector<StudyRung> const& rungs)
{
    std::vector<StudyRung const*> const all = above(rungs, not_measured);
    auto const best = std::min_element(all.begin(), all.end(), [](StudyRung const* a, StudyRung const* b) { return a->error < b->error; });
    auto last = all.begin();   // until a hair is left
    while (last != best && falls(**last, **(last + 1)))
        ++last;
    if (last == all.begin() || all.empty() || falls(**last, **best))
        return {};
    StudyRung const &from = **all.begin(), &to = **last;
    return ErrorPerStep{std::pow(from.error / to.error, 1 / (to.value - from.value)), to.value};
}

double floor_of(std::vector<StudyRung> const& rungs)
{
    if (rungs.size() < 3)
        return not_measured;
    double const last = rungs.back().error, before = rungs[rungs.size() - 2].error;
    constexpr double tenth = 0.1;
    if (!(last > 0) || !(before > 0) || std::abs(last - before) > tenth * last)
        return not_measured;
    double least = last;
    for (StudyRung const& rung : rungs)
        if (rung.error > 0)
            least = std::min(least, rung.error);
    return least;
}

std::vector<StudyLadder> ladders_of(AccuracyReport const& report)
{
    std::vector<StudyLadder> ladders = collected(report.records, report.scene.drive.name);
    for (StudyLadder& ladder : ladders)
    {
        ladder.floor = floor_of(ladder.rungs);
        if (!has_power_law(ladder.knob))
            continue;
        ladder.no_order = why_no_order(ladder.rungs, ladder.floor);
        if (ladder.no_order.empty())
            ladder.order = observed_order(ladder.rungs, ladder.floor);
    }
    return ladders;
}

/// Errors are told with three digits: chords that are exactly as long as allowed, and the rounding of their ends, still keep what was asked.
constexpr double as_printed = 1.005;

std::optional<Recommendation> fastest_within(std::vector<StudyLadder> const& ladders, double error)
{
    std::optional<Recommendation> best;
    for (Recommendation setting : settings(ladders))
    {
        setting.reaches = worst_error(setting) <= as_printed * error;
        bool const better = !best || (setting.reaches && !best->reaches)
                            || (setting.reaches == best->reaches
                                && (setting.reaches ? setting.rung.median < best->rung.median : worst_error(setting) < worst_error(*best)));
        if (better)
            best = setting;
    }
    return best;
}

std::optional<Recommendation> finest_within(std::vector<StudyLadder> const& ladders, double seconds)
{
    std::optional<Recommendation> best;
    for (Recommendation setting : settings(ladders))
    {
        setting.reaches = setting.rung.median <= seconds;
        bool const better = !best || (setting.reaches && !best->reaches)
                            || (setting.reaches == best->reaches
                                && (setting.reaches ? worst_error(setting) < worst_error(*best) : setting.rung.median < best->rung.median));
        if (better)
            best = setting;
    }
    return best;
}

}  // namespace hdconj
