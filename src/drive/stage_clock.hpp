// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stages that a plan names, and keeps their times.
#pragma once

#include <algorithm>
#include <chrono>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "hdconj/plan.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::drive {

/// Enters a stage only if the plan has it, tells the observer, and adds up its time.
class StageClock
{
  public:
    /// @param plan  must outlive the clock
    StageClock(Plan const& plan, StageObserver observer) : plan_(plan), observer_(std::move(observer)) {}

    /// Runs @p body if @p stage is planned; says whether it ran.
    template <class Body>
    bool run(Stage stage, Body&& body)
    {
        if (!plan_.has(stage))
            return false;
        if (observer_)
            observer_(stage);
        add(stage, seconds_of(body));
        return true;
    }

    /// What @p make builds in a planned @p stage.
    template <class Make>
    [[nodiscard]] auto value_of(Stage stage, Make const& make)
    {
        std::optional<decltype(make())> result;
        run(stage, [&] { result.emplace(make()); });
        return std::move(*result);
    }

    /// Runs @p body, which runs stages itself; what of its time is none of theirs is added to @p stage's.
    template <class Body>
    void run_rest(Stage stage, Body&& body)
    {
        double const before = total();
        double const seconds = seconds_of(body);
        add(stage, std::max(0.0, seconds - (total() - before)));
    }

    [[nodiscard]] std::vector<StageTime> const& times() const { return times_; }

  private:
    template <class Body>
    [[nodiscard]] static double seconds_of(Body&& body)
    {
        auto const start = std::chrono::steady_clock::now();
        body();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

    void add(Stage stage, double seconds)
    {
        auto const same = std::find_if(times_.begin(), times_.end(),
                                       [&](StageTime const& time) { return time.stage == to_string(stage); });
        if (same == times_.end())
            times_.push_back({to_string(stage), seconds});
        else
            same->seconds += seconds;
    }

    [[nodiscard]] double total() const
    {
        return std::accumulate(times_.begin(), times_.end(), 0.0,
                               [](double sum, StageTime const& time) { return sum + time.seconds; });
    }

    Plan const& plan_;
    StageObserver observer_;
    std::vector<StageTime> times_;
};

}  // namespace hdconj::drive
