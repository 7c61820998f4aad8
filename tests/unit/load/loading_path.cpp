// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Torques of a curve, and curves that are stopped.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "load/study/loaded_scene.hpp"
#include "support/catch.hpp"

namespace hdconj::test::loading_path_cases {

TEST_CASE("no two torques of a curve differ by rounding alone, and those of the catalogue are among them", "[load]")
{
    Scene const scene = builtin_scene({"load.torque=20"});
    LoadOptions options;
    for (int tenths = 1; tenths <= 400; ++tenths)
        for (int const points : {0, 1, 5, 8, 25, 40, 80, 200})
            for (double const sign : {1.0, -1.0}) {
                CAPTURE(tenths, points, sign);
                double const torque = sign * tenths * 0.1 * newton_metre;
                options.torque = torque;
                options.points = points;
                std::vector<double> const given = load::loading_path(scene, options).forth.given;
                REQUIRE(given.front() == 0);
                REQUIRE(given.back() == torque);
                for (std::size_t i = 1; i < given.size(); ++i)
                    REQUIRE(std::abs(given[i]) - std::abs(given[i - 1]) > 1e-6 * std::abs(torque));
                auto const [first, second, lost_motion] = load::catalogue_torques(scene, torque);
                for (double const named : {first, second, lost_motion})
                    REQUIRE(std::ranges::any_of(given,
                                                [&](double each) { return load::is_same_torque(each, sign * named); }));
            }
}

TEST_CASE("a curve that is stopped anywhere says so, and gives no error of nothing", "[load]")
{
    // Pitch errors make both senses of torque two problems. Asked for in the order: case, torques forth, torques back.
    Scene const scene =
        builtin_scene({"slices.count=3", "contact.flank_points=60", "circular_spline.backlash_offset=0.09",
                       "bearing.circles=3", "load.torque=20", "errors.circular_spline.eccentricity=0.001"});
    LoadOptions options;
    options.points = 1;
    int asked = 0;
    options.stop = [&asked] {
        ++asked;
        return false;
    };
    LoadStudy const whole = study_load(scene, options);
    REQUIRE(whole.missing.empty());
    REQUIRE(whole.cases.front().curve.front().torque < 0);
    for (int const allowed : {asked - 1, asked / 2 + 1, asked / 2, asked / 2 - 1}) {
        CAPTURE(asked, allowed);
        int left = allowed;
        options.stop = [&left] { return --left < 0; };
        LoadStudy const stopped = study_load(scene, options);
        REQUIRE_FALSE(stopped.missing.empty());
        CHECK_THAT(stopped.missing.front(), ContainsSubstring("stopped"));
        LoadCase const& found = stopped.cases.front();
        // the opposites of torques that are missing are not asked for
        if (std::ranges::all_of(found.unsettled, [](auto const& each) { return each.torque < 0; }))
            CHECK(found.curve.size() + found.unsettled.size() == whole.cases.front().curve.size());
        if (found.estimated && found.stages.first != 0)
            CHECK(found.stages.first_error > 0);
    }
}

}  // namespace hdconj::test::loading_path_cases
