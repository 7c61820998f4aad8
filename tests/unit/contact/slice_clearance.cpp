// SPDX-License-Identifier: GPL-3.0-or-later
// Full turns of the points of slices.
#include "contact/clearance/slice_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/clearance/side_clearance_search.hpp"
#include "drive/drive.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::slice_clearance_cases {

TEST_CASE("a side clearance is found where the clearance hardly grows, and where it jumps", "[contact]")
{
    constexpr double enough = 1e-8;
    // steep up to 0.035, then a corner that is met nearly along the flank: zero at 0.04
    auto const flat = [](double at) { return std::min(at - 0.0353, 0.01 * (at - 0.04)); };
    for (double const guess : {0.0, 0.034, 0.06}) {
        auto const found = contact::side_clearance_search(flat, guess, enough);
        REQUIRE(found);
        CHECK(std::abs(flat(*found)) <= enough);
    }
    auto const jumping = [](double at) { return at < 0.04 ? at - 0.05 : at + 0.01; };
    auto const found = contact::side_clearance_search(jumping, 0.03, enough);
    REQUIRE(found);
    CHECK(jumping(*found) > 0);
    CHECK(*found - 0.04 <= enough);
    CHECK_FALSE(contact::side_clearance_search([](double) { return -1.0; }, 0.01, enough));
}

TEST_CASE("full turns: points taken together are each what it is by itself, and those left out are left out",
          "[contact]")
{
    for (char const* const name : {"type-50", "cycloid"}) {
        ConedDrive drive(read_scene(file_of(name), coned()), 3);
        contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::per_slice), 40);
        contact::SliceClearances const turns(*drive.context);
        contact::ClearanceSet const set = contact::flank_set(grid, false);
        constexpr double distance = 2e-3;  // mm
        contact::TurnMinima const together = turns(set, distance);
        std::vector<std::vector<std::uint8_t>> wanted(set.point.size());
        for (std::size_t k = 0; k < wanted.size(); ++k)
            for (std::size_t i = 0; i < set.point[k].size(); ++i)
                wanted[k].push_back((i + k) % 3 == 0 ? 1 : 0);
        contact::TurnMinima const some = turns(set, distance, &wanted);
        double const rounding = drive.context->tolerance.roundoff();
        for (std::size_t k = 0; k < set.point.size(); ++k) {
            distance::FullTurnClearance<motion::AnyMotion> const turn(
                drive.tooth, drive.maker->motion(k).motion, drive.pitch(), drive::pitches_per_lobe(drive.scene));
            std::vector<Vec2> const place = contact::moved_slice(set, k, distance).point;
            REQUIRE(together[k].size() == place.size());
            REQUIRE(some[k].size() == place.size());
            for (std::size_t i = 0; i < place.size(); ++i) {
                CAPTURE(name, k, i);
                double const alone = turn(place[i]).distance;
                CHECK(std::abs(together[k][i].distance - alone) <= rounding);
                if (wanted[k][i] != 0)
                    CHECK(std::abs(some[k][i].distance - alone) <= rounding);
                else
                    CHECK(some[k][i].distance == std::numeric_limits<double>::infinity());
            }
        }
    }
}

}  // namespace hdconj::test::slice_clearance_cases
