// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Limits of effects along the axis and of contact: with nothing to move they change nothing, and tend to nothing with
/// what they are made of.
#include <algorithm>
#include <cmath>
#include <map>

#include "support/catch.hpp"
#include "support/contact_scenes.hpp"
#include "support/polyline.hpp"

namespace hdconj::test::contact_limits_cases {

namespace {

std::map<Stage, int> entered(Scene const& scene, Verb verb)
{
    std::map<Stage, int> count;
    StageObserver const observer = [&](Stage stage) { ++count[stage]; };
    if (verb == Verb::solve)
        (void)solve(scene, observer);
    else
        (void)study_contact(scene, {}, observer);
    return count;
}

double furthest(std::vector<Vec2> const& a, std::vector<Vec2> const& b)
{
    REQUIRE(a.size() == b.size());
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, (a[i] - b[i]).norm());
    return worst;
}

double furthest_from(std::vector<Vec2> const& line, std::vector<Vec2> const& points)
{
    double worst = 0;
    for (Vec2 const& p : points)
        worst = std::max(worst, distance_to_polyline(line, p));
    return worst;
}

}  // namespace

TEST_CASE("contact law: one slice is the plane drive bit for bit whatever effects are there", "[law][contact]")
{
    Solution const plane = solve(builtin_scene());
    for (std::string const surface : {"tilted", "ruled", "per-slice"})
        for (Keys const& effects : {Keys{}, coned(), coned("mapped"), tilted(0.7), with(coned(), tilted(0.7))}) {
            Solution const sliced_drive = solve(builtin_scene(with(sliced(1, surface), effects)));
            CHECK(sliced_drive.circular_spline.outline == plane.circular_spline.outline);
            CHECK(sliced_drive.circular_spline.z == plane.circular_spline.z);
            CHECK(sliced_drive.circular_spline.landmarks == plane.circular_spline.landmarks);
            CHECK(sliced_drive.check->smallest_clearance == plane.check->smallest_clearance);
            CHECK(sliced_drive.geometry.land_half_angle == plane.geometry.land_half_angle);
        }
}

TEST_CASE("contact law: effects without anything to move leave the bits and their stages are not entered",
          "[law][contact]")
{
    Solution const plane = solve(builtin_scene());
    // a tilt of zero and slices of one outline repeat it
    for (Keys const& keys : {with(sliced(5, "tilted"), tilted(0)), sliced(5, "tilted"),
                             with(sliced(5, "tilted"), coned()), with(sliced(4, "per-slice"), {})}) {
        Solution const drive = solve(builtin_scene(keys));
        for (auto const& outline : drive.circular_spline.outline)
            CHECK(outline == plane.circular_spline.outline.front());
    }
    std::vector<Stage> const axial{Stage::coning,    Stage::surface, Stage::tilt,
                                   Stage::clearance, Stage::gap_map, Stage::contact};
    std::map<Stage, int> base = entered(builtin_scene(), Verb::solve);
    for (Stage const stage : axial)
        CHECK(base[stage] == 0);
    // tables that change nothing enter nothing
    for (Keys const& keys : {coned(), tilted(0.7), Keys{"contact.contact_gap=0.002"}}) {
        std::map<Stage, int> counts = entered(builtin_scene(keys), Verb::solve);
        for (Stage const stage : axial)
            CHECK(counts[stage] == 0);
    }
    std::map<Stage, int> slices_only = entered(builtin_scene(sliced(3, "tilted")), Verb::solve);
    CHECK(slices_only[Stage::surface] == 1);
    for (Stage const stage : {Stage::coning, Stage::tilt, Stage::clearance, Stage::gap_map, Stage::contact})
        CHECK(slices_only[stage] == 0);
    std::map<Stage, int> tilt_too = entered(builtin_scene(with(sliced(3, "tilted"), tilted(0.1))), Verb::solve);
    CHECK(tilt_too[Stage::tilt] == 1);
    CHECK(tilt_too[Stage::coning] == 0);
    std::map<Stage, int> cone = entered(builtin_scene(with(sliced(3, "per-slice"), coned())), Verb::solve);
    CHECK(cone[Stage::coning] == 1);
    CHECK(cone[Stage::tilt] == 0);
    // and of the verb contact
    std::map<Stage, int> plain = entered(builtin_scene(small({})), Verb::contact);
    CHECK(plain[Stage::coning] == 0);
    CHECK(plain[Stage::tilt] == 0);
    CHECK(plain[Stage::contact] >= 1);
    std::map<Stage, int> coned_contact =
        entered(builtin_scene(small(with(sliced(3, "tilted"), coned()))), Verb::contact);
    CHECK(coned_contact[Stage::coning] >= 1);
    CHECK(coned_contact[Stage::tilt] == 0);
}

TEST_CASE("contact law: outlines tend to the plane one with the tilt in first order", "[law][contact]")
{
    Solution const plane = solve(builtin_scene());
    auto const& base = plane.circular_spline.outline.front();
    for (std::string const kind : {"radial", "draft"}) {
        for (double const angle : {1e-3, 1e-6, 1e-9, 1e-12, -1e-3, -1e-9}) {
            Solution const drive = solve(builtin_scene(with(sliced(3, "tilted"), tilted(angle, kind))));
            double const wanted = 3.5 * std::tan(std::abs(angle) * degree);
            INFO(kind << " " << angle);
            auto const& outlines = drive.circular_spline.outline;
            REQUIRE(outlines.size() == 3);
            if (kind == "radial") {
                CHECK(outlines[1] == base);
                for (std::size_t const k : {0u, 2u})
                    CHECK(furthest(outlines[k], base) == Approx(wanted).margin(1e-14));
            } else {
                // another choice of points: both polygons are right to the chord error
                CHECK(furthest_from(base, outlines[1]) < 1.05e-6);
                for (std::size_t const k : {0u, 2u}) {
                    CHECK(furthest_from(base, outlines[k]) < 1.42 * wanted + 1.05e-6);
                    CHECK(furthest(outlines[k], outlines[1]) >= wanted * (1 - 1e-9) - 1e-14);
                    CHECK(furthest(outlines[k], outlines[1]) < 2.5 * wanted + 2e-12);
                }
            }
        }
    }
}

