// SPDX-License-Identifier: GPL-3.0-or-later
#include "conjugate/matched_outline.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/oracle/touch.hpp"
#include "support/polyline.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::matched_outline_cases {

namespace {

constexpr double chord = 1e-6;

/// A slice solved as a drive of its own, with the tip circle of the surface.
Solution slice_alone(ConedDrive const& drive, std::size_t k, double tip, double tolerance)
{
    Scene scene = drive.slice_scene(k);
    scene.circular_spline.inner_radius = tip;
    scene.solver.tolerance = tolerance;
    return solve(scene);
}

double tip_of(ConedDrive& drive, ToothSurface surface)
{
    return drive.maker->needed_tip({surface, TiltKind::radial, 0}).radius;
}

void check_order_and_landmarks(conjugate::MatchedOutline const& outline, std::vector<double> const& tip, double pitch)
{
    std::size_t const n = outline.points.front().size();
    auto const [left_land, left_end, middle, right_end, right_land] = outline.landmarks;
    CHECK(0 < left_land);
    CHECK(left_land < left_end);
    CHECK(left_end <= middle);
    CHECK(middle <= right_end);
    CHECK(right_end < right_land);
    CHECK(right_land < n - 1);
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
        auto const& p = outline.points[k];
        INFO("slice " << k);
        REQUIRE(p.size() == n);
        REQUIRE(outline.normals[k].size() == n);
        for (std::size_t i = 0; i + 1 < n; ++i)
            CHECK(p[i + 1].x() > p[i].x());
        for (std::size_t i = 0; i < n; ++i)
            CHECK(outline.normals[k][i].norm() == Approx(1).epsilon(1e-13));
        CHECK(p[middle].x() == 0);
        for (std::size_t const land : {std::size_t{0}, left_land, right_land, n - 1})
            CHECK(p[land].norm() == Approx(tip[k]).epsilon(1e-13));
        // the flank leaves the tip circle there
        CHECK(p[right_land - 1].norm() > tip[k] * (1 + 1e-9));
        CHECK(p[left_land + 1].norm() > tip[k] * (1 + 1e-9));
        CHECK(std::atan2(p.back().x(), p.back().y()) == Approx(pitch / 2).epsilon(1e-13));
        CHECK(std::atan2(p.front().x(), p.front().y()) == Approx(-pitch / 2).epsilon(1e-13));
    }
    for (std::size_t i = 0; i + 1 < outline.stretches.size(); ++i)
        CHECK(outline.stretches[i].last == outline.stretches[i + 1].first);
    CHECK(outline.stretches.front().first == 0);
    CHECK(outline.stretches.back().last == n - 1);
    CHECK(outline.stretches.front().last == left_land);
    CHECK(outline.stretches.back().first == right_land);
}

void check_mirror(conjugate::MatchedOutline const& outline)
{
    std::size_t const last = outline.points.front().size() - 1;
    for (std::size_t k = 0; k < outline.points.size(); ++k)
        for (std::size_t i = 0; i <= last; ++i) {
            CHECK(outline.points[k][i].x() == -outline.points[k][last - i].x());
            CHECK(outline.points[k][i].y() == outline.points[k][last - i].y());
        }
    for (std::size_t i = 0; i < outline.landmarks.size(); ++i)
        CHECK(outline.landmarks[i] + outline.landmarks[4 - i] == last);
}

}  // namespace

