// SPDX-License-Identifier: GPL-3.0-or-later
// First designs, and what the advice of faults, failures and warnings makes of them when it is followed once.
#include "support/novice_designs.hpp"

#include <map>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/followed_advice.hpp"

namespace hdconj::test::novice_designs_cases {
namespace {

/// How many of the first designs come to what.
struct Count
{
    int solved = 0, clean = 0;

    void add(DesignOutcome const& outcome)
    {
        solved += outcome.solved ? 1 : 0;
        clean += outcome.clean() ? 1 : 0;
    }
};

/// The designs of the first @p designs seeds, with their advice followed once.
Count followed_once(int designs)
{
    Count before, after;
    std::string refused;
    for (int seed = 0; seed < designs; ++seed) {
        std::string const text = designs::Novice(static_cast<unsigned>(seed))();
        DesignOutcome const first = outcome_of(text);
        bool const followed = !first.clean() && !first.set.empty();
        DesignOutcome const second = followed ? outcome_of(text, first.set) : first;
        before.add(first);
        after.add(second);
        if (!second.solved)
            refused += "seed " + std::to_string(seed) + ": " + second.said + "\n";
    }
    WARN(designs << " designs: " << before.solved << " solved and " << before.clean << " without warning as given, "
                 << after.solved << " and " << after.clean << " with the advice followed once");
    INFO(refused);
    CHECK(after.solved > before.solved);
    return after;
}

}  // namespace

TEST_CASE("advice followed once solves nine in ten first designs, seven in ten without a warning", "[judgement]")
{
    constexpr int designs = 60;
    Count const count = followed_once(designs);
    CHECK(count.solved >= 0.9 * designs);
    CHECK(count.clean >= 0.7 * designs);
}

TEST_CASE("advice that is followed to its end comes to one", "[judgement]")
{
    constexpr int designs = 300, most = 8;
    for (int seed = 0; seed < designs; ++seed) {
        std::string const text = designs::Novice(static_cast<unsigned>(seed))();
        std::map<std::string, std::string> followed;  // by key
        std::string way;
        int steps = 0;
        for (bool goes_on = true; goes_on && steps < most; ++steps) {
            std::vector<std::string> sets;
            for (auto const& [key, each] : followed)
                sets.push_back(each);
            goes_on = false;
            for (std::string const& each : outcome_of(text, sets).set) {
                std::string& last = followed[key_of(each)];
                goes_on = goes_on || last != each;
                last = each;
                way += each + "; ";
            }
            way += "then ";
        }
        INFO(text << way);
        CHECK(steps < most);
    }
}

TEST_CASE("the same of five hundred", "[.][judgement-of-500]")
{
    constexpr int designs = 500;
    Count const count = followed_once(designs);
    CHECK(count.solved >= 0.9 * designs);
    CHECK(count.clean >= 0.7 * designs);
}

}  // namespace hdconj::test::novice_designs_cases
