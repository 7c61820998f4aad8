// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What else must hold of the reverse problem: symmetry, cuts, vanishing clearance, any number of threads.
#include <array>
#include <fstream>

#include "hdconj/error.hpp"
#include "support/catch.hpp"
#include "support/reverse_law.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

namespace hdconj::test::reverse_cases {

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;
using hdconj::Vec2;

TEST_CASE("a skew tooth and its mirror image are solved as mirror images, and touched", "[reverse]")
{
    std::array<Solution, 2> solutions;
    for (int side : {1, -1}) {
        hdconj::test::TemporaryFolder const folder;
        std::ofstream file(folder / "tooth.csv");
        file.precision(17);
        constexpr int half = 20;
        for (int i = -half; i <= half; ++i) {
            double const t = static_cast<double>(i) / half;
            file << side * 0.30 * t + 0.02 * side * (1 - t * t) << ","
                 << 0.2 - 0.48 * (0.6 * t * t + 0.4 * t * t * t * t) << "\n";
        }
        file.close();
        std::string const text =
            "[drive]\nmodule = 0.25\nflexspline_teeth = 200\ncircular_spline_teeth = 202\n"
            "[flexspline]\nwall = 0.7\naddendum = 0.15\ndedendum = 0.303\n"
            "[wave_generator]\nfamily = \"cosine\"\nradial_deformation = 0.25\n"
            "[circular_spline.profile]\nfamily = \"points\"\nside = \"full\"\nfile = \"tooth.csv\"\n";
        Solution& solution = solutions[side > 0 ? 0 : 1];
        solution = hdconj::solve(hdconj::parse_scene(text, "skew", folder.path()));
        CHECK(std::abs(solution.check->smallest_clearance) < 1e-12);
    }
    auto const& a = solutions[0];
    auto const& b = solutions[1];
    REQUIRE(a.flexspline_pieces.size() == b.flexspline_pieces.size());
    for (std::size_t i = 0; i < a.flexspline_pieces.size(); ++i) {
        auto const& one = a.flexspline_pieces[i];
        auto const& other = b.flexspline_pieces[b.flexspline_pieces.size() - 1 - i];
        CHECK(one.kind == other.kind);
        Vec2 const p = a.flexspline_outline[one.first];
        Vec2 const q = b.flexspline_outline[other.last];
        CHECK((p - Vec2(-q.x(), q.y())).norm() < 1e-11);
    }
    CHECK(std::abs(a.flexspline_outline.front().x() + a.flexspline_outline.back().x()) > 1e-3);
}

TEST_CASE("the solved tooth of a symmetric pair is symmetric, bit for bit", "[reverse]")
{
    Solution const solution = hdconj::solve(given_scene());
    auto const& outline = solution.flexspline_outline;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        CHECK(outline[i].x() == -outline[outline.size() - 1 - i].x());
        CHECK(outline[i].y() == outline[outline.size() - 1 - i].y());
    }
    auto const& spline = solution.circular_spline.outline[0];
    for (std::size_t i = 0; i < spline.size(); ++i)
        CHECK(spline[i].x() == -spline[spline.size() - 1 - i].x());
}

TEST_CASE("the outline of a reverse result is cut where the scene says", "[reverse]")
{
    Scene const scene = given_scene();
    Solution const solution = hdconj::solve(scene);
    auto const& outline = solution.flexspline_outline;
    CHECK(outline.front().y() == -*scene.flexspline.dedendum);
    CHECK(outline.back().y() == -*scene.flexspline.dedendum);
    double top = 0;
    for (Vec2 const& p : outline)
        top = std::max(top, p.y());
    CHECK(top == Approx(*scene.flexspline.addendum).epsilon(1e-14));
    // pieces follow each other and cover it
    std::size_t at = 0;
    for (auto const& piece : solution.flexspline_pieces) {
        CHECK(piece.first == at);
        CHECK(piece.last > piece.first);
        at = piece.last;
    }
    CHECK(at + 1 == outline.size());
    CHECK(solution.flexspline_pieces.front().kind == "root wall");
    // the given member, in the frame and order of a solved one
    auto const& spline = solution.circular_spline;
    REQUIRE(spline.z.size() == 1);
    auto const& points = spline.outline[0];
    double const half_pitch = pi<double>() / scene.drive.circular_spline_teeth;
    CHECK(std::atan2(points.front().x(), points.front().y()) == Approx(-half_pitch).epsilon(1e-12));
    CHECK(std::atan2(points.back().x(), points.back().y()) == Approx(half_pitch).epsilon(1e-12));
    CHECK(points.front().norm() == Approx(solution.geometry.circular_spline_inner_radius).epsilon(1e-14));
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        CHECK(points[i + 1].x() > points[i].x());
    REQUIRE(spline.landmarks.size() == 5);
    CHECK(points[static_cast<std::size_t>(spline.landmarks[2])].x() == 0);
    at = 0;
    for (auto const& piece : spline.pieces) {
        CHECK(piece.first == at);
        at = piece.last;
    }
    CHECK(at + 1 == points.size());
    // every point of it lies on the given tooth
    GivenTeeth<double> const teeth(scene);
    for (auto const& piece : spline.pieces) {
        if (piece.kind == "root")
            continue;
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            double const angle = half_pitch - std::atan2(std::abs(points[i].x()), points[i].y());
            Point<double> const p{points[i].norm() * std::sin(angle),
                                  teeth.pitch_radius - points[i].norm() * std::cos(angle)};
            CHECK(std::abs(teeth.tooth.distance_from_pitch_line(p)) < 1e-12);
        }
    }
}

TEST_CASE("a vanishing side clearance gives the tooth without", "[reverse]")
{
    Solution const base = hdconj::solve(given_scene());
    for (double const offset : {1e-12, 1e-9, 1e-6}) {
        Solution const moved =
            hdconj::solve(given_scene({"circular_spline.backlash_offset=" + designs::text_of(offset)}));
        double worst = 0;
        for (std::size_t i = 0; i < moved.flexspline_pieces.size(); ++i)
            for (auto const end : {&hdconj::OutlinePiece::first, &hdconj::OutlinePiece::last})
                worst = std::max(worst, (moved.flexspline_outline[moved.flexspline_pieces[i].*end] -
                                         base.flexspline_outline[base.flexspline_pieces[i].*end])
                                            .norm());
        REQUIRE(moved.flexspline_pieces.size() == base.flexspline_pieces.size());
        INFO("offset " << offset << ", corners moved by " << worst);
        CHECK(worst < 4 * offset + 1e-11);
    }
}

TEST_CASE("a reverse result does not depend on the number of threads", "[reverse]")
{
    Solution const one = hdconj::solve(given_scene({"solver.threads=1"}));
    Solution const four = hdconj::solve(given_scene({"solver.threads=4"}));
    CHECK(one.flexspline_outline == four.flexspline_outline);
    CHECK(one.check->smallest_clearance == four.check->smallest_clearance);
}

TEST_CASE("a tooth that would be pointed below its tip is refused with its height", "[reverse]")
{
    try {
        (void)hdconj::solve(given_scene({"flexspline.addendum=0.2750"}));
        FAIL("was not refused");
    } catch (hdconj::NumericalError const& error) {
        std::string const what = error.what();
        CHECK(what.find("pointed") != std::string::npos);
        CHECK(what.find("flexspline.addendum") != std::string::npos);
    }
}

}  // namespace hdconj::test::reverse_cases
