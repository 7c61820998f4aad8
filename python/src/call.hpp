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

/// While it lives, SIGINT sets @p asked before it does what it did. One object at a time, in Python's main thread,
/// where Python runs the handlers of signals.
class InterruptWatch
{
  public:
    InterruptWatch(std::atomic<bool>& asked, bool is_main_thread);
    ~InterruptWatch();
    InterruptWatch(InterruptWatch const&) = delete;
    InterruptWatch& operator=(InterruptWatch const&) = delete;

  private:
    struct sigaction before_ = {};
    bool is_set_ = false;
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
/// @param function        see Observer
/// @param is_main_thread  of Python
template <class Compute>
auto run(nanobind::handle function, bool is_main_thread, Compute const& compute)
{
    std::atomic<bool> asked = false;
    Observer const observer(function, asked);
    try {
        InterruptWatch const watch(asked, is_main_thread);
        StopScope const scope(&asked);
        nanobind::gil_scoped_release const unlocked;
        auto const begin = std::chrono::steady_clock::now();
        auto result = compute(observer);
        if constexpr (requires { result->seconds; })
            result->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result;
    } catch (Stopped const&) {
        observer.rethrow();
        if (PyErr_CheckSignals() != 0)  // by default KeyboardInterrupt
            throw nanobind::python_error();
        throw;
    }
}

}  // namespace hdconj::python
