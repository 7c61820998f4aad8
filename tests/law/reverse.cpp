// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The laws of the reverse problem: each point of the solved flexspline flank is touched by a circular-spline tooth at
/// some position and entered at none; solved back, a solved flank is the one it came from.
#include <array>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

#include "hdconj/contact/tooth_distance.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/profile/registry.hpp"
#include "support/catch.hpp"
#include "support/check_touch.hpp"
#include "support/oracle/reverse_touch.hpp"
#include "support/oracle/run.hpp"
#include "support/random_reverse_designs.hpp"
#include "support/temporary_folder.hpp"
#include "support/type50.hpp"

using namespace oracle;
using hdconj::Kinematics;
using hdconj::Scene;
using hdconj::Solution;
using hdconj::Vec2;

namespace {

constexpr std::size_t all_points = static_cast<std::size_t>(-1);

Scene given_scene(std::vector<std::string> const& overrides = {})
{
    return hdconj::read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/circular-spline-given.toml", overrides);
}

/// Both laws on the flexspline tooth, at most @p most points; the straight walls are looked at in between as well.
TouchReport reverse_touch_law(Solution const& solution, ReverseTouchScan& scan, std::size_t most)
{
    double const clearance = solution.scene.circular_spline.backlash_offset;
    auto const& outline = solution.flexspline_outline;
    TouchReport report;
    auto const look = [&](Point<double> const& p, std::string const& kind, std::size_t index) {
        double const distance = scan.nearest(p).distance - clearance;
        bool const cut = kind == "flank" || kind == "corner";
        if (cut)
            report.touched.take(std::abs(distance), distance, p, kind, index);
        report.entered.take(distance < 0 ? -distance : 0, distance, p, kind, index);
    };
    for (auto const& piece : solution.flexspline_pieces) {
        std::size_t const count = piece.last - piece.first;
        std::size_t const stride = std::max<std::size_t>(1, count * solution.flexspline_pieces.size() / most);
        for (std::size_t i = piece.first; i <= piece.last; i = i < piece.last ? std::min(i + stride, piece.last) : i + 1)
            look(point_of(outline[i]), piece.kind, i);
        if (piece.kind == "root wall" || piece.kind == "land")
            for (double share : {0.01, 0.25, 0.5, 0.75, 0.99})
                look(point_of(outline[piece.first] + share * (outline[piece.last] - outline[piece.first])), "straight", piece.first);
    }
    return report;
}

void check_every_point(Solution const& solution)
{
    ReverseTouchScan scan(solution.scene);
    auto const report = reverse_touch_law(solution, scan, all_points);
    CHECK(report.touched.points > 100);
    check_touched(report);
    CHECK(solution.check->smallest_clearance == Approx(solution.scene.circular_spline.backlash_offset).margin(1e-11));
}

Solution reversed(Scene const& scene)
{
    return hdconj::solve(hdconj::parse_scene(designs::reverse_toml_of(scene), "generated scene"));
}

}  // namespace

TEST_CASE("reverse touch law: the given tooth of data/scenes, every point", "[touch][reverse]")
{
    for (std::vector<std::string> const& overrides : std::vector<std::vector<std::string>>{
             {},
             {"solver.kinematics=first-order"},
             {"solver.kinematics=material"},
             {"wave_generator.family=ellipse", "solver.kinematics=material"},
             {"circular_spline.backlash_offset=0.003"},
             {"circular_spline.inner_radius=25.06"},
             {"flexspline.neutral_offset=0.1"},
             {"wave_generator.family=ellipse"},
             {"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=30"},
             {"wave_generator.family=four-roller", "wave_generator.roller_angle_deg=30", "solver.kinematics=first-order"},
             {"wave_generator.family=two-disc", "wave_generator.wrap_angle_deg=30"},
             {"wave_generator.waves=1", "drive.circular_spline_teeth=201", "wave_generator.radial_deformation=0.14",
              "flexspline.addendum=0.1", "circular_spline.profile.addendum=0.12"},
             {"wave_generator.waves=3", "drive.circular_spline_teeth=203", "wave_generator.radial_deformation=0.37"},
             {"wave_generator.waves=1", "drive.circular_spline_teeth=203", "wave_generator.radial_deformation=0.37",
              "flexspline.addendum=0.2"}}) {
        Solution const solution = hdconj::solve(given_scene(overrides));
        INFO((overrides.empty() ? "" : overrides.front()));
        check_every_point(solution);
    }
}