TEST_CASE("slices of a coned drive have matched outlines that are those of the slices alone", "[matched_outline]")
{
    // type-50: conjugate zones appear and vanish along z (design 3.4)
    ConedDrive drive(builtin_scene(coned()), 9);
    double const tip = tip_of(drive, ToothSurface::per_slice);
    conjugate::MatchedOutline const outline = drive.surface(ToothSurface::per_slice, TiltKind::radial, 0, chord, 0);
    REQUIRE(outline.points.size() == 9);
    check_order_and_landmarks(outline, std::vector<double>(9, tip), drive.pitch());
    check_mirror(outline);
    CHECK_FALSE(outline.by_origin);
    CHECK(outline.chord <= chord);
    CHECK(outline.chord > chord / 8);
    double off = 0, coarse = 0, off_corner = 0;
    for (std::size_t k = 0; k < outline.points.size(); ++k) {
        constexpr double finer = 1e-8;
        Solution const own = slice_alone(drive, k, tip, finer);
        auto const& fine = own.circular_spline.outline.front();
        for (Vec2 const& p : outline.points[k])
            off = std::max(off, distance_to_polyline(fine, p));
        for (Vec2 const& p : fine)
            coarse = std::max(coarse, distance_to_polyline(outline.points[k], p));
        // where one stretch of this slice ends and another begins there is a station
        for (OutlinePiece const& piece : own.circular_spline.pieces) {
            double nearest = 1;
            for (Vec2 const& p : outline.points[k])
                nearest = std::min(nearest, (p - fine[piece.last]).norm());
            off_corner = std::max(off_corner, piece.last + 1 < fine.size() ? nearest : 0.0);
        }
    }
    INFO("points off their slice " << off << ", polygon off " << coarse << ", corners off " << off_corner);
    CHECK(off < 1.05e-8);
    CHECK(coarse < 1.05 * chord);
    CHECK(coarse > 0.2 * chord);
    CHECK(off_corner < 1e-10);
}

TEST_CASE("points of matched outlines are exact contacts and their normals those of the boundary", "[matched_outline]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    conjugate::MatchedOutline const outline = drive.surface(ToothSurface::per_slice, TiltKind::radial, 0, chord, 0);
    std::size_t const middle = outline.landmarks[2];
    std::size_t const right_land = outline.landmarks[4];
    for (std::size_t k = 0; k < 3; ++k) {
        oracle::TouchScan scan(drive.slice_scene(k));
        double worst = 0, worst_moved = 0;
        auto const& line = outline.points[k];
        std::vector<Vec2> corners;
        for (std::size_t i = middle + 1; i <= right_land; ++i)
            if (std::abs(cross((line[i] - line[i - 1]).normalized(), (line[i + 1] - line[i]).normalized())) > 0.05)
                corners.push_back(line[i]);
        CHECK(corners.size() >= 1);
        int moved = 0;
        for (std::size_t i = middle; i <= right_land; i += 12) {
            Vec2 const p = line[i];
            worst = std::max(worst, std::abs(scan.nearest({p.x(), p.y()}).distance));
            // a small way along the normal every point is that far from the teeth, unless it is beside a corner of the
            // boundary
            if (std::any_of(corners.begin(), corners.end(), [&](Vec2 const& c) { return (c - p).norm() < 2e-3; }))
                continue;
            ++moved;
            Vec2 const q = p + 1e-4 * outline.normals[k][i];
            worst_moved = std::max(worst_moved, std::abs(scan.nearest({q.x(), q.y()}).distance - 1e-4));
        }
        INFO("slice " << k << ": " << worst << ", moved " << worst_moved);
        CHECK(worst < 1e-11);
        CHECK(worst_moved < 1e-10);
        CHECK(moved > 30);
    }
}

TEST_CASE("matched outlines have the same bits for 1 2 and 4 threads", "[matched_outline][parallel]")
{
    auto const made = [](int threads) {
        return ConedDrive(builtin_scene(coned()), 5, threads).surface(ToothSurface::per_slice);
    };
    conjugate::MatchedOutline const one = made(1);
    for (int const threads : {2, 4}) {
        conjugate::MatchedOutline const many = made(threads);
        CHECK(many.points == one.points);
        CHECK(many.normals == one.normals);
        CHECK(many.landmarks == one.landmarks);
    }
}

TEST_CASE("matched outlines for a map have about as many points along the flank as asked for", "[matched_outline]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    for (int const wanted : {50, 200, 2000}) {
        // so coarse a chord that only the wish counts
        conjugate::MatchedOutline const outline =
            drive.surface(ToothSurface::per_slice, TiltKind::radial, 0, 1e-2, wanted);
        std::size_t const intervals = outline.landmarks[4] - outline.landmarks[3];
        CHECK(intervals >= static_cast<std::size_t>(wanted));
        CHECK(intervals < static_cast<std::size_t>(1.1 * wanted) + 40);
    }
}

