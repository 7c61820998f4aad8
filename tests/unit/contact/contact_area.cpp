// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_area.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "support/catch.hpp"

namespace hdconj::test::contact_area_cases {

namespace {

/// A flat flank in the plane x = const, y from 0 to @p height, the same on both sides; irregular stations.
contact::FlankGrid flat_flank(std::vector<double> const& z, std::vector<double> const& share, double height)
{
    contact::FlankGrid grid;
    grid.z = z;
    grid.station = share;
    for (std::size_t flank = 0; flank < 2; ++flank) {
        double const side = flank == GapMap::right ? 1 : -1;
        grid.point[flank].resize(z.size());
        grid.normal[flank].resize(z.size());
        for (std::size_t k = 0; k < z.size(); ++k)
            for (double const s : share) {
                grid.point[flank][k].emplace_back(0.3 * side, height * s);
                grid.normal[flank][k].emplace_back(side, 0.0);
            }
    }
    return grid;
}

/// One space for each of @p gaps, functions of z and height.
GapMap map_of(contact::FlankGrid const& grid, std::vector<std::function<double(double, double)>> const& gaps)
{
    GapMap map{grid.z, grid.station, {}, {}};
    for (std::size_t s = 0; s < gaps.size(); ++s)
        map.angle.push_back(0.1 * static_cast<double>(s));
    map.gap.resize(gaps.size() * 2 * grid.slices() * grid.points());
    for (std::size_t s = 0; s < gaps.size(); ++s)
        for (int flank = 0; flank < 2; ++flank)
            for (std::size_t k = 0; k < grid.slices(); ++k)
                for (std::size_t i = 0; i < grid.points(); ++i)
                    map.gap[map.index(s, flank, k, i)] =
                        gaps[s](grid.z[k], grid.point[static_cast<std::size_t>(flank)][k][i].y());
    return map;
}

std::vector<double> const slices{-3.5, -2.0, -1.5, 0.0, 0.3, 2.0, 3.5};
std::vector<double> const stations{0, 0.1, 0.15, 0.4, 0.5, 0.8, 1};
constexpr double height = 0.5;
constexpr double width = 7;

/// Area of {a + b z + c y <= limit} in the rectangle |z| <= 3.5, 0 <= y <= height: polygon cut by a line.
double area_below(double a, double b, double c, double limit)
{
    std::vector<Eigen::Vector2d> const box{{-3.5, 0}, {3.5, 0}, {3.5, height}, {-3.5, height}};
    auto const value = [&](Eigen::Vector2d const& p) { return a + b * p.x() + c * p.y() - limit; };
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < box.size(); ++i) {
        Eigen::Vector2d const p = box[i], q = box[(i + 1) % box.size()];
        double const at_p = value(p), at_q = value(q);
        if (at_p <= 0)
            kept.push_back(p);
        if ((at_p <= 0) != (at_q <= 0))
            kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    double twice = 0;
    for (std::size_t i = 0; i < kept.size(); ++i)
        twice += cross(kept[i], kept[(i + 1) % kept.size()]);
    return 0.5 * std::abs(twice);
}

}  // namespace

TEST_CASE("the part of a cell in contact alone has the bits that it has beside the whole", "[contact_area]")
{
    std::mt19937 random(31);
    std::uniform_real_distribution<double> off(-0.1, 0.1), excess(-1, 1);
    double contact = 0, alone = 0, whole = 0;
    for (int i = 0; i < 1000; ++i) {
        std::array<contact::AreaCorner, 4> corner;
        constexpr std::array<std::array<int, 2>, 4> square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        for (std::size_t c = 0; c < corner.size(); ++c)
            corner[c] = {{square[c][0] + off(random), square[c][1] + off(random), off(random)},
                         i % 4 == 0   ? 1 + excess(random)
                         : i % 4 == 1 ? -1 + excess(random)
                                      : excess(random)};
        contact::add_cell(corner, contact, whole);
        contact::add_contact_of_cell(corner, alone);
        CHECK(alone == contact);
    }
    CHECK(contact > 0.2 * whole);
    CHECK(contact < 0.8 * whole);
}

TEST_CASE("contact area of a gap that is linear over the flank is exact", "[contact_area]")
{
    contact::FlankGrid const grid = flat_flank(slices, stations, height);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    int partial = 0;
    for (int i = 0; i < 200; ++i) {
        double const a = any(random), b = any(random), c = 4 * any(random), limit = 0.3 * any(random);
        GapMap const map = map_of(grid, {[&](double z, double y) { return a + b * z + c * y; }});
        double const expected = area_below(a, b, c, limit);
        contact::ContactArea const area = contact::contact_area(map, grid, GapMap::right, limit, width);
        CHECK(area.contact == Approx(expected).margin(1e-13));
        CHECK(area.whole == Approx(width * height).epsilon(1e-14));
        CHECK(area.spaces == (expected > 0 ? 1 : 0));
        partial += expected > 0.01 && expected < width * height - 0.01;
    }
    CHECK(partial > 100);
}

TEST_CASE("contact area with the limit on grid points counts what is at the limit once", "[contact_area]")
{
    contact::FlankGrid const grid = flat_flank(slices, stations, height);
    auto const area = [&](std::function<double(double, double)> const& gap, double limit) {
        return contact::contact_area(map_of(grid, {gap}), grid, GapMap::right, limit, width);
    };
    CHECK(area([](double, double) { return 0.001; }, 0.001).share() == 1);
    CHECK(area([](double, double) { return std::nextafter(0.001, 1.0); }, 0.001).share() == 0);
    // edge exactly along a row of points, from either side
    CHECK(area([](double, double y) { return y; }, 0.25).share() == Approx(0.5).epsilon(1e-14));
    CHECK(area([](double, double y) { return -y; }, -0.25).share() == Approx(0.5).epsilon(1e-14));
    // a line and a point have no area
    CHECK(area([](double, double y) { return std::abs(y - 0.25); }, 0).contact == 0);
    CHECK(area([](double z, double y) { return std::abs(y - 0.25) + std::abs(z); }, 0).contact == 0);
    CHECK(area([](double z, double y) { return std::abs(y - 0.25) + std::abs(z); }, 0).spaces == 0);
    CHECK(contact::ContactArea{}.share() == 0);
}

TEST_CASE("contact area of a curved gap converges with the square of the spacing", "[contact_area]")
{
    // an ellipse about the middle: area pi a b, with a = 2 and b = 0.15
    auto const gap = [](double z, double y) { return std::pow(z / 2, 2) + std::pow((y - 0.25) / 0.15, 2); };
    double before = 0;
    for (int const n : {33, 65, 129}) {
        std::vector<double> z, share;
        for (int i = 0; i < n; ++i) {
            z.push_back(-3.5 + 7.0 * i / (n - 1));
            share.push_back(static_cast<double>(i) / (n - 1));
        }
        contact::FlankGrid const grid = flat_flank(z, share, height);
        GapMap const map = map_of(grid, {gap});
        double const fine = contact::contact_area(map, grid, GapMap::right, 1, width).contact;
        double const error = std::abs(fine - std::numbers::pi * 2 * 0.15);
        INFO(n << ": error " << error);
        CHECK(error < 4e-2 * 33 * 33 / (n * n));
        if (before > 0)
            CHECK(before / error == Approx(4).epsilon(0.2));
        before = error;
    }
}

TEST_CASE("contact area against Monte Carlo on triangles", "[contact_area]")
{
    // one cell, arbitrary corner gaps: the gap is linear in the four triangles about the middle
    contact::FlankGrid const grid = flat_flank({-3.5, 3.5}, {0, 1}, height);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1, 1), unit(0, 1);
    for (int i = 0; i < 12; ++i) {
        GapMap map = map_of(grid, {[](double, double) { return 0.0; }});
        for (double& gap : map.gap)
            gap = any(random);
        double const a = map.at(0, 1, 0, 0), b = map.at(0, 1, 0, 1), c = map.at(0, 1, 1, 1), d = map.at(0, 1, 1, 0);
        double const middle = 0.25 * (a + b + c + d);
        int below = 0;
        constexpr int samples = 40000;
        for (int k = 0; k < samples; ++k) {
            double const x = unit(random), y = unit(random);  // x along z, y along the flank
            // the triangle by the side that is nearest: bottom y = 0 (a, d), right x = 1 (d, c), top (b, c), left (a,
            // b)
            double const to_side = std::min(std::min(x, 1 - x), std::min(y, 1 - y));
            bool const flat = to_side == y || to_side == 1 - y;
            double const p = to_side == y ? a : to_side == 1 - y ? b : to_side == x ? a : d;
            double const q = to_side == y ? d : to_side == 1 - y ? c : to_side == x ? b : c;
            double const along = flat ? x : y;
            // barycentric: weight of the middle 2 to_side
            double const gap = 2 * to_side * middle + (along - to_side) * q + (1 - along - to_side) * p;
            below += gap <= 0.1;
        }
        double const share = static_cast<double>(below) / samples;
        // five standard deviations
        CHECK(contact_area(map, grid, GapMap::right, 0.1, width).share() ==
              Approx(share).margin(5 * 0.5 / std::sqrt(samples)));
    }
}

