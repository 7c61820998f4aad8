// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Errors of a loaded drive whose side clearance is found: a finer grid finds another.
#include <cmath>

#include "hdconj/contact.hpp"
#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::ring_error_cases {
namespace {

/// A drive with ruled teeth that clear in 9 slices and not between them.
Scene ruled_drive(int slices)
{
    DesignWishes wishes;
    wishes.diameter = 69.9;
    wishes.ratio = 40;
    wishes.length_ratio = 0.44;
    return parse_scene(scene_text(design_drive(wishes)), "designed", {}, {"slices.count=" + std::to_string(slices)});
}

LoadOptions at(double torque)
{
    LoadOptions options;
    options.torque = torque * newton_metre;
    options.curve = false;
    options.surfaces = {ToothSurface::ruled};
    return options;
}

}  // namespace

TEST_CASE("at small torques too, errors hold the side clearance that more slices ask for", "[load][errors]")
{
    for (double const torque : {1.4, 7.0}) {
        CAPTURE(torque);
        LoadCase const coarse = study_load(ruled_drive(9), at(torque)).cases.front(),
                       fine = study_load(ruled_drive(33), at(torque)).cases.front();
        REQUIRE(coarse.estimated);
        // the finer grid asks for more, and the teeth no longer press on both flanks
        CHECK(fine.backlash_offset > coarse.backlash_offset + 2e-4);
        CHECK(coarse.backlash < 0);
        CHECK(fine.backlash > 0);
        CHECK(std::abs(fine.backlash_offset - coarse.backlash_offset) <= coarse.backlash_offset_error);
        CHECK(fine.backlash_offset_error < 0.5 * coarse.backlash_offset_error);
        CHECK(std::abs(fine.backlash - coarse.backlash) <= coarse.backlash_error);
        LoadedState const &here = coarse.curve[coarse.rated], &there = fine.curve[fine.rated];
        CHECK(std::abs(there.twist - here.twist) <= coarse.error.twist);
        CHECK(std::abs(there.twist - here.twist) > 0.1 * coarse.error.twist);
        CHECK(std::abs(there.teeth - here.teeth) <= coarse.error.teeth);
        CHECK(std::abs(there.largest_force - here.largest_force) <= coarse.error.largest_force);
        CHECK(std::abs(there.contact_area - here.contact_area) <= coarse.error.contact_area);
    }
}

TEST_CASE("the error of a side clearance under torque is that of the contact study", "[load][errors]")
{
    LoadOptions options = at(7);
    Scene const scene = ruled_drive(9);
    LoadCase const loaded = study_load(scene, options).cases.front();
    ContactOptions contact;
    contact.surfaces = options.surfaces;
    ContactCase const unloaded = study_contact(loaded_scene(scene, options), contact).cases.front();
    CHECK(loaded.backlash_offset == Approx(unloaded.least_side_clearance).margin(1e-9));
    CHECK(loaded.backlash_offset_error == Approx(unloaded.least_side_clearance_error).epsilon(0.01));
    options.errors = false;
    CHECK(study_load(scene, options).cases.front().backlash_offset_error == 0);
}

TEST_CASE("a side clearance that is given, and is enough, has no error", "[load][errors]")
{
    Scene scene = ruled_drive(9);
    scene.circular_spline.backlash_offset = 0.01;
    LoadCase const loaded = study_load(scene, at(7)).cases.front();
    CHECK(loaded.backlash_offset == 0.01);
    CHECK(loaded.backlash_offset_error == 0);
}

}  // namespace hdconj::test::ring_error_cases
