// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Every scene of data/scenes is a drive: it solves, and no tooth enters its outline over a full turn.
#include <algorithm>
#include <filesystem>
#include <vector>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wanted_curve.hpp"
#include "support/catch.hpp"

namespace hdconj::test::scenes_cases {

TEST_CASE("every scene of data/scenes solves and passes its own check over a full turn", "[hard][scenes]")
{
    std::vector<std::filesystem::path> scenes;
    for (auto const& entry : std::filesystem::directory_iterator(HDCONJ_SOURCE_DIR "/data/scenes"))
        if (entry.path().extension() == ".toml")
            scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    CHECK(scenes.size() >= 11);
    for (auto const& scene : scenes) {
        INFO(scene.filename().string());
        Scene const read = read_scene(scene);
        if (read.wave_generator.shape.family == "wanted") {
            CHECK(find_neutral_curve(read).residual < read.solver.tolerance);
            continue;
        }
        Solution const solution = solve(read);
        for (Vec2 const& p : solution.circular_spline.outline.front())
            REQUIRE(p.allFinite());
        CHECK(solution.scene.drive.name == scene.stem().string());
        REQUIRE(solution.check.has_value());
        CHECK(std::abs(solution.check->smallest_clearance - solution.scene.circular_spline.backlash_offset) < 1e-10);
        CHECK(solution.error.chord <= solution.scene.solver.tolerance);
    }
}

}  // namespace hdconj::test::scenes_cases