TEST_CASE("matched outlines of one slice are the outline of the pair", "[matched_outline]")
{
    for (std::string const name :
         {"type-50", "liu-2025", "involute", "straight", "cycloid", "ellipse", "four-roller", "s-tooth", "points"}) {
        INFO(name);
        ConedDrive drive(read_scene(file_of(name)), 1);
        conjugate::MatchedOutline const outline = drive.surface(ToothSurface::tilted, TiltKind::radial, 0, chord, 0);
        check_order_and_landmarks(outline, {drive.middle.geometry.circular_spline_inner_radius}, drive.pitch());
        double off = 0, coarse = 0;
        auto const& own = drive.middle.circular_spline.outline.front();
        for (Vec2 const& p : outline.points.front())
            off = std::max(off, distance_to_polyline(own, p));
        for (Vec2 const& p : own)
            coarse = std::max(coarse, distance_to_polyline(outline.points.front(), p));
        CHECK(off < 1.05e-6);
        CHECK(coarse < 1.05e-6);
        CHECK(outline.by_origin);
        // the landmarks that solve itself gives
        for (std::size_t i = 0; i < 5; ++i)
            CHECK((outline.points.front()[outline.landmarks[i]] -
                   own[static_cast<std::size_t>(drive.middle.circular_spline.landmarks[i])])
                      .norm() < 1e-9);
    }
}

TEST_CASE("ruled surfaces are straight between their end planes and those are the slices' own", "[matched_outline]")
{
    ConedDrive drive(builtin_scene(coned()), 5);
    conjugate::MatchedOutline const ruled = drive.surface(ToothSurface::ruled);
    double const tip = tip_of(drive, ToothSurface::ruled);
    for (std::size_t const k : {0u, 4u}) {
        Solution const own = slice_alone(drive, k, tip, 1e-8);
        for (Vec2 const& p : ruled.points[k])
            CHECK(distance_to_polyline(own.circular_spline.outline.front(), p) < 1.05e-8);
    }
    double bent = 0;
    for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t i = 0; i < ruled.points[k].size(); ++i)
            bent = std::max(
                bent, (ruled.points[k][i] -
                       (ruled.points[0][i] + (ruled.points[4][i] - ruled.points[0][i]) * (static_cast<double>(k) / 4)))
                          .norm());
    CHECK(bent < 1e-13);
    for (std::size_t k = 0; k < 5; ++k)
        for (std::size_t i = 0; i + 1 < ruled.points[k].size(); ++i)
            CHECK(ruled.points[k][i + 1].x() > ruled.points[k][i].x());
    check_mirror(ruled);
}

TEST_CASE("a ruled surface between its end planes does not depend on how finely it is sampled", "[matched_outline]")
{
    // contacts run along their paths at no steady pace: shares of length that were met in the wave generator's angle
    // joined other points at every chord
    for (std::string const name : {"arc-chain", "straight"}) {
        ConedDrive drive(read_scene(file_of(name), coned("none", 20)), 3);
        constexpr double fine = 1e-8;
        conjugate::MatchedOutline const exact = drive.surface(ToothSurface::ruled, TiltKind::radial, 0, fine, 0);
        for (double const coarse : {1e-5, 1e-6}) {
            conjugate::MatchedOutline const ruled = drive.surface(ToothSurface::ruled, TiltKind::radial, 0, coarse, 0);
            double worst = 0;
            for (Vec2 const& p : exact.points[1])
                worst = std::max(worst, distance_to_polyline(ruled.points[1], p));
            INFO(name << ", chord " << coarse << " mm: " << worst << " mm");
            CHECK(worst <= coarse + fine);
        }
    }
}

TEST_CASE(
    "points of a ruled surface between its end planes are off by no more than they say, and those of others by "
    "roundings",
    "[matched_outline]")
{
    for (std::string const surface : {"ruled", "per-slice"}) {
        auto const slices = [&](double tolerance) {
            Scene scene = read_scene(
                file_of("cycloid"),
                with(coned("none", 20), {"slices.count=3", "slices.surface=" + surface, "circular_spline.width=7"}));
            scene.solver.tolerance = tolerance;
            return solve(scene);
        };
        constexpr double finer = 1e-8;
        Solution const coarse = slices(1e-4), fine = slices(finer);
        double worst = 0;
        for (std::size_t k = 0; k < 3; ++k)
            for (Vec2 const& p : coarse.circular_spline.outline[k])
                worst = std::max(worst, distance_to_polyline(fine.circular_spline.outline[k], p));
        INFO(surface << ": " << worst << " of " << coarse.error.point);
        CHECK(worst <= coarse.error.point + 1.05 * finer);
        CHECK((worst > 1.05 * finer) == (surface == "ruled"));
    }
}

