// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/deferred_tasks.hpp"

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/catch.hpp"

namespace hdconj::test::deferred_tasks_cases {

using hdconj::DeferredTasks;

TEST_CASE("late jobs: each is done once, whoever helps", "[late jobs][parallel]")
{
    for (int helpers = 0; helpers < 4; ++helpers) {
        DeferredTasks jobs;
        std::vector<std::atomic<int>> done(100);
        std::vector<std::thread> threads;
        for (int i = 0; i < helpers; ++i)
            threads.emplace_back([&] { jobs.help(); });
        jobs.open(done.size(), [&](std::size_t i) { ++done[i]; });
        jobs.help();
        for (std::thread& each : threads)
            each.join();
        jobs.finish();
        for (auto const& count : done)
            CHECK(count == 1);
    }
}

TEST_CASE("late jobs: none, and who waits for them goes on", "[late jobs][parallel]")
{
    DeferredTasks jobs;
    std::thread helper([&] { jobs.help(); });
    jobs.close();
    helper.join();
    CHECK_NOTHROW(jobs.finish());
}

TEST_CASE("late jobs: of several that throw the lowest is heard, and all others are done", "[late jobs][parallel]")
{
    for (int helpers = 0; helpers < 3; ++helpers) {
        DeferredTasks jobs;
        std::atomic<int> done = 0;
        std::vector<std::thread> threads;
        for (int i = 0; i < helpers; ++i)
            threads.emplace_back([&] { jobs.help(); });
        jobs.open(50, [&](std::size_t i) {
            if (i == 7 || i == 8 || i == 40)
                throw std::runtime_error(std::to_string(i));
            ++done;
        });
        jobs.help();
        for (std::thread& each : threads)
            each.join();
        CHECK(done == 47);
        try {
            jobs.finish();
            FAIL("no exception");
        } catch (std::runtime_error const& error) {
            CHECK(std::string(error.what()) == "7");
        }
    }
}

}  // namespace hdconj::test::deferred_tasks_cases
