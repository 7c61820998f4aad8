// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law: each point of the circular spline's flanks is touched by a tooth at some position
/// and entered at none. Found by brute force from the tooth and the motion alone.
#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/check_touch.hpp"
#include "support/oracle/run.hpp"

namespace hdconj::test::touch_cases {

using namespace oracle;
using hdconj::Kinematics;
using hdconj::Scene;
using hdconj::Solution;

namespace {

constexpr std::size_t all_points = static_cast<std::size_t>(-1);

/// The first line of a reason, numbers blanked, so that equal reasons are counted together.
std::string kind_of(std::string const& reason)
{
    std::string kind;
    for (char const c : reason.substr(0, reason.find('\n'))) {
        bool const numeric = (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
        if (!numeric)
            kind += c;
        else if (kind.empty() || kind.back() != '#')
            kind += '#';
    }
    return kind.substr(0, 160);
}

}  // namespace

TEST_CASE("touch law: type-50 and Liu's tooth, every point", "[touch]")
{
    for (Scene const& scene : {type_50(), type_50(Kinematics::first_order), type_50(Kinematics::material), liu_2025(),
                               liu_2025(Kinematics::first_order), liu_2025(Kinematics::material)}) {
        Solution const solution = hdconj::solve(scene);
        TouchScan scan(solution.scene);
        auto const report = touch_law(solution, scan, all_points);
        INFO(scene.drive.name << ", " << to_string(scene.solver.kinematics));
        CHECK(report.touched.points > 100);
        check_touched(report);
    }
}

TEST_CASE("touch law: with side clearance", "[touch]")
{
    for (double const clearance : {1e-12, 1e-4, 0.003, 0.01}) {
        Scene scene = type_50();
        scene.circular_spline.backlash_offset = clearance;
        Solution const solution = solved(scene);
        TouchScan scan(solution.scene);
        auto const report = touch_law(solution, scan, all_points);
        INFO("clearance " << clearance);
        CHECK(report.touched.points > 100);
        check_touched(report);
    }
}

TEST_CASE("touch law: it notices five picometres", "[touch]")
{
    // Negative control: the law must break for a point moved by 5e-9 mm.
    Solution const solution = hdconj::solve(type_50());
    TouchScan scan(solution.scene);
    std::array<Point<double>, 4> const shifts{{{5e-9, 0}, {-5e-9, 0}, {0, 5e-9}, {0, -5e-9}}};
    std::size_t controls = 0;
    for (auto const& piece : solution.circular_spline.pieces) {
        if (piece.kind != "flank" || piece.last < piece.first + 2)
            continue;
        std::size_t const index = (piece.first + piece.last) / 2;
        auto const p = point_of(solution.circular_spline.outline[0][index]);
        double most = 0;
        Point<double> worst;
        for (auto const& shift : shifts)
            if (double const now = std::abs(scan.nearest(p + shift).distance); now > most) {
                most = now;
                worst = shift;
            }
        CHECK(most > 3 * touch_limit);
        CHECK(most < 6 * touch_limit);
        ++controls;
        if (controls > 1)
            continue;

        // And the whole law on a solution with this one point spoiled.
        Solution spoiled = solution;
        spoiled.circular_spline.outline[0][index] += hdconj::Vec2(worst.x, worst.y);
        auto const report = touch_law(spoiled, scan, all_points);
        CHECK(report.touched.deviation > 3 * touch_limit);
        CHECK(report.touched.index == index);
    }
    CHECK(controls >= 2);
}

TEST_CASE("touch law: it notices another drive's profile", "[touch]")
{
    // Negative control on the physics: first-order outline, exact judge.
    Solution const solution = hdconj::solve(type_50(Kinematics::first_order));
    TouchScan scan(type_50());
    auto const report = touch_law(solution, scan, 200);
    CHECK(report.touched.deviation > 1e-3);
    CHECK(report.touched.deviation < 5e-3);
}

TEST_CASE("touch law: random designs", "[touch][random]")
{
    using Clock = std::chrono::steady_clock;
    std::size_t const most = full_run() ? all_points : 60;
    int const wanted = 200, limit_of_refusals = 1;
    designs::RandomDesigns draw(20120601);
    std::map<std::string, int> refusals, accepted_by;
    std::vector<std::string> broken;
    std::size_t points = 0;
    double worst = 0, solving = 0, judging = 0;
    int accepted = 0, refused = 0;
    while (accepted < wanted && refused <= limit_of_refusals) {
        Scene const scene = draw.next();
        auto const start = Clock::now();
        Solution solution;
        try {
            solution = solved(scene);
        } catch (hdconj::InputError const& error) {
            ++refused;
            ++refusals["refused: " + kind_of(error.what())];
            std::cout << "refused design:\n" << designs::toml_of(scene) << error.what() << "\n\n";
            continue;
        } catch (hdconj::NumericalError const& error) {
            ++refused;
            ++refusals["failed: " + kind_of(error.what())];
            std::cout << "failed design:\n" << designs::toml_of(scene) << error.what() << "\n\n";
            continue;
        }
        ++accepted;
        ++accepted_by[scene.flexspline.profile.family];
        ++accepted_by[std::to_string(scene.wave_generator.waves) + " waves"];
        if (scene.circular_spline.backlash_offset > 0)
            ++accepted_by["side clearance"];
        auto const middle = Clock::now();
        TouchScan scan(solution.scene);
        auto const report = touch_law(solution, scan, most, static_cast<std::uint64_t>(accepted));
        points += report.entered.points;
        worst = std::max(worst, report.worst());
        // Root clearance may take the whole flank away where only tip corners make it.
        bool const seen = report.touched.points >= 10 || scene.circular_spline.root_clearance > 0;
        if (!report.holds() || !seen) {
            std::ostringstream text;
            text << designs::toml_of(scene) << report;
            broken.push_back(text.str());
        }
        solving += std::chrono::duration<double>(middle - start).count();
        judging += std::chrono::duration<double>(Clock::now() - middle).count();
    }
    std::cout << "touch law, random designs: " << accepted << " accepted, " << refused << " refused, " << points
              << " points, worst " << worst << " mm; solving " << solving << " s, judging " << judging << " s\n";
    for (auto const& [what, count] : accepted_by)
        std::cout << "  " << what << ": " << count << "\n";
    for (auto const& [reason, count] : refusals)
        std::cout << "  " << count << " x " << reason << "\n";
    for (auto const& text : broken)
        std::cout << "law broken by:\n" << text << "\n\n";
    CHECK(broken.empty());
    CHECK(accepted >= wanted);
    CHECK(refused <= limit_of_refusals);
    CHECK(accepted_by["straight"] > 30);
    CHECK(accepted_by["1 waves"] > 5);
    CHECK(accepted_by["3 waves"] > 15);
    CHECK(accepted_by["side clearance"] > 20);
}

TEST_CASE("touch law: designs that were refused once", "[touch][random]")
{
    // Valid by the oracle (the middle of the land is nowhere near a tooth), refused by an early solver: numbers
    // in the sequence of seed 99.
    std::set<int> const numbers{21,   34,   93,   207,  263,  369,  424,  458,  599,  729,  739,  757,
                                905,  953,  968,  1032, 1105, 1122, 1129, 1197, 1242, 1268, 1284, 1303,
                                1436, 1437, 1498, 1515, 1538, 1594, 1652, 1668, 1675, 1706, 1763, 1807,
                                1872, 1951, 1958, 1961, 2035, 2170, 2212, 2241, 2340, 2353, 2594, 2881};
    designs::RandomDesigns draw(99);
    std::map<std::string, int> refusals;
    int solved_now = 0;
    for (int i = 0; i <= *numbers.rbegin(); ++i) {
        Scene const scene = draw.next();
        if (numbers.count(i) == 0)
            continue;
        try {
            Solution const solution = solved(scene);
            TouchScan scan(solution.scene);
            auto const report = touch_law(solution, scan, 60);
            INFO(designs::toml_of(scene));
            check_touched(report);
            ++solved_now;
        } catch (std::exception const& error) {
            ++refusals[kind_of(error.what())];
        }
    }
    std::cout << "designs refused once: " << solved_now << " of " << numbers.size() << " solved now\n";
    for (auto const& [reason, count] : refusals)
        std::cout << "  " << count << " x " << reason << "\n";
    CHECK(refusals.empty());
}

}  // namespace hdconj::test::touch_cases
