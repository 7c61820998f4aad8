// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a contact share and the clearance it is computed with state of their own error. The whole ladder, with random
/// designs: docs/tables/contact_error.py.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "hdconj/contact.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/contact_scenes.hpp"
#include "support/polyline.hpp"

namespace hdconj::test::contact_error_cases {

namespace {

Keys resolution(int slices, int points, std::string const& surface)
{
    return {"slices.count=" + std::to_string(slices), "contact.flank_points=" + std::to_string(points),
            "slices.surface=" + surface};
}

ContactCase only_case(Keys const& keys)
{
    return study_contact(builtin_scene(keys)).cases.front();
}

}  // namespace

TEST_CASE("contact law: clearance and share do not depend on how many points the flank is looked at", "[law][contact]")
{
    // slices that stay in their planes, and sections that do not: it takes a clearance, which one place of the flank
    // decides
    Keys const drive = with(coned("mapped"), {"solver.kinematics=first-order"});
    ContactCase const many = only_case(with(drive, resolution(3, 800, "per-slice")));
    REQUIRE(many.backlash_offset > 3 * um);
    for (int const points : {50, 73, 200}) {
        ContactCase const few = only_case(with(drive, resolution(3, points, "per-slice")));
        INFO(points << " points: " << few.backlash_offset / um << " um, " << few.state.contact_fraction << " +- "
                    << few.state.contact_fraction_error);
        // the pointed minimum lies between any of these; clearance_accuracy() of both
        CHECK(few.backlash_offset == Approx(many.backlash_offset).margin(2 * 0x1p-6 * 1e-6));
        CHECK(few.state.contact_fraction ==
              Approx(many.state.contact_fraction).margin(few.state.contact_fraction_error));
        CHECK(std::abs(few.state.contact_fraction - many.state.contact_fraction) < 1e-3 * many.state.contact_fraction);
    }
}

TEST_CASE("contact law: the area of drafted flanks does not depend on the slices", "[law][contact]")
{
    // branches of moved flanks cross at another place in each plane
    Keys const drive{"tilt.angle_deg=0.3", "tilt.kind=draft", "coning.model=linear", "coning.bottom_to_middle=9"};
    ContactState const many = only_case(with(drive, resolution(17, 200, "tilted"))).state;
    for (int const slices : {2, 3, 5}) {
        ContactState const few = only_case(with(drive, resolution(slices, 200, "tilted"))).state;
        INFO(slices << " slices: " << few.flank_area << " +- " << few.flank_area_error);
        CHECK(few.flank_area == Approx(many.flank_area).margin(few.flank_area_error + many.flank_area_error));
        CHECK(few.flank_area_error < 2e-4 * few.flank_area);
    }
}

TEST_CASE("contact law: the stated error of a share bounds its distance to that of many more planes", "[law][contact]")
{
    struct Row
    {
        std::string surface, shift;
        int fine;
    };
    for (Row const& row : {Row{"tilted", "none", 17}, Row{"ruled", "mapped", 17}, Row{"per-slice", "none", 9}}) {
        ContactState const fine = only_case(with(coned(row.shift), resolution(row.fine, 100, row.surface))).state;
        for (int const slices : {2, 3}) {
            ContactState const coarse = only_case(with(coned(row.shift), resolution(slices, 50, row.surface))).state;
            INFO(row.surface << ", " << slices << " slices: " << coarse.contact_fraction << " +- "
                             << coarse.contact_fraction_error << ", finer " << fine.contact_fraction << " +- "
                             << fine.contact_fraction_error);
            CHECK(std::abs(coarse.contact_fraction - fine.contact_fraction) <= coarse.contact_fraction_error);
            CHECK(coarse.contact_fraction_error > fine.contact_fraction_error);
            CHECK(coarse.contact_fraction_error < 4 * fine.contact_fraction);
        }
    }
    // planes that are all alike leave nothing open across
    ContactState const one =
        only_case(with({"circular_spline.backlash_offset=0.005"}, resolution(1, 100, "tilted"))).state;
    ContactState const five =
        only_case(with({"circular_spline.backlash_offset=0.005"}, resolution(5, 100, "tilted"))).state;
    CHECK(five.contact_fraction == Approx(one.contact_fraction).epsilon(1e-12));
    CHECK(five.contact_fraction_error == Approx(one.contact_fraction_error).epsilon(1e-6));
    CHECK(one.contact_fraction_error < 1e-3 * one.contact_fraction);
}

TEST_CASE("contact law: the stated error of every figure bounds its distance to a run many times finer",
          "[law][contact]")
{
    struct Design
    {
        std::string surface;
        Keys keys;
    };
    std::mt19937 random(20261122);
    auto const between = [&](double low, double high) {
        return low + (high - low) * std::generate_canonical<double, 53>(random);
    };
    auto const text = [](double value) { return std::to_string(value); };
    std::vector<Design> designs;
    for (std::string const surface : {"tilted", "ruled", "per-slice"}) {
        Keys keys = coned(designs.size() % 2 == 0 ? "mapped" : "none", between(8, 30));
        keys = with(keys, {"wave_generator.radial_deformation=" + text(between(0.242, 0.258)),
                           "contact.wave_generator_angle_deg=" + text(between(-1.5, 1.5)),
                           "flexspline.profile.convex_radius=" + text(between(0.266, 0.274))});
        if (designs.size() != 2)
            keys = with(keys, {"tilt.kind=radial", "tilt.angle_deg=" + text(between(-0.3, 0.3))});
        if (designs.size() > 1)
            keys = with(keys, {"circular_spline.backlash_offset=" + text(between(0.002, 0.02))});
        designs.push_back({surface, keys});
    }
    for (Design const& design : designs) {
        std::string told = design.surface;
        for (std::string const& key : design.keys)
            told += ' ' + key;
        ContactCase const coarse = only_case(with(design.keys, resolution(3, 50, design.surface)));
        ContactCase const fine = only_case(with(design.keys, resolution(13, 100, design.surface)));
        auto const smallest_root = [](ContactCase const& each) {
            double smallest = each.slices.front().root.clearance;
            for (SliceClearance const& slice : each.slices)
                smallest = std::min(smallest, slice.root.clearance);
            return smallest;
        };
        auto const check = [&](char const* what, double value, double error, double true_value, double its_error) {
            INFO(told << ": " << what << " " << value << " +- " << error << ", finer " << true_value << " +- "
                      << its_error);
            CHECK(error >= 0);
            CHECK(std::abs(value - true_value) <= error + its_error);
            // an error that is as large as anything would say nothing
            CHECK(error < 0.1 * std::max(std::abs(value), um));
        };
        check("clearance", coarse.closest_flank().clearance, coarse.clearance_error, fine.closest_flank().clearance,
              fine.clearance_error);
        check("root clearance", smallest_root(coarse), coarse.root_clearance_error, smallest_root(fine),
              fine.root_clearance_error);
        for (std::size_t k = 0; k < coarse.slices.size(); ++k) {
            SliceClearance const &own = coarse.slices[k],
                                 &same = fine.slices[k * (fine.slices.size() - 1) / (coarse.slices.size() - 1)];
            REQUIRE(own.z == Approx(same.z).margin(1e-9));
            check("clearance of a slice", own.flank.clearance, own.flank_error, same.flank.clearance, same.flank_error);
            check("root clearance of a slice", own.root.clearance, own.root_error, same.root.clearance,
                  same.root_error);
        }
        check("least side clearance", coarse.least_side_clearance, coarse.least_side_clearance_error,
              fine.least_side_clearance, fine.least_side_clearance_error);
        check("least tip radius", coarse.least_tip_radius, coarse.least_tip_radius_error, fine.least_tip_radius,
              fine.least_tip_radius_error);
        check("least root clearance", coarse.least_root_clearance, coarse.least_root_clearance_error,
              fine.least_root_clearance, fine.least_root_clearance_error);
        check("backlash of least side clearance", coarse.backlash_of_least_side_clearance,
              coarse.backlash_of_least_side_clearance_error, fine.backlash_of_least_side_clearance,
              fine.backlash_of_least_side_clearance_error);
        check("turn to contact", coarse.state.turn_to_contact, coarse.state.turn_to_contact_error,
              fine.state.turn_to_contact, fine.state.turn_to_contact_error);
        check("reverse turn to contact", coarse.state.reverse_turn_to_contact,
              coarse.state.reverse_turn_to_contact_error, fine.state.reverse_turn_to_contact,
              fine.state.reverse_turn_to_contact_error);
        check("play", coarse.state.backlash(), coarse.state.backlash_error(), fine.state.backlash(),
              fine.state.backlash_error());
        check("smallest gap", coarse.state.smallest_gap, coarse.state.smallest_gap_error, fine.state.smallest_gap,
              fine.state.smallest_gap_error);
        if (design.surface == "ruled") {
            INFO(told << ": deviation " << coarse.ruled_deviation << " +- " << coarse.ruled_deviation_error
                      << ", finer " << fine.ruled_deviation << " +- " << fine.ruled_deviation_error);
            CHECK(std::abs(coarse.ruled_deviation - fine.ruled_deviation) <=
                  coarse.ruled_deviation_error + fine.ruled_deviation_error);
            CHECK(coarse.ruled_deviation_error < coarse.ruled_deviation);
        }
        INFO(told << ": teeth " << coarse.state.teeth_least << " ... " << coarse.state.teeth_most << ", finer "
                  << fine.state.teeth);
        CHECK(coarse.state.teeth_least <= coarse.state.teeth);
        CHECK(coarse.state.teeth <= coarse.state.teeth_most);
        CHECK(coarse.state.teeth_least <= fine.state.teeth);
        CHECK(fine.state.teeth <= coarse.state.teeth_most);
        INFO(told << ": share " << coarse.state.contact_fraction << " +- " << coarse.state.contact_fraction_error
                  << ", finer " << fine.state.contact_fraction << " +- " << fine.state.contact_fraction_error);
        CHECK(std::abs(coarse.state.contact_fraction - fine.state.contact_fraction) <=
              coarse.state.contact_fraction_error + fine.state.contact_fraction_error);
        INFO(told << ": flanks " << coarse.state.flank_area << " +- " << coarse.state.flank_area_error << ", finer "
                  << fine.state.flank_area << " +- " << fine.state.flank_area_error);
        CHECK(std::abs(coarse.state.flank_area - fine.state.flank_area) <=
              coarse.state.flank_area_error + fine.state.flank_area_error);
        CHECK(coarse.state.flank_area_error < 0.05 * coarse.state.flank_area);
        CHECK(std::abs(coarse.state.contact_area - fine.state.contact_area) <=
              coarse.state.contact_area_error + fine.state.contact_area_error);
    }
}

TEST_CASE("contact law: a clearance that opens more slowly than its wall is moved is known to as much less",
          "[law][contact]")
{
    // at a straight tooth the wall beside the root opens half as fast as it is moved outward
    Keys const drive{"coning.model=linear",     "coning.bottom_to_middle=30", "coning.axial_shift=none",
                     "circular_spline.width=7", "tilt.kind=radial",           "tilt.angle_deg=0.2"};
    auto const cleared = [&](std::string const& tolerance) {
        return study_contact(read_scene(file_of("straight"), with(with(drive, resolution(3, 10, "ruled")),
                                                                  {"solver.tolerance=" + tolerance})))
            .cases.front();
    };
    ContactCase const fine = cleared("1e-8");
    for (std::string const tolerance : {"1e-6", "4e-6", "1e-5", "2e-5", "4e-5"}) {
        ContactCase const coarse = cleared(tolerance);
        INFO(tolerance << ": " << coarse.least_root_clearance / um << " +- " << coarse.least_root_clearance_error / um
                       << " um, finer " << fine.least_root_clearance / um);
        CHECK(std::abs(coarse.least_root_clearance - fine.least_root_clearance) <=
              coarse.least_root_clearance_error + fine.least_root_clearance_error);
    }
}

TEST_CASE("contact law: a tooth that touches between two planes is told by the error of the planes", "[law][contact]")
{
    // a negative tilt over-corrects the cone: with a cone of its own the deepest place lies within the width
    Keys const drive = with(coned("none", 60), {"tilt.kind=radial", "tilt.angle_deg=0.25"});
    ContactCase const fine = only_case(with(drive, resolution(17, 50, "tilted")));
    for (int const slices : {2, 3, 4}) {
        ContactCase const coarse = only_case(with(drive, resolution(slices, 50, "tilted")));
        INFO(slices << ": " << coarse.least_side_clearance / um << " +- " << coarse.least_side_clearance_error / um
                    << ", finer " << fine.least_side_clearance / um);
        CHECK(std::abs(coarse.least_side_clearance - fine.least_side_clearance) <=
              coarse.least_side_clearance_error + fine.least_side_clearance_error);
        CHECK(std::abs(coarse.closest_flank().clearance - fine.closest_flank().clearance) <=
              coarse.clearance_error + fine.clearance_error);
    }
}

TEST_CASE("contact law: a tip circle that more planes lift is told by the error of the few", "[law][contact]")
{
    // the rigid bearing of a thin cup enters a ruled surface between its ends only: there nothing is moved, and no
    // corner lifted
    auto const ruled = [](int slices) {
        Keys const drive{"bearing.type=rigid",
                         "bearing.width=2.05",
                         "!bearing.ring_thickness",
                         "!bearing.axially",
                         "flexspline.cup.barrel_wall=0.4",
                         "flexspline.wall=0.6"};
        return study_contact(read_scene(file_of("type-50-elastic"), with(drive, resolution(slices, 50, "ruled"))))
            .cases.front();
    };
    ContactCase const fine = ruled(17);
    CHECK(ruled(2).least_side_clearance == 0);
    for (int const slices : {2, 3, 5}) {
        ContactCase const coarse = ruled(slices);
        INFO(slices << " slices: " << coarse.least_tip_radius << " +- " << coarse.least_tip_radius_error << ", finer "
                    << fine.least_tip_radius << " +- " << fine.least_tip_radius_error);
        CHECK(fine.least_tip_radius - coarse.least_tip_radius > 0.3 * um);
        CHECK(fine.least_tip_radius - coarse.least_tip_radius <=
              coarse.least_tip_radius_error + fine.least_tip_radius_error);
        CHECK(coarse.least_tip_radius_error < 2 * (fine.least_tip_radius - coarse.least_tip_radius));
    }
}

TEST_CASE("contact law: the tip circle of a drafted ring does not depend on the planes that it is sought in",
          "[law][contact]")
{
    // the tip circle passes a joint of the flank's profile from some height on
    auto const drafted = [](int slices) {
        Keys const drive{"drive.flexspline_teeth=240",
                         "drive.circular_spline_teeth=242",
                         "flexspline.wall=0.84",
                         "wave_generator.family=ellipse",
                         "wave_generator.radial_deformation=0.215",
                         "circular_spline.width=10.5",
                         "circular_spline.inner_radius=30.025",
                         "coning.model=linear",
                         "coning.bottom_to_middle=21",
                         "coning.axial_shift=none",
                         "tilt.kind=draft",
                         "tilt.angle_deg=0.1"};
        return study_contact(read_scene(file_of("cycloid"), with(drive, resolution(slices, 20, "tilted"))))
            .cases.front();
    };
    ContactCase const fine = drafted(65);
    for (int const slices : {3, 9, 17}) {
        ContactCase const coarse = drafted(slices);
        double const further = fine.least_tip_radius - coarse.least_tip_radius;
        INFO(slices << " slices: " << coarse.least_tip_radius << " +- " << coarse.least_tip_radius_error << ", finer "
                    << fine.least_tip_radius << " +- " << fine.least_tip_radius_error);
        CHECK(std::abs(further) <= coarse.least_tip_radius_error + fine.least_tip_radius_error);
        CHECK(coarse.least_tip_radius_error < 0.02 * um);
        CHECK(std::abs(fine.backlash_of_least_side_clearance - coarse.backlash_of_least_side_clearance) <=
              coarse.backlash_of_least_side_clearance_error + fine.backlash_of_least_side_clearance_error);
    }
}

TEST_CASE("contact law: a flank between its points is the flank that many more points are on", "[law][contact]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    for (ToothSurface const surface : {ToothSurface::tilted, ToothSurface::per_slice}) {
        conjugate::MatchedOutline const coarse = drive.surface(surface),
                                        fine = drive.surface(surface, TiltKind::radial, 0, 1e-9, 200);
        for (double const offset : {0.0, 0.004}) {
            contact::FlankGrid const grid = contact::moved_into_material(drive.flanks(coarse, 40), offset),
                                     exact = contact::moved_into_material(drive.flanks(fine, 40), offset);
            for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
                for (std::size_t k = 0; k < grid.slices(); ++k) {
                    auto const& line = grid.line[static_cast<std::size_t>(flank)][k];
                    std::vector<Vec2> wanted = exact.line[static_cast<std::size_t>(flank)][k];
                    if (flank == GapMap::right)
                        std::reverse(wanted.begin(), wanted.end());
                    double worst = 0;
                    for (std::size_t i = 0; i + 1 < line.size(); i += 5)
                        for (double const t : {0.0, 0.3, 0.5})
                            worst = std::max(worst, distance_to_polyline(
                                                        wanted, grid.between(flank, k, static_cast<double>(i) + t)));
                    INFO(to_string(surface)
                         << " offset " << offset << " flank " << flank << " slice " << k << ": " << worst);
                    // of a chord error of 1e-6 mm little is left
                    CHECK(worst < 5e-9);
                    for (std::size_t const j : {std::size_t{0}, grid.points() / 2, grid.points() - 1})
                        CHECK((grid.between(flank, k, grid.place(flank, j)) -
                               grid.point[static_cast<std::size_t>(flank)][k][j])
                                  .norm() < 1e-15);
                }
        }
    }
}

