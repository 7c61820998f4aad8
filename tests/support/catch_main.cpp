// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// main() of the test programs, for both layouts of Catch2, and what is said of tests that were not tried.
#if !__has_include(<catch2/catch_all.hpp>)
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#else
#include <catch2/catch_all.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>

int main(int count, char** arguments)
{
    return Catch::Session().run(count, arguments);
}
#endif

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "not_tried.hpp"

namespace hdconj::test {
namespace {

std::vector<std::string>& untried()
{
    static std::vector<std::string> all;
    return all;
}

bool may_be_left(std::string const& what)
{
    std::ifstream in(HDCONJ_SOURCE_DIR "/tests/not_tried.txt");
    for (std::string line; std::getline(in, line);) {
        if (line == what)
            return true;
    }
    return false;
}

#if __has_include(<catch2/catch_all.hpp>)
using Listener = Catch::EventListenerBase;
#else
using Listener = Catch::TestEventListenerBase;
#endif

/// Says at the end of a test what was not tried, in the words that ctest looks for (cmake/Testing.cmake).
struct SayUntried : Listener
{
    using Listener::Listener;
    void testCaseEnded(Catch::TestCaseStats const& test) override
    {
        if (test.totals.assertions.failed == 0) {
            for (auto const& what : untried())
                std::cout << "NOT TRIED: " << what << '\n';
        }
        untried().clear();
    }
};

CATCH_REGISTER_LISTENER(SayUntried)

}  // namespace

void not_tried(std::string const& what)
{
    if (std::getenv("CI") != nullptr && !may_be_left(what))
        FAIL_CHECK("must be tried in CI: " << what);
    untried().push_back(what);
}

}  // namespace hdconj::test
