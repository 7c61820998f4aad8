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
    CHECK(twice.noise == once.noise);
    CHECK(twice.placement.turn.error == once.placement.turn.error);
    REQUIRE(twice.notes.size() == 1);
    CHECK(twice.notes.front() == "250 points stand in the file again, and are used once");
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
