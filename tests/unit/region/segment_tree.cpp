// SPDX-License-Identifier: GPL-3.0-or-later
#include "region/segment_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "support/catch.hpp"
#include "support/polyline.hpp"
#include "wedm/seen_distance.hpp"

namespace hdconj::test::segment_tree_cases {

namespace {

std::vector<Vec2> random_line(int segments)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> step(-1, 1);
    std::vector<Vec2> line{{0, 0}};
    for (int i = 0; i < segments; ++i)
        line.push_back(line.back() + Vec2(step(random), step(random)));
    return line;
}

}  // namespace

TEST_CASE("a tree of segments finds the nearest one, from anywhere and along any lean", "[region]")
{
    std::vector<Vec2> const line = random_line(200);
    region::SegmentTree const tree(line), ring(line, true);
    wedm::Lean const lean({0, 0}, {0.9, -0.4}, 1);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-30, 30);
    double const none = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 300; ++k) {
        Vec2 const p(place(random), place(random));
        double open = none, seen = none;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            open = std::min(open, distance_to_segment(line[i], line[i + 1], p));
            seen = std::min(seen, distance_to_segment(lean.seen(line[i]), lean.seen(line[i + 1]), lean.seen(p)));
        }
        CHECK(tree.nearest(p, k % 200).distance == Approx(open).epsilon(1e-14));
        CHECK(wedm::seen_distance(tree, p) == Approx(open).epsilon(1e-14));
        CHECK(wedm::seen_distance(tree, p, lean) == Approx(seen).epsilon(1e-13));
        CHECK(wedm::seen_distance(ring, p) ==
              Approx(std::min(open, distance_to_segment(line.back(), line.front(), p))).epsilon(1e-14));
    }
}

TEST_CASE("a tree of segments knows whose boxes meet, and the first crossing", "[region]")
{
    std::vector<Vec2> const line = random_line(400);
    region::SegmentTree const tree(line);
    auto const box = [&](std::size_t i) {
        return Eigen::AlignedBox2d(line[i].cwiseMin(line[i + 1]), line[i].cwiseMax(line[i + 1]));
    };
    std::pair<std::size_t, std::size_t> first{0, 0};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        std::vector<std::size_t> meeting;
        for (std::size_t j = 0; j + 1 < line.size(); ++j) {
            if (box(i).intersects(box(j)))
                meeting.push_back(j);
            if (first == std::pair<std::size_t, std::size_t>{0, 0} && j > i + 1 &&
                region::distance_of_segments(line[i], line[i + 1], line[j], line[j + 1]) == 0)
                first = {i, j};
        }
        CHECK(tree.near(i) == meeting);
    }
    CHECK(first.second > 0);
    CHECK(tree.crossing() == first);
    std::vector<Vec2> const square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    CHECK(region::SegmentTree(square, true).crossing() == std::pair<std::size_t, std::size_t>{0, 0});
}

TEST_CASE("a search in a line a hundred times as fine asks some ten times as many segments", "[region]")
{
    std::size_t coarse = 0;
    for (int const segments : {1000, 100'000}) {
        std::vector<Vec2> arc;
        for (int i = 0; i <= segments; ++i)
            arc.emplace_back(std::cos(1.0 * i / segments), std::sin(1.0 * i / segments));
        region::SegmentTree const tree(arc);
        std::size_t asked = 0;
        double best = std::numeric_limits<double>::infinity();
        Vec2 const p = 0.9 * Vec2(std::cos(0.6), std::sin(0.6));
        tree.approach(p, best, [&](std::size_t i) {
            ++asked;
            return best = std::min(best, region::segment_foot(p, arc[i], arc[i + 1]).squared);
        });
        CHECK(std::sqrt(best) == Approx(0.1).epsilon(1e-6));
        CHECK(asked < (coarse == 0 ? 100 : 20 * coarse));
        coarse = asked;
    }
}

}  // namespace hdconj::test::segment_tree_cases
