// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/flank_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contact/gap_field.hpp"
#include "hdconj/profile/profile.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::flank_deviation_cases {

namespace {

/// A relief that begins at the height @p from above the pitch line.
struct Relief
{
    double amount, from, pitch_line, addendum;
    double operator()(double y) const
    {
        double const share = std::max(0.0, (y - pitch_line - from) / (addendum - from));
        return amount * share * share;
    }
};

/// Points of the right half of a tooth, moved into the material by a relief.
std::vector<Vec2> relieved(profile::Profile const& tooth, Relief const& relief)
{
    constexpr int steps = 4000;
    constexpr double h = 1e-6;
    std::vector<Vec2> points;
    for (profile::ProfilePiece const& piece : tooth.pieces)
        for (int i = 0; i <= steps; ++i) {
            double const t = static_cast<double>(i) / steps;
            Vec2 const p = profile::point_at(piece.shape, t);
            Vec2 const along = profile::point_at(piece.shape, std::min(1.0, t + h)) -
                               profile::point_at(piece.shape, std::max(0.0, t - h));
            if (along.norm() > 0)
                points.push_back(p - relief(p.y()) * left_of(along).normalized());
        }
    return points;
}

double distance_to(std::vector<Vec2> const& polygon, Vec2 const& x)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
        Vec2 const d = polygon[i + 1] - polygon[i];
        double const t = d.norm() > 0 ? std::clamp((x - polygon[i]).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
        best = std::min(best, (x - polygon[i] - t * d).norm());
    }
    return best;
}

}  // namespace

TEST_CASE("flanks that deviate by nothing keep every bit of their gaps", "[gap_field]")
{
    ConedFlanks const flanks;
    contact::FlankDeviation const none;
    contact::FlankDeviation const zero{{0, 0, 0}};
    GapMap const map = flanks.field(nullptr).map(1e-4, 1);
    CHECK(flanks.field(&none).map(1e-4, 1).gap == map.gap);
    CHECK(flanks.field(&zero).map(1e-4, 1).gap == map.gap);
}

TEST_CASE("a slice that stands back opens all its gaps by the same amount", "[gap_field]")
{
    ConedFlanks const flanks;
    contact::FlankDeviation const ends{{4e-3, 0, 1e-3}};
    constexpr double turn = 1e-4;  // no mirrored map, of which the left flanks are those of the other side
    GapMap const before = flanks.field(nullptr).map(turn, 1), after = flanks.field(&ends).map(turn, 1);
    for (std::size_t space = 0; space < before.angle.size(); space += 7)
        for (int const flank : {0, 1})
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t i = 0; i < before.station.size(); i += 5)
                    CHECK(after.at(space, flank, k, i) - before.at(space, flank, k, i) ==
                          Approx(ends.slice[k]).margin(1e-15));
}

TEST_CASE("gaps with a tip relief are distances to the relieved tooth, and their normals its normals", "[gap_field]")
{
    ConedFlanks const flanks;
    profile::Profile const& tooth = flanks.drive.tooth;
    Relief const relief{4e-3, 0.05, tooth.pitch_line, tooth.addendum};
    contact::FlankDeviation const tip{{}, relief};
    contact::GapField const plain = flanks.field(nullptr), made = flanks.field(&tip);
    std::vector<Vec2> const polygon = relieved(tooth, relief);
    constexpr double near = 0.02;
    int compared = 0;
    for (std::size_t space = 95; space < 108; ++space)
        for (int const flank : {0, 1})
            for (std::size_t i = 0; i < flanks.grid.points(); ++i) {
                contact::GapField::Index const at{space, flank, 1, i};
                auto const before = plain.touch(at, 0), after = made.touch(at, 0);
                double const opened = relief(before.nearest.point.y());
                CHECK(after.nearest.distance == Approx(before.nearest.distance + opened).margin(1e-15));
                CHECK(made.gap(at, 0) == after.nearest.distance);
                double const height = before.nearest.point.y() - tooth.pitch_line;
                if (!(opened > 0) || std::abs(before.nearest.distance) > near || height > 0.9 * tooth.addendum)
                    continue;
                ++compared;
                Vec2 const x = before.nearest.point + before.nearest.distance * before.nearest.normal;
                double const slope = 2 * relief.amount / (tooth.addendum - relief.from);
                double const off = slope * slope * near;
                CHECK(std::abs(after.nearest.distance) == Approx(distance_to(polygon, x)).margin(off));
                // the gradient, by differences of gaps
                constexpr double h = 1e-6;
                Vec2 const& q = flanks.grid.point[static_cast<std::size_t>(flank)][1][i];
                auto const gap = [&](Vec2 const& d) { return made.touch(space, 1, q + d, 0).nearest.distance; };
                Vec2 const gradient((gap({h, 0}) - gap({-h, 0})) / (2 * h), (gap({0, h}) - gap({0, -h})) / (2 * h));
                CHECK((after.normal - gradient.normalized()).norm() < 1e-6);
                CHECK(after.normal.norm() == Approx(1));
            }
    CHECK(compared > 100);
}

