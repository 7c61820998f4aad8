// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "conjugate/plane/boundary_checks.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

namespace hdconj::test::solve_cases {

namespace {

std::map<Stage, int> stages_entered(std::vector<std::string> const& overrides)
{
    std::map<Stage, int> count;
    (void)solve(builtin_scene(overrides), [&](Stage stage) { ++count[stage]; });
    return count;
}

std::vector<Vec2> outline(std::vector<std::string> const& overrides)
{
    return solve(builtin_scene(overrides)).circular_spline.outline.front();
}

}  // namespace

TEST_CASE("stages that the scene does not call for are never entered", "[pipeline]")
{
    std::map<Stage, int> base = stages_entered({});
    CHECK(base[Stage::backlash] == 0);
    CHECK(base[Stage::root_clearance] == 0);
    CHECK(base[Stage::region] == 1);
    CHECK(base[Stage::interference] == 1);
    std::map<Stage, int> offset = stages_entered({"circular_spline.backlash_offset=0.01"});
    CHECK(offset[Stage::backlash] == 1);
    CHECK(offset[Stage::root_clearance] == 0);
    std::map<Stage, int> deep = stages_entered({"circular_spline.root_clearance=0.01"});
    CHECK(deep[Stage::backlash] == 0);
    CHECK(deep[Stage::root_clearance] == 1);
    // and the plan says the same in advance
    Plan const plan = make_plan(builtin_scene());
    CHECK_FALSE(plan.has(Stage::backlash));
    for (auto const& [stage, times] : base)
        CHECK(plan.has(stage) == (times > 0));
}

TEST_CASE("the times written are those of the stages that ran", "[pipeline]")
{
    Solution const solution = solve(builtin_scene());
    for (StageTime const& time : solution.timing) {
        CHECK(time.seconds >= 0);
        bool planned = false;
        for (PlannedStage const& stage : solution.plan.stages)
            planned = planned || to_string(stage.stage) == time.stage;
        CHECK(planned);
    }
    CHECK(solution.timing.size() == solution.plan.stages.size());
}

TEST_CASE("solve gives the same bits for 1, 2 and 4 threads", "[pipeline][parallel]")
{
    for (std::string const kinematics : {"exact", "first-order", "material"}) {
        std::vector<std::string> const common{"solver.kinematics=" + kinematics, "solver.tolerance=1e-7",
                                              "circular_spline.backlash_offset=0.01"};
        auto const with_threads = [&](int threads) {
            std::vector<std::string> overrides = common;
            overrides.push_back("solver.threads=" + std::to_string(threads));
            return solve(builtin_scene(overrides));
        };
        Solution const one = with_threads(1);
        for (int threads : {2, 4}) {
            Solution const many = with_threads(threads);
            REQUIRE(many.circular_spline.outline == one.circular_spline.outline);
            CHECK(many.check->smallest_clearance == one.check->smallest_clearance);
            CHECK(many.check->where == one.check->where);
            REQUIRE(many.branches.size() == one.branches.size());
            for (std::size_t i = 0; i < one.branches.size(); ++i) {
                CHECK(many.branches[i].u == one.branches[i].u);
                CHECK(many.branches[i].point == one.branches[i].point);
            }
            CHECK(many.work.envelope_points == one.work.envelope_points);
        }
    }
}

TEST_CASE("teeth of curves and given circular splines are the same bits on 1, 2 and 4 threads", "[pipeline][parallel]")
{
    for (char const* const name : {"cycloid", "points", "circular-spline-given"}) {
        Scene scene = read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
        scene.solver.threads = 1;
        Solution const one = solve(scene);
        for (int threads : {2, 4}) {
            scene.solver.threads = threads;
            Solution const many = solve(scene);
            CAPTURE(name, threads);
            CHECK(many.circular_spline.outline == one.circular_spline.outline);
            CHECK(many.flexspline_outline == one.flexspline_outline);
            CHECK(many.check->smallest_clearance == one.check->smallest_clearance);
            CHECK(many.check->where == one.check->where);
            CHECK(many.work.envelope_points == one.work.envelope_points);
            REQUIRE(many.branches.size() == one.branches.size());
            for (std::size_t i = 0; i < one.branches.size(); ++i) {
                CHECK(many.branches[i].tooth == one.branches[i].tooth);
                CHECK(many.branches[i].u == one.branches[i].u);
                CHECK(many.branches[i].point == one.branches[i].point);
            }
        }
    }
}

TEST_CASE("the tooth that is shown is the given one to the tolerance, on every number of threads",
          "[pipeline][parallel]")
{
    for (char const* const tolerance : {"1e-5", "1e-9"})
        for (int threads : {1, 2, 4}) {
            Scene scene = builtin_scene({"solver.tolerance=" + std::string(tolerance)});
            scene.solver.threads = threads;
            profile::Profile const tooth = test::type50_tooth();
            std::vector<Vec2> expected = profile::polygon_of(tooth, scene.solver.tolerance);
            for (Vec2& p : expected)
                p.y() -= tooth.pitch_line;
            CAPTURE(tolerance, threads);
            CHECK(solve(scene).flexspline_outline == expected);
        }
}

TEST_CASE("an offset of zero is no offset, and a small one moves every flank point by its size", "[pipeline]")
{
    CHECK(outline({"circular_spline.backlash_offset=0.0"}) == outline({}));
    CHECK(outline({"circular_spline.root_clearance=0.0"}) == outline({}));
    Solution const solution = solve(builtin_scene({"circular_spline.backlash_offset=0.01"}));
    CHECK(solution.check->smallest_clearance == Approx(0.01).margin(1e-12));
}

TEST_CASE("root clearance moves the bottom and nothing else", "[pipeline]")
{
    Solution const plain = solve(builtin_scene());
    Solution const deep = solve(builtin_scene({"circular_spline.root_clearance=0.03"}));
    CHECK(deep.geometry.space_depth == Approx(plain.geometry.space_depth + 0.03).margin(1e-9));
    auto const& a = plain.circular_spline;
    auto const& b = deep.circular_spline;
    REQUIRE(a.landmarks.size() == 5);
    REQUIRE(b.landmarks.size() == 5);
    for (int i = 0; i <= a.landmarks[1]; ++i)
        CHECK(a.outline[0][static_cast<std::size_t>(i)] == b.outline[0][static_cast<std::size_t>(i)]);
    int walls = 0;
    for (OutlinePiece const& piece : b.pieces)
        walls += piece.kind == "root wall";
    CHECK(walls == 2);
    for (std::size_t i = 0; i + 1 < b.pieces.size(); ++i)
        CHECK(b.pieces[i].last == b.pieces[i + 1].first);
    CHECK(deep.check->smallest_clearance >= -1e-12);
}

TEST_CASE("a boundary that does not close says what to write", "[pipeline]")
{
    profile::Profile const tooth = test::type50_tooth();
    auto const motion = motion::AnyMotion::owning(test::type50_motion());
    envelope::AnyEnvelope const envelope(tooth, motion, 0);
    std::vector<envelope::ContactArc> arcs;
    for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    std::size_t open = 0;
    for (std::size_t lost = 0; lost < arcs.size(); ++lost) {
        auto fewer = arcs;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(lost));
        try {
            (void)conjugate::ToothSpaceFinder<motion::AnyMotion>(envelope, fewer, 25.025, test::type50_z_c, {1e-6, 26},
                                                                 1e-4)();
        } catch (NumericalError const& error) {
            open += error.cause().find("do not meet") != std::string::npos;
            INFO(error.what());
            CHECK_FALSE(error.remedy().empty());
        }
    }
    CHECK(open > 0);
}

