// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a contact share and the clearance it is computed with state of their own error. The whole ladder, with random designs: docs/tables/contact_error.py.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "hdconj/pipeline/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/polyline.hpp"

using namespace hdconj;
using namespace hdconj::test;

namespace {

using Keys = std::vector<std::string>;

constexpr double um = 1e-3;

Keys resolution(int slices, int points, std::string const& surface)
{
    return {"slices.count=" + std::to_string(slices), "contact.flank_points=" + std::to_string(points), "slices.surface=" + surface};
}

ContactCase only_case(Keys const& keys)
{
    return contact(builtin_scene(keys)).cases.front();
}

}  // namespace

TEST_CASE("contact law: clearance and share do not depend on how many points the flank is looked at", "[law][contact]")
{
    // slices that stay in their planes, and sections that do not: it takes a clearance, which one place of the flank decides
    Keys const drive = with(coned("mapped"), {"solver.kinematics=first-order"});
    ContactCase const many = only_case(with(drive, resolution(3, 800, "per-slice")));
    REQUIRE(many.backlash_offset > 3 * um);
    for (int const points : {50, 73, 200})
    {
        ContactCase const few = only_case(with(drive, resolution(3, points, "per-slice")));
        INFO(points << " points: " << few.backlash_offset / um << " um, " << few.state.share << " +- " << few.state.share_error);
        // the pointed minimum lies between any of these; clearing_accuracy() of both
        CHECK(few.backlash_offset == Approx(many.backlash_offset).margin(2 * 0x1p-6 * 1e-6));
        CHECK(few.state.share == Approx(many.state.share).margin(few.state.share_error));
        CHECK(std::abs(few.state.share - many.state.share) < 1e-3 * many.state.share);
    }
}

TEST_CASE("contact law: the stated error of a share bounds its distance to that of many more planes", "[law][contact]")
{
    struct Row
    {
        std::string surface, shift;
        int fine;
    };
    for (Row const& row : {Row{"tilted", "none", 17}, Row{"ruled", "mapped", 17}, Row{"per-slice", "none", 9}})
    {
        ContactState const fine = only_case(with(coned(row.shift), resolution(row.fine, 100, row.surface))).state;
        for (int const slices : {2, 3})
        {
            ContactState const coarse = only_case(with(coned(row.shift), resolution(slices, 50, row.surface))).state;
            INFO(row.surface << ", " << slices << " slices: " << coarse.share << " +- " << coarse.share_error << ", finer " << fine.share << " +- " << fine.share_error);
            CHECK(std::abs(coarse.share - fine.share) <= coarse.share_error);
            CHECK(coarse.share_error > fine.share_error);
            CHECK(coarse.share_error < 4 * fine.share);
        }
    }
    // planes that are all alike leave nothing open across
    ContactState const one = only_case(with({"circular_spline.backlash_offset=0.005"}, resolution(1, 100, "tilted"))).state;
    ContactState const five = only_case(with({"circular_spline.backlash_offset=0.005"}, resolution(5, 100, "tilted"))).state;
    CHECK(five.share == Approx(one.share).epsilon(1e-12));
    CHECK(five.share_error == Approx(one.share_error).epsilon(1e-6));
    CHECK(one.share_error < 1e-3 * one.share);
}

