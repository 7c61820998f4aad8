// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that are found while a loop already runs.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

namespace hdconj {

/// Jobs that one thread of a loop finds while the others are busy with other things, and that whoever is done takes.
/// They do not depend on each other: slot i belongs to job i. One thread calls open() or close(); every thread may call
/// help(), and comes back when no job is left to take; finish() comes after all of them.
class DeferredTasks
{
  public:
    /// @param job  called with 0 ... @p count - 1, each once, in this order, by any thread
    void open(std::size_t count, std::function<void(std::size_t)> job)
    {
        job_ = std::move(job);
        thrown_.resize(count);
        known_.store(true, std::memory_order_release);
        known_.notify_all();
    }

    /// There are none.
    void close() noexcept
    {
        known_.store(true, std::memory_order_release);
        known_.notify_all();
    }

    /// Waits until jobs are known, and takes them. What a job throws is kept.
    void help() noexcept
    {
        known_.wait(false, std::memory_order_acquire);
        for (std::size_t i = next_.fetch_add(1); i < thrown_.size(); i = next_.fetch_add(1))
            try {
                job_(i);
            } catch (...) {
                thrown_[i] = std::current_exception();
            }
    }

    /// Throws again what the lowest job threw, whatever the number of threads.
    void finish() const
    {
        for (std::exception_ptr const& each : thrown_)
            if (each)
                std::rethrow_exception(each);
    }

  private:
    std::atomic<bool> known_ = false;
    std::atomic<std::size_t> next_ = 0;
    std::function<void(std::size_t)> job_;
    std::vector<std::exception_ptr> thrown_;
};

}  // namespace hdconj
