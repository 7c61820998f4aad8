// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/gap_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/oracle/tooth.hpp"

namespace hdconj::test::gap_field_cases {

namespace {

/// Places and field that belong together.
struct Field
{
    Field(ConedDrive const& drive, contact::FlankGrid const& grid, double phase_)
        : phase(phase_),
          places(contact::tooth_places(*drive.context, phase, drive.context->maker.z())),
          field(drive.tooth, grid, places, drive.z_f(), drive.z_c(), phase)
    {
    }
    double phase;
    contact::ToothPoses places;
    contact::GapField field;
};

Vec2 of(oracle::Point<double> const& p)
{
    return {p.x, p.y};
}

/// All teeth of one slice in the fixed frame, by the oracle's tooth and motion.
struct PlacedTeeth
{
    PlacedTeeth(ConedDrive const& drive, std::size_t slice, double phase)
        : scene(drive.slice_scene(slice)), tooth(scene), motion(scene)
    {
        double const k = static_cast<double>(drive.z_f()) / drive.z_c();
        for (int i = 0; i < drive.z_f(); ++i) {
            double const phi = 2 * std::numbers::pi * i / drive.z_f() + phase;
            oracle::Pose<double> pose = motion.pose(oracle_parameter(motion, phi), phi);
            for (auto* v : {&pose.origin, &pose.along, &pose.outward})
                *v = oracle::turned_clockwise(*v, k * phi);
            poses.push_back(pose);
        }
    }
    /// Signed distance of a point of the fixed frame to the nearest of all teeth.
    [[nodiscard]] double distance(Vec2 const& p) const
    {
        double best = std::numeric_limits<double>::infinity();
        for (auto const& pose : poses) {
            oracle::Point<double> const x = pose.to_tooth({p.x(), p.y()});
            if (x.y > 0 && std::abs(x.x) < 3 * tooth.half_width)
                best = std::min(best, tooth.distance(x));
        }
        return best;
    }
    Scene scene;
    oracle::Tooth<double> tooth;
    oracle::Motion<double> motion;
    std::vector<oracle::Pose<double>> poses;
};

Vec2 in_fixed_frame(Vec2 const& p, double space_angle)
{
    return turned_clockwise(p, space_angle);
}

}  // namespace

TEST_CASE("gap map of a coned drive is what the oracle finds among all teeth", "[gap_field]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 60);
    double worst = 0;
    int negative = 0;
    for (double const angle : {0.0, 0.31 * deg, -1.2 * deg}) {
        Field const f(drive, grid, contact::phase_of(drive.scene, angle));
        GapMap const map = f.field.map(0, 1);
        REQUIRE(map.angle.size() == static_cast<std::size_t>(drive.z_c()));
        for (std::size_t k = 0; k < grid.slices(); ++k) {
            PlacedTeeth const teeth(drive, k, f.phase);
            for (std::size_t space = k; space < map.angle.size(); space += 5)
                for (int flank : {0, 1})
                    for (std::size_t i = space % 3; i < grid.points(); i += 3) {
                        Vec2 const p =
                            in_fixed_frame(grid.point[static_cast<std::size_t>(flank)][k][i], map.angle[space]);
                        double const expected = teeth.distance(p);
                        double const found = map.at(space, flank, k, i);
                        worst = std::max(worst, std::abs(found - expected));
                        negative += found < -1e-3;
                        // at angle 0 a left flank has the gap of the right one on the other side, -100 ... 100
                        std::size_t const last = map.angle.size() - 2;
                        bool const image = angle == 0 && flank == GapMap::left && space <= last;
                        CHECK(found == (image ? f.field.gap({last - space, GapMap::right, k, i}, 0)
                                              : f.field.gap({space, flank, k, i}, 0)));
                    }
        }
    }
    INFO("worst difference " << worst);
    CHECK(worst < 1e-12);
    CHECK(negative > 20);
}

TEST_CASE("gap map against a million points on the teeth", "[gap_field]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::per_slice), 100);
    double const phase = contact::phase_of(drive.scene, 0.17 * deg);
    Field const f(drive, grid, phase);
    GapMap const map = f.field.map(0, 1);
    for (std::size_t const k : {0u, 2u}) {
        PlacedTeeth const teeth(drive, k, phase);
        // the same number of points on every piece of every tooth, evenly by length
        constexpr std::size_t per_tooth = 5000;
        std::vector<Vec2> samples;
        double spacing = 0;
        std::size_t const pieces = teeth.tooth.pieces_of_whole();
        std::size_t const per_piece = per_tooth / pieces;
        for (auto const& pose : teeth.poses) {
            Vec2 before = Vec2::Zero();
            for (std::size_t piece = 0; piece < pieces; ++piece)
                for (std::size_t i = 0; i <= per_piece; ++i) {
                    auto const q =
                        teeth.tooth.on_whole(piece, static_cast<double>(i) / static_cast<double>(per_piece)).point;
                    Vec2 const p = of(pose.to_circular_spline(q));
                    if (piece + i > 0)
                        spacing = std::max(spacing, (p - before).norm());
                    before = p;
                    samples.push_back(p);
                }
        }
        REQUIRE(samples.size() >= 1000000);
        std::size_t const each = samples.size() / teeth.poses.size();
        double worst = 0, nearest_gap = 1;
        for (std::size_t space = 0; space < map.angle.size(); space += 7)
            for (int flank : {0, 1})
                for (std::size_t i = 0; i < grid.points(); i += 11) {
                    Vec2 const p = in_fixed_frame(grid.point[static_cast<std::size_t>(flank)][k][i], map.angle[space]);
                    double sampled = std::numeric_limits<double>::infinity();
                    for (std::size_t t = 0; t < teeth.poses.size(); ++t)
                        if ((of(teeth.poses[t].origin) - p).norm() < 2.5)
                            for (std::size_t s = t * each; s < (t + 1) * each; ++s)
                                sampled = std::min(sampled, (samples[s] - p).squaredNorm());
                    sampled = std::sqrt(sampled);
                    double const gap = std::abs(map.at(space, flank, k, i));
                    // the nearest sample lies within half a spacing of the foot, across the gap; the back of an arc of
                    // radius r falls off, which makes (spacing/2)^2 larger by 1 + gap/r, and no arc of this tooth has r
                    // < 0.25
                    double const bound =
                        std::sqrt(gap * gap + 0.25 * (1 + gap / 0.25) * spacing * spacing) - gap + 1e-12;
                    worst = std::max(worst, (sampled - gap) / bound);
                    nearest_gap = std::min(nearest_gap, gap);
                    CHECK(sampled >= gap - 1e-12);
                    CHECK(sampled - gap <= bound);
                }
        INFO("spacing " << spacing << ", largest difference as a share of the bound " << worst << ", least gap "
                        << nearest_gap);
        CHECK(spacing < 6e-4);
        CHECK(worst > 0.1);
        CHECK(nearest_gap < 5e-5);
    }
}

TEST_CASE("gap map of a wave generator turned by one tooth is the same map one space on", "[gap_field]")
{
    for (std::string const shift : {"none", "mapped"}) {
        ConedDrive drive(builtin_scene(coned(shift)), 3);
        contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 20);
        double const phase = 0.3 * 2 * std::numbers::pi / drive.z_f();
        Field const one(drive, grid, phase);
        Field const next(drive, grid, phase + 2 * std::numbers::pi / drive.z_f());
        GapMap const a = one.field.map(1e-4, 1);
        GapMap const b = next.field.map(1e-4, 1);
        std::size_t const row = 2 * grid.slices() * grid.points();
        double worst = 0;
        for (std::size_t space = 0; space < a.angle.size(); ++space) {
            // the last one goes on over the end of the turn
            std::size_t const from = (space + 1) % a.angle.size();
            for (std::size_t i = 0; i < row; ++i)
                worst = std::max(worst, std::abs(b.gap[space * row + i] - a.gap[from * row + i]));
            CHECK(std::abs(std::remainder(b.angle[space] - a.angle[from], 2 * std::numbers::pi)) < 1e-14);
        }
        INFO(shift << ": worst " << worst);
        CHECK(worst < 1e-12);
        CHECK(a.gap != b.gap);
        // and phase_of() knows that these are the same
        double const angle = -phase * drive.z_f() / drive.z_c();
        CHECK(contact::phase_of(drive.scene, angle) == Approx(phase).epsilon(1e-12));
        CHECK(contact::phase_of(drive.scene, angle - drive.pitch()) == Approx(phase).epsilon(1e-12));
    }
}

