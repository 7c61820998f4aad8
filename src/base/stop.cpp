// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/base/stop.hpp"

#include <utility>

namespace hdconj {
namespace {

thread_local std::atomic<bool> const* stop_asked = nullptr;

}  // namespace

StopScope::StopScope(std::atomic<bool> const* asked) noexcept : before_(std::exchange(stop_asked, asked)) {}

StopScope::~StopScope()
{
    stop_asked = before_;
}

std::atomic<bool> const* StopScope::of_this_thread() noexcept
{
    return stop_asked;
}

void end_if_stopped()
{
    if (stop_asked != nullptr && stop_asked->load(std::memory_order_relaxed))
        throw Stopped();
}

}  // namespace hdconj
