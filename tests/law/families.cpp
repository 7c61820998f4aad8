// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law for each tooth family: 16 random valid drives, or 100 with HDCONJ_FULL, judged by brute force on the
/// oracle's own tooth.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <sstream>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/family_designs.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/temporary_folder.hpp"

namespace hdconj::test::families_cases {

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;

namespace {

void check_family(std::string const& family, std::uint64_t seed, int limit_of_refusals)
{
    using Clock = std::chrono::steady_clock;
    std::size_t const most = full_run() ? static_cast<std::size_t>(-1) : 24;
    std::size_t const positions = full_run() ? 2400 : 1200;
    int const wanted = full_run() ? 100 : 16;
    hdconj::test::TemporaryFolder const folder;
    designs::FamilyDesigns draw(family, seed, folder.path());
    std::vector<std::string> broken;
    std::size_t points = 0;
    double worst = 0, solving = 0, judging = 0;
    int accepted = 0, refused = 0;
    while (accepted < wanted && refused <= limit_of_refusals) {
        Scene const scene = draw.next();
        std::string const text = designs::toml_of(scene);
        auto const start = Clock::now();
        Solution solution;
        try {
            solution = hdconj::solve(hdconj::parse_scene(text, "generated scene", scene.folder));
        } catch (std::runtime_error const& error) {
            ++refused;
            std::cout << "refused design:\n" << text << error.what() << "\n\n";
            continue;
        }
        ++accepted;
        auto const middle = Clock::now();
        TouchScan scan(solution.scene, positions);
        auto const report = touch_law(solution, scan, most, static_cast<std::uint64_t>(accepted));
        points += report.entered.points;
        worst = std::max(worst, report.worst());
        if (!report.holds() || report.touched.points < 10) {
            std::ostringstream found;
            found << text << report;
            broken.push_back(found.str());
        }
        solving += std::chrono::duration<double>(middle - start).count();
        judging += std::chrono::duration<double>(Clock::now() - middle).count();
    }
    std::cout << "touch law, " << family << ": " << accepted << " accepted, " << refused << " refused, " << draw.drawn
              << " drawn, " << points << " points, worst " << worst << " mm; solving " << solving << " s, judging "
              << judging << " s\n";
    for (auto const& text : broken)
        std::cout << "law broken by:\n" << text << "\n\n";
    CHECK(broken.empty());
    CHECK(accepted == wanted);
    CHECK(refused <= limit_of_refusals);
}

}  // namespace

TEST_CASE("touch law of the family straight", "[touch][family]")
{
    check_family("straight", 1, 0);
}

TEST_CASE("touch law of the family involute", "[touch][family]")
{
    check_family("involute", 2, 0);
}

TEST_CASE("touch law of the family cycloid", "[touch][family]")
{
    check_family("cycloid", 3, 0);
}

TEST_CASE("touch law of the family s-tooth", "[touch][family]")
{
    check_family("s-tooth", 4, 0);
}

TEST_CASE("touch law of the family arc-chain", "[touch][family]")
{
    check_family("arc-chain", 5, 0);
}

TEST_CASE("touch law of the family bezier", "[touch][family]")
{
    check_family("bezier", 6, 0);
}

TEST_CASE("touch law of the family b-spline", "[touch][family]")
{
    check_family("b-spline", 7, 0);
}

TEST_CASE("touch law of the family points", "[touch][family]")
{
    check_family("points", 8, 0);
}

TEST_CASE("the oracle's distance to a curved flank is a step along its normal", "[oracle][family]")
{
    hdconj::test::TemporaryFolder const folder;
    for (char const* family : {"involute", "cycloid", "s-tooth", "arc-chain", "bezier", "b-spline", "points"}) {
        designs::FamilyDesigns draw(family, 11, folder.path());
        for (int i = 0; i < 5; ++i) {
            Scene const scene = draw.next();
            Tooth<double> const tooth(scene);
            double const m = scene.drive.module;
            INFO(designs::toml_of(scene));
            for (std::size_t piece = 0; piece < tooth.pieces_of_whole(); ++piece)
                for (double const t : {0.1, 0.37, 0.5, 0.9})
                    for (double const step : {-1e-3, -1e-8, 1e-8, 1e-3}) {
                        auto const on = tooth.on_whole(piece, t);
                        double const wanted = step * m;
                        // a step into a sharply bent stretch may come nearer to another part of it, never further away
                        double const found = tooth.distance(on.point + wanted * on.normal);
                        if (std::abs(step) < 1e-5)
                            CHECK(std::abs(found - wanted) < 1e-14 * (1 + m * scene.drive.flexspline_teeth));
                        else
                            CHECK(std::abs(found) <= std::abs(wanted) + 1e-14 * m * scene.drive.flexspline_teeth);
                    }
        }
    }
}

}  // namespace hdconj::test::families_cases
