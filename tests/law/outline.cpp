// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Laws of the outline that need no reference: symmetry, scaling, closure, order, and that the stated
/// errors are not exceeded.
#include <algorithm>
#include <array>
#include <optional>

#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/oracle/chain.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/touch_law.hpp"

namespace hdconj::test::outline_cases {

using namespace oracle;
using hdconj::Kinematics;
using hdconj::Scene;
using hdconj::Solution;
using hdconj::Vec2;

namespace {

std::vector<Vec2> const& outline_of(Solution const& solution)
{
    return solution.circular_spline.outline.at(0);
}

std::vector<Point<double>> chain_of(Solution const& solution)
{
    std::vector<Point<double>> chain;
    for (auto const& p : outline_of(solution))
        chain.push_back(point_of(p));
    return chain;
}

/// The scenes that every law is asked on: known drives, then random ones.
std::vector<Scene> scenes(int random)
{
    std::vector<Scene> all{type_50(),
                           type_50(Kinematics::first_order),
                           liu_2025(),
                           liu_2025(Kinematics::first_order),
                           type_50(Kinematics::material),
                           liu_2025(Kinematics::material)};
    designs::RandomDesigns draw(50);
    for (int i = 0; i < random; ++i)
        all.push_back(as_read(draw.next()));
    return all;
}

/// Runs @p law on every scene that the solver accepts; the share of refusals is judged in touch.cpp, here
/// only that a law is not vacuous.
template <class Law>
void for_each_accepted(std::vector<Scene> const& all, Law const& law)
{
    std::size_t accepted = 0;
    for (Scene const& scene : all) {
        std::optional<Solution> solution;
        try {
            solution = hdconj::solve(scene);
        } catch (hdconj::InputError const&) {
            continue;
        } catch (hdconj::NumericalError const&) {
            continue;
        }
        ++accepted;
        INFO(designs::toml_of(scene));
        law(scene, *solution);
    }
    CHECK(10 * accepted >= 9 * all.size());
}

/// Largest distance between a point and the mirror image of its partner.
double asymmetry(std::vector<Vec2> const& outline)
{
    double worst = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Vec2 const& p = outline[i];
        Vec2 const& q = outline[outline.size() - 1 - i];
        worst = std::max(worst, std::hypot(p.x() + q.x(), p.y() - q.y()));
    }
    return worst;
}

}  // namespace

TEST_CASE("outline: symmetric for a symmetric tooth", "[outline]")
{
    for_each_accepted(scenes(20), [](Scene const&, Solution const& solution) {
        auto outline = outline_of(solution);
        REQUIRE(outline.size() > 10);
        CHECK(asymmetry(outline) <= 1e-12 * solution.geometry.circular_spline_inner_radius);
        // Negative control.
        outline[outline.size() / 3].x() += 1e-10 * solution.geometry.circular_spline_inner_radius;
        CHECK(asymmetry(outline) > 1e-12 * solution.geometry.circular_spline_inner_radius);
    });
}

TEST_CASE("outline: twice the drive, twice the outline", "[outline]")
{
    for_each_accepted(scenes(6), [](Scene const& scene, Solution const& one) {
        for (double const factor : {2.0, 0x1p-7, 0x1p10}) {
            INFO("times " << factor);
            Solution const other = solved(designs::scaled(scene, factor));
            auto const &a = outline_of(one), &b = outline_of(other);
            REQUIRE(a.size() == b.size());
            double worst = 0;
            for (std::size_t i = 0; i < a.size(); ++i)
                worst = std::max(worst, (factor * a[i] - b[i]).norm() / (factor * a[i].norm()));
            CHECK(worst <= 1e-13);
            CHECK(one.branches.size() == other.branches.size());
            CHECK(one.zones.size() == other.zones.size());
        }
    });
}

