// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far a ruled surface deviates from the conjugate outlines of its planes.
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hdconj/contact.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"

namespace hdconj::test::ruled_deviation_cases {

TEST_CASE("contact law: how far a ruled surface deviates does not depend on how many points the flank is looked at",
          "[law][contact]")
{
    std::mt19937 random(5);
    auto const between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    ContactOptions options;
    options.errors = false;
    for (int i = 0; i < 3; ++i) {
        std::vector<std::string> const drive = with(
            coned("none", between(9, 14)), {"wave_generator.radial_deformation=" + std::to_string(between(0.235, 0.26)),
                                            "flexspline.profile.convex_radius=" + std::to_string(between(0.25, 0.3)),
                                            "slices.count=3", "slices.surface=ruled"});
        auto const deviation = [&](char const* points) {
            Scene const scene = builtin_scene(with(drive, {std::string("contact.flank_points=") + points}));
            return study_contact(scene, options).cases.front().ruled_deviation;
        };
        double const few = deviation("12"), many = deviation("600");
        INFO(drive[1] << ", " << drive[4] << ", " << drive[5] << ": " << few << " mm, " << many << " mm");
        // both follow the flanks and the outlines to the chord error
        CHECK(std::abs(few - many) < 2 * builtin_scene(drive).solver.tolerance);
        CHECK(many > 0.01);
    }
}

}  // namespace hdconj::test::ruled_deviation_cases
