// SPDX-License-Identifier: GPL-3.0-or-later
// Points that name teeth, flanks and planes which the part has not, and points that stand in the file again.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"

namespace hdconj::test::plane_points_cases {

namespace {

constexpr int teeth = 200;

/// Points of some teeth of the built-in drive, each with its tooth and its flank.
PointFile labelled(double noise = 0)
{
    MeasuredRing ring;
    ring.measured = {0, 1, 40, 90, 150};
    ring.noise = noise;
    designs::Draws draws(7);
    PointFile file = points_of(ring, draws);
    file.file = "points.csv";
    int line = 1;
    for (PartPoint& point : file.points) {
        double const pitches = std::atan2(point.where.x(), point.where.y()) / (2 * std::numbers::pi / teeth);
        double const nearest = std::round(pitches);
        point.tooth = (static_cast<int>(nearest) + teeth) % teeth + 1;
        point.right = pitches > nearest;
        point.line = ++line;
    }
    return file;
}

std::string refusal(PointFile const& file, InspectOptions const& options = {})
{
    try {
        (void)inspect_points(builtin_scene(), file, options);
    } catch (InputError const& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("numbers of teeth that the part has not are refused", "[inspect]")
{
    PointFile file = labelled();
    CHECK(refusal(file).empty());
    for (PartPoint& point : file.points)
        point.tooth += 100;
    CHECK_THAT(refusal(file), ContainsSubstring("points.csv line 202: column tooth = 251: the part has 200 teeth "
                                                "(write a number from 1 to 200)") &&
                                  ContainsSubstring("further lines: 30 more faults are not listed"));
}

TEST_CASE("points of one number on several teeth, and of two numbers on one, are refused", "[inspect]")
{
    PointFile file = labelled();
    for (PartPoint& point : file.points)
        point.tooth = 3;
    CHECK_THAT(refusal(file), ContainsSubstring("column tooth = 3: the points of this tooth stand on 5 teeth"));
    file = labelled();
    for (PartPoint& point : file.points)
        if (point.tooth == 1 && *point.right)
            point.tooth = 9;
    CHECK_THAT(refusal(file),
               ContainsSubstring("column tooth = 9: the points of this tooth stand on that of number 1"));
    for (PartPoint& point : file.points)  // numbers that are counted from another tooth are none of a fault
        point.tooth = (point.tooth == 9 ? 1 : point.tooth) + 5;
    CHECK(refusal(file).empty());
}

TEST_CASE("numbers that do not count the teeth clockwise are refused", "[inspect]")
{
    PointFile const file = labelled();
    auto const renumbered = [&](auto number) {
        PointFile other = file;
        for (PartPoint& point : other.points)
            point.tooth = number(point.tooth);
        return refusal(other);
    };
    auto const mirrored = [](int tooth) { return teeth + 1 - tooth; };
    CHECK_THAT(renumbered(mirrored), ContainsSubstring("the numbers run counter-clockwise, and teeth are counted "
                                                       "clockwise (write 201 less each number, or leave "));
    CHECK_THAT(renumbered([&](int tooth) { return mirrored((tooth + 36) % teeth + 1); }),
               ContainsSubstring("the numbers run counter-clockwise"));
    CHECK_THAT(renumbered([](int tooth) { return tooth == 41 ? 42 : tooth; }),
               ContainsSubstring("column tooth = 42: 1 of 5 numbers do not count the teeth clockwise: by the others "
                                 "this tooth is number 41"));
    CHECK_THAT(renumbered([](int tooth) { return tooth == 1   ? 2
                                                 : tooth == 2 ? 1
                                                              : tooth * 7 % 199 + 3; }),
               ContainsSubstring("numbers do not count the teeth clockwise"));
    for (int const from : {1, 60, 199})  // wherever they begin
        CHECK(renumbered([&](int tooth) { return (tooth + from) % teeth + 1; }).empty());
}

TEST_CASE("a tooth of the layer that solve writes is told to be the assembled one", "[inspect]")
{
    PointFile file = labelled();
    for (PartPoint& point : file.points)
        point.where *= 1 + 0.25 / point.where.norm();
    InspectOptions options;
    options.registration = Registration::datum;
    for (bool const own : {false, true}) {
        file.layers = {own ? "FLEXSPLINE_TOOTH" : "0"};
        auto const notes = inspect_points(builtin_scene(), file, options).notes;
        CHECK(own == std::ranges::any_of(notes, [](std::string const& note) {
                  return note.find("draws the assembled tooth at the major axis") != std::string::npos;
              }));
    }
}

TEST_CASE("flanks that are exchanged are refused, wherever the part is turned to", "[inspect]")
{
    for (double const turn : {0.0, 0.3, -0.45})
        for (Registration const registration :
             {Registration::turn, Registration::least_squares, Registration::minimum_zone}) {
            CAPTURE(turn);
            PointFile file = labelled(1e-4);
            for (PartPoint& point : file.points)
                point.where = turned_clockwise(point.where, turn * 2 * std::numbers::pi / teeth);
            InspectOptions options;
            options.registration = registration;
            CHECK(refusal(file, options).empty());
            for (PartPoint& point : file.points)
                point.right = !*point.right;
            CHECK_THAT(refusal(file, options), ContainsSubstring("points.csv: column flank: 250 of 250 points stand on "
                                                                 "the flank opposite to the one that they name") &&
                                                   ContainsSubstring("exchange left and right"));
        }
}

TEST_CASE("flanks with deviations as wide as a tenth of a module keep their names", "[inspect]")
{
    PointFile file = labelled(0.025);
    CHECK(refusal(file).empty());
}

TEST_CASE("points that stand in the file again are used once", "[inspect]")
{
    PointFile const file = labelled(2e-4);
    PointFile doubled = file;
    doubled.points.insert(doubled.points.end(), file.points.begin(), file.points.end());
    Inspection const once = inspect_points(builtin_scene(), file, {}),
                     twice = inspect_points(builtin_scene(), doubled, {});
    CHECK(once.notes.empty());
    CHECK(twice.points.size() == once.points.size());
    CHECK(twice.repeated == file.points.size());
    CHECK(twice.noise == once.noise);
    CHECK(twice.placement.turn.error == once.placement.turn.error);
    REQUIRE(twice.notes.size() == 1);
    CHECK(twice.notes.front() == "250 points stand in the file again, and are used once");
}

TEST_CASE("heights that scatter or rise are one plane, and change no figure of equal sections", "[inspect]")
{
    PointFile file = labelled(2e-4);
    Inspection const flat = inspect_points(builtin_scene(), file, {});
    designs::Draws draws(11);
    file.has_z = true;
    auto const with_heights = [&](auto height) {
        for (PartPoint& point : file.points)
            point.z = height(point);
        Inspection found = inspect_points(builtin_scene(), file, {});
        CHECK(found.nominal.size() == 1);
        CHECK(found.points.size() == file.points.size());
        CHECK(found.elsewhere + found.repeated == 0);
        CHECK(found.sides[1].total_pitch.value == flat.sides[1].total_pitch.value);
        return found;
    };
    for (double const width : {0.004, 0.02, 0.3, 6.0}) {
        CAPTURE(width);
        Inspection const even = with_heights([&](PartPoint const&) { return draws.between(-width / 2, width / 2); });
        CHECK(even.notes.empty() == (width < 0.04));
        Inspection const bell = with_heights([&](PartPoint const&) { return width / 8 * normal(draws); });
        CHECK(bell.notes.empty() == (width < 0.04));
    }
}

TEST_CASE("the intervals of a part that leans hold what a flat one has", "[inspect]")
{
    MeasuredRing ring;
    ring.points = 5;
    ring.noise = 2e-4;
    designs::Draws draws(5);
    PointFile const level = points_of(ring, draws);
    PlaneFigures const upright = inspect_points(scene_of(ring), level, {}).planes.front();
    for (double const slope : {1e-3, 0.01, 0.05}) {
        CAPTURE(slope);
        PointFile file = level;
        file.has_z = true;
        for (PartPoint& point : file.points) {
            point.where.x() *= std::cos(std::atan(slope));
            point.z = slope * point.where.x();
        }
        Inspection const found = inspect_points(scene_of(ring), file, {});
        CHECK(found.nominal.size() == 1);
        CHECK(found.points.size() == file.points.size());
        REQUIRE(found.notes.size() == 1);
        CHECK_THAT(found.notes.front(), ContainsSubstring("it leans by") && ContainsSubstring("lay the part flat"));
        PlaneFigures const& leaning = found.planes.front();
        CHECK(std::abs(leaning.runout.value - upright.runout.value) < leaning.runout.error);
        CHECK(std::abs(leaning.thickness.value - upright.thickness.value) < leaning.thickness.error);
    }
}

TEST_CASE("planes of few points stay apart, and points of other planes are counted", "[inspect]")
{
    PointFile const one = labelled(2e-4);
    PointFile file = one;
    designs::Draws draws(12);
    file.points.clear();
    for (double const z : {-1.0, 0.4, 1.0})
        for (PartPoint point : one.points) {
            point.z = z + 0.004 * normal(draws);
            file.points.push_back(point);
        }
    file.has_z = true;
    Inspection const all = inspect_points(builtin_scene(), file, {});
    CHECK(all.nominal.size() == 3);
    CHECK(all.points.size() == file.points.size());
    InspectOptions options;
    options.plane = 0.41;
    Inspection const alone = inspect_points(builtin_scene(), file, options);
    CHECK(alone.points.size() == one.points.size());
    CHECK(alone.elsewhere == 2 * one.points.size());
}

TEST_CASE("planes that have no tooth in common are told", "[inspect]")
{
    PointFile file = labelled(2e-4);
    file.has_z = true;
    for (PartPoint& point : file.points)
        point.z = 0.1 * point.tooth / teeth;  // as a few teeth of a part that leans
    Inspection const found = inspect_points(builtin_scene(), file, {});
    CHECK(found.nominal.size() > 1);
    CHECK(std::ranges::any_of(found.notes, [](std::string const& note) {
        return note.find("planes have no tooth in common") != std::string::npos;
    }));
}

TEST_CASE("without a cup the teeth of a flexspline are as wide as the circular spline", "[inspect]")
{
    auto const reading = examine_scene_file(HDCONJ_SOURCE_DIR "/data/scenes/type-50.toml",
                                            {"!flexspline.cup", "circular_spline.width=7"});
    REQUIRE(reading.faults.empty());
    PointFile file = labelled();
    file.has_z = true;
    for (PartPoint& point : file.points)
        point.z = 3.51;
    CHECK(inspect_points(reading.scene, file, {}).points.size() == file.points.size());
    for (PartPoint& point : file.points)
        point.z = 5;
    CHECK_THROWS_WITH(inspect_points(reading.scene, file, {}),
                      ContainsSubstring("points.csv line 2: z = 5: the teeth of the flexspline stand between z = -3.5 "
                                        "and 3.5 mm") &&
                          ContainsSubstring("flexspline.cup"));
}

TEST_CASE("planes beside the teeth are refused on either part", "[inspect]")
{
    PointFile file = labelled();
    file.has_z = true;
    for (PartPoint& point : file.points)
        point.z = 4.01;  // the teeth of the cup end at 4
    CHECK(refusal(file).empty());
    file.points[3].z = 50;
    CHECK_THAT(refusal(file), ContainsSubstring("points.csv line 5: z = 50: the teeth of the flexspline stand between "
                                                "z = -4 and 4 mm"));
    InspectOptions options;
    options.part = InspectedPart::circular_spline;
    CHECK_THAT(refusal(file, options), ContainsSubstring("z = 4.01: the circular spline stands between z = -3.5 and "
                                                         "3.5 mm") &&
                                           ContainsSubstring("z = 50"));
    file.has_z = false;
    options.plane = -3.6;
    CHECK_THAT(refusal(file, options), ContainsSubstring("--plane = -3.6: the circular spline stands between"));
}

}  // namespace hdconj::test::plane_points_cases
