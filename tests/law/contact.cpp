// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of surfaces and contact: what they clear, and what must not change them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "contact/clearance/made_flanks.hpp"
#include "contact/clearance/part_flanks.hpp"
#include "hdconj/distance/full_turn.hpp"
#include "support/catch.hpp"
#include "support/contact_scenes.hpp"
#include "support/oracle/touch.hpp"
#include "support/polyline.hpp"
#include "support/run/full_run.hpp"
#include "surface/cone.hpp"

namespace hdconj::test::contact_cases {

TEST_CASE("contact law: a conjugate surface clears itself in each of its slices", "[law][contact]")
{
    // Between its points the flank is a cubic, which at 1e-6 differs from the envelope by up to some 2e-9 where it
    // bends most (falling faster than the tolerance): what the tooth is found to enter by there depends on where the
    // search looks, so the outline is a finer one.
    for (std::string const name : {"type-50", "liu-2025", "ellipse"}) {
        Scene const scene = read_scene(
            file_of(name),
            small(with(with({"circular_spline.width=7.0", "solver.tolerance=1e-7"}, coned()), sliced(5, "per-slice"))));
        ContactCase const one = only_case(scene);
        INFO(name);
        CHECK(one.least_side_clearance == 0);
        CHECK_FALSE(one.side_clearance_increased);
        REQUIRE(one.slices.size() == 5);
        for (SliceClearance const& slice : one.slices) {
            INFO("z " << slice.z << ": " << slice.flank.clearance);
            CHECK(std::abs(slice.flank.clearance) <= 1e-10);
            CHECK(slice.root.clearance >= -1e-9);
        }
    }
}

TEST_CASE("contact law: clearances of a tilted type-50 are the oracle's and the design's", "[law][contact]")
{
    // Design 3.4, cone with its apex 0.43 mm above the cup's bottom, zero clearance, tilted radially. "Over the flank"
    // is here: all points of the circular spline between land corner and flank end, and the depth of each of them in
    // the nearest tooth over a full turn. At z = -3.5 the worst is the land corner, and the design's numbers are met to
    // 2 um. At z = +3.5 it is the flank end, and this gives -70, -62, -38, -3 where the design says -81, -72, -48, -3.
    // The design's numbers are right for a flank that reaches 14 um further, to x = 0.0447 on the land in the root,
    // under the tip of the tooth: one place that gives all three. In the middle of the root it is -100, -87, -53, which
    // the program tells apart as the root's.
    struct Row
    {
        double tilt_deg, at_bottom_end, at_open_end, root, design_at_open_end;
    };
    for (Row const& row : {Row{0, -78, -69.9, -99.6, -81},
                           {0.2, -88, -61.9, -87.4, -72},
                           {0.77, -117, -37.6, -52.5, -48},
                           {1.67, -157, -3.4, 0, 0}}) {
        Keys const keys = with(with(small(coned()), sliced(3, "tilted")), tilted(row.tilt_deg));
        ContactCase const one = only_case(builtin_scene(keys));
        INFO("tilt " << row.tilt_deg << ": " << one.slices.front().flank.clearance / um << ", "
                     << one.slices.back().flank.clearance / um << ", root " << one.slices.back().root.clearance / um);
        CHECK(one.slices.front().flank.clearance / um == Approx(row.at_bottom_end).margin(2.2));
        CHECK(one.slices.back().flank.clearance / um == Approx(row.at_open_end).margin(0.1));
        if (row.root < 0)
            CHECK(one.slices.back().root.clearance / um == Approx(row.root).margin(0.1));

        // the oracle: its own tooth, its own motion, all positions
        Solution const plane = solve(builtin_scene());
        auto const& outline = plane.circular_spline.outline.front();
        auto const& marks = plane.circular_spline.landmarks;
        ConedDrive const drive(builtin_scene(keys), 3);
        for (std::size_t const k : {0u, 2u}) {
            oracle::TouchScan scan(drive.slice_scene(k), 600);
            double worst = 1;
            int where = marks[3];
            auto const look = [&](int i) {
                Vec2 const p = surface::moved_radially(outline[static_cast<std::size_t>(i)],
                                                       drive.z()[k] * std::tan(row.tilt_deg * degree));
                double const distance = scan.nearest({p.x(), p.y()}).distance;
                where = distance < worst ? i : where;
                worst = std::min(worst, distance);
            };
            // the ends and a few between, then all about the worst
            for (int i = marks[3]; i < marks[4]; i += 16)
                look(i);
            look(marks[4]);
            int const about = where;
            for (int i = std::max(marks[3], about - 16); i <= std::min(marks[4], about + 16); i += 2)
                look(i);
            double const found = (k == 0 ? one.slices.front() : one.slices.back()).flank.clearance;
            CHECK(found == Approx(worst).margin(0.1 * um));
            if (k == 2 && row.root < 0) {
                // the root is flat there to a tenth of a micrometre
                Vec2 const bottom = outline[static_cast<std::size_t>(marks[2])];
                Vec2 const under_the_tip =
                    surface::moved_radially({0.0447, bottom.y()}, drive.z()[k] * std::tan(row.tilt_deg * degree));
                CHECK(scan.nearest({under_the_tip.x(), under_the_tip.y()}).distance / um ==
                      Approx(row.design_at_open_end).margin(1));
            }
        }
    }
}

TEST_CASE("contact law: the least side clearance leaves no interference, a micrometre less does", "[law][contact]")
{
    for (Keys const& surface : {with(sliced(3, "tilted"), tilted(0.2)), sliced(3, "tilted"), sliced(3, "ruled"),
                                with(sliced(3, "tilted"), tilted(0.2, "draft"))}) {
        Scene const scene = builtin_scene(with(with({"contact.flank_points=200"}, coned()), surface));
        ContactCase const one = only_case(scene);
        INFO(to_string(one.surface) << " " << to_string(one.kind) << " " << one.tilt / degree << ": offset "
                                    << one.least_side_clearance / um);
        // the straight lines between conjugate end planes stay clear of the slices between them on this drive
        bool const needed = one.surface != ToothSurface::ruled;
        CHECK((one.least_side_clearance > 1 * um) == needed);
        // finer points than the program looked at
        ConedDrive drive(scene, 3);
        contact::FlankGrid const fine =
            drive.flanks_to_tip({one.surface, one.kind.value_or(TiltKind::radial), one.tilt}, one.least_tip_radius,
                                one.least_side_clearance, 700);
        auto const least = [&](double offset) {
            contact::FlankGrid const moved = contact::moved_into_material(fine, offset);
            double worst = 1;
            for (std::size_t k = 0; k < fine.slices(); ++k) {
                auto const& motion = drive.maker->motion(k).motion;
                distance::FullTurnClearance<motion::AnyMotion> const turns(drive.tooth, motion, drive.pitch(), 1);
                distance::TurnMinimum last = turns(moved.point[1][k].front());
                for (Vec2 const& p : moved.point[1][k]) {
                    last = turns(p, &last);
                    worst = std::min(worst, last.distance);
                }
            }
            return worst;
        };
        CHECK(least(one.least_side_clearance) >= -1e-6);
        if (needed)
            CHECK(least(one.least_side_clearance - 1 * um) < 0);
    }
}

TEST_CASE("contact law: the flank moved by a side clearance is the flank solved with it", "[law][contact]")
{
    ConedDrive drive(builtin_scene(), 1);
    for (double const offset : {1e-4, 0.003, 0.02}) {
        double const tip = drive.middle.geometry.circular_spline_inner_radius;
        contact::FlankGrid const moved = contact::moved_into_material(
            drive.flanks_to_tip({ToothSurface::tilted, TiltKind::radial, 0}, tip, offset, 200), offset);
        auto const own =
            solve(builtin_scene({"circular_spline.backlash_offset=" + number(offset), "solver.tolerance=1e-8"}))
                .circular_spline.outline.front();
        for (std::size_t flank = 0; flank < 2; ++flank) {
            double worst = 0;
            std::size_t looked = 0;
            for (Vec2 const& p : moved.point[flank][0]) {
                double const d = distance_to_polyline(own, p);
                looked += d < 1.05e-8;
                worst = std::max(worst, d);
            }
            INFO("offset " << offset << " flank " << flank << " worst " << worst);
            CHECK(worst < 0.2 * offset);
            CHECK(looked + 12 > moved.point[flank][0].size());
        }
    }
}

TEST_CASE("contact law: flanks of a ruled surface with a side clearance lie on the outlines that are written",
          "[law][contact]")
{
    constexpr std::size_t slices = 5;
    for (double const offset : {0.004, 0.04}) {
        INFO("side clearance " << offset);
        Keys const keys =
            with(with({"circular_spline.backlash_offset=" + number(offset)}, coned()), sliced(slices, "ruled"));
        Solution const written = solve(builtin_scene(keys));
        double const tip = written.geometry.circular_spline_inner_radius;
        ConedDrive drive(builtin_scene(keys), slices);
        contact::CaseSurface const surface(*drive.context, {ToothSurface::ruled, TiltKind::radial, 0});
        contact::FlankGrid const bare = contact::part_flanks(surface, surface.outline(tip), tip, offset).grid;
        auto const worst = [&](contact::FlankGrid const& grid) {
            double most = 0;
            for (auto const& flank : grid.point)
                for (std::size_t k = 0; k < slices; ++k)
                    for (Vec2 const& p : flank[k])
                        most = std::max(most, distance_to_polyline(written.circular_spline.outline[k], p));
            return most;
        };
        CHECK(worst(contact::made_flanks(surface, bare, tip, offset)) < 2e-6);
        // slices that are moved along their own normals do not
        CHECK(worst(contact::moved_into_material(bare, offset)) > 1e-4);
    }
}

TEST_CASE("contact law: a ruled flank with a side clearance has the area of the surface that is written",
          "[law][contact]")
{
    for (double const offset : {0.0, 0.04}) {
        INFO("side clearance " << offset);
        Keys const keys =
            with(with({"contact.flank_points=200", "circular_spline.backlash_offset=" + number(offset)}, coned()),
                 sliced(17, "ruled"));
        ContactStudy const study = study_contact(builtin_scene(keys));
        ContactState const& told = study.cases.front().state;
        auto const& spline = study.solution.circular_spline;
        // straight lines join the ends: in many more steps than there are slices
        constexpr int steps = 256;
        auto const point = [&](int step, int i) {
            double const share = static_cast<double>(step) / steps;
            auto const at = static_cast<std::size_t>(i);
            Vec2 const p = (1 - share) * spline.outline.front()[at] + share * spline.outline.back()[at];
            return Eigen::Vector3d(p.x(), p.y(), std::lerp(spline.z.front(), spline.z.back(), share));
        };
        double area = 0;
        for (int k = 0; k < steps; ++k)
            for (int i = spline.landmarks[3]; i < spline.landmarks[4]; ++i) {
                Eigen::Vector3d const a = point(k, i), b = point(k, i + 1), c = point(k + 1, i),
                                      d = point(k + 1, i + 1);
                area += (b + d - a - c).cross(c + d - a - b).norm() / 4;  // by the middle of each patch
            }
        area *= 202;
        INFO(told.flank_area << " +- " << told.flank_area_error << " mm^2, written " << area);
        CHECK(std::abs(told.flank_area - area) < told.flank_area_error);
    }
}

TEST_CASE("contact law: flanks with a draft that are written touch, are not entered, and have the area that is told",
          "[law][contact]")
{
    constexpr int slices = 9;
    for (double const draft : full_run() ? std::vector{-1.0, -0.3, 0.3} : std::vector{-1.0, 0.3}) {
        Keys const drafted = with(with(coned(), sliced(slices, "tilted")), tilted(draft, "draft"));
        ContactCase const least = only_case(builtin_scene(drafted));
        Scene const scene =
            builtin_scene(with(drafted, {"circular_spline.backlash_offset=" + number(least.least_side_clearance),
                                         "circular_spline.inner_radius=" + number(least.least_tip_radius)}));
        ContactStudy const study = study_contact(scene);
        ContactCase const& made = study.cases.front();
        auto const& spline = study.solution.circular_spline;
        auto const first = static_cast<std::size_t>(spline.landmarks[3]),
                   last = static_cast<std::size_t>(spline.landmarks[4]);
        INFO("draft " << draft << ", side clearance " << made.backlash_offset / um << " um");
        REQUIRE(made.backlash_offset == scene.circular_spline.backlash_offset);
        ConedDrive drive(scene, slices);
        double lowest = 1, area = 0;
        for (std::size_t k = 0; k < spline.outline.size(); ++k) {
            distance::FullTurnClearance<motion::AnyMotion> const turns(drive.tooth, drive.maker->motion(k).motion,
                                                                       drive.pitch(), 1);
            for (std::size_t i = first; i <= last; ++i)
                lowest = std::min(lowest, turns(spline.outline[k][i]).distance);
            double length = 0;
            for (std::size_t i = first; i < last; ++i)
                length += (spline.outline[k][i + 1] - spline.outline[k][i]).norm();
            area += length * (k == 0 || k + 1 == spline.outline.size() ? 0.5 : 1.0);
        }
        CHECK(std::abs(lowest) < 1e-6);
        area *= drive.z_c() * (spline.z.back() - spline.z.front()) / (slices - 1) / std::cos(draft * degree);
        CHECK(made.state.flank_area == Approx(area).epsilon(1e-4));
    }
}

TEST_CASE("contact law: slices made for the sections of a cup that shifts along its axis are touched and not entered",
          "[law][contact]")
{
    Keys const cone = with(with(coned("mapped"), sliced(3, "per-slice")), {"contact.flank_points=60"});
    for (Keys const& drive : {Keys{}, Keys{"solver.kinematics=material"}, Keys{"wave_generator.family=ellipse"},
                              Keys{"circular_spline.width=5"}}) {
        ContactCase const one = only_case(builtin_scene(with(cone, drive)));
        CAPTURE(one.backlash_offset, one.state.smallest_gap);
        for (auto const& slice : one.slices) {
            CHECK(slice.flank.clearance > -1e-9);
            CHECK(slice.flank.clearance < 1e-6);
        }
        // no side clearance: neither for a full turn nor for the gaps
        CHECK(one.backlash_offset < 1e-9);
        CHECK(one.state.smallest_gap > -1e-9);
    }
    ConedDrive rollers(builtin_scene(with(coned("mapped"),
                                          {"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=25"})),
                       3);
    CHECK(rollers.maker->note_on_sections().find("has breaks") != std::string::npos);
    CHECK(ConedDrive(builtin_scene(coned("mapped")), 3).maker->note_on_sections().empty());
}

TEST_CASE("contact law: both flanks are alike at no torque", "[law][contact]")
{
    for (std::string const shift : {"none", "mapped"}) {
        ContactState const state = only_case(builtin_scene(small(with(with(coned(shift), sliced(3, "per-slice")),
                                                                      {"circular_spline.backlash_offset=0.05"}))))
                                       .state;
        INFO(shift);
        CHECK(state.turn_to_contact == Approx(state.reverse_turn_to_contact).margin(1e-13));
    }
    // and with the wave generator off a tooth space one flank at an angle is the other at the opposite one
    auto const at = [](double angle) {
        return only_case(builtin_scene(small({"circular_spline.backlash_offset=0.01",
                                              "contact.wave_generator_angle_deg=" + number(angle)})))
            .state;
    };
    ContactState const plus = at(0.37), minus = at(-0.37);
    CHECK(plus.turn_to_contact == Approx(minus.reverse_turn_to_contact).margin(1e-13));
    CHECK(plus.reverse_turn_to_contact == Approx(minus.turn_to_contact).margin(1e-13));
    CHECK(plus.smallest_gap == Approx(minus.smallest_gap).margin(1e-12));
}

TEST_CASE("contact law: nothing changes when the wave generator turns by one pitch of the circular spline",
          "[law][contact]")
{
    auto const at = [](double angle) {
        return only_case(builtin_scene(small(with(with(coned("mapped"), sliced(3, "tilted")),
                                                  {"circular_spline.backlash_offset=0.15",
                                                   "contact.wave_generator_angle_deg=" + number(angle)}))))
            .state;
    };
    ContactState const one = at(0.4), next = at(0.4 + 360.0 / 202), far = at(0.4 - 7 * 360.0 / 202);
    for (ContactState const& other : {next, far}) {
        CHECK(other.turn_to_contact == Approx(one.turn_to_contact).margin(1e-12));
        CHECK(other.reverse_turn_to_contact == Approx(one.reverse_turn_to_contact).margin(1e-12));
        CHECK(other.contact_fraction == Approx(one.contact_fraction).margin(1e-9));
        CHECK(other.teeth == one.teeth);
        CHECK(other.smallest_gap == Approx(one.smallest_gap).margin(1e-11));
    }
    ContactState const half = at(0.4 + 180.0 / 202);
    CHECK(std::abs(half.smallest_gap - one.smallest_gap) > 1e-9);
}

TEST_CASE("contact law: a drive twice or a quarter as large has lengths twice or a quarter as large", "[law][contact]")
{
    auto const scaled = [](double s) {
        Keys keys{"contact.flank_points=60", "contact.contact_gap=" + number(s * 1e-3),
                  "solver.tolerance=" + number(s * 0x1p-20)};
        for (auto const& [key, value] : std::map<std::string, double>{{"drive.module", 0.25},
                                                                      {"flexspline.wall", 0.7},
                                                                      {"flexspline.profile.addendum", 0.225},
                                                                      {"flexspline.profile.dedendum", 0.303},
                                                                      {"flexspline.profile.convex_radius", 0.2701},
                                                                      {"flexspline.profile.convex_offset", 0.0982},
                                                                      {"flexspline.profile.concave_radius", 0.5145},
                                                                      {"flexspline.profile.concave_rise", 0.0671},
                                                                      {"flexspline.profile.tip_line_from", 0.19},
                                                                      {"wave_generator.radial_deformation", 0.25},
                                                                      {"circular_spline.width", 7.0},
                                                                      {"circular_spline.backlash_offset", 0.02},
                                                                      {"circular_spline.inner_radius", 25.025},
                                                                      {"coning.bottom_to_middle", 9.0},
                                                                      {"coning.apex_height", 0.43}})
            keys.push_back(key + "=" + number(s * value));
        return only_case(builtin_scene(with(with(keys, {"coning.model=linear", "coning.axial_shift=mapped"}),
                                            with(sliced(3, "tilted"), tilted(0.1)))));
    };
    ContactCase const one = scaled(1);
    for (double const s : {2.0, 0.25}) {
        ContactCase const other = scaled(s);
        INFO("scale " << s);
        CHECK(other.least_side_clearance == Approx(s * one.least_side_clearance).epsilon(1e-12));
        CHECK(other.least_tip_radius == Approx(s * one.least_tip_radius).epsilon(1e-12));
        CHECK(other.state.turn_to_contact == Approx(one.state.turn_to_contact).epsilon(1e-10));
        CHECK(other.state.contact_fraction == Approx(one.state.contact_fraction).margin(1e-9));
        CHECK(other.state.flank_area == Approx(s * s * one.state.flank_area).epsilon(1e-10));
        for (std::size_t k = 0; k < one.slices.size(); ++k)
            CHECK(other.slices[k].flank.clearance == Approx(s * one.slices[k].flank.clearance).epsilon(1e-11));
    }
}

TEST_CASE("contact law: a whole study has the same bits for 1 and 2 threads", "[law][contact][parallel]")
{
    auto const study = [](int threads) {
        ContactOptions options;
        options.tilts = {0, 0.2 * degree};
        options.surfaces = {ToothSurface::tilted, ToothSurface::per_slice};
        return study_contact(builtin_scene(small(with(with(coned("mapped"), sliced(3, "tilted")),
                                                      {"solver.threads=" + std::to_string(threads)}))),
                             options);
    };
    ContactStudy const one = study(1), two = study(2);
    REQUIRE(one.cases.size() == two.cases.size());
    CHECK(one.cases.size() == 4);
    CHECK(one.written_case == two.written_case);
    CHECK(one.map.gap == two.map.gap);
    CHECK(one.solution.circular_spline.outline == two.solution.circular_spline.outline);
    for (std::size_t i = 0; i < one.cases.size(); ++i) {
        CHECK(one.cases[i].least_side_clearance == two.cases[i].least_side_clearance);
        CHECK(one.cases[i].least_root_clearance == two.cases[i].least_root_clearance);
        CHECK(one.cases[i].state.turn_to_contact == two.cases[i].state.turn_to_contact);
        CHECK(one.cases[i].state.contact_area == two.cases[i].state.contact_area);
        CHECK(one.cases[i].state.contact_fraction_error == two.cases[i].state.contact_fraction_error);
        for (std::size_t k = 0; k < one.cases[i].slices.size(); ++k) {
            CHECK(one.cases[i].slices[k].flank.clearance == two.cases[i].slices[k].flank.clearance);
            CHECK(one.cases[i].slices[k].root.clearance == two.cases[i].slices[k].root.clearance);
        }
    }
}

}  // namespace hdconj::test::contact_cases