TEST_CASE("gap map seen in a mirror is that of the mirrored angle and turn", "[gap_field]")
{
    for (std::string const shift : {"none", "mapped"}) {
        ConedDrive drive(builtin_scene(coned(shift)), 3);
        contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 20);
        double const phase = 0.2 * 2 * std::numbers::pi / drive.z_f();
        constexpr double turn = 3e-4;
        Field const plus(drive, grid, phase);
        Field const minus(drive, grid, -phase);
        GapMap const a = plus.field.map(turn, 1);
        GapMap const b = minus.field.map(-turn, 1);
        std::size_t const spaces = a.angle.size();
        double worst = 0, difference = 0;
        for (std::size_t space = 0; space < spaces; ++space) {
            // spaces -100 ... 101: number m is at m + 100, and 101 is its own image half a turn away
            std::size_t const image = space + 1 == spaces ? space : spaces - 2 - space;
            for (std::size_t k = 0; k < grid.slices(); ++k)
                for (std::size_t i = 0; i < grid.points(); ++i) {
                    worst =
                        std::max(worst, std::abs(a.at(space, GapMap::right, k, i) - b.at(image, GapMap::left, k, i)));
                    difference = std::max(difference,
                                          std::abs(a.at(space, GapMap::right, k, i) - a.at(image, GapMap::left, k, i)));
                }
        }
        INFO(shift << ": worst " << worst);
        CHECK(worst < 1e-12);
        CHECK(difference > 1e-4);
    }
}