// Found by the law of accuracy on random drives: what lay above the open end of the last curve counted as outside, and nothing was left of the tooth.
TEST_CASE("reverse touch law: curves of the outermost teeth that end below the tip", "[touch][reverse]")
{
    for (char const* const text : {R"(
[drive]
name = "random reverse"
module = 0.44586398094972884
flexspline_teeth = 63
circular_spline_teeth = 65
[flexspline]
addendum = 0.29894924246291066
dedendum = 0.33892907226666463
wall = 0.722179939301243
neutral_offset = 0.13999756497471613
[circular_spline.profile]
family = "double-circular-arc"
addendum = 0.30413483904907695
concave_offset = "tangent"
concave_radius = 0.86633708549037
concave_rise = 0.07031449483665929
convex_offset = 0.6296627968463544
convex_radius = 0.9957754403577102
convex_rise = -0.3102472304331817
dedendum = 0.47710055916399663
tip_line_from = 0.24494031554860496
[wave_generator]
family = "cosine"
radial_deformation = 0.3339501531982759
waves = 2
[circular_spline]
backlash_offset = 0.0
[solver]
kinematics = "exact"
tolerance = 1e-08
)", R"(
[drive]
name = "random reverse"
module = 0.11227474569595795
flexspline_teeth = 152
circular_spline_teeth = 158
[flexspline]
addendum = 0.055899733486762096
dedendum = 0.061423984012701424
wall = 0.1191661165359992
[circular_spline.profile]
family = "straight"
addendum = 0.04709858291180779
dedendum = 0.059510215411587394
pressure_angle_deg = 26.22661428344788
thickness = 0.20081044059011743
[wave_generator]
family = "cosine"
radial_deformation = 0.3651957152838746
waves = 3
[circular_spline]
backlash_offset = 0.002765847837010971
[solver]
kinematics = "first-order"
tolerance = 1e-08
)"}) {
        Solution const solution = hdconj::solve(hdconj::parse_scene(text, "open end"));
        check_every_point(solution);
    }
}

TEST_CASE("reverse touch law: it notices five picometres and another drive", "[touch][reverse]")
{
    Solution const solution = hdconj::solve(given_scene());
    ReverseTouchScan scan(solution.scene);
    auto const flank = std::find_if(solution.flexspline_pieces.begin(), solution.flexspline_pieces.end(),
                                    [](auto const& piece) { return piece.kind == "flank"; });
    REQUIRE(flank != solution.flexspline_pieces.end());
    auto const p = point_of(solution.flexspline_outline[(flank->first + flank->last) / 2]);
    double most = 0;
    for (Point<double> const shift : {Point<double>{5e-9, 0}, {-5e-9, 0}, {0, 5e-9}, {0, -5e-9}})
        most = std::max(most, std::abs(scan.nearest(p + shift).distance));
    CHECK(most > 3 * touch_limit);
    CHECK(most < 6 * touch_limit);

    Solution const other = hdconj::solve(given_scene({"solver.kinematics=first-order"}));
    CHECK(reverse_touch_law(other, scan, 200).touched.deviation > 1e-4);
}

TEST_CASE("reverse touch law: random designs", "[touch][random][reverse]")
{
    std::size_t const most = full_run() ? all_points : 40;
    int const wanted = 100;
    designs::RandomReverseDesigns draw(19551122);
    std::map<std::string, int> refusals, kinds;
    std::vector<std::string> broken;
    std::size_t points = 0;
    double worst = 0;
    for (int i = 0; i < wanted; ++i) {
        Scene const scene = draw.next();
        Solution solution;
        try {
            solution = reversed(scene);
        } catch (std::exception const& error) {
            ++refusals[error.what()];
            std::cout << "refused design:\n" << designs::reverse_toml_of(scene) << error.what() << "\n\n";
            continue;
        }
        ++kinds[scene.circular_spline.profile->family];
        ++kinds[std::to_string(scene.wave_generator.waves) + " waves"];
        if (scene.circular_spline.backlash_offset > 0)
            ++kinds["side clearance"];
        ReverseTouchScan scan(solution.scene);
        auto const report = reverse_touch_law(solution, scan, most);
        points += report.entered.points;
        worst = std::max(worst, report.worst());
        if (!report.holds() || report.touched.points < 10) {
            std::ostringstream text;
            text << designs::reverse_toml_of(scene) << report;
            broken.push_back(text.str());
        }
    }
    std::cout << "reverse touch law, random designs: " << wanted << " of " << draw.drawn << " drawn, " << refusals.size()
              << " refused, " << points << " points, worst " << worst << " mm\n";
    for (auto const& [what, count] : kinds)
        std::cout << "  " << what << ": " << count << "\n";
    for (auto const& text : broken)
        std::cout << "law broken by:\n" << text << "\n\n";
    CHECK(broken.empty());
    CHECK(refusals.empty());
    CHECK(kinds["straight"] > 15);
    CHECK(kinds["double-circular-arc"] > 30);
    CHECK(kinds["1 waves"] >= 5);
    CHECK(kinds["3 waves"] > 5);
    CHECK(kinds["side clearance"] > 10);
}

