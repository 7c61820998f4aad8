// SPDX-License-Identifier: GPL-3.0-or-later
#include "call.hpp"

namespace hdconj::python {
namespace {

std::atomic<std::atomic<bool>*> watched = nullptr;
std::atomic<void (*)(int)> former_handler = nullptr;
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free);  // used by a signal

void note_interrupt(int number)
{
    if (auto* const asked = watched.load())
        asked->store(true);
    if (auto const former = former_handler.load())
        former(number);
}

}  // namespace

InterruptWatch::InterruptWatch(std::atomic<bool>& asked, bool is_main_thread)
{
    // without a handler of Python's, Ctrl-C ends the process or is ignored, and goes on to do so
    bool const handled = is_main_thread && sigaction(SIGINT, nullptr, &before_) == 0 &&
                         (before_.sa_flags & SA_SIGINFO) == 0 && before_.sa_handler != SIG_DFL &&
                         before_.sa_handler != SIG_IGN && before_.sa_handler != note_interrupt;
    if (!handled)
        return;
    former_handler = before_.sa_handler;
    watched = &asked;
    struct sigaction ours = before_;
    ours.sa_handler = note_interrupt;
    is_set_ = sigaction(SIGINT, &ours, nullptr) == 0;
}

InterruptWatch::~InterruptWatch()
{
    if (!is_set_)
        return;
    sigaction(SIGINT, &before_, nullptr);
    watched = nullptr;
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