TEST_CASE("turning the flexspline clockwise is turning each of its teeth clockwise about the axis", "[gap_field]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 20);
    Field const f(drive, grid, 0.003);
    for (double const turn : {2e-4, -1e-3}) {
        contact::ToothPoses turned = f.places;
        for (Pose& pose : turned.pose) {
            double const theta = std::atan2(pose.sine, pose.cosine) + turn;
            pose = {std::cos(theta), std::sin(theta), turned_clockwise(pose.origin, turn)};
        }
        contact::GapField const other(drive.tooth, grid, turned, drive.z_f(), drive.z_c(), f.phase);
        GapMap const a = f.field.map(turn, 1), b = other.map(0, 1);
        double worst = 0;
        for (std::size_t i = 0; i < a.gap.size(); ++i)
            worst = std::max(worst, std::abs(a.gap[i] - b.gap[i]));
        CHECK(worst < 1e-12);
        CHECK(f.field.map(0, 1).gap != a.gap);
    }
}

TEST_CASE("gap map has the same bits for 1 2 and 4 threads", "[gap_field][parallel]")
{
    ConedDrive drive(builtin_scene(coned("mapped")), 5);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 100);
    Field const f(drive, grid, 0.001);
    GapMap const one = f.field.map(1e-4, 1);
    CHECK(f.field.map(1e-4, 2).gap == one.gap);
    CHECK(f.field.map(1e-4, 4).gap == one.gap);
}

TEST_CASE("no gap changes faster than the reach of the flanks times the turn", "[gap_field]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 40);
    Field const f(drive, grid, 0.002);
    GapMap const before = f.field.map(0, 1);
    double fastest = 0;
    for (double const turn : {1e-5, -1e-4, 1e-3}) {
        GapMap const after = f.field.map(turn, 1);
        for (std::size_t i = 0; i < before.gap.size(); ++i)
            fastest = std::max(fastest, std::abs(after.gap[i] - before.gap[i]) / std::abs(turn));
    }
    CHECK(fastest <= f.field.reach() * (1 + 1e-9));
    CHECK(fastest > 0.5 * f.field.reach());
}

TEST_CASE("a grid moved into the material by nothing keeps its bits and else moves by the clearance", "[gap_field]")
{
    ConedDrive drive(builtin_scene(), 1);
    contact::FlankGrid const grid = drive.flanks(drive.surface(ToothSurface::tilted), 40);
    contact::FlankGrid const same = contact::moved_into_material(grid, 0);
    CHECK(same.point == grid.point);
    contact::FlankGrid const moved = contact::moved_into_material(grid, 0.013);
    Field const f(drive, grid, 0), g(drive, moved, 0);
    int further = 0;
    for (std::size_t flank = 0; flank < 2; ++flank)
        for (std::size_t i = 0; i < grid.points(); ++i) {
            // where two branches overlap their crossing is further off than either was moved: 1/cos of half a corner of
            // 9 degrees
            double const way = (moved.point[flank][0][i] - grid.point[flank][0][i]).norm();
            CHECK(way >= 0.013 * (1 - 1e-12));
            CHECK(way <= 0.013 * 1.004);
            further += way > 0.013 * (1 + 1e-12) ? 1 : 0;
            CHECK(grid.normal[flank][0][i].norm() == Approx(1).epsilon(1e-14));
            // into the material is away from the teeth: on the right flank to the right
            CHECK((flank == 1 ? 1 : -1) * grid.normal[flank][0][i].x() > 0);
        }
    GapMap const a = f.field.map(0, 1), b = g.field.map(0, 1);
    CHECK(further <= 4);
    for (std::size_t space = 0; space < a.angle.size(); ++space)
        for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
            for (std::size_t i = 0; i < grid.points(); ++i) {
                auto const side = static_cast<std::size_t>(flank);
                double const way = (moved.point[side][0][i] - grid.point[side][0][i]).norm();
                CHECK(b.at(space, flank, 0, i) <= a.at(space, flank, 0, i) + way + 1e-12);
            }
}

}  // namespace hdconj::test::gap_field_cases
