// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_conclusions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "accuracy_figures.hpp"
#include "hdconj/scene/tolerance_limits.hpp"

namespace hdconj {

using Ladders = std::vector<StudyLadder>;

StudyLadder const* find(Ladders const& ladders, std::string const& study, std::string const& method, bool sample)
{
    for (auto const& ladder : ladders) {
        if (ladder.study == study && ladder.method == method && (ladder.drive == worst_of_sample) == sample) {
            return &ladder;
        }
    }
    return nullptr;
}

namespace {

/// The rung with the smallest error that was measured; else the first.
StudyRung const& best_of(StudyLadder const& ladder)
{
    return *std::min_element(ladder.rungs.begin(), ladder.rungs.end(), [](auto const& a, auto const& b) { return a.error < b.error || (a.error == a.error && b.error != b.error); });
}

/// Times of single runs are compared with no others.
bool has_median(StudyRung const& a, StudyRung const& b)
{
    return a.runs > 1 && b.runs > 1;
}

/// Time of a ladder at an error, between its rungs on log-log lines; nothing outside of it.
std::optional<double> time_at(StudyLadder const& ladder, double error)
{
    for (std::size_t i = 0; i + 1 < ladder.rungs.size(); ++i) {
        auto const& a = ladder.rungs[i];
        auto const& b = ladder.rungs[i + 1];
        if (a.error >= error && b.error <= error && a.error > b.error) {
            double const share = std::log(a.error / error) / std::log(a.error / b.error);
            return a.median * std::pow(b.median / a.median, share);
        }
    }
    return {};
}

std::string um_text(double mm)
{
    return fmt::format("{:.3g} um", mm * 1e3);
}

void conclude_tolerance(Page& page, Ladders const& ladders)
{
    auto const* ladder = find(ladders, "tolerance", "solve");
    if (ladder == nullptr) {
        return;
    }
    auto const &first = ladder->rungs.front(), &last = ladder->rungs.back();
    double over = 0, under = 0;
    for (auto const& rung : ladder->rungs) {
        over = std::max(over, rung.estimate / rung.error);
        under = std::max(under, rung.error / rung.estimate);
    }
    std::string text = ladder->order == ladder->order ? fmt::format("The error follows the tolerance with order {:.2f}, down to {} mm, where the finest rung stands.", ladder->order, scientific(last.error))
                                                      : fmt::format("The error is {} mm with the coarsest tolerance and {} mm with the finest.", scientific(first.error), scientific(last.error));
    text += fmt::format(" The program's own estimate is at most {:.2f} times the true error{}.", over,
                        under > 1 ? fmt::format(", and where chords are long it may be {:.0f} % too small", (under - 1) * 100) : " and never below it");
    if (has_median(first, last)) {
        text += fmt::format(" From {} to {} mm time {} from {} to {}.", scientific(first.error), scientific(last.error), last.median > first.median ? "grows" : "goes", duration(first.median),
                            duration(last.median));
    }
    page.line("{}", text);
}

/// The order of a ladder against its number of points, in words; empty where there is none.
std::string order_in_points(StudyLadder const& ladder)
{
    std::vector<StudyRung> rungs = ladder.rungs;
    for (auto& rung : rungs) {
        rung.value = rung.points;
    }
    double const order = why_no_order(rungs, ladder.floor).empty() ? observed_order(rungs, ladder.floor) : not_measured;
    return order == order ? fmt::format("{:.2f}", -order) : std::string();
}

void conclude_sampling(Page& page, Ladders const& ladders)
{
    auto const* equal = find(ladders, "sampling", "equal steps of u");
    auto const* adaptive = find(ladders, "sampling", "adaptive");
    if (equal == nullptr || adaptive == nullptr) {
        return;
    }
    std::string ratios;
    for (auto const& rung : adaptive->rungs) {
        for (std::size_t i = 0; i + 1 < equal->rungs.size(); ++i) {
            auto const& a = equal->rungs[i];
            auto const& b = equal->rungs[i + 1];
            if (a.error >= rung.error && b.error <= rung.error && a.error > b.error) {
                double const share = std::log(a.error / rung.error) / std::log(a.error / b.error);
                ratios += fmt::format("{}{:.2g} at {} mm", ratios.empty() ? "" : ", ", a.points * std::pow(b.points / a.points, share) / rung.points, scientific(rung.error));
            }
        }
    }
    std::string const of_equal = order_in_points(*equal), of_adaptive = order_in_points(*adaptive);
    auto const told = [](std::string const& order) { return order.empty() ? std::string("no order that could be told") : "order " + order; };
    std::string const text = fmt::format("Against the number of points the error falls with {} for equal steps of u, with {} for the adaptive sampler; chords of a smooth curve allow 2.", told(of_equal), told(of_adaptive));
    page.line("{}{}", text, ratios.empty() ? "" : " Equal steps of u need this many times the points for the same error: " + ratios + ".");
}

void conclude_model(Page& page, Ladders const& ladders)
{
    auto const* first = find(ladders, "motion-model", "first order");
    auto const* material = find(ladders, "motion-model", "material");
    auto const* exact = find(ladders, "motion-model", "exact");
    if (first == nullptr || exact == nullptr) {
        return;
    }
    auto const floor = [](StudyLadder const* ladder) {
        return ladder->floor == ladder->floor ? fmt::format("stays at {}, whatever the tolerance", um_text(ladder->floor)) : fmt::format("comes no closer than {}", um_text(best_of(*ladder).error));
    };
    auto const times = [&](StudyLadder const* ladder) { return fmt::format("{:.2g}", ladder->rungs.back().median / exact->rungs.back().median); };
    std::string text = "First order " + floor(first) + (material == nullptr ? "" : "; material " + floor(material)) + (material == nullptr ? ": a floor" : ": floors") + " of the model, not of the arithmetic.";
    if (has_median(first->rungs.back(), exact->rungs.back())) {
        text += " At equal tolerance " + (material == nullptr ? "it takes " + times(first) : "they take " + times(first) + " and " + times(material)) + " times the time of exact motion.";
    }
    page.line("{}", text);
}

int most_missed(StudyLadder const& ladder)
{
    int most = 0;
    for (auto const& rung : ladder.rungs) {
        most = std::max(most, rung.missed);
    }
    return most;
}

/// What a ladder of degrees came to. @param rounding  below which an error is one [mm]
std::string fit_words(StudyLadder const& ladder, double rounding)
{
    auto const& best = best_of(ladder);
    auto const& last = ladder.rungs.back();
    std::string const model = ladder.method.substr(ladder.method.find(',') + 2);
    if (best.error != best.error) {
        return fmt::format("With {} too few points of the grid have a contact on the flank for a fit.", model == "first order" ? "first-order motion" : model);
    }
    std::string text = fmt::format("With {} the fit is best with degree {:.0f}, {} mm", model == "first order" ? "first-order motion" : model, best.value, scientific(best.error));
    if (best.error < rounding) {
        text += ", which is rounding";
    } else if (ladder.floor == ladder.floor) {
        text += ", and the highest degrees tried differ by less than a tenth";
    } else if (&best == &last) {
        text += ", the highest that was tried";
    } else {
        text += fmt::format("; degree {:.0f}, the highest that was tried, is off by {} mm", last.value, scientific(last.error));
    }
    if (int const missed = most_missed(ladder); missed > 0) {
        text += fmt::format(" ({} of {:.0f} points of the grid have no contact on the flank)", missed, missed + last.points);
    }
    return text + ".";
}

void conclude_fit(Page& page, Ladders const& ladders, Scene const& scene)
{
    constexpr double roundings = 100;   // of the pitch radius: what a fit by powers leaves
    double const rounding = roundings * std::numeric_limits<double>::epsilon() * flexspline_pitch_radius(scene.drive);
    std::string text;
    for (auto const& ladder : ladders) {
        if (ladder.study != "polynomial-fit") {
            continue;
        }
        bool const of_sample = ladder.drive == worst_of_sample, fits = ladder.knob == polynomial_degree;
        auto const& best = best_of(ladder);
        if (fits && !of_sample) {
            text += (text.empty() ? "" : " ") + fit_words(ladder, rounding);
        } else if (fits && best.error == best.error) {
            text += fmt::format(" Of the sample ({}) no degree fits all designs to better than {} mm.", ladder.method, scientific(best.error));
        } else if (auto const& finest = ladder.rungs.back(); !of_sample && finest.error == finest.error) {
            text += fmt::format(" Points of a finer grid joined by straight lines, {:.0f} of them, are right to {} mm.", finest.points, scientific(finest.error));
        }
    }
    page.line("{}", text);
}

void conclude_union(Page& page, Ladders const& ladders)
{
    auto const* united = find(ladders, "union", "union of positions");
    if (united == nullptr) {
        return;
    }
    auto const& last = united->rungs.back();
    auto const* solve = find(ladders, "tolerance", "solve");
    auto const there = solve == nullptr ? std::optional<double>() : time_at(*solve, last.error);
    page.line("{:.0f} positions leave {} of the flank uncut and take {} and {:.0f} MB.{}", last.value, um_text(last.error), duration(last.median), last.memory,
              there && has_median(last, solve->rungs.back()) && last.median > *there ? fmt::format(" `solve` is there after {}, {:.2g} times sooner.", duration(*there), last.median / *there) : "");
}

void conclude_roots(Page& page, Ladders const& ladders)
{
    auto const* closed = find(ladders, "roots", "closed form (arcs)");
    auto const* proved = find(ladders, "roots", "certified (spline)");
    auto const* scan = find(ladders, "roots", "scan and bracket (spline)");
    if (proved == nullptr || scan == nullptr) {
        return;
    }
    auto const& sure = proved->rungs.front();
    auto const complete = std::find_if(scan->rungs.begin(), scan->rungs.end(), [](auto const& rung) { return rung.missed == 0; });
    auto const times = [&](StudyRung const& rung) { return has_median(rung, sure) ? fmt::format(", in {:.2g} times the time", rung.median / sure.median) : std::string(); };
    std::string text;
    if (closed != nullptr) {
        text = fmt::format("In closed form a contact costs {}. ", duration(closed->rungs.front().median / closed->rungs.front().evaluations));
    }
    text += fmt::format("All certified roots of a polynomial piece at one instant cost {}. ", duration(sure.median / sure.evaluations));
    if (complete == scan->rungs.end()) {
        auto const& last = scan->rungs.back();
        text += fmt::format("The scan still misses {} of {:.0f} roots with {:.0f} steps a piece{}.", last.missed, sure.points, last.value, times(last));
    } else {
        bool const stays = std::all_of(complete, scan->rungs.end(), [](auto const& rung) { return rung.missed == 0; });
        text += fmt::format("The scan finds all {:.0f} roots {} {:.0f} steps a piece{} ({} missed with {:.0f}){}, and cannot say so.", sure.points, stays ? "from" : "with", complete->value,
                            stays ? " on" : "", scan->rungs.front().missed, scan->rungs.front().value, times(*complete));
    }
    page.line("{}", text);
}

void conclude_type(Page& page, Ladders const& ladders, Scene const& scene)
{
    auto const* wide = find(ladders, "number-type", "long double");
    auto const* narrow = find(ladders, "number-type", "float");
    auto const* usual = find(ladders, "number-type", "double");
    if (wide == nullptr || narrow == nullptr || usual == nullptr) {
        return;
    }
    auto const& f = narrow->rungs.front();
    auto const& d = usual->rungs.front();
    auto const& l = wide->rungs.front();
    std::string text = fmt::format("Points of a flank's arc are right to {} mm in float, {} mm in double and {} mm in long double.", scientific(f.error), scientific(d.error), scientific(l.error));
    if (has_median(f, d) && has_median(l, d)) {
        text += fmt::format(" Long double takes {:.2g} times the time of double, float {:.2g} times.", l.median / d.median, f.median / d.median);
    }
    page.line("{}{}", text, d.error < least_tolerance(scene.drive) ? " Double is below any tolerance that can be asked for." : "");
}

void conclude_contact(Page& page, Ladders const& ladders)
{
    auto const* slices = find(ladders, "contact-area", "slices");
    auto const* points = find(ladders, "contact-area", "flank points");
    if (slices == nullptr || points == nullptr) {
        return;
    }
    std::string reference;
    if (auto const* own = find(ladders, "contact-area", "reference: lengths in planes"); own != nullptr) {
        auto const& rung = own->rungs.back();
        double const finest = slices->rungs.back().error;
        reference = fmt::format(" Slices are measured against lengths of contact in {:.0f} exact planes, another path whose own error is {} mm^2, {}; "
                                "a table of a reference has its own error in place of a distance from it.",
                                rung.value, scientific(rung.error),
                                finest > rung.error ? fmt::format("1/{:.0f} of that of the most slices tested", std::floor(finest / rung.error)) : "no less than what the most slices tested are off by");
    }
    auto const* sample = find(ladders, "contact-area", "slices", true);
    auto const* of_sample = find(ladders, "contact-area", "reference: lengths in planes", true);
    if (sample != nullptr && of_sample != nullptr) {
        reference += fmt::format(" The worst of {} designs of the sample is right to {} mm^2 with {:.0f} slices, against {:.0f} planes with errors of {} mm^2 or less.", sample->rungs.back().drives,
                                 scientific(sample->rungs.back().error),
                                 sample->rungs.back().value, of_sample->rungs.back().value, scientific(of_sample->rungs.back().error));
    }
    double const of_slices = slices->rungs.back().error, of_points = points->rungs.back().error;
    page.line("The contact area is right to {} mm^2 with {:.0f} slices and to {} mm^2 with {:.0f} flank points{}. "
              "This is no distance from a reference in 50 digits, see the notes below.{}",
              scientific(of_slices), slices->rungs.back().value, scientific(of_points), points->rungs.back().value,
              of_slices > of_points ? "; slices are the knob that counts" : of_points > of_slices ? "; flank points are the knob that counts" : "", reference);
}

void conclude_load(Page& page, Ladders const& ladders)
{
    std::string found, of_sample;
    double widest = 0, least = std::numeric_limits<double>::infinity();   // what the finest rungs leave open, and the smallest distance from one
    for (char const* knob : {"harmonics", "slices", "flank points", "circles"}) {
        std::string const method = std::string(knob) + ": twist";
        if (auto const* ladder = find(ladders, "load", method); ladder != nullptr) {
            auto const& rung = ladder->rungs.back();
            found += fmt::format("{}{:.0f} {} ({}, {})", found.empty() ? "" : ", ", rung.value, knob, scientific(rung.error), duration(rung.median));
            least = std::min(least, rung.error);
        }
        if (auto const* finest = find(ladders, "load", "reference: " + method); finest != nullptr) {
            widest = std::max(widest, finest->rungs.back().estimate);
        }
        if (auto const* ladder = find(ladders, "load", method, true); ladder != nullptr) {
            auto const& rung = ladder->rungs.back();
            of_sample += fmt::format("{}{} with {:.0f} {}", of_sample.empty() ? " The worst of the sample, from the standard grid: " : ", ", scientific(rung.error), rung.value, knob);
        }
    }
    if (found.empty()) {
        return;
    }
    std::string own;
    if (widest > 0) {
        own = fmt::format(" The finest rungs themselves are right to {} of the twist or better, as the program estimates them (tables \"reference\"){}.", scientific(widest),
                          widest > least ? ": these distances say how the twist settles as one count grows, not how far it is from the truth" : "");
    }
    page.line("How far the twist at the rated torque is from that of the finest rung, relative to it, and what it takes: {}.{} This is no distance from a reference in 50 digits, see the notes below.{}",
              found, own, of_sample.empty() ? of_sample : of_sample + ".");
}

void conclude_threads(Page& page, Ladders const& ladders)
{
    auto const* threads = find(ladders, "threads", "solve");
    if (threads == nullptr || threads->rungs.size() < 2) {
        return;
    }
    auto const& one = threads->rungs.front();
    auto const& last = threads->rungs.back();
    auto const* sample = find(ladders, "threads", "solve", true);
    int differ = last.extra;
    for (std::size_t i = 0; sample != nullptr && i < sample->rungs.size(); ++i) {
        differ = std::max(differ, sample->rungs[i].extra);
    }
    auto const* apart = find(ladders, "threads", "solves side by side");
    std::string const same = differ > 0 ? fmt::format("{} points differ", differ) : fmt::format("no bit of the outline differs{}", sample == nullptr ? "" : ", of this drive or any design of the sample");
    if (!has_median(one, last)) {
        page.line("On 1 thread and on {:.0f}, of single runs, whose times are not compared: {}.", last.value, same);
        return;
    }
    std::string const given = apart == nullptr || apart->rungs.size() < 2
        ? std::string()
        : fmt::format(", where the machine gave {:.2f}: so much more was done in the same minutes by {:.0f} solves side by side, which share nothing else",
                      apart->rungs.front().median / apart->rungs.back().median, last.value);
    page.line("{:.0f} threads are {:.2f} times as fast as one{}; {}.", last.value, one.median / last.median, given, same);
}

}  // namespace

void conclude(Page& page, std::string const& name, Ladders const& ladders, Scene const& scene)
{
    // two of the studies are told with what the scene asks for
    if (name == "polynomial-fit") {
        return conclude_fit(page, ladders, scene);
    }
    if (name == "number-type") {
        return conclude_type(page, ladders, scene);
    }
    static std::map<std::string, void (*)(Page&, Ladders const&)> const others{
        {"tolerance", conclude_tolerance}, {"sampling", conclude_sampling}, {"motion-model", conclude_model}, {"union", conclude_union},
        {"roots", conclude_roots}, {"contact-area", conclude_contact}, {"load", conclude_load}, {"threads", conclude_threads}};
    if (auto const one = others.find(name); one != others.end()) {
        one->second(page, ladders);
    }
}

}  // namespace hdconj
