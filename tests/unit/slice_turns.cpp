// SPDX-License-Identifier: GPL-3.0-or-later
// Full turns of the points of slices.
#include "pipeline/slice_turns.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "pipeline/drive.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

using namespace hdconj;
using namespace hdconj::test;

TEST_CASE("full turns: points taken together are each what it is by itself, and those left out are left out", "[contact]")
{
    for (char const* const name : {"type-50", "cycloid"})
    {
        ConedDrive drive(read_scene(file_of(name), coned()), 3);
        FlankGrid const grid = drive.flanks(drive.surface("per-slice"), 40);
        detail::SliceTurns const turns(*drive.bench);
        detail::ClearanceSet const set = detail::flank_set(grid, false);
        constexpr double distance = 2e-3;   // mm
        detail::TurnMinima const together = turns(set, distance);
        std::vector<std::vector<std::uint8_t>> wanted(set.point.size());
        for (std::size_t k = 0; k < wanted.size(); ++k)
            for (std::size_t i = 0; i < set.point[k].size(); ++i)
                wanted[k].push_back((i + k) % 3 == 0 ? 1 : 0);
        detail::TurnMinima const some = turns(set, distance, &wanted);
        double const rounding = drive.bench->tolerance.roundoff();
        for (std::size_t k = 0; k < set.point.size(); ++k)
        {
            FullTurnClearance<ErasedMotion> const turn(drive.tooth, drive.maker->motion(k).motion, drive.pitch(), detail::pitches_per_lobe(drive.scene));
            std::vector<Vec2> const place = detail::moved_slice(set, k, distance).point;
            REQUIRE(together[k].size() == place.size());
            REQUIRE(some[k].size() == place.size());
            for (std::size_t i = 0; i < place.size(); ++i)
            {
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
