// SPDX-License-Identifier: GPL-3.0-or-later
// A loop whose slots do not depend on each other, spread over threads.
#pragma once

#include <cstddef>
#include <functional>

namespace hdconj {

/// Number of threads meant by @p requested, 0: all cores, at most as many as OMP_NUM_THREADS says. It is 1 in a fork()
/// of a process that had a team of threads.
[[nodiscard]] int thread_count(int requested);

/// What every thread that a loop starts does first, once; of a program that has something to prepare for its threads.
/// Absent: nothing. To be set before the first loop, by one thread. @p prepare must not throw.
void at_thread_start(void (*prepare)() noexcept);

/// Calls @p body(i) for i = 0 ... count - 1. Slot i belongs to iteration i: a body that writes only there gives the
/// same bits for any number of threads. Exceptions do not cross the parallel region: the one of the lowest i is
/// thrown again after the loop. Ends with Stopped where the calling thread is asked to (StopScope).
/// @param grain  fewest iterations worth a thread: about a millisecond of work. Waking a thread is cheap, but on a
///               machine that has other work its share may wait for a time slice, and everybody waits for it.
void parallel_for(std::size_t count, int threads, std::size_t grain, std::function<void(std::size_t)> const& body);

}  // namespace hdconj
