// SPDX-License-Identifier: GPL-3.0-or-later
#include "call.hpp"

#include <algorithm>
#include <array>

namespace hdconj::python {
namespace {

/// A computation that may run. None is ever freed: a signal may come at any time.
struct Computation
{
    std::atomic<bool> runs = false;
    std::atomic<bool> asked = false;  ///< to end
};

std::array<Computation, 1024> computations;  // more at a time are not told
std::atomic<void (*)(int)> former_handler = nullptr;
static_assert(std::atomic<bool>::is_always_lock_free &&
              std::atomic<void (*)(int)>::is_always_lock_free);  // in a signal

// Under the lock of the interpreter:
struct sigaction former = {};
int watches = 0;

void note_interrupt(int number)
{
    for (Computation& each : computations)
        if (each.runs)
            each.asked = true;
    if (auto const handler = former_handler.load())
        handler(number);
}

/// What SIGINT calls; null: no function that takes its number.
auto present_handler(struct sigaction& present)
{
    bool const is_simple = sigaction(SIGINT, nullptr, &present) == 0 && (present.sa_flags & SA_SIGINFO) == 0 &&
                           present.sa_handler != SIG_DFL && present.sa_handler != SIG_IGN;
    return is_simple ? present.sa_handler : nullptr;
}

/// Puts note_interrupt() before the handler that Python has set. Without one Ctrl-C ends the process or is ignored, and
/// goes on to do so.
void listen()
{
    struct sigaction present = {};
    auto* const handler = present_handler(present);
    if (handler == nullptr || handler == note_interrupt)
        return;
    former = present;
    former_handler = handler;
    present.sa_handler = note_interrupt;
    sigaction(SIGINT, &present, nullptr);
}

}  // namespace

InterruptWatch::InterruptWatch()
{
    auto const idle = std::ranges::find_if(computations, [](Computation const& each) { return !each.runs; });
    if (idle != computations.end()) {
        idle->asked = false;
        idle->runs = true;
        asked_ = &idle->asked;
        runs_ = &idle->runs;
    }
    ++watches;
    listen();
}

InterruptWatch::~InterruptWatch()
{
    if (runs_ != nullptr)
        *runs_ = false;
    struct sigaction present = {};
    if (--watches == 0 && present_handler(present) == note_interrupt)
        sigaction(SIGINT, &former, nullptr);
}

void Observer::tell(std::string const& what, std::optional<double> share) const
{
    if (function_.is_none())
        return;
    nanobind::gil_scoped_acquire const locked;
    try {
        if (thrown_)
            return;
        if (share)
            function_(what.c_str(), *share);
        else
            function_(what.c_str(), nanobind::none());
    } catch (nanobind::python_error& error) {
        thrown_.emplace(std::move(error));
        asked_ = true;
    }
}

StageObserver Observer::stages() const
{
    if (function_.is_none())
        return {};
    return [this](Stage stage) { tell(to_string(stage), std::nullopt); };
}

Progress Observer::shares() const
{
    if (function_.is_none())
        return {};
    return [this](std::string const& what, double share) { tell(what, share); };
}

void Observer::rethrow() const
{
    if (thrown_)
        throw nanobind::python_error(std::move(*thrown_));
}

}  // namespace hdconj::python
