// SPDX-License-Identifier: GPL-3.0-or-later
// The largest torque that some wall stands, of walls whose stress is a formula.
#include "design/torque_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/catch.hpp"

namespace hdconj::test::torque_search_cases {
namespace {

using design::most_torque;

constexpr double allowed = 558;

/// As of cups: grows fast at first, then little, then in proportion. The thickest wall is stressed least far above.
WallTrial under(std::size_t wall, double torque)
{
    constexpr std::array assembled{431.0, 446.0, 429.0, 470.0}, early{8.0, 7.0, 3.6, 3.0}, late{3.1, 3.3, 3.8, 4.6};
    WallTrial trial;
    trial.assembled = assembled.at(wall);
    trial.loaded = std::max(assembled.at(wall) + 2 * early.at(wall) * std::sqrt(torque), late.at(wall) * torque);
    if (trial.loaded > allowed)
        trial.refusal = "too much";
    return trial;
}

}  // namespace

TEST_CASE("the largest torque that a wall stands is the same from far and from near", "[design]")
{
    REQUIRE(under(2, 140).refusal.empty());
    for (std::size_t wall = 0; wall < 4; ++wall)
        REQUIRE_FALSE(under(wall, 150).refusal.empty());
    for (double const asked : {151.0, 160.0, 200.0, 480.0, 5e3, 1e8}) {
        std::vector<WallTrial> refused;
        for (std::size_t wall = 0; wall < 4; ++wall)
            refused.push_back(under(wall, asked));
        int trials = 0;
        auto const counted = [&](std::size_t wall, double torque) {
            CHECK(torque < asked);
            ++trials;
            return under(wall, torque);
        };
        CAPTURE(asked);
        CHECK(most_torque(refused, asked, allowed, 1000, counted) == 140);
        CHECK(trials <= 16);
    }
}

TEST_CASE("a largest torque is found where the torque that is asked for has no result", "[design]")
{
    auto const slips = [](std::size_t wall, double torque) {
        WallTrial trial;
        trial.refusal = "the teeth slip over each other";
        return torque > 300 ? trial : under(wall, torque);
    };
    std::vector<WallTrial> const refused(4, slips(0, 5000));
    CHECK(most_torque(refused, 5000, allowed, 1000, slips) == 140);
    std::vector<WallTrial> const always(2, slips(0, 5000));
    auto const never = [&](std::size_t wall, double) { return slips(wall, 5000); };
    CHECK_FALSE(most_torque(always, 5000, allowed, 1000, never));
    CHECK_FALSE(most_torque({}, 5000, allowed, 1000, never));
}

}  // namespace hdconj::test::torque_search_cases