TEST_CASE("a side clearance that removes a part of the flank says where and how much", "[pipeline]")
{
    profile::Profile const tooth = test::type50_tooth();
    auto const motion = motion::AnyMotion::owning(test::type50_motion());
    envelope::AnyEnvelope const envelope(tooth, motion, 0);
    std::vector<envelope::ContactArc> arcs;
    for (envelope::Branch const& branch : envelope::find_branches(envelope, 1).branches)
        arcs.insert(arcs.end(), branch.arcs.begin(), branch.arcs.end());
    double const pitch = 2 * std::numbers::pi / test::type50_z_c;
    constexpr double offset = 0.03;
    conjugate::ToothSpace const before =
        conjugate::ToothSpaceFinder<motion::AnyMotion>(envelope, arcs, 25.025, test::type50_z_c, {1e-6, 26}, 1e-4)();
    auto const judge = [&](conjugate::ToothSpace const& after) {
        conjugate::require_same_topology(envelope, arcs, before, arcs, after, pitch, offset, 1e-6);
    };
    CHECK_NOTHROW(judge(before));
    conjugate::ToothSpace lost = before;
    auto const flank = std::find_if(lost.pieces.begin(), lost.pieces.end(), [&](conjugate::BoundaryPiece const& piece) {
        return piece.arc >= 0 && arcs[static_cast<std::size_t>(piece.arc)].piece == 7;  // right convex arc
    });
    REQUIRE(flank != lost.pieces.end());
    lost.pieces.erase(flank);
    CHECK_THROWS_AS(judge(lost), NumericalError);
    // the stretch runs from (0.0946, 25.4370) to (0.2678, 25.0484)
    CHECK_THROWS_WITH(judge(lost),
                      ContainsSubstring("0.03") && ContainsSubstring("near (0.1") && ContainsSubstring("mm long"));
}

