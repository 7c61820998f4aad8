// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The resultant of the bearing over a lobe, and where it acts.
#include <cmath>
#include <numbers>

#include "load/study/bearing_map.hpp"
#include "support/catch.hpp"

namespace hdconj::test::lobe_reaction_cases {

namespace {

constexpr int places = 8, heights = 3;

/// A ring of one sector, three heights, without force.
BearingMap bearing()
{
    BearingMap map;
    map.z = {-1, 0, 1};
    for (int i = 0; i < places; ++i)
        map.angle.push_back(2 * std::numbers::pi * i / places);
    map.force.assign(static_cast<std::size_t>(places) * heights, 0.0);
    return map;
}

double& force(BearingMap& map, int place, int height)
{
    return map.force[static_cast<std::size_t>(place * heights + height)];
}

}  // namespace

TEST_CASE("the resultant of a lobe acts on the bearing, or is a couple that acts nowhere", "[load]")
{
    BearingMap map = bearing();
    force(map, 0, 2) = 3;
    load::LobeReaction const alone = load::lobe_reaction(map, 1, 1);
    CHECK(alone.along == Approx(3));
    CHECK(alone.z == Approx(1));

    SECTION("forces on either side of the ring, at different heights")
    {
        force(map, places / 2, 0) = 2;
        load::LobeReaction const both = load::lobe_reaction(map, 1, 1);
        CHECK(both.along == Approx(1));
        CHECK(std::isnan(both.z));
    }
    SECTION("the resultant does not press outward")
    {
        force(map, places / 2, 2) = 4;
        CHECK(load::lobe_reaction(map, 1, 1).along == Approx(-1));
        CHECK(std::isnan(load::lobe_reaction(map, 1, 1).z));
    }
    SECTION("two waves: the other side belongs to the other lobe")
    {
        force(map, places / 2, 0) = 2;
        force(map, 1, 1) = 1;
        double const z = load::lobe_reaction(map, 1, 2).z;
        CHECK((z > 0 && z < 1));
    }
    SECTION("without force")
    {
        CHECK(std::isnan(load::lobe_reaction(bearing(), 1, 1).z));
    }
}

}  // namespace hdconj::test::lobe_reaction_cases
