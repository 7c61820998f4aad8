// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law for every wave generator family: the oracle has its own neutral curves, arc lengths and teeth.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/check_touch.hpp"
#include "support/oracle/run.hpp"
#include "support/random_wave_generators.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::wave_generators_cases {

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;

namespace {

void touch_law_holds(std::string const& family, std::uint64_t seed)
{
    hdconj::test::TemporaryFolder const folder;
    designs::WaveGeneratorDesigns draw(family, seed);
    std::size_t const most = full_run() ? static_cast<std::size_t>(-1) : 16;
    int const wanted = full_run() ? 100 : 40;
    int refused = 0;
    std::size_t points = 0;
    double worst = 0;
    for (int i = 0; i < wanted; ++i) {
        Scene const scene = draw.next(folder.path());
        INFO(designs::toml_of(scene));
        try {
            Solution const solution =
                hdconj::solve(hdconj::parse_scene(designs::toml_of(scene), "generated scene", folder.path()));
            TouchScan scan(solution.scene, 1200);
            auto const report = touch_law(solution, scan, most, static_cast<std::uint64_t>(i));
            check_touched(report);
            worst = std::max(worst, report.worst());
            points += report.entered.points;
        } catch (std::runtime_error const& error) {
            ++refused;
            std::cout << family << ", refused: " << error.what() << "\n" << designs::toml_of(scene) << "\n";
        }
    }
    std::cout << "touch law, " << family << ": " << wanted - refused << " designs, " << refused << " refused, "
              << points << " points, worst " << worst << " mm\n";
    CHECK(refused == 0);
}

}  // namespace

TEST_CASE("touch law: ellipse", "[touch][wavegen]")
{
    touch_law_holds("ellipse", 11);
}

TEST_CASE("touch law: rollers", "[touch][wavegen]")
{
    touch_law_holds("four-roller", 12);
}

TEST_CASE("touch law: discs", "[touch][wavegen]")
{
    touch_law_holds("two-disc", 13);
}

TEST_CASE("touch law: ring on a cosine cam", "[touch][wavegen]")
{
    touch_law_holds("ring-on-cosine-cam", 14);
}

TEST_CASE("touch law: cam from a table", "[touch][wavegen]")
{
    touch_law_holds("table", 15);
}

}  // namespace hdconj::test::wave_generators_cases