TEST_CASE("what cannot mesh is an error that names the tip circle, not an empty result", "[pipeline]")
{
    CHECK_THROWS_AS(solve(builtin_scene({"wave_generator.radial_deformation=0.15"})), NumericalError);
    CHECK_THROWS_WITH(solve(builtin_scene({"wave_generator.radial_deformation=0.15"})),
                      ContainsSubstring("tip circle"));
    CHECK_THROWS_AS(solve(builtin_scene({"circular_spline.inner_radius=26"})), InputError);
}

TEST_CASE("a tooth given by points is solved like the arcs the points were taken from", "[pipeline]")
{
    // type-50 without its tip line: two arcs, 60 points each
    Solution const arcs = solve(builtin_scene({"!flexspline.profile.tip_line_from"}));
    test::TemporaryFolder const folder;
    profile::Profile const tooth = test::type50_tooth({"!flexspline.profile.tip_line_from"});
    std::string csv;
    for (std::size_t i = tooth.pieces.size() - 2; i < tooth.pieces.size(); ++i)
        for (int k = i + 1 == tooth.pieces.size() ? 1 : 0; k <= 60; ++k) {
            Vec2 const p = profile::point_at(tooth.pieces[i].shape, k / 60.0);
            csv +=
                std::to_string(p.x() * 1e12) + "e-12," + std::to_string((p.y() - tooth.pitch_line) * 1e12) + "e-12\n";
        }
    std::ofstream(folder / "flank.csv") << csv;
    Scene scene = builtin_scene();
    scene.folder = folder.path();
    scene::FamilyChoice& choice = scene.flexspline.profile;
    choice.family = "points";
    choice.given = {{"file", {std::string("flank.csv"), 1}}};
    Solution const spline = solve(scene);
    CHECK(spline.check->smallest_clearance >= -1e-10);
    for (BranchRecord const& branch : spline.branches)
        CHECK((branch.kind == "regular" || branch.segment_name.find("tip land") != std::string::npos));
    // polygon against polygon: both chord errors, and the spline's own error at the jump of curvature between the arcs
    auto const& a = arcs.circular_spline.outline.front();
    double worst = 0;
    for (Vec2 const& p : spline.circular_spline.outline.front()) {
        double nearest = 1;
        for (std::size_t i = 0; i + 1 < a.size(); ++i) {
            Vec2 const d = a[i + 1] - a[i];
            double const t = std::clamp((p - a[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (p - a[i] - t * d).norm());
        }
        worst = std::max(worst, nearest);
    }
    CHECK(worst < 5e-6);
}

TEST_CASE("a boundary that cannot be found is told alike on 1, 2 and 4 threads", "[pipeline][parallel]")
{
    std::vector<std::string> told;
    for (std::string const threads : {"1", "2", "4"})
        try {
            // fine enough for branches to be taken beside the boundary, by threads that wait for its pieces
            (void)solve(builtin_scene(
                {"solver.tolerance=1e-8", "circular_spline.backlash_offset=0.1", "solver.threads=" + threads}));
            FAIL("100 um of side clearance leave no land, and were taken");
        } catch (NumericalError const& error) {
            told.push_back(error.what());
        }
    CHECK(told[0] == told[1]);
    CHECK(told[0] == told[2]);
}

TEST_CASE("landmarks stand where their names say", "[pipeline]")
{
    Solution const solution = solve(builtin_scene());
    auto const& points = solution.circular_spline.outline.front();
    auto const& marks = solution.circular_spline.landmarks;
    REQUIRE(marks.size() == 5);
    auto const at = [&](std::size_t k) { return points[static_cast<std::size_t>(marks[k])]; };
    double const tip = solution.geometry.circular_spline_inner_radius;
    CHECK(at(0).norm() == Approx(tip).epsilon(1e-14));
    CHECK(at(4).norm() == Approx(tip).epsilon(1e-14));
    CHECK(at(2).x() == 0);
    CHECK(std::is_sorted(marks.begin(), marks.end()));
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        CHECK(points[i + 1].x() > points[i].x());
}

}  // namespace hdconj::test::solve_cases