TEST_CASE("outline: from mid-land to mid-land, in order, on the tip circle", "[outline]")
{
    for_each_accepted(scenes(40), [](Scene const& scene, Solution const& solution) {
        auto const& outline = outline_of(solution);
        double const half_pitch = pi<double>() / scene.drive.circular_spline_teeth;
        double const tip = solution.geometry.circular_spline_inner_radius;
        CHECK(tip == Approx(designs::tip_circle(scene)).epsilon(1e-14));

        CHECK(std::atan2(outline.front().x(), outline.front().y()) == Approx(-half_pitch).epsilon(0).margin(1e-14));
        CHECK(std::atan2(outline.back().x(), outline.back().y()) == Approx(half_pitch).epsilon(0).margin(1e-14));
        CHECK(outline.front().norm() == Approx(tip).epsilon(1e-14));
        CHECK(outline.back().norm() == Approx(tip).epsilon(1e-14));

        double back = 0, below = 0, twice = 1e300;
        for (std::size_t i = 0; i < outline.size(); ++i) {
            REQUIRE(std::isfinite(outline[i].x()));
            REQUIRE(std::isfinite(outline[i].y()));
            below = std::max(below, tip - outline[i].norm());
            if (i == 0)
                continue;
            back = std::max(back, outline[i - 1].x() - outline[i].x());
            twice = std::min(twice, (outline[i] - outline[i - 1]).norm());
        }
        CHECK(back <= 0);
        CHECK(below <= 1e-13 * tip);
        CHECK(twice > 0);

        // Pieces follow one another without a gap and cover the outline.
        auto const& pieces = solution.circular_spline.pieces;
        REQUIRE(!pieces.empty());
        CHECK(pieces.front().kind == "land");
        CHECK(pieces.back().kind == "land");
        CHECK(pieces.front().first == 0);
        CHECK(pieces.back().last == outline.size() - 1);
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            CHECK(pieces[i].first <= pieces[i].last);
            if (i > 0)
                CHECK((pieces[i].first == pieces[i - 1].last || pieces[i].first == pieces[i - 1].last + 1));
            if (pieces[i].kind == "land")
                for (std::size_t k = pieces[i].first; k <= pieces[i].last; ++k)
                    CHECK(outline[k].norm() == Approx(tip).epsilon(1e-13));
        }
        for (int const landmark : solution.circular_spline.landmarks) {
            CHECK(landmark >= 0);
            CHECK(static_cast<std::size_t>(landmark) < outline.size());
        }
        CHECK(std::is_sorted(solution.circular_spline.landmarks.begin(), solution.circular_spline.landmarks.end()));
    });
}

TEST_CASE("outline: the polygon's sides are as near to the true curve as stated", "[outline]")
{
    // Asked of the oracle: the middle of a side is as far from the touching tooth as the side is from the curve.
    for (double const tolerance : {1e-4, 1e-6, 1e-7})
        for (Kinematics const kinematics : hdconj::all_kinematics) {
            Scene scene = type_50(kinematics);
            scene.solver.tolerance = tolerance;
            Solution const solution = solved(scene);
            CHECK(solution.error.largest() <= tolerance);
            TouchScan scan(solution.scene);
            auto const chain = chain_of(solution);
            double worst = 0, land = 0;
            std::size_t sides = 0;
            for (auto const& piece : solution.circular_spline.pieces)
                for (std::size_t i = piece.first; i < piece.last; ++i) {
                    auto const middle = 0.5 * (chain[i] + chain[i + 1]);
                    if (must_be_touched(piece.kind)) {
                        worst = std::max(worst, std::abs(scan.nearest(middle).distance));
                        ++sides;
                    } else if (piece.kind == "land")
                        land = std::max(land, solution.geometry.circular_spline_inner_radius - length(middle));
                }
            INFO("tolerance " << tolerance);
            CHECK(sides > 20);
            CHECK(worst <= solution.error.largest());
            CHECK(land <= solution.error.largest());
            // No side is needlessly short everywhere: the stated error is used.
            CHECK(std::max(worst, land) >= 0.01 * tolerance);
        }
}

TEST_CASE("outline: a finer tolerance moves nothing by more than the coarser one", "[outline]")
{
    for_each_accepted(scenes(6), [](Scene scene, Solution const&) {
        double const coarse = 1e-4 * scene.drive.module, fine = 1e-3 * coarse;
        scene.solver.tolerance = coarse;
        auto const rough = chain_of(solved(scene));
        scene.solver.tolerance = fine;
        auto const smooth = chain_of(solved(scene));
        CHECK(rough.size() < smooth.size());
        double of_rough = 0, of_smooth = 0;
        for (auto const& p : rough)
            of_rough = std::max(of_rough, distance_to_chain(p, smooth, false));
        for (auto const& p : smooth)
            of_smooth = std::max(of_smooth, distance_to_chain(p, rough, false));
        // The corners of the coarse polygon lie on the true curve.
        CHECK(of_rough <= fine + 1e-13 * length(rough.front()));
        CHECK(of_smooth <= coarse);
    });
}

TEST_CASE("outline: the number of threads changes no bit", "[outline]")
{
    for_each_accepted(scenes(6), [](Scene scene, Solution const&) {
        scene.solver.threads = 1;
        auto const one = outline_of(solved(scene));
        scene.solver.threads = 2;
        auto const two = outline_of(solved(scene));
        scene.solver.threads = 5;
        auto const five = outline_of(solved(scene));
        CHECK(one == two);
        CHECK(one == five);
    });
}

TEST_CASE("outline: the finished pair clears over a full turn", "[outline]")
{
    // The solver's own check against the oracle, and that it sees what the oracle sees.
    for_each_accepted(scenes(20), [](Scene const& scene, Solution const& solution) {
        REQUIRE(solution.check.has_value());
        TouchScan scan(solution.scene);
        double least = 1e300;
        for (auto const& p : outline_of(solution))
            least = std::min(least, scan.nearest(point_of(p)).distance);
        CHECK(solution.check->smallest_clearance == Approx(least).epsilon(0).margin(1e-9));
        CHECK(solution.check->smallest_clearance >= -scene.solver.tolerance);
        CHECK(solution.check->points > 0);
    });
}

}  // namespace hdconj::test::outline_cases