namespace {

/// The stretch of type-50's circular spline that its convex arc makes, as a right flank that points inward, y from the pitch line,
/// between two heights.
std::vector<Vec2> solved_flank(Solution const& there, double lowest, double highest)
{
    double const pitch_radius = there.geometry.r_m + there.geometry.pitch_line + there.geometry.w0;
    double const half_pitch = pi<double>() / there.scene.drive.circular_spline_teeth;
    std::vector<Vec2> flank;
    for (auto const& piece : there.circular_spline.pieces) {
        if (piece.segment_name != "right convex arc" || piece.kind != "flank")
            continue;
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            Vec2 const p = there.circular_spline.outline[0][i];
            double const angle = half_pitch - std::atan2(p.x(), p.y());
            Vec2 const q(p.norm() * std::sin(angle), pitch_radius - p.norm() * std::cos(angle));
            if (q.y() > lowest && q.y() < highest)
                flank.push_back(q);
        }
    }
    return flank;
}

/// @p flank given as a spline through @p count of its points, at equal shares of its length, and solved back.
Solution solved_back(Solution const& there, std::vector<Vec2> const& flank, std::size_t count, double addendum)
{
    hdconj::test::TemporaryFolder const folder;
    std::vector<double> length{0};
    for (std::size_t i = 1; i < flank.size(); ++i)
        length.push_back(length.back() + (flank[i] - flank[i - 1]).norm());
    double const tip = std::max(flank.front().y(), flank.back().y());
    double const middle = 0.5 * (flank.front().y() + flank.back().y());
    std::ofstream file(folder / "flank.csv");
    file.precision(17);
    std::size_t at = 0;
    for (std::size_t k = 0; k < count; ++k) {
        double const wanted = length.back() * static_cast<double>(k) / static_cast<double>(count - 1);
        while (at + 1 < flank.size() && length[at + 1] <= wanted)
            ++at;
        Vec2 const& p = k + 1 == count ? flank.back() : flank[at];
        file << p.x() << "," << p.y() - middle << "\n";
    }
    file.close();
    std::ostringstream text;
    text.precision(17);
    text << "[drive]\nmodule = 0.25\nflexspline_teeth = 200\ncircular_spline_teeth = 202\n[flexspline]\nwall = 0.7\naddendum = "
         << addendum
         << "\ndedendum = 0.303\n[wave_generator]\nfamily = \"cosine\"\nradial_deformation = 0.25\n[circular_spline]\ninner_radius = "
         << there.geometry.r_m + there.geometry.pitch_line + there.geometry.w0 - tip
         << "\n[circular_spline.profile]\nfamily = \"points\"\nfile = \"flank.csv\"\n";
    return hdconj::solve(hdconj::parse_scene(text.str(), "round trip", folder.path()));
}

/// How far the solved flank above @p from is off type-50's tooth, and how far that one reaches out of it.
struct RoundTrip
{
    double worst = 0, deepest = 0;
    std::size_t seen = 0;
};

RoundTrip compared(Solution const& back, double from)
{
    hdconj::Profile const tooth = hdconj::test::type50_tooth();
    hdconj::ToothDistance const distance(tooth);
    RoundTrip trip;
    for (auto const& piece : back.flexspline_pieces) {
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            Vec2 const p = back.flexspline_outline[i] + Vec2(0, tooth.pitch_line);
            double const away = distance(p).distance;
            // the original tooth is free of the circular spline, so the largest free tooth contains it
            if (piece.kind == "flank" || piece.kind == "corner")
                trip.deepest = std::max(trip.deepest, -away);
            // what the given flank touches is the convex arc that it came from
            if (piece.kind == "flank" && p.y() > tooth.pitch_line + from) {
                trip.worst = std::max(trip.worst, std::abs(away));
                ++trip.seen;
            }
        }
    }
    return trip;
}

}  // namespace

