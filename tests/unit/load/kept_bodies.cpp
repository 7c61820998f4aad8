// SPDX-License-Identifier: GPL-3.0-or-later
// Loads of drives that share cup and bearing.
#include "hdconj/elastic_cup.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test::kept_bodies_cases {

namespace {

LoadedState under_torque(char const* clearance)
{
    LoadOptions options;
    options.torque = 20 * newton_metre;
    options.curve = options.errors = false;
    Scene const scene = builtin_scene({"slices.count=3", "contact.flank_points=40", "bearing.circles=5", clearance});
    LoadCase const found = study_load(scene, options, {}, {}, {}).cases.at(0);
    return found.curve.at(found.rated);
}

}  // namespace

TEST_CASE("drives with the same cup and bearing share them, and no bit changes", "[load]")
{
    LoadedState const alone = under_torque("circular_spline.backlash_offset=0.02");
    keep_elastic_bodies(3);
    (void)under_torque("circular_spline.backlash_offset=0.01");
    ElasticBodyCount const before = elastic_body_count();
    LoadedState const shared = under_torque("circular_spline.backlash_offset=0.02");
    ElasticBodyCount const after = elastic_body_count();
    keep_elastic_bodies(0);
    CHECK(after.computed == before.computed);
    CHECK(after.reused > before.reused);
    CHECK(shared.twist == alone.twist);
    CHECK(shared.stiffness == alone.stiffness);
    CHECK(shared.largest_stress == alone.largest_stress);
}

}  // namespace hdconj::test::kept_bodies_cases
