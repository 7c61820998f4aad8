// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fstream>

#include "hdconj/profile/registry.hpp"
#include "profile/measured_points.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

namespace hdconj::test::profile_cases {

namespace {

scene::FamilyChoice points_choice(std::string const& file, std::string const& side = "right")
{
    scene::FamilyChoice choice;
    choice.family = "points";
    choice.path = "flexspline.profile";
    choice.given["file"] = {file, 3};
    choice.given["side"] = {side, 4};
    return choice;
}

}  // namespace

TEST_CASE("the type-50 tooth: touching arcs, tangent joints, two tip corners", "[profile]")
{
    profile::Profile const tooth = type50_tooth();
    REQUIRE(tooth.segment_names.size() == 7);
    CHECK(tooth.segment_names[3] == "tip land");
    CHECK(tooth.pitch_line == Approx(0.653));
    int corners = 0;
    profile::PieceShape const* before = nullptr;
    for (profile::ProfilePiece const& piece : tooth.pieces) {
        if (before != nullptr) {
            CHECK((end_of(*before).point - start_of(piece.shape).point).norm() < 1e-15);
            CHECK((end_of(*before).normal - start_of(piece.shape).normal).norm() < 1e-14);
        }
        before = &piece.shape;
        corners += piece.corner;
    }
    CHECK(corners == 2);
    // design 3.8 and notes: half thicknesses at the tip's start, the pitch line and the root
    profile::PieceEnd const root = profile::end_of(tooth.pieces.back().shape);
    CHECK(root.point.x() == Approx(0.32612).margin(1e-5));
    CHECK(root.point.y() - tooth.pitch_line == Approx(-0.303).epsilon(1e-14));
}

TEST_CASE("l_f = tangent is 0.683525 and the same number typed in full gives the same tooth", "[profile]")
{
    profile::Profile const word = type50_tooth();
    profile::Profile const number = type50_tooth({"flexspline.profile.concave_offset=0.683525"});
    REQUIRE(number.segment_names == word.segment_names);
    CHECK((end_of(word.pieces.back().shape).point - end_of(number.pieces.back().shape).point).norm() < 1e-5);
    profile::Profile const apart = type50_tooth({"flexspline.profile.concave_offset=0.69"});
    CHECK(apart.segment_names.size() == 9);
}

TEST_CASE("a tooth is its own mirror image", "[profile]")
{
    std::vector<Vec2> const polygon = profile::polygon_of(type50_tooth(), 1e-5);
    std::size_t const n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        CHECK(std::abs(polygon[i].x() + polygon[n - 1 - i].x()) < 1e-15);
        CHECK(std::abs(polygon[i].y() - polygon[n - 1 - i].y()) < 1e-15);
    }
}

TEST_CASE("the polygon of a tooth keeps its chord error", "[profile]")
{
    profile::Profile const tooth = type50_tooth();
    for (double chord : {1e-3, 1e-5}) {
        std::vector<Vec2> const coarse = profile::polygon_of(tooth, chord);
        double worst = 0;
        for (Vec2 const& p : profile::polygon_of(tooth, 1e-8)) {
            double nearest = 1;
            for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
                Vec2 const d = coarse[i + 1] - coarse[i];
                double const t = std::clamp((p - coarse[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (p - coarse[i] - t * d).norm());
            }
            worst = std::max(worst, nearest);
        }
        CHECK(worst <= chord * (1 + 1e-9));
        CHECK(worst > chord / 8);
    }
}

TEST_CASE("a straight tooth has its thickness at the pitch line and its pressure angle", "[profile]")
{
    scene::FamilyChoice choice;
    choice.family = "straight";
    choice.path = "flexspline.profile";
    choice.given["addendum"] = {0.2, 1};
    choice.given["dedendum"] = {0.3, 2};
    choice.given["thickness"] = {0.36, 3};
    choice.given["pressure_angle_deg"] = {20.0, 4};
    Faults faults;
    profile::Profile const tooth = profile::build_profile(choice, {0.25, 200, 0.7, 0, ""}, faults);
    REQUIRE(faults.empty());
    REQUIRE(tooth.segment_names.size() == 3);
    auto const& right = std::get<profile::LinePiece>(tooth.pieces.back().shape);
    double const share = (right.a.y() - tooth.pitch_line) / (right.a.y() - right.b.y());
    CHECK(right.a.x() + share * (right.b.x() - right.a.x()) == Approx(0.18));
    CHECK(std::atan2(right.b.x() - right.a.x(), right.a.y() - right.b.y()) == Approx(20 * std::numbers::pi / 180));
    choice.given["addendum"] = {0.6, 1};
    CHECK(profile::build_profile(choice, {0.25, 200, 0.7, 0, ""}, faults).pieces.empty());
    REQUIRE(faults.size() == 1);
    CHECK(faults[0].path == "flexspline.profile.addendum");
}

TEST_CASE("a spline through points passes through them with continuous tangent and curvature", "[profile]")
{
    std::vector<Vec2> points;
    for (int i = 0; i <= 20; ++i)
        points.push_back(0.5 * direction(1.2 - 0.08 * i));
    std::vector<profile::CurvePiece> const pieces = profile::spline_through(points);
    REQUIRE(pieces.size() == 18);
    CHECK((pieces.front().point(0) - points.front()).norm() < 1e-15);
    CHECK((pieces.back().point(1) - points.back()).norm() < 1e-15);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
        CHECK((pieces[i].point(1) - pieces[i + 1].point(0)).norm() < 1e-15);
        CHECK((pieces[i].first(1).normalized() - pieces[i + 1].first(0).normalized()).norm() < 1e-13);
    }
}