TEST_CASE("round trip: a flank that was solved for, given and solved back, is the one it came from", "[reverse]")
{
    // what the second conjugate zone made
    Solution const there = hdconj::solve(hdconj::builtin_scene({"solver.tolerance=1e-9"}));
    std::vector<Vec2> const flank = solved_flank(there, -0.186, -0.06);
    REQUIRE(flank.size() > 1000);
    std::vector<double> errors;
    for (std::size_t const count : {9, 17, 33, 65}) {
        RoundTrip const trip = compared(solved_back(there, flank, count, 0.17), 0);
        CHECK(trip.seen > 100);
        CHECK(trip.deepest <= trip.worst);
        errors.push_back(trip.worst);
        std::cout << "round trip through " << count << " points: " << trip.worst << " mm, " << trip.seen << " points compared\n";
    }
    // a cubic spline tends to fourth order
    for (std::size_t i = 1; i < errors.size(); ++i)
        CHECK(errors[i] < errors[i - 1] / 6);
    CHECK(errors[3] < errors[1] / 128);
    CHECK(errors.back() < 5e-9);
}

TEST_CASE("round trip: both conjugate zones at once", "[reverse]")
{
    // each zone touches the whole solved flank: two branches side by side, as near as the spline is good
    Solution const there = hdconj::solve(hdconj::builtin_scene({"solver.tolerance=1e-9"}));
    std::vector<Vec2> const flank = solved_flank(there, -1, 1);
    double before = 1;
    for (std::size_t const count : {17, 19, 21}) {
        Solution const back = solved_back(there, flank, count, 0.157);
        RoundTrip const trip = compared(back, 0.07);
        std::cout << "round trip through " << count << " points of both zones: " << trip.worst << " mm, clearance "
                  << back.check->smallest_clearance << " mm\n";
        CHECK(trip.seen > 50);
        CHECK(trip.worst < before);
        // not farther inside than the written error says
        CHECK(back.check->smallest_clearance >= -2 * back.error.largest());
        CHECK(back.check->smallest_clearance >= -back.scene.solver.tolerance / 4);
        CHECK(back.error.largest() <= 1.1 * back.scene.solver.tolerance);
        before = trip.worst;
    }
    CHECK(before < 2e-6);
}