TEST_CASE("contact law: clearance as given does not jump where a tilt of either kind begins", "[law][contact]")
{
    auto const as_made = [](std::string const& kind, std::string const& tilt) {
        return only_case(
                   with(with(coned(), resolution(3, 60, "tilted")), {"tilt.kind=" + kind, "tilt.angle_deg=" + tilt}))
            .closest_flank()
            .clearance;
    };
    double const untilted = as_made("radial", "0");
    CHECK(untilted == Approx(-79.55 * um).margin(0.01 * um));
    CHECK(as_made("draft", "0") == untilted);
    // 3.5 mm times 1e-6 deg is 0.06 nm
    for (std::string const kind : {"radial", "draft"}) {
        CHECK(as_made(kind, "1e-6") == Approx(untilted).margin(1e-3 * um));
        CHECK(as_made(kind, "-1e-6") == Approx(untilted).margin(1e-3 * um));
    }
}

TEST_CASE("contact law: the written outline is that of the part whose contact is told", "[law][contact]")
{
    // one plane: what solve makes with the same side clearance
    Keys const offset{"circular_spline.backlash_offset=0.01"};
    ContactStudy const plane = study_contact(builtin_scene(with(offset, {"contact.flank_points=40"})));
    CHECK(plane.solution.circular_spline.outline == solve(builtin_scene(offset)).circular_spline.outline);
    // slices: all flanks are the side clearance into the material of what they are without
    for (ToothSurface const surface : {ToothSurface::tilted, ToothSurface::per_slice}) {
        // a tilted outline is given what it takes, the slices' own need nothing
        Keys const given = surface == ToothSurface::tilted ? Keys{} : Keys{"circular_spline.backlash_offset=0.004"};
        ContactStudy const study = study_contact(
            builtin_scene(with(with(coned("mapped"), given), resolution(3, 40, std::string(to_string(surface))))));
        ContactCase const& one = study.cases.front();
        CircularSplineOutline const& part = study.solution.circular_spline;
        INFO(to_string(surface) << ": side clearance " << one.backlash_offset / um << " um");
        REQUIRE(one.backlash_offset > um);
        CHECK(study.solution.notes.empty());
        ConedDrive drive(builtin_scene(coned("mapped")), 3);
        conjugate::MatchedOutline const bare =
            drive.maker->outline({surface, TiltKind::radial, 0}, one.least_tip_radius, {1e-6, 200});
        for (std::size_t k = 0; k < 3; ++k) {
            auto const first = part.outline[k].begin() + part.landmarks[3],
                       last = part.outline[k].begin() + part.landmarks[4];
            double least = 1, most = 0;
            // beside both ends the flank goes on where the bare one has ended
            for (auto p = first + (last - first) / 10; p < last - (last - first) / 4; ++p) {
                double const distance = distance_to_polyline(bare.points[k], *p);
                least = std::min(least, distance);
                most = std::max(most, distance);
            }
            CHECK(most == Approx(one.backlash_offset).margin(2e-6));
            CHECK(least > 0.9 * one.backlash_offset);
        }
    }
}

