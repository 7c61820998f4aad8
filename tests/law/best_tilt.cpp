// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The search for the best tilt where not every tilt makes a surface.
#include <numbers>

#include "hdconj/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::best_tilt_cases {

namespace {

constexpr double degree = std::numbers::pi / 180;

ContactStudy best_draft(double from, double to)
{
    ContactOptions options;
    options.surfaces = {ToothSurface::tilted};
    options.kinds = {TiltKind::draft};
    options.tilts = {from * degree, to * degree};
    options.best = true;
    options.best_from = from * degree;
    options.best_to = to * degree;
    return study_contact(builtin_scene(with(coned("none"), {"slices.count=3", "contact.flank_points=20"})), options);
}

}  // namespace

TEST_CASE("best tilt: ends that make no surface are left out and named", "[law][contact]")
{
    ContactStudy const study = best_draft(-0.1, 2.4);
    REQUIRE(study.cases.size() == 1);
    CHECK(study.cases.front().tilt == Approx(-0.1 * degree));
    REQUIRE(study.best.size() == 2);
    for (BestTilt const& best : study.best) {
        CHECK(best.refused > 0);
        CHECK(!best.refusal.empty());
        CHECK(best.possible_from == Approx(-0.1 * degree));
        CHECK(best.possible_to < 2.4 * degree);
        CHECK(best.tilt >= best.possible_from);
        CHECK(best.tilt <= best.possible_to);
    }
    REQUIRE(!study.solution.notes.empty());
    CHECK_THAT(study.solution.notes.front(), ContainsSubstring("no result for tilt 2.4 deg"));
}

TEST_CASE("best tilt: the ends of the range that it calls possible have rows of their own", "[law][contact]")
{
    // beyond this tip circle the outline has a corner, which a draft moves out of the land
    std::vector<std::string> const keys =
        with(coned("none"), {"slices.count=3", "contact.flank_points=20", "circular_spline.inner_radius=25.05"});
    ContactOptions options;
    options.errors = false;
    options.surfaces = {ToothSurface::tilted};
    options.kinds = {TiltKind::draft};
    options.tilts = {0};
    options.best = true;
    options.best_from = 0.8 * degree;
    options.best_to = 2.2 * degree;
    std::vector<BestTilt> const found = study_contact(builtin_scene(keys), options).best;
    REQUIRE(found.size() == 2);
    options.best = false;
    for (BestTilt const& best : found) {
        CHECK(best.refused > 0);
        CHECK(best.possible_from == Approx(0.8 * degree));
        CHECK(best.possible_to > 1.5 * degree);
        for (double const tilt : {best.possible_from, best.possible_to}) {
            options.tilts = {tilt};
            CHECK(study_contact(builtin_scene(keys), options).cases.size() == 1);
        }
    }
}

TEST_CASE("best tilt: it fails only where no tilt makes a surface", "[law][contact]")
{
    CHECK_THROWS_AS(best_draft(2.6, 2.8), NumericalError);
    // listed without a search, every tilt is asked for by itself
    ContactOptions options;
    options.surfaces = {ToothSurface::tilted};
    options.kinds = {TiltKind::draft};
    options.tilts = {2.6 * degree};
    CHECK_THROWS_AS(
        study_contact(builtin_scene(with(coned("none"), {"slices.count=3", "contact.flank_points=20"})), options),
        NumericalError);
}

}  // namespace hdconj::test::best_tilt_cases