TEST_CASE("rings that are turned as a whole are a turn of the flexspline", "[gap_field]")
{
    ConedFlanks const flanks;
    constexpr double turn = 2e-4, beside = 1.3e-4;
    contact::GapField const plain = flanks.field(nullptr);
    auto const check = [&](contact::FlankDeviation const& deviation, double same_turn) {
        contact::GapField const turned = flanks.field(&deviation);
        std::vector<double> const a = turned.map(turn, 1).gap, b = plain.map(same_turn, 1).gap;
        double worst = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            worst = std::max(worst, std::abs(a[i] - b[i]));
        CHECK(worst < 1e-13);
        CHECK(turned.touch({3, 0, 1, 10}, turn).turn == Approx(same_turn).epsilon(1e-14));
    };
    contact::FlankDeviation teeth, spaces;
    teeth.teeth.assign(static_cast<std::size_t>(flanks.drive.z_f()), {beside, Vec2::Zero()});
    spaces.spaces.assign(static_cast<std::size_t>(flanks.drive.z_c()), {beside, Vec2::Zero()});
    check(teeth, turn + beside);
    check(spaces, turn - beside);
}

TEST_CASE("an eccentric ring changes gaps in opposite zones by opposite amounts", "[gap_field]")
{
    ConedFlanks const flanks;
    constexpr double e = 1e-4, direction = 0.4;
    // flanks and teeth are no more curved than their radii of 0.1 mm tell
    constexpr double second_order = e * e / 0.1;
    contact::GapField const plain = flanks.field(nullptr);
    auto const ring = [&](int count) {
        std::vector<contact::Displacement> all;
        for (int i = 0; i < count; ++i) {
            double const angle = direction - 2 * std::numbers::pi * i / count;
            all.push_back({0, e * Vec2(std::sin(angle), std::cos(angle))});
        }
        return all;
    };
    contact::FlankDeviation teeth, spaces;
    teeth.teeth = ring(flanks.drive.z_f());
    spaces.spaces = ring(flanks.drive.z_c());
    std::size_t const middle = plain.spaces() / 2, half = middle;
    for (std::size_t const space : {std::size_t{2}, std::size_t{5}, std::size_t{12}})
        for (int const flank : {0, 1})
            for (std::size_t i = 0; i < flanks.grid.points(); i += 9)
                for (contact::FlankDeviation const* const deviation : {&teeth, &spaces}) {
                    contact::GapField const made = flanks.field(deviation);
                    double change[2];
                    for (std::size_t zone = 0; zone < 2; ++zone) {
                        contact::GapField::Index const at{space + zone * half, flank, 1, i};
                        auto const touch = plain.touch(at, 0);
                        change[zone] = made.gap(at, 0) - plain.gap(at, 0);
                        int const number = static_cast<int>(at.space) - static_cast<int>(middle) + 1;
                        Vec2 const shift = contact::displacement_at(spaces.spaces, number).shift;
                        double const expected =
                            deviation == &spaces
                                ? touch.normal.dot(shift)
                                : -touch.nearest.normal.dot(contact::displacement_at(teeth.teeth, touch.tooth).shift);
                        CHECK(change[zone] == Approx(expected).margin(second_order));
                    }
                    CHECK(change[0] == Approx(-change[1]).margin(2 * second_order));
                }
}

TEST_CASE("a ring that wobbles is eccentric in each slice by another amount", "[gap_field]")
{
    ConedFlanks const flanks;
    std::vector<double> const& z = flanks.drive.context->maker.z();
    REQUIRE(z.size() == 3);
    auto const ring = [](int count, double eccentric, double wobble) {
        std::vector<contact::Displacement> all;
        for (int i = 0; i < count; ++i) {
            double const angle = 0.4 - 2 * std::numbers::pi * i / count;
            Vec2 const direction(std::sin(angle), std::cos(angle));
            all.push_back({0, eccentric * direction, wobble * direction});
        }
        return all;
    };
    constexpr double wobble = 3e-4, eccentricity = 1e-3;
    auto const map = [&](double eccentric, double lean) {
        contact::FlankDeviation deviation;
        deviation.teeth = ring(flanks.drive.z_f(), eccentric, lean);
        deviation.spaces = ring(flanks.drive.z_c(), -eccentric, -lean);
        deviation.z = z;
        return flanks.field(&deviation).map(0, 1);
    };
    GapMap const wobbling = map(eccentricity, wobble);
    for (std::size_t k = 0; k < z.size(); ++k) {
        GapMap const eccentric = map(eccentricity + wobble * z[k], 0);
        for (std::size_t space = 0; space < wobbling.angle.size(); space += 3)
            for (int const flank : {0, 1})
                for (std::size_t i = 0; i < wobbling.station.size(); i += 5)
                    CHECK(wobbling.at(space, flank, k, i) == Approx(eccentric.at(space, flank, k, i)).margin(1e-14));
    }
    CHECK(map(eccentricity, 0).gap != wobbling.gap);
}

}  // namespace hdconj::test::flank_deviation_cases