TEST_CASE("drafted slices lie parallel to the middle one by the height times the tangent", "[matched_outline]")
{
    ConedDrive drive(builtin_scene({"solver.tolerance=1e-6"}), 5);
    for (double const tilt : {0.05 * deg, 0.2 * deg}) {
        conjugate::MatchedOutline const outline = drive.surface(ToothSurface::tilted, TiltKind::draft, tilt);
        double const tip = drive.maker->needed_tip({ToothSurface::tilted, TiltKind::draft, tilt}).radius;
        std::vector<double> tips;
        for (double const z : drive.z())
            tips.push_back(tip + z * std::tan(tilt));
        check_order_and_landmarks(outline, tips, drive.pitch());
        check_mirror(outline);
        Solution const base = slice_alone(drive, 2, tip, 1e-8);
        auto const& fine = base.circular_spline.outline.front();
        for (std::size_t k = 0; k < drive.z().size(); ++k) {
            double const wanted = std::abs(drive.z()[k] * std::tan(tilt));
            double nearest = 1, furthest = 0;
            // sharp corners stand further off
            std::size_t parallel = 0;
            for (std::size_t i = outline.landmarks[3]; i <= outline.landmarks[4]; ++i) {
                double const d = distance_to_polyline(fine, outline.points[k][i]);
                nearest = std::min(nearest, d);
                furthest = std::max(furthest, d);
                parallel += std::abs(d - wanted) < 1.1e-8;
            }
            INFO("tilt " << tilt << " z " << drive.z()[k]);
            CHECK(nearest > wanted - 1.1e-8);
            CHECK(furthest < 2 * wanted + 1.1e-8);
            CHECK(parallel + 60 > outline.landmarks[4] - outline.landmarks[3]);
        }
    }
}

TEST_CASE("ends of a flank have the flank's normals on both sides also where the pair is not its own mirror image",
          "[matched_outline]")
{
    TemporaryFolder const folder;
    std::string table;
    for (int i = 0; i < 60; ++i) {
        double const u = 2 * std::numbers::pi * i / 60;
        table += std::to_string(3.0 * i) + "," + std::to_string(0.25 * std::cos(u) + 0.004 * std::sin(2 * u)) + "\n";
    }
    std::ofstream(folder / "cam-table.csv") << table;
    std::ifstream text(file_of("cam-table"));
    std::string const scene((std::istreambuf_iterator<char>(text)), {});
    ConedDrive drive(parse_scene(scene, "uneven cam", folder.path()), 1);
    REQUIRE_FALSE(drive.maker->motion(0).motion.symmetric());
    conjugate::MatchedOutline const outline = drive.surface(ToothSurface::tilted);
    auto const& p = outline.points.front();
    auto const& n = outline.normals.front();
    auto const [left_land, left_end, middle, right_end, right_land] = outline.landmarks;
    CHECK(left_end <= middle);
    // the chord beside the end lies along the flank to the turn of one chord; land and root turn away from it by a
    // quarter of a right angle at least
    for (auto const& [end, inner] : {std::pair(left_land, left_land + 1),
                                     {left_end, left_end - 1},
                                     {right_end, right_end + 1},
                                     {right_land, right_land - 1}})
        CHECK(std::abs(n[end].dot((p[inner] - p[end]).normalized())) < 0.02);
}

