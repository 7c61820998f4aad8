// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <tuple>
#include <utility>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#include <pthread.h>

#include "separate_processors.hpp"
#endif

#include "hdconj/base/stop.hpp"

namespace hdconj {

#ifdef _OPENMP
namespace {

/// Whether this process is a copy, by fork(), of one that had a team of threads. A copy has one thread; a loop of
/// OpenMP there waits for ever for the others.
std::atomic<bool> team_is_lost = false;

/// To be called before a team begins.
void notice_forks()
{
    [[maybe_unused]] static int const noticed =
        pthread_atfork(nullptr, nullptr, [] { team_is_lost.store(true, std::memory_order_relaxed); });
}

}  // namespace
#endif

int thread_count(int requested)
{
#ifdef _OPENMP
    if (team_is_lost.load(std::memory_order_relaxed))
        return 1;
    return requested > 0 ? requested : std::max(1, std::min(omp_get_num_procs(), omp_get_max_threads()));
#else
    (void)requested;
    return 1;
#endif
}

namespace {

void (*prepare_thread)() noexcept = nullptr;

/// A loop's iterations, handed out in order, block by block.
class Blocks
{
  public:
    Blocks(std::size_t count, std::size_t threads) : count_(count), threads_(threads) {}

    /// Takes the next block; an empty one: there is none left.
    std::pair<std::size_t, std::size_t> take() noexcept
    {
        std::size_t begin = next_.load(std::memory_order_relaxed), end = 0;
        do
            end = begin + size(count_ - begin);
        while (!next_.compare_exchange_weak(begin, end, std::memory_order_relaxed));
        return {begin, end};
    }

  private:
    /// Iterations may differ much in work, and other processes may hold a thread up: a share of what is left, so that
    /// the last ones are handed out one by one.
    [[nodiscard]] std::size_t size(std::size_t left) const
    {
        constexpr std::size_t blocks_a_thread = 16;
        if (threads_ == 1)
            return left;
        return std::min(left, std::max<std::size_t>(1, left / (threads_ * blocks_a_thread)));
    }

    std::size_t count_;
    std::size_t threads_;
    std::atomic<std::size_t> next_ = 0;
};

/// What one thread does: it takes the next block of the loop until there is none; stops at its first exception. Blocks
/// are taken in order, so all iterations before the lowest exception have been taken, and run up to exceptions of their
/// own: the lowest of all is among those kept.
struct Worker
{
    std::size_t failed_at = 0;
    std::exception_ptr thrown;

    void run(Blocks& blocks, std::function<void(std::size_t)> const& body, std::atomic<bool> const* stop_asked) noexcept
    {
        std::size_t i = 0;
        StopScope const scope(stop_asked);
        try {
            for (auto [begin, end] = blocks.take(); begin < end; std::tie(begin, end) = blocks.take())
                for (i = begin; i < end; ++i) {
                    if (stop_asked != nullptr)
                        end_if_stopped();
                    body(i);
                }
        } catch (...) {
            thrown = std::current_exception();
            failed_at = i;
        }
    }
};

}  // namespace

void at_thread_start(void (*prepare)() noexcept)
{
    prepare_thread = prepare;
}

#ifdef _OPENMP
namespace {

/// A thread of the team that is not the one that begins the loop, before its first iteration.
void begin_thread(SeparateProcessors& processors) noexcept
{
    processors.settle();
    thread_local bool prepared = false;
    if (prepared || prepare_thread == nullptr)
        return;
    prepare_thread();
    prepared = true;
}

}  // namespace
#endif

void parallel_for(std::size_t count, int threads, std::size_t grain, std::function<void(std::size_t)> const& body)
{
    std::size_t const worth = std::max<std::size_t>(1, count / std::max<std::size_t>(1, grain));
    std::size_t const team = std::min(static_cast<std::size_t>(thread_count(threads)), worth);
    std::vector<Worker> workers(team);
    Blocks blocks(count, team);
    auto const* const stop_asked = StopScope::of_this_thread();
    if (team == 1) {
        workers[0].run(blocks, body, stop_asked);
    } else {
        auto const n = static_cast<int>(team);
#ifdef _OPENMP
        notice_forks();
        SeparateProcessors processors;
#pragma omp parallel for num_threads(n) schedule(static, 1)
#endif
        for (int k = 0; k < n; ++k) {
#ifdef _OPENMP
            // its first share: a thread gets several where there are fewer than were asked for
            if (k > 0 && k == omp_get_thread_num())
                begin_thread(processors);
#endif
            workers[static_cast<std::size_t>(k)].run(blocks, body, stop_asked);
        }
    }
    Worker const* first = nullptr;
    for (Worker const& worker : workers)
        if (worker.thrown && (first == nullptr || worker.failed_at < first->failed_at))
            first = &worker;
    if (first != nullptr)
        std::rethrow_exception(first->thrown);
}

}  // namespace hdconj