TEST_CASE("a given tooth of arcs is solved in closed form, and as a spline gives the same", "[reverse]")
{
    Solution const arcs = hdconj::solve(given_scene());
    hdconj::Faults faults;
    Scene const scene = given_scene();
    hdconj::Profile const tooth = hdconj::build_profile(
        *scene.circular_spline.profile, {scene.drive.module, 202, 0, 0, "", true, 2, 2}, faults);
    REQUIRE(faults.empty());
    for (auto const& piece : tooth.pieces)
        CHECK_FALSE(std::holds_alternative<hdconj::CurvePiece>(piece.shape));

    // the same flank as points of a spline
    hdconj::test::TemporaryFolder const folder;
    std::ofstream file(folder / "flank.csv");
    file.precision(17);
    for (auto const& piece : tooth.pieces) {
        if (tooth.segment_names[static_cast<std::size_t>(piece.segment)] != "right convex arc" || piece.corner)
            continue;
        constexpr int count = 100;
        for (int i = 0; i <= count; ++i) {
            Vec2 const p = hdconj::point_at(piece.shape, static_cast<double>(i) / count);
            file << p.x() << "," << p.y() - tooth.pitch_line << "\n";
        }
    }
    file.close();
    std::string text = arcs.scene.text;
    std::size_t const from = text.find("[circular_spline.profile]");
    text.replace(from, text.find("[solver]") - from, "[circular_spline.profile]\nfamily = \"points\"\nfile = \"flank.csv\"\n");
    text.replace(text.find("addendum = 0.2250"), 17, "addendum = 0.02  ");
    Solution const spline = hdconj::solve(hdconj::parse_scene(text, "as points", folder.path()));
    // the spline tooth ends where its convex arc ends, so only what that arc makes can be compared
    double worst = 0;
    std::size_t seen = 0;
    auto const& fine = arcs.flexspline_outline;
    for (auto const& piece : spline.flexspline_pieces) {
        if (piece.kind != "flank")
            continue;
        for (std::size_t i = piece.first; i <= piece.last; ++i) {
            Vec2 const p = spline.flexspline_outline[i];
            double nearest = 1;
            for (std::size_t k = 0; k + 1 < fine.size(); ++k) {
                Vec2 const d = fine[k + 1] - fine[k];
                double const share = std::clamp((p - fine[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (p - fine[k] - share * d).norm());
            }
            worst = std::max(worst, nearest);
            ++seen;
        }
    }
    CHECK(seen > 50);
    CHECK(worst < 1.1e-6);  // the chord error of the polygon that it is measured against
}

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
            file << side * 0.30 * t + 0.02 * side * (1 - t * t) << "," << 0.2 - 0.48 * (0.6 * t * t + 0.4 * t * t * t * t) << "\n";
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

TEST_CASE("every tooth family is taken on the circular spline and touched", "[touch][reverse]")
{
    std::size_t families = 0;
    for (std::string const name : {"arc-chain", "b-spline", "bezier", "cycloid", "involute", "points", "s-tooth", "straight", "type-50"}) {
        // the tooth of a forward scene, put on the other member
        Scene scene = hdconj::read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + name + ".toml");
        double const m = scene.drive.module;
        scene.circular_spline = {};
        scene.circular_spline.profile = scene.flexspline.profile;
        scene.circular_spline.profile->path = "circular_spline.profile";
        scene.flexspline.profile = {};
        scene.flexspline.addendum = 0.6 * m;
        scene.flexspline.dedendum = 1.3 * m;
        Solution const solution = hdconj::solve(scene);
        INFO(name);
        CHECK(std::abs(solution.check->smallest_clearance) < 1e-11);
        ++families;

        // by the oracle's motion and the exact distance to the given tooth
        hdconj::Faults faults;
        hdconj::Profile const tooth = hdconj::build_profile(
            *scene.circular_spline.profile,
            {m, scene.drive.circular_spline_teeth, 0, 0, scene.folder.string(), true, scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth, 2},
            faults);
        REQUIRE(faults.empty());
        hdconj::ToothDistance const distance(tooth);
        Scene as_forward = scene;
        as_forward.flexspline.inner_radius = solution.geometry.flexspline_inner_radius;
        Motion<double> const motion(as_forward);
        double const pitch_line = solution.geometry.pitch_line;
        double const seat = solution.geometry.circular_spline_inner_radius + tooth.addendum + tooth.pitch_line;
        auto const at = [&](Vec2 const& p, int k, double u) {
            auto const there = turned_clockwise(motion.pose(u).to_circular_spline({p.x(), p.y() + pitch_line}), -(k - 0.5) * motion.pitch());
            return distance({-there.x, seat - there.y}).distance;
        };
        for (auto const& piece : solution.flexspline_pieces) {
            if (piece.kind != "flank" && piece.kind != "corner")
                continue;
            std::size_t const stride = std::max<std::size_t>(1, (piece.last - piece.first) / 3);
            for (std::size_t i = piece.first; i <= piece.last; i += stride) {
                Vec2 const p = solution.flexspline_outline[i];
                constexpr int steps = 1500;
                double const step = pi<double>() / steps;
                struct Low
                {
                    double value, u;
                    int k;
                };
                std::vector<Low> lows;
                double best = 1;
                for (int k : {-1, 0, 1, 2}) {
                    std::vector<double> values;
                    for (int j = 0; j <= steps; ++j)
                        values.push_back(at(p, k, -pi<double>() / 2 + step * j));
                    for (std::size_t j = 1; j + 1 < values.size(); ++j)
                        if (values[j] <= values[j - 1] && values[j] <= values[j + 1])
                            lows.push_back({values[j], -pi<double>() / 2 + step * static_cast<double>(j), k});
                }
                for (Low const& low : lows)
                    best = std::min(best, low.value);
                // a tooth moves by less than this in a step
                double const slack = 4 * m * step;
                double least = 1;
                for (Low const& low : lows) {
                    if (low.value > best + slack)
                        continue;
                    double from = low.u - step, to = low.u + step;
                    for (int n = 0; n < 70; ++n) {
                        double const c = from + (to - from) / 3, e = to - (to - from) / 3;
                        (at(p, low.k, c) < at(p, low.k, e) ? to : from) = at(p, low.k, c) < at(p, low.k, e) ? e : c;
                    }
                    least = std::min({least, low.value, at(p, low.k, 0.5 * (from + to))});
                }
                INFO(piece.kind << " point " << i << ": " << least);
                CHECK(std::abs(least) < touch_limit);
            }
        }
    }
    CHECK(families == 9);
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
            Point<double> const p{points[i].norm() * std::sin(angle), teeth.pitch_radius - points[i].norm() * std::cos(angle)};
            CHECK(std::abs(teeth.tooth.distance_from_pitch_line(p)) < 1e-12);
        }
    }
}

TEST_CASE("a vanishing side clearance gives the tooth without", "[reverse]")
{
    Solution const base = hdconj::solve(given_scene());
    for (double const offset : {1e-12, 1e-9, 1e-6}) {
        Solution const moved = hdconj::solve(given_scene({"circular_spline.backlash_offset=" + designs::text_of(offset)}));
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
