// SPDX-License-Identifier: GPL-3.0-or-later
// A long computation called from Python: without the interpreter's lock, told of to an observer, and ended by Ctrl-C.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <string>

#include "hdconj/base/stop.hpp"
#include "hdconj/contact.hpp"
#include "hdconj/plan.hpp"

namespace hdconj::python {

/// A computation of any thread: while it lives, SIGINT sets its asked() before it does what it did. Made and destroyed
/// under the lock of the interpreter.
class InterruptWatch
{
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(InterruptWatch const&) = delete;
    InterruptWatch& operator=(InterruptWatch const&) = delete;

    [[nodiscard]] std::atomic<bool>& asked() const { return *asked_; }

  private:
    mutable std::atomic<bool> own_ = false;
    std::atomic<bool>* asked_ = &own_;
    std::atomic<bool>* runs_ = nullptr;
};

/// Tells a Python function what runs. What that throws ends the computation and is thrown again by rethrow().
class Observer
{
  public:
    /// @param function  of a text and of a share 0 ... 1 or None; None: nobody is told
    Observer(nanobind::handle function, std::atomic<bool>& asked) : function_(function), asked_(asked) {}

    void tell(std::string const& what, std::optional<double> share) const;
    [[nodiscard]] StageObserver stages() const;
    [[nodiscard]] Progress shares() const;
    void rethrow() const;

  private:
    nanobind::handle function_;
    std::atomic<bool>& asked_;
    mutable std::optional<nanobind::python_error> thrown_;
};

/// Runs @p compute, which is called with an Observer.
/// @param function  see Observer
template <class Compute>
auto run(nanobind::handle function, Compute const& compute)
{
    InterruptWatch const watch;
    Observer const observer(function, watch.asked());
    try {
        StopScope const scope(&watch.asked());
        nanobind::gil_scoped_release const unlocked;
        auto const begin = std::chrono::steady_clock::now();
        auto result = compute(observer);
        if constexpr (requires { result->seconds; })
            result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result;
    } catch (Stopped const&) {
        observer.rethrow();
        if (PyErr_CheckSignals() != 0)  // in the main thread, by default KeyboardInterrupt
            throw nanobind::python_error();
        throw;
    }
}

}  // namespace hdconj::python