TEST_CASE("where the contact jumps to the next piece of the profile matched outlines have a corner and no gap",
          "[matched_outline]")
{
    // two branches of one flank cross in the rear slice, with touching pieces of a tooth given by points on either side
    // of the crossing
    TemporaryFolder const folder;
    std::ofstream(folder / "flank.csv") << "x,y\n0.212270,0.606485\n0.285607,0.517140\n0.348611,0.420954\n0.402523,0."
                                           "319370\n0.448581,0.213832\n0.488074,0.105741\n0.522756,-0.003937\n"
                                           "0.555000,-0.114386\n0.588416,-0.224432\n0.626448,-0.332945\n0.669598,-0."
                                           "439631\n0.717168,-0.544538\n0.768459,-0.647716\n0.822771,-0.749213\n"
                                           "0.879403,-0.849079\n";
    std::string const text = R"([drive]
module = 0.75
flexspline_teeth = 130
circular_spline_teeth = 133
[flexspline]
wall = 1.17204
[flexspline.cup]
length = 29.25
barrel_wall = 0.668065
bottom = 0.975
corner_radius = 3.9
flange_radius = 25.35
tooth_width = 15.6
front_land = 3.9
rear_ramp = 0.78
front_ramp = 0.78
[flexspline.profile]
family = "points"
file = "flank.csv"
[wave_generator]
family = "cosine"
waves = 3
radial_deformation = 1.07449
[circular_spline]
width = 4.0
backlash_offset = 0.031029
[coning]
model = "elastic"
bottom_to_middle = 17.55
axial_shift = "mapped"
[bearing]
type = "rigid"
width = 11.7
[slices]
count = 2
surface = "per-slice"
)";
    auto const slices = [&](double tolerance) {
        Scene scene = parse_scene(text, "jump", folder.path());
        scene.solver.tolerance = tolerance;
        return solve(scene);
    };
    constexpr double finer = 1e-7;
    Solution const coarse = slices(chord), fine = slices(finer);
    CHECK(coarse.error.chord <= chord);
    for (std::size_t k = 0; k < coarse.circular_spline.outline.size(); ++k) {
        auto const& a = coarse.circular_spline.outline[k];
        auto const& b = fine.circular_spline.outline[k];
        double off = 0, polygon = 0;
        for (Vec2 const& p : a)
            off = std::max(off, distance_to_polyline(b, p));
        for (Vec2 const& p : b)
            polygon = std::max(polygon, distance_to_polyline(a, p));
        INFO("slice " << k);
        CHECK(off < 1.05 * finer);
        CHECK(polygon < 1.05 * chord);
    }
}

TEST_CASE("branches that meet in a joint of the profile leave no stretch of a rounding's length", "[matched_outline]")
{
    // both arcs of the flank trace nearly the same curve and cross where the joint between them touches
    Scene const scene = builtin_scene({"!circular_spline.inner_radius",
                                       "!flexspline.profile.tip_line_from",
                                       "drive.module=0.408",
                                       "drive.flexspline_teeth=291",
                                       "drive.circular_spline_teeth=293",
                                       "flexspline.wall=1.55964",
                                       "flexspline.profile.addendum=0.3581480947",
                                       "flexspline.profile.dedendum=0.5088874111",
                                       "flexspline.profile.convex_radius=0.4406931421",
                                       "flexspline.profile.convex_offset=0.1630222904",
                                       "flexspline.profile.concave_radius=0.8527866568",
                                       "flexspline.profile.concave_rise=0.1127844045",
                                       "wave_generator.radial_deformation=0.394494",
                                       "circular_spline.width=17.9627",
                                       "coning.model=linear",
                                       "coning.bottom_to_middle=61.9992",
                                       "coning.axial_shift=mapped",
                                       "coning.apex_height=-2.1928",
                                       "slices.count=9",
                                       "slices.surface=per-slice"});
    Solution const solution = solve(scene);
    Tolerance const tolerance{scene.solver.tolerance, 60.2};
    double shortest = 1;
    for (auto const& outline : solution.circular_spline.outline)
        for (std::size_t i = 1; i < outline.size(); ++i)
            shortest = std::min(shortest, (outline[i] - outline[i - 1]).norm());
    CHECK(shortest > tolerance.coincidence());
}

