// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One hard case is one test, named by what is hard, why, and the outcome it must have: `ctest -L hard` prints the
/// table.
#pragma once

#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"

#define HARD_ROW(name, cause, outcome) TEST_CASE(name " | " cause " | " outcome, "[hard]")

namespace hdconj::test {

using Overrides = std::vector<std::string>;

/// One line of the table in docs/explanation/stability.md.
inline void say(std::string const& measured)
{
    std::cout << "| " << std::string(Catch::getResultCapture().getCurrentTestName()) << " | " << measured << " |\n";
}

inline std::string three_digits(double value)
{
    std::ostringstream text;
    text.precision(3);
    text << value;
    return text.str();
}

inline Overrides operator+(Overrides a, Overrides const& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Everything that is written is a number.
inline bool all_finite(Solution const& s)
{
    auto const fine = [](std::vector<Vec2> const& points) {
        for (Vec2 const& p : points)
            if (!p.allFinite())
                return false;
        return true;
    };
    bool good = fine(s.flexspline_outline) && fine(s.neutral_curve);
    for (auto const& slice : s.circular_spline.outline)
        good = good && fine(slice);
    for (BranchRecord const& branch : s.branches) {
        good = good && fine(branch.point);
        for (std::size_t i = 0; i < branch.u.size(); ++i)
            good = good && std::isfinite(branch.u[i]) && std::isfinite(branch.phi[i]) && std::isfinite(branch.t[i]);
    }
    return good;
}

inline bool same_bits(Solution const& a, Solution const& b)
{
    if (a.circular_spline.outline != b.circular_spline.outline ||
        a.circular_spline.landmarks != b.circular_spline.landmarks || a.branches.size() != b.branches.size() ||
        a.flexspline_outline != b.flexspline_outline)
        return false;
    for (std::size_t i = 0; i < a.branches.size(); ++i)
        if (a.branches[i].u != b.branches[i].u || a.branches[i].t != b.branches[i].t ||
            a.branches[i].point != b.branches[i].point)
            return false;
    return true;
}

/// A right answer: finite, touched within @p roundings of the radius and never entered, chords as asked, and the same
/// bits on 1, 2 and 4 threads.
inline Solution right_answer_of(Scene scene, std::string const& note)
{
    scene.solver.threads = 1;
    Solution const solution = solve(scene);
    CHECK(all_finite(solution));
    double const offset = scene.circular_spline.backlash_offset;
    double const radius = solution.geometry.circular_spline_inner_radius;
    REQUIRE(solution.check);
    // rounding of coordinates, and what the result itself states
    constexpr double roundings = 64 * 1.2e-16;
    CHECK(solution.check->smallest_clearance >= offset - roundings * radius - 1e-13 - solution.error.point);
    CHECK(solution.check->smallest_clearance <= offset + scene.solver.tolerance);
    CHECK(solution.error.chord <= scene.solver.tolerance);
    for (int threads : {2, 4}) {
        scene.solver.threads = threads;
        CHECK(same_bits(solution, solve(scene)));
    }
    say(std::to_string(solution.circular_spline.outline.front().size()) + " points, clearance " +
        three_digits(solution.check->smallest_clearance) + " mm, point error " + three_digits(solution.error.point) +
        " mm" + (note.empty() ? "" : ", " + note));
    return solution;
}

inline Solution right_answer(Overrides const& overrides, std::string const& note = "")
{
    return right_answer_of(builtin_scene(overrides), note);
}

/// Refused with a message that holds @p part.
inline void refused_job(std::function<void()> const& job, std::string const& part)
{
    try {
        job();
    } catch (std::runtime_error const& error) {
        INFO(error.what());
        CHECK_THAT(error.what(), ContainsSubstring(part));
        std::string text = error.what();
        for (char& c : text)
            if (c == '\n')
                c = ' ';
        say(text.substr(0, 160));
        return;
    }
    FAIL("accepted, but should be refused for: " << part);
}

inline void refused(Overrides const& overrides, std::string const& part)
{
    refused_job([&] { (void)solve(builtin_scene(overrides)); }, part);
}

}  // namespace hdconj::test
