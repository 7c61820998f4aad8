// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/error.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/result_files.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/measured_ring.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::point_file_cases {

namespace {

PointReading read_points(std::string const& text)
{
    TemporaryFolder const folder;
    write(folder / "points.csv", text);
    return examine_points(folder / "points.csv");
}

/// A bad file, and words of the message.
struct BadPoints
{
    std::string text, reason, remedy;
};

}  // namespace

TEST_CASE("a file of points has its columns by name, in any order and with units", "[inspect]")
{
    auto const found = read_points(
        "# a comment\nflank;tooth;z [um];y;x [inch]; who\nright;7;-500;25.1;0.01;me\n"
        "L;201;0;-3;+1;\n");
    REQUIRE(found.faults.empty());
    REQUIRE(found.measured.points.size() == 2);
    CHECK(found.measured.has_z);
    PartPoint const& first = found.measured.points[0];
    CHECK(first.where == Vec2(0.254, 25.1));
    CHECK(first.z == Approx(-0.5));
    CHECK(first.tooth == 7);
    CHECK(first.right == true);
    CHECK(first.line == 3);
    CHECK(found.measured.points[1].right == false);

    auto const plain = read_points("\xef\xbb\xbfX,Y\r\n1,2\r\n");
    REQUIRE(plain.faults.empty());
    CHECK_FALSE(plain.measured.has_z);
    CHECK(plain.measured.points.front().tooth == 0);
    CHECK_FALSE(plain.measured.points.front().right.has_value());
}

TEST_CASE("the units that are said to be known are read", "[inspect]")
{
    std::string const said = read_points("x [kg],y\n1,2\n").faults.front().remedy;
    std::size_t units = 0;
    for (std::size_t at = said.find('['); at != std::string::npos; at = said.find('[', at + 1)) {
        ++units;
        std::string const heading = "x " + said.substr(at, said.find(']', at) + 1 - at);
        INFO(heading);
        CHECK(read_points(heading + ",y\n1,2\n").faults.empty());
    }
    CHECK(units > 3);
    CHECK(read_points("x [cm],y\n1,2\n").measured.points.front().where.x() == 10);
}

TEST_CASE("a bad file of points is refused with place, reason and remedy", "[inspect]")
{
    std::vector<BadPoints> const table = {{"", "no header and no points", "names its columns"},
                                          {"\n\n# nothing\n", "no header and no points", "names its columns"},
                                          {"x,y\n", "header and no points", "one point a line"},
                                          {"1,2\n3,4\n", "begins with numbers", "names its columns"},
                                          {"a,b\n1,2\n", "no column \"x\"", "names its columns"},
                                          {"a,b\n1,2\n", "no column \"y\"", "names its columns"},
                                          {"x,b\n1,2\n", "no column \"y\"", "names its columns"},
                                          {"y\n1\n", "no column \"x\"", "names its columns"},
                                          {"x,x,y\n1,2,3\n", "has a column already", "leave one of them out"},
                                          {"x,y,z,z\n1,2,3,4\n", "has a column already", "leave one of them out"},
                                          {"x [kg],y\n1,2\n", "unit is not known", "x [mm]"},
                                          {"x,y [deg]\n1,2\n", "unit is not known", "y [mm]"},
                                          {"x,y,tooth [mm]\n1,2,3\n", "has no unit", "write tooth"},
                                          {"x,y,flank (1)\n1,2,left\n", "has no unit", "write flank"},
                                          {"x,y\n1\n", "is missing", "write a number"},
                                          {"x,y\n,2\n", "is missing", "write a number"},
                                          {"x,y\n1,\n", "is missing", "write a number"},
                                          {"x,y\none,2\n", "no finite number", "write a number"},
                                          {"x,y\n1,nan\n", "no finite number", "write a number"},
                                          {"x,y\ninf,2\n", "no finite number", "write a number"},
                                          {"x,y\n1e999,2\n", "no finite number", "write a number"},
                                          {"x;y\n1,5;2\n", "no finite number", "decimal comma"},
                                          {"x,y\n1 2,3\n", "no finite number", "write a number"},
                                          {"x,y\n0x10,3\n", "no finite number", "write a number"},
                                          {"x,y\n1e9,3\n", "no coordinate of a gear", "unit after the heading"},
                                          {"x [m],y [m]\n1,250\n", "no coordinate of a gear", "unit after the heading"},
                                          {"x,y,z\n1,2,up\n", "no finite number", "write a number"},
                                          {"x,y,z\n1,2\n", "is missing", "write a number"},
                                          {"x,y,tooth\n1,2,0\n", "no number of a tooth", "whole number from 1 on"},
                                          {"x,y,tooth\n1,2,-3\n", "no number of a tooth", "whole number from 1 on"},
                                          {"x,y,tooth\n1,2,1.5\n", "no number of a tooth", "whole number from 1 on"},
                                          {"x,y,tooth\n1,2,a\n", "no number of a tooth", "whole number from 1 on"},
                                          {"x,y,tooth\n1,2,1e300\n", "no number of a tooth", "whole number from 1 on"},
                                          {"x,y,tooth\n1,2,\n", "no number of a tooth", "whole number from 1 on"},
                                          {"x,y,flank\n1,2,up\n", "is no flank", "left or right"},
                                          {"x,y,flank\n1,2,\n", "is no flank", "left or right"},
                                          {"x,y,flank\n1,2\n", "is no flank", "left or right"}};
    for (auto const& [text, reason, remedy] : table) {
        CAPTURE(text);
        auto const found = read_points(text);
        REQUIRE_FALSE(found.faults.empty());
        std::string const told = describe(found.faults);
        CHECK_THAT(told, ContainsSubstring(reason));
        CHECK_THAT(told, ContainsSubstring(remedy));
    }
    CHECK_THAT(describe(examine_points("/").faults), ContainsSubstring("is a folder"));
    CHECK_THAT(describe(examine_points("/dev/zero").faults), ContainsSubstring("no file that ends"));
    CHECK_THAT(describe(examine_points("no such file").faults), ContainsSubstring("cannot be read"));
}

