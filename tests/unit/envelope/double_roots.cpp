// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/envelope/double_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "hdconj/envelope/find_branches.hpp"
#include "support/catch.hpp"
#include "support/turning_motion.hpp"
#include "support/type50.hpp"

namespace hdconj::test::double_roots_cases {

namespace {

envelope::DoubleRoots search(profile::CurvePiece const& curve, Turning const& motion)
{
    return envelope::DoubleRootSearch(curve, motion::rates_model(motion, -1, 1), -1, 1)();
}

}  // namespace

TEST_CASE("a merge is found once, with its direction and a width that holds it", "[envelope]")
{
    // p = (t - 0.4)^2: f = rate (u - at) - p, two contacts from u = at on when rate > 0
    profile::CurvePiece const curve = with_slope({0.16, -0.24, 0.36});
    for (double rate : {0.7, -0.7}) {
        for (double at : {-0.31, 0.0, 0.25, 0.5}) {
            envelope::DoubleRoots const found = search(curve, {rate, at});
            REQUIRE(found.certified());
            REQUIRE(found.roots.size() == 1);
            envelope::DoubleRoot const& root = found.roots[0];
            CHECK(std::abs(root.t - 0.4) <= root.t_width / 2);
            CHECK(std::abs(root.u - at) <= root.u_width / 2);
            CHECK(root.t_width < 1e-11);
            CHECK(root.u_width < 1e-11);
            CHECK(root.change == (rate > 0 ? 2 : -2));
            CHECK(found.boxes < 400);
        }
    }
}

TEST_CASE("merges that do not happen are excluded: above, below and beside the curve", "[envelope]")
{
    CHECK(search(with_slope({0.16, -0.24, 0.36}), {0.7, 3}).roots.empty());
    CHECK(search(with_slope({1, 2, 3}), {0.7, 0}).roots.empty());
    CHECK(search(with_slope({0.5, 1.5}), {0, 0}).roots.empty());
}

TEST_CASE("a merge next to an end of the curve, and one at the very end", "[envelope]")
{
    // p = (t - e)^2
    for (double e : {1e-3, 1e-6, 1e-9}) {
        envelope::DoubleRoots const found = search(with_slope({e * e, e * e - e, (1 - e) * (1 - e)}), {1, 0.1});
        REQUIRE(found.roots.size() == 1);
        CHECK(std::abs(found.roots[0].t - e) <= found.roots[0].t_width / 2);
    }
    // there the end is crossed, and no two contacts merge inside
    CHECK(search(with_slope({0, 0, 1}), {1, 0.1}).roots.empty());
}

TEST_CASE("tracing goes on where contacts merge next to an end, however near", "[envelope]")
{
    // f = rate (u - at) - (t - e)^2: one of two contacts crosses the end e^2/rate after the merge, or before it
    for (double const rate : {1.0, -1.0})
        for (double const at : {-0.013, 0.1, 0.7})
            for (double e = 0.1; e > 1e-11; e /= 1.7)
                for (bool const mirrored : {false, true}) {
                    INFO(rate << " " << at << " " << e << " " << mirrored);
                    std::array<double, 3> slope{e * e, e * e - e, (1 - e) * (1 - e)};
                    if (mirrored)
                        std::reverse(slope.begin(), slope.end());
                    Turning const motion{rate, at};
                    profile::Profile profile;
                    profile.segment_names = {"only"};
                    profile.pieces.push_back({with_slope({slope[0], slope[1], slope[2]}), 0, 0, 1, false});
                    envelope::BranchSet const set =
                        envelope::find_branches(envelope::Envelope<Turning>(profile, motion, 0), 1);
                    CHECK(set.record.certified());
                    // the one comes from the merge and leaves at the end, or both are one that comes from the end
                    int merging = 0, crossing = 0, other = 0;
                    for (envelope::Branch const& branch : set.branches)
                        for (envelope::ContactArc const& arc : branch.arcs)
                            for (auto const& [t, why] :
                                 {std::pair(arc.t_begin, arc.begins), std::pair(arc.t_end, arc.ends)}) {
                                merging += why == envelope::BranchEnd::double_root;
                                crossing += why == envelope::BranchEnd::segment_end && t == (mirrored ? 1 : 0);
                                other += why == envelope::BranchEnd::segment_end && t == (mirrored ? 0 : 1);
                            }
                    CHECK(crossing == 1);
                    CHECK((merging == 2 || (merging == 0 && e * e < 1e-9)));
                    CHECK(other <= 1);
                }
}

TEST_CASE("three contacts that merge, and a merge that parts at once, end as one flagged box in bounded work",
          "[envelope]")
{
    // p = (t - 0.4)^3: f = f_t = f_tt = 0
    envelope::DoubleRoots const triple = search(with_slope({-0.064, 0.096, -0.144, 0.216}), {0.7, 0.1});
    CHECK(triple.boxes <= 4096 + 64);
    REQUIRE(triple.roots.size() == 1);
    CHECK_FALSE(triple.roots[0].separated);
    CHECK(std::abs(triple.roots[0].t - 0.4) <= triple.roots[0].t_width / 2);
    CHECK(std::abs(triple.roots[0].u - 0.1) <= triple.roots[0].u_width / 2);
    CHECK(triple.roots[0].t_width < 1e-3);
    CHECK(triple.roots[0].u_width < 1e-8);

    // q_y = (u - at)^2: f_u = 0 as well
    envelope::DoubleRoots const touching = search(with_slope({0.16, -0.24, 0.36}), {0, 0.1, 1});
    CHECK(touching.boxes <= 4096 + 64);
    REQUIRE(touching.roots.size() == 1);
    CHECK_FALSE(touching.roots[0].separated);
    CHECK(std::abs(touching.roots[0].t - 0.4) <= touching.roots[0].t_width / 2);
    CHECK(std::abs(touching.roots[0].u - 0.1) <= touching.roots[0].u_width / 2);
    CHECK(touching.roots[0].u_width < 1e-5);
}

TEST_CASE("a condition that vanishes on a whole curve at one instant ends in bounded work", "[envelope]")
{
    // p = 0: f = q_y, zero for all t at u = 0.1
    envelope::DoubleRoots const found = search(with_slope({0, 0, 0}), {1, 0.1});
    CHECK(found.boxes <= 4096 + 64);
    REQUIRE(found.roots.size() == 1);
    CHECK_FALSE(found.roots[0].separated);
    CHECK(found.roots[0].t_width == Approx(1));
    CHECK(found.roots[0].u_width < 1e-12);
}

TEST_CASE("tracing goes on across a triple contact, with a doubt of stated width", "[envelope]")
{
    Turning const motion{0.7, 0.1};
    profile::Profile profile;
    profile.segment_names = {"only"};
    profile.pieces.push_back({with_slope({-0.064, 0.096, -0.144, 0.216}), 0, 0, 1, false});
    envelope::BranchSet const set = envelope::find_branches(envelope::Envelope<Turning>(profile, motion, 0), 1);
    CHECK_FALSE(set.record.certified());
    bool stated = false;
    for (envelope::RootDoubt const& doubt : set.record.doubts)
        stated = stated || (std::abs(doubt.u - 0.1) <= doubt.width / 2 && doubt.width < 1e-8 && doubt.reach < 1e-15);
    CHECK(stated);
    // one contact, from the end where it enters to the end where it leaves
    REQUIRE(set.branches.size() == 1);
    CHECK(set.branches[0].arcs.front().begins == envelope::BranchEnd::segment_end);
    CHECK(set.branches[0].arcs.back().ends == envelope::BranchEnd::segment_end);
}

TEST_CASE("many short pieces are excluded with a few boxes each", "[envelope]")
{
    Exact const motion = type50_motion();
    motion::RatesModel const rates = motion::rates_model(motion, -motion.half_lobe(), motion.half_lobe());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-1, 1);
    std::size_t boxes = 0;
    constexpr int pieces = 500;
    for (int k = 0; k < pieces; ++k) {
        Vec2 const start{0.3 * any(random), 0.7 + 0.3 * any(random)};
        double const heading = 3 * any(random);
        std::vector<double> x, y;
        for (int i = 0; i <= 3; ++i) {
            double const s = 1e-3 * i / 3;
            double const d = s * s * any(random);
            x.push_back(start.x() + s * std::cos(heading) - d * std::sin(heading));
            y.push_back(start.y() + s * std::sin(heading) + d * std::cos(heading));
        }
        envelope::DoubleRoots const found =
            envelope::DoubleRootSearch(profile::CurvePiece(x, y), rates, -motion.half_lobe(), motion.half_lobe())();
        CHECK(found.certified());
        boxes += found.boxes;
    }
    CHECK(boxes < 16 * pieces);
}

}  // namespace hdconj::test::double_roots_cases