TEST_CASE("contact law: outlines of a coned drive tend to the plane one with the length of the cup in first order",
          "[law][contact]")
{
    Solution const plane = solve(builtin_scene());
    double before = 0;
    for (double const length : {1e2, 1e4, 1e6, 1e8}) {
        // the last one is more than a scene may ask for
        Scene scene = builtin_scene(coned());
        scene.coning->bottom_to_middle = length;
        ConedDrive drive(scene, 3);
        conjugate::MatchedOutline const outline = drive.surface(ToothSurface::per_slice, TiltKind::radial, 0, 1e-6, 0);
        double const moved =
            std::max(furthest(outline.points[0], outline.points[1]), furthest(outline.points[2], outline.points[1]));
        INFO("length " << length << ": " << moved);
        CHECK(furthest_from(plane.circular_spline.outline.front(), outline.points[1]) < 1.05e-6);
        // amplitudes differ by w0 z/length; points of one origin move by a few times that
        CHECK(moved < 10 * 0.25 * 3.5 / length + 1e-12);
        CHECK(moved > 0.25 * 3.5 / length * 0.5);
        if (before > 0)
            CHECK(before / moved == Approx(100).epsilon(0.2));
        before = moved;
    }
}

TEST_CASE("contact law: contact of a coned drive tends to that of the plane one", "[law][contact]")
{
    ContactState const plane =
        only_case(builtin_scene(small(with({"circular_spline.backlash_offset=0.002"}, sliced(3, "tilted"))))).state;
    for (std::string const shift : {"none", "mapped"}) {
        double before = 0;
        for (double const length : {1e2, 1e4, 1e6}) {
            ContactCase const one = only_case(builtin_scene(small(
                with(with({"circular_spline.backlash_offset=0.002"}, sliced(3, "tilted")), coned(shift, length)))));
            double const difference = std::abs(one.state.turn_to_contact - plane.turn_to_contact);
            INFO(shift << ", length " << length << ": " << difference);
            // no more than the change of shape over the reach: (w0 z + r u_z'...)/length over 25 mm
            CHECK(difference < 1 / (25 * length) + 1e-12);
            if (before > 0)
                CHECK(difference < before / 50 + 1e-13);
            before = difference;
        }
    }
}

TEST_CASE("contact law: area grows with the contact gap and is gone with it", "[law][contact]")
{
    double before = 0;
    for (double const gap : {1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 0.003, 0.01, 0.025}) {
        ContactCase const one = only_case(builtin_scene(with(
            {"contact.flank_points=200", "circular_spline.backlash_offset=0.005", "contact.contact_gap=" + number(gap)},
            {})));
        INFO("gap " << gap << ": share " << one.state.contact_fraction);
        CHECK(one.state.contact_fraction >= before);
        CHECK(one.state.contact_fraction <= 1);
        if (gap <= 1e-7)
            CHECK(one.state.contact_fraction < 1e-3);
        if (gap >= 0.003)
            CHECK(one.state.contact_fraction > 0.05);
        before = one.state.contact_fraction;
    }
}

TEST_CASE("contact law: play goes to nothing with the side clearance", "[law][contact]")
{
    double before = 1;
    for (double const offset : {1e-2, 1e-4, 1e-6}) {
        ContactState const state =
            only_case(builtin_scene(small({"circular_spline.backlash_offset=" + number(offset)}))).state;
        INFO("offset " << offset << " play " << state.backlash());
        CHECK(state.backlash() > 2 * offset / 26);
        CHECK(state.backlash() < 4 * offset / 25);
        CHECK(state.backlash() < before);
        before = state.backlash();
    }
}

TEST_CASE("contact law: the least side clearance and its tip circle make a part that is touched and not entered",
          "[law][contact]")
{
    for (auto const& [keys, tilt] : {std::pair(Keys{}, 0.5), std::pair(coned(), 0.5), std::pair(coned(), -1.5)}) {
        Keys const drive = with(with(keys, sliced(3, "tilted")), tilted(tilt, "radial"));
        ContactCase const least = only_case(builtin_scene(drive));
        ContactCase const made = only_case(
            builtin_scene(with(drive, {"circular_spline.backlash_offset=" + number(least.least_side_clearance),
                                       "circular_spline.inner_radius=" + number(least.least_tip_radius)})));
        INFO((keys.empty() ? "straight, tilt " : "coned, tilt ")
             << tilt << ": clearance " << made.closest_flank().clearance / um << " um");
        REQUIRE(least.least_side_clearance > 1 * um);
        CHECK(made.tip == least.least_tip_radius);
        CHECK_FALSE(made.side_clearance_increased);
        CHECK(std::abs(made.closest_flank().clearance) <= least.least_side_clearance_error + made.clearance_error);
    }
}

}  // namespace hdconj::test::contact_limits_cases
