// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The reference of the contact area: lengths in exact planes against more of them, against cells, and against what can
/// be told in closed form.
#include "contact/study/contact_by_planes.hpp"

#include <cmath>

#include "hdconj/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::contact_by_planes_cases {

namespace {

Scene per_slice(std::string const& shift, int slices, int points)
{
    return builtin_scene(
        with(coned(shift), {"slices.surface=per-slice", "slices.count=" + std::to_string(slices),
                            "contact.flank_points=" + std::to_string(points), "contact.contact_gap=0.001"}));
}

}  // namespace

TEST_CASE("area by planes: its stated error bounds its distance to that of more planes and stations", "[law][contact]")
{
    contact::AreaByPlanes const coarse = contact::contact_by_planes(per_slice("none", 1, 20), 33),
                                fine = contact::contact_by_planes(per_slice("none", 1, 40), 129);
    INFO(coarse.area() << " +- " << coarse.error() << ", finer " << fine.area() << " +- " << fine.error());
    REQUIRE(coarse.sums.size() == 5);
    REQUIRE(fine.sums.back().planes == 129);
    CHECK(std::abs(coarse.area() - fine.area()) <= coarse.error());
    CHECK(fine.error() < coarse.error() / 2);
    CHECK(fine.error() < 0.005 * fine.area());
    // nested: the planes of one are among those of the other; stations are not, and lean is told from planes further
    // off
    CHECK(coarse.area() == Approx(fine.sums[coarse.sums.size() - 1].area).epsilon(1e-4));
}

TEST_CASE("area by planes: cells between slices come to the same area within their stated error", "[law][contact]")
{
    contact::AreaByPlanes const reference = contact::contact_by_planes(per_slice("mapped", 1, 30), 257);
    for (int const slices : {2, 5}) {
        ContactState const state = study_contact(per_slice("mapped", slices, 40)).cases.front().state;
        double const error = std::abs(state.contact_area - reference.area());
        INFO(slices << " slices: " << state.contact_area << " against " << reference.area() << " +- "
                    << reference.error());
        CHECK(error <= state.contact_fraction_error * state.flank_area);
        // what the study calls a reference
        CHECK(reference.error() <= error / 100);
    }
}

TEST_CASE("area by planes: planes that are all alike have the area of one of them", "[law][contact]")
{
    Scene const scene = builtin_scene({"contact.flank_points=200", "contact.contact_gap=0.001"});
    contact::AreaByPlanes const found = contact::contact_by_planes(scene, 9);
    ContactState const state = study_contact(scene).cases.front().state;
    CHECK(found.across == Approx(0).margin(1e-12));
    CHECK(found.area() ==
          Approx(state.contact_area).margin(state.fraction_error_along * state.flank_area + found.along));
    CHECK_THROWS_AS(contact::contact_by_planes(builtin_scene({"circular_spline.backlash_offset=0.005"}), 9),
                    InputError);
}

}  // namespace hdconj::test::contact_by_planes_cases