TEST_CASE("contact law: a flank between its points is the flank that many more points are on", "[law][contact]")
{
    ConedDrive drive(builtin_scene(coned()), 3);
    for (std::string const surface : {"tilted", "per-slice"})
    {
        MatchedOutline const coarse = drive.surface(surface), fine = drive.surface(surface, "radial", 0, 1e-9, 200);
        for (double const offset : {0.0, 0.004})
        {
            FlankGrid const grid = moved_into_material(drive.flanks(coarse, 40), offset), exact = moved_into_material(drive.flanks(fine, 40), offset);
            for (int const flank : {static_cast<int>(GapMap::left), static_cast<int>(GapMap::right)})
                for (std::size_t k = 0; k < grid.slices(); ++k)
                {
                    auto const& line = grid.line[static_cast<std::size_t>(flank)][k];
                    std::vector<Vec2> wanted = exact.line[static_cast<std::size_t>(flank)][k];
                    if (flank == GapMap::right)
                        std::reverse(wanted.begin(), wanted.end());
                    double worst = 0;
                    for (std::size_t i = 0; i + 1 < line.size(); i += 5)
                        for (double const t : {0.0, 0.3, 0.5})
                            worst = std::max(worst, distance_to_polyline(wanted, grid.between(flank, k, static_cast<double>(i) + t)));
                    INFO(surface << " offset " << offset << " flank " << flank << " slice " << k << ": " << worst);
                    // of a chord error of 1e-6 mm little is left
                    CHECK(worst < 5e-9);
                    for (std::size_t const j : {std::size_t{0}, grid.points() / 2, grid.points() - 1})
                        CHECK((grid.between(flank, k, grid.place(flank, j)) - grid.point[static_cast<std::size_t>(flank)][k][j]).norm() < 1e-15);
                }
        }
    }
}

TEST_CASE("contact law: clearance as made does not jump where a tilt of either kind begins", "[law][contact]")
{
    auto const as_made = [](std::string const& kind, std::string const& tilt) {
        return only_case(with(with(coned(), resolution(3, 60, "tilted")), {"tilt.kind=" + kind, "tilt.angle_deg=" + tilt})).closest_flank().clearance;
    };
    double const untilted = as_made("radial", "0");
    CHECK(untilted == Approx(-79.55 * um).margin(0.01 * um));
    CHECK(as_made("draft", "0") == untilted);
    // 3.5 mm times 1e-6 deg is 0.06 nm
    for (std::string const kind : {"radial", "draft"})
    {
        CHECK(as_made(kind, "1e-6") == Approx(untilted).margin(1e-3 * um));
        CHECK(as_made(kind, "-1e-6") == Approx(untilted).margin(1e-3 * um));
    }
}

TEST_CASE("contact law: the written outline is that of the part whose contact is told", "[law][contact]")
{
    // one plane: what solve makes with the same side clearance
    Keys const offset{"circular_spline.backlash_offset=0.01"};
    ContactStudy const plane = contact(builtin_scene(with(offset, {"contact.flank_points=40"})));
    CHECK(plane.solution.circular_spline.outline == solve(builtin_scene(offset)).circular_spline.outline);
    CHECK(plane.side_clearance == 0.01);
    // slices: all flanks are the side clearance into the material of what they are without
    for (std::string const surface : {"tilted", "per-slice"})
    {
        // a tilted outline is given what it takes, the slices' own need nothing
        Keys const given = surface == "tilted" ? Keys{} : Keys{"circular_spline.backlash_offset=0.004"};
        ContactStudy const study = contact(builtin_scene(with(with(coned("mapped"), given), resolution(3, 40, surface))));
        ContactCase const& one = study.cases.front();
        CircularSplineOutline const& part = study.solution.circular_spline;
        INFO(surface << ": side clearance " << one.backlash_offset / um << " um");
        REQUIRE(one.backlash_offset > um);
        CHECK(study.side_clearance == one.backlash_offset);
        CHECK(study.solution.notes.empty());
        ConedDrive drive(builtin_scene(coned("mapped")), 3);
        MatchedOutline const bare = (*drive.maker)({surface, "radial", 0}, one.clearing_tip, 1e-6, 200);
        for (std::size_t k = 0; k < 3; ++k)
        {
            auto const first = part.outline[k].begin() + part.landmarks[3], last = part.outline[k].begin() + part.landmarks[4];
            double least = 1, most = 0;
            // beside both ends the flank goes on where the bare one has ended
            for (auto p = first + (last - first) / 10; p < last - (last - first) / 4; ++p)
            {
                double const distance = distance_to_polyline(bare.points[k], *p);
                least = std::min(least, distance);
                most = std::max(most, distance);
            }
            CHECK(most == Approx(one.backlash_offset).margin(2e-6));
            CHECK(least > 0.9 * one.backlash_offset);
        }
    }
    CHECK(contact(builtin_scene({"contact.flank_points=40"})).side_clearance == 0);
}
