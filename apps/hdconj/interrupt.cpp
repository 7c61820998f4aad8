// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.hpp"

#include <unistd.h>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string_view>

namespace hdconj::cli {
namespace {

std::atomic<bool> stopped = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // may be set by a signal

void note_interrupt(int)
{
    constexpr std::string_view words =
        "\nhdconj: stopping after what is being computed; Ctrl-C again ends at once, without a result\n";
    stopped = true;
    std::signal(SIGINT, SIG_DFL);
    [[maybe_unused]] auto const written = ::write(STDERR_FILENO, words.data(), words.size());
}

}  // namespace

void stop_at_interrupt()
{
    if (std::signal(SIGINT, note_interrupt) == SIG_IGN)
        std::signal(SIGINT, SIG_IGN);
}

bool is_stopped()
{
    return stopped;
}

void end_by_interrupt()
{
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
    std::abort();
}

}  // namespace hdconj::cli
