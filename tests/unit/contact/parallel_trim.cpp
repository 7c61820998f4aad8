// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Moved flanks without overlaps: corners and bends whose parallels are known in closed form.
#include "contact/parallel_trim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/flank_grid.hpp"
#include "hdconj/contact.hpp"
#include "support/catch.hpp"

namespace hdconj::test::parallel_trim_cases {

namespace {

struct Curve
{
    std::vector<Vec2> point, normal;

    void add(Vec2 const& p, double heading)
    {
        point.push_back(p), normal.emplace_back(-std::sin(heading), std::cos(heading));
    }
    /// Moved by @p distance and trimmed; @p cut says whether anything was.
    [[nodiscard]] Curve moved(double distance, bool& cut) const
    {
        Curve result = *this;
        for (std::size_t i = 0; i < point.size(); ++i)
            result.point[i] += distance * normal[i];
        cut = contact::trim_overlaps(point, result.point, result.normal) > 0;
        return result;
    }
};

/// Along the x axis to the origin, then onward at @p turn; the corner has the normal of the second branch, as matched
/// outlines have.
Curve corner(double turn, double step, int count)
{
    Curve curve;
    for (int i = count; i > 0; --i)
        curve.add({-step * i, 0}, 0);
    for (int i = 0; i <= count; ++i)
        curve.add({step * i * std::cos(turn), step * i * std::sin(turn)}, turn);
    return curve;
}

/// A bend of radius @p radius by @p turn between two straight branches.
Curve bend(double radius, double turn, double step, int count)
{
    Curve curve;
    for (int i = count; i > 0; --i)
        curve.add({-step * i, 0}, 0);
    for (int i = 0; i <= count; ++i) {
        double const a = turn * i / count;
        curve.add({radius * std::sin(a), radius * (1 - std::cos(a))}, a);
    }
    Vec2 const end = curve.point.back();
    for (int i = 1; i <= count; ++i)
        curve.add(end + step * i * Vec2(std::cos(turn), std::sin(turn)), turn);
    return curve;
}

/// How far the nearest branch of the bare corner is: no point of a parallel is nearer than it was moved.
double nearest_branch(Vec2 const& p, double turn, Vec2 const& second)
{
    Vec2 const along(std::cos(turn), std::sin(turn));
    double const first = p.x() <= 0 ? std::abs(p.y()) : p.norm();
    double const t = std::max(0.0, (p - second).dot(along));
    return std::min(first, (p - second - t * along).norm());
}

}  // namespace

TEST_CASE("trimmed parallel: branches of a corner end at their crossing", "[contact]")
{
    for (double const turn : {0.05, 0.146, 0.9, 2.2})
        for (double const distance : {0.0046, 0.012, 0.035})
            for (double const step : {0.0013, 0.01, 0.2}) {
                int const count = 40 + static_cast<int>(0.2 / step);
                bool cut = false;
                Curve const curve = corner(turn, step, count), moved = curve.moved(distance, cut);
                // the crossing lies on the bisector, d tan(turn/2) before the corner along either branch
                Vec2 const crossing(-distance * std::tan(turn / 2), distance);
                INFO("turn " << turn << ", moved by " << distance << ", step " << step);
                REQUIRE(cut);
                double nearest = 1, reached = 1;
                for (Vec2 const& p : moved.point) {
                    nearest = std::min(nearest, nearest_branch(p, turn, {0, 0}));
                    reached = std::min(reached, (p - crossing).norm());
                }
                CHECK(nearest == Approx(distance).margin(1e-12));
                CHECK(reached < 1e-12);
                for (std::size_t i = 0; i + 1 < moved.point.size(); ++i) {
                    Vec2 const onward = right_of(curve.normal[i] + curve.normal[i + 1]);
                    CHECK((moved.point[i + 1] - moved.point[i]).dot(onward) >= -1e-12);
                }
            }
}

TEST_CASE("trimmed parallel: a bend tighter than the distance ends at the crossing of its branches", "[contact]")
{
    double const radius = 0.008, turn = 0.8, distance = 0.02;
    for (int const count : {6, 40, 200}) {
        bool cut = false;
        Curve const curve = bend(radius, turn, 0.01, count), moved = curve.moved(distance, cut);
        REQUIRE(cut);
        // both branches touch the circle of the bend, whose centre is at (0, radius)
        Vec2 const crossing(-(distance - radius) * std::tan(turn / 2), distance);
        double reached = 1;
        for (std::size_t i = 0; i < moved.point.size(); ++i) {
            reached = std::min(reached, (moved.point[i] - crossing).norm());
            CHECK(nearest_branch(moved.point[i], turn, {radius * std::sin(turn), radius * (1 - std::cos(turn))}) >=
                  distance - 1e-9);
            CHECK(moved.normal[i].norm() == Approx(1).epsilon(1e-14));
        }
        CHECK(reached < 1e-9);
    }
}

TEST_CASE("trimmed parallel: what does not overlap keeps its bits", "[contact]")
{
    bool cut = true;
    // wider than the distance, and corners that open
    for (Curve const& curve : {bend(0.03, 0.8, 0.01, 40), corner(-0.5, 0.01, 40), corner(0, 0.01, 40)}) {
        Curve const moved = curve.moved(0.02, cut);
        CHECK(!cut);
        for (std::size_t i = 0; i < curve.point.size(); ++i)
            CHECK(moved.point[i] == Vec2(curve.point[i] + 0.02 * curve.normal[i]));
    }
    // normals off those of the curve by the same angle, as a ruled surface has them
    Curve askew = bend(0.03, 0.8, 0.01, 40);
    for (Vec2& n : askew.normal)
        n = Vec2(std::cos(0.03) * n.x() - std::sin(0.03) * n.y(), std::sin(0.03) * n.x() + std::cos(0.03) * n.y());
    (void)askew.moved(0.02, cut);
    CHECK(!cut);
    // no crossing within the curve: left as it is
    Curve end = corner(0.9, 0.01, 2);
    end.point.erase(end.point.begin());
    end.normal.erase(end.normal.begin());
    (void)end.moved(0.2, cut);
    CHECK(!cut);
}

TEST_CASE("trimmed parallel: a flank moved into the material has its crossing in all its lists", "[contact]")
{
    Curve const curve = corner(0.146, 0.0013, 60);
    contact::FlankGrid grid;
    grid.z = {-1, 0, 1};
    for (std::size_t j = 0; j < curve.point.size(); j += 5)
        grid.station.push_back(static_cast<double>(j));
    for (std::size_t f = 0; f < 2; ++f) {
        grid.line[f].assign(3, curve.point);
        grid.line_normal[f].assign(3, curve.normal);
        grid.point[f].resize(3);
        grid.normal[f].resize(3);
        for (std::size_t j = 0; j < curve.point.size(); j += 5) {
            grid.index[f].push_back(j);
            for (std::size_t k = 0; k < 3; ++k) {
                grid.point[f][k].push_back(curve.point[j]);
                grid.normal[f][k].push_back(curve.normal[j]);
            }
        }
    }
    contact::FlankGrid const moved = contact::moved_into_material(grid, 0.012), one = contact::slice_of(moved, 1);
    for (std::size_t f = 0; f < 2; ++f)
        for (std::size_t j = 0; j < grid.points(); ++j) {
            CHECK(moved.point[f][2][j] == moved.line[f][2][grid.index[f][j]]);
            CHECK(moved.normal[f][2][j] == moved.line_normal[f][2][grid.index[f][j]]);
            CHECK(one.point[f][0][j] == moved.point[f][1][j]);
        }
    CHECK(one.z == std::vector<double>{0});
    // a corner in every slice leaves nothing open; one that has left in one of them does
    CHECK(overlap_at_ends(grid, 0.012) == 0);
    contact::FlankGrid some = grid;
    for (std::size_t i = 0; i < curve.point.size(); ++i) {
        some.line[1][2][i] = {0.0013 * static_cast<double>(i), 0};
        some.line_normal[1][2][i] = {0, 1};
    }
    CHECK(overlap_at_ends(some, 0.012) == Approx(0.012 * (1 - std::cos(0.146))).epsilon(1e-9));
    CHECK(overlap_at_ends(some, 0) == 0);
    // it is less by what the slices beside it clear more than the closest one, but for what may lie between these two
    double const whole = 0.012 * (1 - std::cos(0.146));
    CHECK(overlap_at_ends(some, 0.012, {0, 4e-5, 8e-5}) == Approx(whole - 4e-5).epsilon(1e-9));
    CHECK(overlap_at_ends(some, 0.012, {0, 1, 2}) == 0);
    CHECK(overlap_at_ends(some, 0.012, {0, 4e-5, 4e-5}) == Approx(whole - 3e-5).epsilon(1e-9));
    // nowhere nearer to the bare flank than it was moved, between the points too
    for (double s = 0; s < static_cast<double>(curve.point.size() - 1); s += 0.25)
        CHECK(nearest_branch(moved.between(GapMap::right, 0, s), 0.146, {0, 0}) >= 0.012 - 1e-9);
}

}  // namespace hdconj::test::parallel_trim_cases
