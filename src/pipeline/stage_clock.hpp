// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs the stages that a plan names, and keeps their times.
#pragma once

#include <chrono>
#include <vector>

#include "hdconj/pipeline/solution.hpp"
#include "hdconj/pipeline/solve.hpp"

namespace hdconj::detail {

/// Enters a stage only if the plan has it, tells the observer, and adds up its time.
class StageClock
{
  public:
    StageClock(Plan const& plan, StageObserver const& observer) : plan_(plan), observer_(observer) {}

    /// Runs @p body if @p stage is planned; says whether it ran.
    template<class Body>
    bool run(Stage stage, Body&& body)
    {
        if (!plan_.has(stage))
            return false;
        if (observer_)
            observer_(stage);
        auto const start = std::chrono::steady_clock::now();
        body();
        double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        for (StageTime& time : times_)
        {
            if (time.stage == to_string(stage))
            {
                time.seconds += seconds;
                return true;
            }
        }
        times_.push_back({to_string(stage), seconds});
        return true;
    }

    [[nodiscard]] std::vector<StageTime> const& times() const { return times_; }

  private:
    Plan const& plan_;
    StageObserver const& observer_;
    std::vector<StageTime> times_;
};

}  // namespace hdconj::detail
