// SPDX-License-Identifier: GPL-3.0-or-later
// Module and pitch diameter of random wishes.
#include <cmath>
#include <string>

#include "hdconj/design.hpp"
#include "support/catch.hpp"
#include "support/draws.hpp"

namespace hdconj::test::design_sizes_cases {
namespace {

DesignWishes drawn(designs::Draws& draws)
{
    auto const size = [&](double low, double high) { return std::exp(draws.between(std::log(low), std::log(high))); };
    DesignWishes wishes;
    wishes.ratio = draws.whole(30, 320);
    if (draws.chance(0.7))
        wishes.diameter = size(3, 900);
    if (!wishes.diameter || draws.chance(0.6))
        wishes.module = size(0.02, 20);
    if (wishes.diameter && wishes.module && draws.chance(0.5))
        wishes.diameter = *wishes.module * 2 * wishes.ratio;
    return wishes;
}

/// The number behind the last @p word of @p remedy.
double behind(std::string const& word, std::string const& remedy)
{
    std::size_t const at = remedy.rfind(word + " ");
    REQUIRE(at != std::string::npos);
    return std::stod(remedy.substr(at + word.size() + 1));
}

/// @p wishes as @p fault tells to write them.
DesignWishes followed(DesignWishes wishes, Fault const& fault)
{
    auto const says = [&](char const* words) { return fault.remedy.find(words) != std::string::npos; };
    if (!wishes.module)
        wishes.diameter = behind("is", fault.remedy);
    else if (!wishes.diameter)
        wishes.module = behind("is", fault.remedy);
    else if (says("--module "))
        wishes.module = behind("--module", fault.remedy);
    if (wishes.module && (says("with --diameter ") || says("is --diameter ")))
        wishes.diameter = behind("--diameter", fault.remedy);
    return wishes;
}

}  // namespace

TEST_CASE("a module and a pitch diameter that are named are taken", "[design]")
{
    designs::Draws draws(3);
    int refused = 0;
    constexpr int all = 400;
    for (int i = 0; i < all; ++i) {
        DesignWishes const wishes = drawn(draws);
        Faults const faults = check_design(wishes);
        if (faults.empty())
            continue;
        ++refused;
        INFO(wishes.ratio << ": " << describe(faults));
        REQUIRE(faults.size() == 1);
        Faults const left = check_design(followed(wishes, faults.front()));
        INFO(describe(left));
        CHECK(left.empty());
    }
    CHECK(refused > all / 5);
}

}  // namespace hdconj::test::design_sizes_cases