TEST_CASE("contact area of one slice is its share of length over the whole width", "[contact_area]")
{
    contact::FlankGrid const grid = flat_flank({0.0}, stations, height);
    GapMap const map = map_of(grid, {[](double, double y) { return y; }, [](double, double y) { return y - 1; },
                                     [](double, double y) { return y + 1; }});
    contact::ContactArea const area = contact::contact_area(map, grid, GapMap::right, 0.125, width);
    CHECK(area.whole == Approx(3 * width * height).epsilon(1e-14));
    CHECK(area.contact == Approx(width * (0.125 + height)).epsilon(1e-13));
    CHECK(area.spaces == 2);
}

TEST_CASE("contact area looks at the flank it is asked for and does not know left from right", "[contact_area]")
{
    contact::FlankGrid const grid = flat_flank(slices, stations, height);
    GapMap map = map_of(grid, {[](double z, double y) { return 0.4 * z + 3 * y * y - 0.3; }});
    contact::ContactArea const right = contact::contact_area(map, grid, GapMap::right, 0, width);
    contact::ContactArea const left = contact::contact_area(map, grid, GapMap::left, 0, width);
    CHECK(right.contact == left.contact);
    CHECK(right.whole == left.whole);
    for (std::size_t k = 0; k < grid.slices(); ++k)
        for (std::size_t i = 0; i < grid.points(); ++i)
            map.gap[map.index(0, GapMap::left, k, i)] = 1;
    CHECK(contact_area(map, grid, GapMap::left, 0, width).contact == 0);
    CHECK(contact_area(map, grid, GapMap::right, 0, width).contact == right.contact);
}

TEST_CASE("contact area grows with the limit and never beyond the flank", "[contact_area]")
{
    contact::FlankGrid const grid = flat_flank(slices, stations, height);
    GapMap const map = map_of(grid, {[](double z, double y) { return std::sin(3 * z) + std::cos(9 * y); }});
    double before = 0;
    for (double limit = -2.1; limit < 2.2; limit += 0.01) {
        contact::ContactArea const area = contact::contact_area(map, grid, GapMap::right, limit, width);
        CHECK(area.contact >= before);
        CHECK(area.contact <= area.whole * (1 + 1e-15));
        before = area.contact;
    }
    CHECK(before == Approx(width * height).epsilon(1e-14));
}

}  // namespace hdconj::test::contact_area_cases