TEST_CASE("points and polylines of a drawing are read, in the unit of the drawing", "[inspect]")
{
    TemporaryFolder const folder;
    auto const read_drawing = [&](std::string const& text) {
        write(folder / "points.DXF", text);
        return examine_points(folder / "points.DXF");
    };
    std::string const head = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    auto const found = read_drawing(head +
                                    "0\nPOINT\n8\n\n10\n1\n20\n2\n30\n0\n0\nLINE\n10\n7\n20\n7\n11\n8\n21\n8\n"
                                    "0\nPOLYLINE\n66\n1\n10\n9\n20\n9\n0\nVERTEX\n10\n3\n20\n4\n0\nSEQEND\n"
                                    "0\nLWPOLYLINE\n38\n0.1\n10\n5\n20\n6\n10\n7\n20\n8\n0\nENDSEC\n0\nEOF\n");
    REQUIRE(found.faults.empty());
    REQUIRE(found.measured.points.size() == 4);
    double next = 1;
    for (PartPoint const& point : found.measured.points) {
        CHECK((point.where - 25.4 * Vec2(next, next + 1)).norm() < 1e-12);
        next += 2;
    }
    CHECK(found.measured.has_z);
    CHECK(found.measured.points[1].z == 0);
    CHECK(found.measured.points[3].z == Approx(2.54));

    CHECK(found.measured.layers == std::vector<std::string>{"0"});

    std::string const begin = "0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n";
    for (auto const& [text, reason] :
         std::vector<std::pair<std::string, std::string>>{{"", "no POINT and no polyline"},
                                                          {"0\nEOF\n", "no POINT and no polyline"},
                                                          {"x\n0\n", "is no group code"},
                                                          {begin + "one\n", "is no finite number"},
                                                          {begin + "1e9\n", "is no coordinate of a gear"},
                                                          {"9\n$INSUNITS\n70\n20\n", "is no $INSUNITS of a gear"}}) {
        CAPTURE(text);
        auto const refused = read_drawing(text);
        REQUIRE_FALSE(refused.faults.empty());
        CHECK_THAT(describe(refused.faults), ContainsSubstring(reason));
    }
}

TEST_CASE("of a drawing with several layers the one of the part is read, or none", "[inspect]")
{
    TemporaryFolder const folder;
    write_dxf(solve(builtin_scene()), folder / "drive.dxf");
    PointFile measured = examine_points(folder / "drive.dxf").measured;
    CHECK(measured.layers == std::vector<std::string>{"CIRCULAR_SPLINE", "FLEXSPLINE_TOOTH", "NEUTRAL_CURVE"});
    InspectOptions options;
    options.part = InspectedPart::circular_spline;
    Inspection const found = inspect_points(builtin_scene(), measured, options);
    CHECK(found.placement.rms < 1e-6);
    CHECK(found.placement.shift_y.value < 1e-3);
    REQUIRE_FALSE(found.notes.empty());
    CHECK(found.notes.back() == "of the 3 layers of the drawing CIRCULAR_SPLINE is read alone");
    measured.layers[0] = "0";
    CHECK_THROWS_WITH(inspect_points(builtin_scene(), measured, options),
                      ContainsSubstring("has points on 3 layers: 0, FLEXSPLINE_TOOTH, NEUTRAL_CURVE") &&
                          ContainsSubstring("CIRCULAR_SPLINE"));
}

TEST_CASE("one report lists twenty faults of a file of points and counts the others", "[inspect]")
{
    std::string text = "x,y\n";
    for (int i = 0; i < 100; ++i)
        text += "a,b\n";
    Faults const faults = read_points(text).faults;
    REQUIRE(faults.size() == 21);
    CHECK(faults[19].line == 11);
    CHECK(faults[20].reason == "180 more faults are not listed");
}

TEST_CASE("points that are none of the part are refused", "[inspect]")
{
    Scene const scene = builtin_scene();
    InspectOptions options;
    PointFile far{"far", {}, false};
    for (int i = 0; i < 50; ++i)
        far.points.push_back({Vec2(3.0 + 0.1 * i, 2), 0, 0, std::nullopt, i});
    CHECK_THROWS_WITH(inspect_points(scene, far, options), ContainsSubstring("0 of 50 points stand on a flank"));

    MeasuredRing balls;
    balls.measured = {0, 40, 90, 150};
    balls.probe = 0.05;
    designs::Draws of_balls(2);
    Inspection const found = inspect_points(scene, points_of(balls, of_balls), options);
    REQUIRE(found.notes.size() == 1);
    CHECK_THAT(found.notes.front(), ContainsSubstring("all points lie about 0.05 mm outside the material"));

    MeasuredRing ring;
    ring.measured = {0};
    designs::Draws draws(1);
    PointFile tooth = points_of(ring, draws);
    tooth.points.resize(2);
    CHECK_THROWS_WITH(inspect_points(scene, tooth, options), ContainsSubstring("do not determine the position"));
    tooth.has_z = true;
    options.plane = 3;
    CHECK_THROWS_WITH(inspect_points(scene, tooth, options), ContainsSubstring("the file has no points there"));
}

}  // namespace hdconj::test::point_file_cases
