// SPDX-License-Identifier: GPL-3.0-or-later
// Threads of loops: what each does first, the processors they run on, and how they are stopped.
#include <atomic>
#include <chrono>
#include <set>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

#include "base/separate_processors.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/base/stop.hpp"
#include "support/catch.hpp"

namespace hdconj::test::threads_of_loops_cases {

namespace {

std::atomic<int> prepared = 0;

/// Until all @p threads are in the loop, so that each of them has an iteration; not for ever, should there be fewer.
void meet(std::atomic<int>& there, int threads)
{
    constexpr std::chrono::seconds patience{2};
    auto const end = std::chrono::steady_clock::now() + patience;
    ++there;
    while (there < threads && std::chrono::steady_clock::now() < end)
        std::this_thread::yield();
}

}  // namespace

TEST_CASE("a thread that a loop starts prepares itself once, the one that begins the loop never", "[numeric][parallel]")
{
    constexpr int threads = 3;
    std::set<std::thread::id> others;
    prepared = 0;
    at_thread_start([]() noexcept { ++prepared; });
    for (int loop = 0; loop < 3; ++loop) {
        std::atomic<int> there = 0;
        std::vector<std::thread::id> by(threads);
        parallel_for(by.size(), threads, 1, [&](std::size_t i) {
            by[i] = std::this_thread::get_id();
            meet(there, threads);
        });
        others.insert(by.begin(), by.end());
        others.erase(std::this_thread::get_id());
        CHECK(prepared == static_cast<int>(others.size()));
    }
    at_thread_start(nullptr);
}

#ifdef __linux__

TEST_CASE("a thread on a processor that is taken moves to another, and is bound to none", "[numeric][parallel]")
{
    cpu_set_t allowed;
    REQUIRE(sched_getaffinity(0, sizeof allowed, &allowed) == 0);
    constexpr int trials = 50;
    int moved = 0;
    for (int trial = 0; trial < trials; ++trial) {
        SeparateProcessors processors;
        int const first = sched_getcpu();
        bool ready = false;
        cpu_set_t after;
        CPU_ZERO(&after);
        std::thread([&] {
            // to where the loop began, as a kernel may wake it
            cpu_set_t there;
            CPU_ZERO(&there);
            CPU_SET(first, &there);
            ready =
                sched_setaffinity(0, sizeof there, &there) == 0 && sched_setaffinity(0, sizeof allowed, &allowed) == 0;
            bool const taken = sched_getcpu() == first;
            processors.settle();
            moved += taken && sched_getcpu() != first ? 1 : 0;
            ready = ready && sched_getaffinity(0, sizeof after, &after) == 0;
        }).join();
        REQUIRE(ready);
        CHECK(CPU_EQUAL(&after, &allowed));
    }
    if (CPU_COUNT(&allowed) > 1)
        CHECK(moved > 0);
    else
        CHECK(moved == 0);
}

TEST_CASE("a thread that its user has bound stays", "[numeric][parallel]")
{
    SeparateProcessors processors;
    int const first = sched_getcpu();
    bool ready = false, same = false;
    int last = -1;
    std::thread([&] {
        cpu_set_t there, after;
        CPU_ZERO(&there);
        CPU_ZERO(&after);
        CPU_SET(first, &there);
        ready = sched_setaffinity(0, sizeof there, &there) == 0;
        processors.settle();
        ready = ready && sched_getaffinity(0, sizeof after, &after) == 0;
        same = CPU_EQUAL(&after, &there);
        last = sched_getcpu();
    }).join();
    REQUIRE(ready);
    CHECK(same);
    CHECK(last == first);
}

#endif

TEST_CASE("a loop that is asked to stop ends, with any number of threads and loops within", "[numeric][parallel]")
{
    constexpr int enough = 100;
    for (int const threads : {1, 2, 4}) {
        std::atomic<bool> asked = false;
        std::atomic<int> runs = 0;
        auto const loop = [&] {
            parallel_for(1000000, threads, 1, [&](std::size_t) {
                parallel_for(2, 1, 1, [](std::size_t) {});
                if (++runs == enough)
                    asked = true;
            });
        };
        {
            StopScope const scope(&asked);
            CHECK_THROWS_AS(loop(), Stopped);
            CHECK(runs < enough + 2 * threads);
            CHECK_THROWS_AS(end_if_stopped(), Stopped);
            StopScope const inner(nullptr);  // nobody can ask
            CHECK_NOTHROW(parallel_for(2, threads, 1, [](std::size_t) {}));
        }
        CHECK_NOTHROW(end_if_stopped());
        CHECK_NOTHROW(parallel_for(2, threads, 1, [](std::size_t) {}));
    }
}

}  // namespace hdconj::test::threads_of_loops_cases