TEST_CASE("a spline through points of a circle converges with the fourth order", "[profile]")
{
    auto const error = [](int intervals) {
        std::vector<Vec2> points;
        for (int i = 0; i <= intervals; ++i)
            points.push_back(direction(1.5 * i / intervals));
        double worst = 0;
        for (profile::CurvePiece const& piece : profile::spline_through(points))
            for (double t : {0.25, 0.5, 0.75})
                worst = std::max(worst, std::abs(piece.point(t).norm() - 1));
        return worst;
    };
    double const order = std::log2(error(16) / error(32));
    CHECK(order > 3.7);
    CHECK(order < 5.5);
}

TEST_CASE("a file of points becomes a tooth, bad files become faults with their line", "[profile]")
{
    test::TemporaryFolder const folder;
    auto const write = [&](std::string const& name, std::string const& text) {
        std::ofstream(folder.path() / name) << text;
        return name;
    };
    profile::ToothPlace const place{0.25, 200, 0.7, 0, folder.path().string(), false};
    std::string const flank = "x,y\n# a flank\n0.05,0.2\n0.11;0.1\n0.15 0.0\n0.2\t-0.1\n0.3,-0.3\n";
    Faults faults;
    profile::Profile const tooth = profile::build_profile(points_choice(write("good.csv", flank)), place, faults);
    REQUIRE(faults.empty());
    CHECK(tooth.addendum == Approx(0.2));
    CHECK(tooth.dedendum == Approx(0.3));
    CHECK(tooth.mirror_symmetric);

    struct Bad
    {
        std::string name, text, reason;
    };
    std::vector<Bad> const table{
        {"words.csv", "0.05,0.2\n0.1,abc\n", "line 2"},
        {"nan.csv", "0.05,0.2\n0.1,nan\n", "line 2"},
        {"three.csv", "0.05,0.2,7\n0.1,0.1,7\n", "line 2"},
        {"twice.csv", "0.05,0.2\n0.05,0.2\n0.1,0\n0.2,-0.1\n", "repeats"},
        {"short.csv", "0.05,0.2\n0.1,0.1\n0.2,-0.1\n", "needs 4"},
        {"empty.csv", "", "needs 4"},
        {"above.csv", "0.05,0.4\n0.06,0.3\n0.08,0.2\n0.1,0.1\n", "pitch line"},
        {"left.csv", "-0.05,0.2\n0.1,0.1\n0.15,0\n0.2,-0.1\n", "left of"},
    };
    for (Bad const& bad : table) {
        Faults found;
        INFO(bad.name);
        CHECK(build_profile(points_choice(write(bad.name, bad.text)), place, found).pieces.empty());
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].reason, ContainsSubstring(bad.reason));
        CHECK_FALSE(found[0].remedy.empty());
    }
    Faults missing;
    CHECK(build_profile(points_choice("none.csv"), place, missing).pieces.empty());
    REQUIRE(missing.size() == 1);
    CHECK(missing[0].line == 3);
}

TEST_CASE("polygons of extreme pieces have a bounded number of points", "[profile]")
{
    auto const polygon = [](profile::PieceShape shape, double chord) {
        profile::Profile tooth;
        tooth.pieces.push_back({std::move(shape)});
        return profile::polygon_of(tooth, chord);
    };
    // nearly straight: 1 - chord/r rounds to 1
    double const angle = 1e-9;
    // 1 mm of an arc in steps of sqrt(8 r chord)
    profile::ArcPiece const flat{{0, -1e9}, 1e9, std::numbers::pi / 2, std::numbers::pi / 2 - angle};
    CHECK(polygon(flat, 1e-12).size() == 13);
    CHECK(polygon(flat, 1e-18).size() == 11182);
    auto const wild = polygon(profile::CurvePiece({0, 1e9, -1e9, 0}, {0, 1, 2, 3}), 1e-12);
    CHECK(wild.size() <= (1 << 16) + 1);
    auto const wilder = polygon(profile::CurvePiece({0, 1e300, -1e300, 0}, {0, 1, 2, 3}), 1e-300);
    CHECK(wilder.size() <= (1 << 16) + 1);
}

TEST_CASE("a file of points that has no end is refused before it is read", "[profile]")
{
    hdconj::test::TemporaryFolder const folder;
    auto const refused = [&](std::string const& file) {
        Scene scene = builtin_scene({"!circular_spline.inner_radius"});
        scene.flexspline.profile = {"points", 0, "flexspline.profile", {{"file", {file, 0}}}};
        scene.folder = folder.path();
        Faults faults;
        (void)profile::build_profile(scene.flexspline.profile, place_of(scene), faults);
        return faults.empty() ? std::string("accepted") : faults.front().reason;
    };
    auto const write = [&](std::string const& name, int rows) {
        std::ofstream out(folder / name);
        for (int i = 0; i < rows; ++i)
            out << 0.2 + 1e-5 * i << ',' << 0.2 - 4e-5 * i << '\n';
        return name;
    };
    CHECK_THAT(refused("/dev/zero"), ContainsSubstring("no file of numbers"));
    CHECK(refused(write("most.csv", 10000)) == "accepted");
    CHECK_THAT(refused(write("more.csv", 10001)), ContainsSubstring("more than 10000 points"));
    std::filesystem::resize_file(folder / "more.csv", std::uintmax_t{17} << 20);
    CHECK_THAT(refused("more.csv"), ContainsSubstring("larger than 16 MiB"));
}

}  // namespace hdconj::test::profile_cases
