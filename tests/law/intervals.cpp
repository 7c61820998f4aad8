// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where along the turn the teeth are in contact: zones and branches against positions found by
/// brute force.
#include <algorithm>

#include "support/catch.hpp"
#include "support/oracle/envelope.hpp"
#include "support/oracle/run.hpp"

namespace hdconj::test::intervals_cases {

using namespace oracle;
using hdconj::ConjugateZone;
using hdconj::Kinematics;
using hdconj::Scene;
using hdconj::Solution;

namespace {

double degrees(double angle)
{
    return angle * 180 / pi<double>();
}

/// Ends of regular zones on @p segment at the profile parameter @p t: undeformed angles [deg], sorted.
std::vector<double> zone_ends(Solution const& solution, std::size_t segment, double t)
{
    std::vector<double> found;
    for (auto const& zone : solution.zones) {
        if (zone.kind != "regular" || zone.segment != static_cast<int>(segment))
            continue;
        if (std::abs(zone.t_begin - t) < 1e-9)
            found.push_back(degrees(zone.phi_begin));
        if (std::abs(zone.t_end - t) < 1e-9)
            found.push_back(degrees(zone.phi_end));
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

TEST_CASE("intervals: zones of the profile's ends are where brute force finds contact", "[intervals]")
{
    for (Scene const& scene :
         {type_50(), type_50(Kinematics::first_order), liu_2025(), liu_2025(Kinematics::first_order)}) {
        Solution const solution = hdconj::solve(scene);
        Tooth<double> const tooth(scene);
        Motion<double> const motion(scene);
        REQUIRE(solution.segment_names.size() == tooth.pieces_of_whole());
        std::size_t compared = 0;
        for (std::size_t segment = 0; segment < tooth.pieces_of_whole(); ++segment)
            for (double const t : {0.0, 1.0}) {
                INFO(scene.drive.name << ": " << tooth.name_of_whole(segment) << " at t = " << t);
                std::vector<double> expected;
                for (double const s : contact_positions(motion, tooth.on_whole(segment, t)))
                    expected.push_back(degrees(motion.phi(s)));
                auto const found = zone_ends(solution, segment, t);
                // A branch that starts on one side of the lobe's end may be told on the other.
                CHECK(found.size() == expected.size());
                for (double const angle : expected) {
                    double nearest = 1e300;
                    for (double const other : found)
                        nearest =
                            std::min(nearest, std::abs(std::remainder(angle - other, degrees(2 * motion.half_lobe()))));
                    CHECK(nearest < 1e-7);
                    ++compared;
                }
            }
        CHECK(compared >= 16);
    }
}

TEST_CASE("intervals: Liu's tooth, first order, against an independent program", "[intervals]")
{
    // Undeformed angles in degrees where the ends of the right flank are in contact, computed elsewhere
    // with the first-order formulas. (The same program's numbers for the exact motion leave the neutral
    // curve unclosed; the oracle reproduces them in that reading, see oracle.cpp.)
    Solution const solution = hdconj::solve(liu_2025(Kinematics::first_order));
    Tooth<double> const tooth(solution.scene);
    std::size_t const tip = tooth.pieces_of_whole() / 2;
    auto const near = [](std::vector<double> const& found, double angle) {
        return std::any_of(found.begin(), found.end(), [&](double other) { return std::abs(angle - other) < 0.01; });
    };
    auto const top = zone_ends(solution, tip + 1, 0), root = zone_ends(solution, tooth.pieces_of_whole() - 1, 1);
    CHECK(near(top, 1.476));
    CHECK(near(top, 59.525));
    CHECK(near(root, -0.997));
    CHECK(near(root, 56.922));
    CHECK_FALSE(near(root, 58.284));  // exact, unclosed: must not be met here
}

TEST_CASE("intervals: no contact near the joint of type-50", "[intervals]")
{
    // Between the double roots on both sides of the joint no position touches: the branches have to
    // stop there, with the reason.
    for (Kinematics const kinematics : hdconj::all_kinematics) {
        Scene const scene = type_50(kinematics);
        Solution const solution = hdconj::solve(scene);
        Tooth<double> const tooth(scene);
        Motion<double> const motion(scene);
        std::size_t const convex = tooth.pieces_of_whole() - 2, concave = tooth.pieces_of_whole() - 1;
        CHECK(contact_positions(motion, tooth.on_whole(convex, 1.0)).empty());
        CHECK(contact_positions(motion, tooth.on_whole(concave, 0.0)).empty());
        // Largest t of the convex arc with contact, by bisection on the number of contacts.
        double in = 0, out = 1;
        while (out - in > 1e-7)
            (contact_positions(motion, tooth.on_whole(convex, (in + out) / 2), 20000).empty() ? out : in) =
                (in + out) / 2;
        double reached = 0;
        bool fold = false;
        for (auto const& zone : solution.zones)
            if (zone.kind == "regular" && zone.segment == static_cast<int>(convex))
                reached = std::max({reached, zone.t_begin, zone.t_end});
        for (auto const& branch : solution.branches)
            if (branch.segment == static_cast<int>(convex))
                fold = fold || branch.begins == "double root" || branch.ends == "double root" || branch.t.size() > 2;
        CHECK(reached == Approx(in).epsilon(0).margin(2e-6));
        CHECK(fold);
    }
}

}  // namespace hdconj::test::intervals_cases
