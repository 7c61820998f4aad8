// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a side clearance does to flanks that touched without one, corners of the outline included; and where a smallest value may lie.
#include <algorithm>
#include <cmath>

#include "hdconj/pipeline/contact.hpp"
#include "pipeline/place_range.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

using namespace hdconj;
using namespace hdconj::test;

TEST_CASE("contact law: conjugate flanks clear by their side clearance, however they are looked at", "[law][contact]")
{
    // the end planes of a ruled surface have a corner between two branches, which overlap when they are moved
    std::vector<std::string> const drive = with(coned("none", 10.8787), {"wave_generator.radial_deformation=0.243807", "flexspline.profile.convex_radius=0.26706", "contact.contact_gap=0.003",
                                                                         "slices.surface=ruled", "slices.count=3"});
    struct Row
    {
        double offset;
        int points;
    };
    for (auto const& [offset, points] : {Row{0.0046, 50}, Row{0.012, 80}})
    {
        ContactCase const found = contact(builtin_scene(with(drive, {"circular_spline.backlash_offset=" + std::to_string(offset), "contact.flank_points=" + std::to_string(points)}))).cases.front();
        INFO(offset << " mm, " << points << " points: clearance " << found.closest_flank().clearance << " +- " << found.clearance_error);
        CHECK(found.closest_flank().clearance == Approx(offset).margin(found.clearance_error));
        CHECK(found.state.smallest_gap == Approx(offset).margin(found.state.smallest_gap_error));
        CHECK(found.state.teeth_least <= found.state.teeth);
        CHECK(found.state.teeth <= found.state.teeth_most);
        // both end planes clear by as much
        CHECK(found.closest_z_from == -3.5);
        CHECK(found.closest_z_to == 3.5);
        CHECK(found.state.smallest_z_from == -3.5);
        CHECK(found.state.smallest_spaces > 100);
    }
}

TEST_CASE("contact law: one plane alone decides where tilted teeth come closest", "[law][contact]")
{
    ContactCase const found = contact(builtin_scene(with(coned("none"), {"slices.surface=tilted", "slices.count=5", "contact.flank_points=40"}))).cases.front();
    CHECK(found.closest_slice().z == -3.5);
    CHECK(found.closest_z_from == -3.5);
    CHECK(found.closest_z_to == -1.75);
}

TEST_CASE("place range: planes as good as the least and their neighbours", "[contact]")
{
    std::vector<double> const z{-2, -1, 0, 1, 2};
    auto const range = [&](std::vector<double> const& excess, double error) {
        detail::PlaceRange const found = detail::place_range(z, excess, error);
        return std::pair(found.from, found.to);
    };
    CHECK(range({4, 1, 0, 1, 4}, 0.5) == std::pair(-1.0, 1.0));
    CHECK(range({4, 1, 0, 1, 4}, 1) == std::pair(-2.0, 2.0));
    CHECK(range({0, 1, 2, 3, 4}, 0) == std::pair(-2.0, -1.0));
    CHECK(range({0, 9, 9, 9, 0}, 0) == std::pair(-2.0, 2.0));
    CHECK(range({9, 9, 0, 0, 9}, 0) == std::pair(-1.0, 2.0));
    detail::PlaceRange const one = detail::place_range({0}, {0}, 0);
    CHECK(one.from == 0);
    CHECK(one.to == 0);
}