TEST_CASE("contact law: a side clearance that solve looks for by itself is the least one of contact", "[law][contact]")
{
    Keys const drive = with(with(coned(), resolution(3, 60, "tilted")), {"circular_spline.backlash_offset=\"auto\""});
    Solution const solved = solve(builtin_scene(drive));
    ContactCase const told = only_case(drive);
    CHECK(told.least_side_clearance > 60 * um);
    CHECK(told.backlash_offset == told.least_side_clearance);
    CHECK(solved.geometry.circular_spline_inner_radius == Approx(told.least_tip_radius).margin(1e-6));

    // how well it was found is part of what is stated of a drive that has it
    Keys const tilted = with(drive, {"tilt.kind=radial", "tilt.angle_deg=0.2"});
    Solution const coarse = solve(builtin_scene(tilted)),
                   fine = solve(builtin_scene(with(tilted, {"solver.tolerance=1e-9"})));
    double const radius = coarse.geometry.circular_spline_inner_radius;
    REQUIRE(fine.geometry.circular_spline_inner_radius == Approx(radius).margin(1e-6));
    double const clearance = std::abs(coarse.check->smallest_clearance - fine.check->smallest_clearance);
    double const land = 2 * radius * std::abs(coarse.geometry.land_half_angle - fine.geometry.land_half_angle);
    INFO("clearance off by " << clearance << " +- " << coarse.error.clearance << ", land by " << land << " +- "
                             << coarse.error.land);
    CHECK(clearance > 1e-10);
    CHECK(clearance <= coarse.error.clearance + fine.error.clearance);
    CHECK(land <= coarse.error.land + fine.error.land);
    CHECK(coarse.error.clearance < coarse.scene.solver.tolerance);
}

}  // namespace hdconj::test::contact_error_cases