TEST_CASE("slices that are moved outward or have side clearance are solved outside of where the roots come",
          "[matched_outline]")
{
    // flat flanks that meet nothing below the pitch line: the tip circle is at the flexspline's rim, which in front
    // comes further out than at z = 0
    std::vector<std::string> const flat{"!circular_spline.inner_radius",
                                        "drive.module=0.75",
                                        "drive.flexspline_teeth=130",
                                        "drive.circular_spline_teeth=133",
                                        "flexspline.wall=1.17",
                                        "flexspline.profile.family=straight",
                                        "!flexspline.profile.convex_radius",
                                        "!flexspline.profile.convex_offset",
                                        "!flexspline.profile.concave_radius",
                                        "!flexspline.profile.concave_offset",
                                        "!flexspline.profile.concave_rise",
                                        "!flexspline.profile.tip_line_from",
                                        "flexspline.profile.addendum=0.606",
                                        "flexspline.profile.dedendum=0.68",
                                        "flexspline.profile.thickness=1.1",
                                        "flexspline.profile.pressure_angle_deg=20",
                                        "wave_generator.waves=3",
                                        "wave_generator.radial_deformation=1.17",
                                        "circular_spline.width=10.85",
                                        "coning.model=linear",
                                        "coning.bottom_to_middle=41",
                                        "coning.axial_shift=none",
                                        "slices.count=3",
                                        "slices.surface=per-slice"};
    for (double const tilt : {0.0, 0.36})
        for (double const clearance : {0.0, 0.03}) {
            INFO("tilt " << tilt << " deg, side clearance " << clearance << " mm");
            Scene const scene =
                builtin_scene(with(flat, {"tilt.kind=radial", "tilt.angle_deg=" + std::to_string(tilt),
                                          "circular_spline.backlash_offset=" + std::to_string(clearance)}));
            Solution const found = solve(scene);
            double const rise = std::tan(tilt * deg);
            ConedDrive const drive(scene, 3, 1, 10.85);
            for (std::size_t k = 0; k < 3; ++k) {
                // the slice as a drive of its own, then moved
                double const z = found.circular_spline.z[k];
                Scene own = drive.slice_scene(k);
                own.circular_spline.inner_radius = found.geometry.circular_spline_inner_radius;
                own.circular_spline.backlash_offset = clearance;
                Solution const alone = solve(own);
                std::vector<Vec2> moved;
                for (Vec2 const& p : alone.circular_spline.outline.front())
                    moved.push_back(p + z * rise * p.normalized());
                double off = 0;
                for (Vec2 const& p : found.circular_spline.outline[k])
                    off = std::max(off, distance_to_polyline(moved, p));
                CHECK(off < 1.05 * chord);
            }
        }
}

TEST_CASE("matched outline: few long chords stay as near to the outline as they say, moved along its radii too",
          "[matched_outline]")
{
    struct Row
    {
        std::string scene;
        std::vector<std::string> keys;
    };
    std::vector<std::string> const cone{"coning.model=linear", "circular_spline.width=3", "slices.count=3"};
    std::vector<Row> const rows{
        {"b-spline",
         with(cone, {"slices.surface=per-slice", "coning.bottom_to_middle=39.66", "coning.axial_shift=mapped"})},
        {"points", with(cone, {"slices.surface=ruled", "coning.bottom_to_middle=24.879", "coning.axial_shift=none",
                               "tilt.angle_deg=-0.385", "tilt.kind=radial", "circular_spline.backlash_offset=0.0081"})},
        {"ellipse", with(cone, {"slices.surface=tilted", "coning.bottom_to_middle=25.619", "coning.axial_shift=none",
                                "tilt.angle_deg=-3", "tilt.kind=radial"})},
        {"ellipse",
         {"circular_spline.width=3", "slices.count=3", "slices.surface=tilted", "tilt.angle_deg=5",
          "tilt.kind=radial"}}};
    for (Row const& row : rows) {
        auto const text = [](double value) { return (std::ostringstream() << value).str(); };
        auto const solved = [&](double tolerance) {
            return solve(read_scene(file_of(row.scene), with(row.keys, {"solver.tolerance=" + text(tolerance)})));
        };
        for (double const tolerance : {1e-3, 1e-5}) {
            Solution const coarse = solved(tolerance), fine = solved(tolerance / 1000);
            CHECK(coarse.error.chord <= tolerance);
            // chords of the coarse outline are cut no finer than they need to be
            CHECK(coarse.error.chord > 0.2 * tolerance);
            for (std::size_t k = 0; k < fine.circular_spline.outline.size(); ++k) {
                std::vector<Vec2> const& chords = coarse.circular_spline.outline[k];
                double worst = 0;
                for (Vec2 const& p : fine.circular_spline.outline[k]) {
                    double nearest = std::numeric_limits<double>::infinity();
                    for (std::size_t i = 0; i + 1 < chords.size(); ++i)
                        nearest = std::min(nearest, distance_to_segment(chords[i], chords[i + 1], p));
                    worst = std::max(worst, nearest);
                }
                INFO(row.scene << ", tolerance " << tolerance << ", slice " << k << ": " << worst << " of "
                               << coarse.error.chord << " mm stated");
                CHECK(worst <= coarse.error.chord + fine.error.chord);
            }
        }
    }
}

}  // namespace hdconj::test::matched_outline_cases
