// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/flank_deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/gap_field.hpp"
#include "hdconj/profile/profile.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::flank_deviation_cases {

namespace {

/// A drive with one outline on three slices, and its gaps for any deviation.
struct Flanks
{
    ConedDrive drive{builtin_scene(coned()), 3};
    contact::FlankGrid grid = drive.flanks(drive.surface(ToothSurface::tilted), 60);
    contact::ToothPoses places = contact::tooth_places(*drive.context, 0, drive.context->maker.z());

    [[nodiscard]] contact::GapField field(contact::FlankDeviation const* deviation) const
    {
        return {
            drive.tooth, grid,     places, drive.scene.drive.flexspline_teeth, drive.scene.drive.circular_spline_teeth,
            0,           deviation};
    }
};

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
    Flanks const flanks;
    contact::FlankDeviation const none;
    contact::FlankDeviation const zero{{0, 0, 0}};
    GapMap const map = flanks.field(nullptr).map(1e-4, 1);
    CHECK(flanks.field(&none).map(1e-4, 1).gap == map.gap);
    CHECK(flanks.field(&zero).map(1e-4, 1).gap == map.gap);
}

TEST_CASE("a slice that stands back opens all its gaps by the same amount", "[gap_field]")
{
    Flanks const flanks;
    contact::FlankDeviation const ends{{4e-3, 0, 1e-3}};
    GapMap const before = flanks.field(nullptr).map(0, 1), after = flanks.field(&ends).map(0, 1);
    for (std::size_t space = 0; space < before.angle.size(); space += 7)
        for (int const flank : {0, 1})
            for (std::size_t k = 0; k < 3; ++k)
                for (std::size_t i = 0; i < before.station.size(); i += 5)
                    CHECK(after.at(space, flank, k, i) - before.at(space, flank, k, i) ==
                          Approx(ends.slice[k]).margin(1e-15));
}

TEST_CASE("gaps with a tip relief are distances to the relieved tooth, and their normals its normals", "[gap_field]")
{
    Flanks const flanks;
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

}  // namespace hdconj::test::flank_deviation_cases
