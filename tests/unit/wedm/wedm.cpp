// SPDX-License-Identifier: GPL-3.0-or-later
// The wire in rooms of known size: planes, parallels, residuals, checks.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "support/catch.hpp"
#include "wedm/checks.hpp"
#include "wedm/offset_path.hpp"
#include "wedm/passes.hpp"
#include "wedm/planes.hpp"
#include "wedm/residual.hpp"

namespace hdconj::test::wedm_cases {

namespace {

using std::numbers::pi;

/// Straight lines through @p corners, @p step apart.
std::vector<Vec2> drawn(std::vector<Vec2> const& corners, double step)
{
    std::vector<Vec2> line{corners.front()};
    for (std::size_t i = 1; i < corners.size(); ++i) {
        Vec2 const way = corners[i] - corners[i - 1];
        int const count = std::max(1, static_cast<int>(std::lround(way.norm() / step)));
        for (int k = 1; k <= count; ++k)
            line.push_back(k == count ? corners[i] : Vec2(corners[i - 1] + way * k / count));
    }
    return line;
}

double distance(Vec2 const& p, std::vector<Vec2> const& line)
{
    double best = 1e300;
    for (std::size_t i = 1; i < line.size(); ++i) {
        Vec2 const along = line[i] - line[i - 1];
        double const share = std::clamp((p - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
        best = std::min(best, (p - line[i - 1] - share * along).norm());
    }
    return best;
}

/// A slot between two lands: from (1, 0) to (w/2, 0), down... here up into the material by @p depth, and back; void on
/// the left.
std::vector<Vec2> slot(double width, double depth, double step)
{
    double const x = width / 2;
    return drawn({{1, 0}, {x, 0}, {x, depth}, {-x, depth}, {-x, 0}, {-1, 0}}, step);
}

/// A ring whose only pitch goes all around: a square hole, from the middle of its lower side, counter-clockwise.
wedm::WireFaces square_hole(double half, double upper_half)
{
    wedm::WireFaces faces;
    faces.teeth = 1;
    auto const around = [](double h) { return drawn({{0, -h}, {h, -h}, {h, h}, {-h, h}, {-h, -h}, {0, -h}}, h / 50); };
    faces.pitch = {around(half), around(upper_half)};
    faces.marks = {0};
    faces.meshing.assign(faces.pitch.size(), 1);
    return faces;
}

wedm::PairedPath with_guards(wedm::WireFaces const& faces)
{
    return {with_neighbours(faces.pitch.lower, faces, 1), with_neighbours(faces.pitch.upper, faces, 1)};
}

WireProgram program_of(wedm::WireFaces const& faces)
{
    WireProgram program;
    program.machine = {7, 20, 30};
    program.wire_diameter = 0.1;
    program.spark_gap = 0.012;
    program.tolerance = 0.0005;
    program.teeth = faces.teeth;
    program.start_hole_radius = 0.5;
    std::vector<std::size_t> const kept = thinned(faces.pitch, 0.0004, faces.marks);
    program.nominal = whole_contour(faces, kept);
    wedm::PairedPath const path = wedm::offset_path(with_guards(faces), 0.062, 3e-5);
    WirePass pass = wire_pass(taken(path, thinned(path, 0.0004)), faces, {0, {0, -1}, 0, 0, false});
    pass.offset = 0.062;
    program.passes = {pass};
    return program;
}

}  // namespace

TEST_CASE("guides and faces are inverse to 1e-13 and weights sum to one", "[wedm]")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-30, 30);
    std::uniform_real_distribution<double> height(0, 60);
    for (int i = 0; i < 1000; ++i) {
        WireMachine const machine{1 + height(random), height(random), height(random)};
        wedm::WirePoints const faces{{place(random), place(random)}, {place(random), place(random)}};
        wedm::WirePoints const back = wedm::faces_of(machine, wedm::guides_of(machine, faces));
        double const grown = 30 * (1 + 2 * machine.guide_distance() / machine.thickness);
        CHECK((back.lower - faces.lower).norm() < 1e-13 * std::max(1.0, grown));
        CHECK((back.upper - faces.upper).norm() < 1e-13 * std::max(1.0, grown));
        Vec2 const moved(100, 100);
        wedm::WirePoints const there = wedm::guides_of(machine, {faces.lower + moved, faces.upper + moved});
        wedm::WirePoints const here = wedm::guides_of(machine, faces);
        CHECK((there.lower - here.lower - moved).norm() < 1e-13 * std::max(1.0, 10 * grown));
        CHECK((there.upper - here.upper - moved).norm() < 1e-13 * std::max(1.0, 10 * grown));
    }
}

TEST_CASE("the guides of the notes' square are those of the notes", "[wedm]")
{
    // a square of 10 mm, 0.2 degrees inwards at the top, wire 0.1, gap 0.012, guides 20 and 30
    WireMachine const machine{7, 20, 30};
    double const in = 7 * std::tan(0.2 * pi / 180);
    wedm::WirePoints const corner{{5 - 0.062, 5 - 0.062}, {5 - 0.062 - in, 5 - 0.062 - in}};
    wedm::WirePoints const guides = wedm::guides_of(machine, corner);
    CHECK(guides.lower.x() == Approx(5.0078).margin(5e-5));
    CHECK(guides.upper.x() == Approx(4.8088).margin(5e-5));
    CHECK(at_height(machine, corner, 0) == corner.lower);
    CHECK(at_height(machine, corner, 7) == corner.upper);
    CHECK((at_height(machine, corner, -20) - guides.lower).norm() < 1e-14);
    CHECK((at_height(machine, corner, 37) - guides.upper).norm() < 1e-14);
    wedm::WirePoints const upright{{1.1, -2.3}, {1.1, -2.3}};
    CHECK(guides_of(machine, upright).lower == upright.lower);
    CHECK(guides_of(machine, upright).upper == upright.lower);
    CHECK(at_height(machine, upright, 3.3) == upright.lower);
}

TEST_CASE("a wire rolls around corners that stick out and stays in corners that do not", "[wedm]")
{
    std::vector<Vec2> const line = slot(0.5, 0.6, 0.01);
    double const d = 0.06;
    wedm::PairedPath const path = wedm::offset_path({line, line}, d, 1e-6);
    for (std::size_t i = 0; i < path.size(); ++i) {
        CHECK(path.lower[i] == path.upper[i]);
        CHECK(distance(path.lower[i], line) == Approx(d).margin(1e-12));
        // chords of the arcs come nearer by their sagitta only
        if (i > 0)
            CHECK(distance(0.5 * (path.lower[i] + path.lower[i - 1]), line) > d - 1.001e-6);
    }
    // the inner corners of the path are points of it
    for (double const side : {1.0, -1.0}) {
        Vec2 const corner(side * (0.25 - d), 0.6 - d);
        CHECK(std::any_of(path.lower.begin(), path.lower.end(),
                          [&](Vec2 const& p) { return (p - corner).norm() < 1e-12; }));
    }
    double highest = -1;
    for (Vec2 const& p : path.lower)
        highest = std::max(highest, p.y());
    CHECK(highest == Approx(0.6 - d).margin(1e-12));
}

TEST_CASE("in a slot narrower than the wire it goes as deep as two corners let it", "[wedm]")
{
    double const d = 0.2;
    double const width = 0.3;
    std::vector<Vec2> const line = slot(width, 0.6, 0.01);
    wedm::PairedPath const path = wedm::offset_path({line, line}, d, 1e-7);
    double highest = -1;
    for (Vec2 const& p : path.lower) {
        CHECK(distance(p, line) > d - 1e-6);
        highest = std::max(highest, p.y());
    }
    // the centre hangs between the two edges, at distance d from both
    CHECK(highest == Approx(-std::sqrt(d * d - width * width / 4)).margin(1e-6));
    std::vector<double> const heights = wedm::uncut_heights(line, path.lower, d, 1e-6);
    // the cut is the circle around that centre, for every point of the slot
    auto const middle =
        std::find_if(line.begin(), line.end(), [](Vec2 const& p) { return p.y() == 0.6 && std::abs(p.x()) < 1e-9; });
    REQUIRE(middle != line.end());
    double const top = d - std::sqrt(d * d - width * width / 4);
    CHECK(heights[static_cast<std::size_t>(middle - line.begin())] == Approx(0.6 - top).margin(2e-6));
    auto const wall =
        std::find_if(line.begin(), line.end(), [](Vec2 const& p) { return std::abs(p.y() - 0.3) < 1e-9 && p.x() > 0; });
    REQUIRE(wall != line.end());
    double const on_wall = heights[static_cast<std::size_t>(wall - line.begin())];
    CHECK(on_wall == Approx(distance(*wall, path.lower) - d).margin(1e-9));
    CHECK(on_wall == Approx((*wall - Vec2(0, highest)).norm() - d).margin(2e-6));  // the path's own chords
}

TEST_CASE("in a square corner the residual is that of a circle between two walls", "[wedm]")
{
    double const d = 0.056;
    std::vector<Vec2> const line = drawn({{-1, 0}, {0, 0}, {0, 1}}, 0.002);
    for (double const stock : {0.0, 0.01}) {
        wedm::PairedPath const path = wedm::offset_path({line, line}, d + stock, 1e-7);
        std::vector<double> const heights = wedm::uncut_heights(line, path.lower, d + stock, 1e-7);
        for (std::size_t i = 5; i + 5 < line.size(); ++i) {
            double const x = std::max(std::abs(line[i].x()), std::abs(line[i].y()));
            double const off = std::max(0.0, d + stock - x);  // of the foot from the circle's centre
            INFO("stock " << stock << " at " << x << " mm from the corner");
            CHECK(heights[i] == Approx(std::hypot(off, d + stock) - (d + stock)).margin(3e-7));
        }
    }
}

TEST_CASE("a residual is the distance of the contour from the cut whatever the walls beside the corner", "[wedm]")
{
    // a flank, a short wall behind it as root clearance makes it, and the root: what is left grows with the wall to
    // that of the square corner, never beyond
    double const d = 0.056;
    double const slope = pi / 4;
    double before = 0;
    for (double const wall : {0.0, 0.006, 0.02, 0.05, 0.1}) {
        Vec2 const edge(0.15, -wall);
        Vec2 const other(-0.15, -wall);
        Vec2 const first = edge + 0.15 * Vec2(std::cos(slope), -std::sin(slope));
        Vec2 const last = other - 0.15 * Vec2(std::cos(slope), std::sin(slope));
        std::vector<Vec2> const reached =
            drawn({first, edge, other, last}, 0.0007);  // by a tooth that ends where the wall begins
        std::vector<Vec2> const line =
            wall > 0 ? drawn({first, edge, {0.15, 0}, {-0.15, 0}, other, last}, 0.0007) : reached;
        wedm::PairedPath const path = wedm::offset_path({line, line}, d, 1e-7);
        std::vector<double> const heights = wedm::uncut_heights(line, path.lower, d, 1e-7);
        double highest = 0;
        for (std::size_t i = 1; i + 1 < line.size(); ++i) {
            // the cut by brute force: discs so dense on the path that no point of it is further than 0.1 um from the
            // centre of one
            double nearest = 1e300;
            for (std::size_t k = 1; k < path.size(); ++k)
                for (double const share : {0.0, 0.25, 0.5, 0.75, 1.0})
                    nearest = std::min(
                        nearest, (line[i] - path.lower[k - 1] - share * (path.lower[k] - path.lower[k - 1])).norm());
            CHECK(heights[i] == Approx(std::max(0.0, nearest - d)).margin(4e-7));
            highest = std::max(highest, heights[i]);
        }
        INFO("wall " << wall);
        CHECK(highest > before - 1e-6);
        CHECK(highest < d * (std::sqrt(2.0) - 1) + 1e-6);
        if (wall == 0)
            CHECK(highest == Approx(d * (1 / std::cos(pi / 8) - 1)).margin(1e-6));
        if (wall > d)
            CHECK(highest == Approx(d * (std::sqrt(2.0) - 1)).margin(1e-6));
        before = highest;
        // the tooth stays clear of what is left where the wall is longer than that, by the rest of the wall
        double const way = wedm::way_to_residual(line, heights, reached);
        if (wall > d)
            CHECK(way == Approx(wall - d).margin(0.001));
        if (wall == 0)
            CHECK(way <= 0);
        // where it says that they do not meet the wire has cut all that the tooth reaches
        if (way > 0)
            CHECK(std::all_of(reached.begin() + 1, reached.end() - 1,
                              [&](Vec2 const& p) { return distance(p, path.lower) <= d + 1e-6; }));
    }
}

TEST_CASE("in a bore wider than the wire nothing is left", "[wedm]")
{
    double const radius = 0.2;
    std::vector<Vec2> bore;
    for (int i = 0; i <= 540; ++i)
        bore.push_back(radius * direction(2 * pi * i / 720));
    for (double const d : {0.05, 0.15, 0.19}) {
        wedm::PairedPath const path = wedm::offset_path({bore, bore}, d, 2e-5);
        REQUIRE(path.size() > 400);
        for (Vec2 const& p : path.lower)
            CHECK(p.norm() == Approx(radius - d).margin(1e-5));
        std::vector<double> const heights = wedm::uncut_heights(bore, path.lower, d, 1e-5);
        CHECK(*std::max_element(heights.begin() + 2, heights.end() - 2) == 0);
    }
}

namespace {

/// The path in @p lower and @p upper is at distance @p d from each, with straight moves, and moves in both.
void check_parallels(std::vector<Vec2> const& lower, std::vector<Vec2> const& upper, double d)
{
    wedm::PairedPath const path = wedm::offset_path({lower, upper}, d, 1e-6);
    REQUIRE(path.lower.size() == path.upper.size());
    for (std::size_t i = 1; i < path.size(); ++i) {
        CHECK(distance(path.lower[i], lower) == Approx(d).margin(2e-6));
        CHECK(distance(path.upper[i], upper) == Approx(d).margin(2e-6));
        CHECK(distance(0.5 * (path.lower[i] + path.lower[i - 1]), lower) == Approx(d).margin(2e-6));
        CHECK(distance(0.5 * (path.upper[i] + path.upper[i - 1]), upper) == Approx(d).margin(2e-6));
        CHECK(path.lower[i] != path.lower[i - 1]);
        CHECK(path.upper[i] != path.upper[i - 1]);
    }
}

}  // namespace

TEST_CASE("faces that differ keep their own exact parallels where the wire cannot follow", "[wedm]")
{
    // the root of one face is sharp, that of the other is an arc that the wire follows to its own corner
    double const d = 0.06;
    std::vector<Vec2> const sharp = slot(0.5, 0.6, 0.01);
    std::vector<Vec2> const turned = [&] {
        std::vector<Vec2> line = sharp;
        for (Vec2& p : line)
            p = Vec2(1.1 * p.x(), 0.9 * p.y() + 0.02 * p.x());
        return line;
    }();
    check_parallels(sharp, turned, d);
}

TEST_CASE("a slot that the wire enters in one face only keeps both its corners there", "[wedm]")
{
    // two loops in one face where the other has one: it passes over the mouth of its slot
    double const d = 0.06;
    std::vector<Vec2> const wide = slot(0.5, 0.6, 0.01);
    std::vector<Vec2> narrow = wide;
    for (Vec2& p : narrow)
        p.x() *= 0.15;
    check_parallels(wide, narrow, d);
    check_parallels(narrow, wide, d);
    // three against one, and against two that end elsewhere
    std::vector<Vec2> const step =
        drawn({{1, 0}, {0.25, 0}, {0.25, 0.6}, {0.1, 0.6}, {0.1, 0.9}, {-0.25, 0.9}, {-0.25, 0}, {-1, 0}}, 0.01);
    std::vector<Vec2> mouth = step, leaning = step;
    for (Vec2& p : mouth)
        p.x() *= 0.15;
    for (Vec2& p : leaning)
        p = Vec2(1.1 * p.x() + 0.05 * p.y(), 0.9 * p.y() + 0.02 * p.x());
    check_parallels(step, mouth, d);
    check_parallels(mouth, step, d);
    check_parallels(step, leaning, d);
    check_parallels(leaning, step, d);
}

TEST_CASE("around a corner of one face the wire moves on in the other too", "[wedm]")
{
    double const d = 0.06;
    std::vector<Vec2> const corner = drawn({{1, 0}, {0, -0.3}, {-1, 0}}, 0.01);
    std::vector<Vec2> plain = corner, bent = corner;
    for (Vec2& p : plain)
        p.y() = 0;
    for (Vec2& p : bent)
        p.y() = 0.01 * p.x() * p.x();
    for (auto const& other : {plain, bent}) {
        check_parallels(corner, other, d);
        check_parallels(other, corner, d);
        wedm::PairedPath const path = wedm::offset_path({corner, other}, d, 1e-6);
        double shortest = 1;
        for (std::size_t i = 1; i < path.size(); ++i)
            shortest = std::min(shortest, (path.upper[i] - path.upper[i - 1]).norm());
        // the fan's chords share the two halves of edges beside it
        CHECK(shortest > 1e-4);
    }
}

TEST_CASE("thinned moves keep to within the tolerance in both faces and between", "[wedm]")
{
    wedm::PairedPath fine;
    for (int i = 0; i <= 400; ++i) {
        double const a = 0.5 * pi * i / 400;
        fine.add(0.3 * direction(a), Vec2(0.4 * direction(a + 0.05 * a * a)));
    }
    double const tolerance = 5e-4;
    std::vector<std::size_t> const keep{100, 207};
    std::vector<std::size_t> const kept = thinned(fine, tolerance, keep);
    CHECK(kept.front() == 0);
    CHECK(kept.back() == 400);
    for (std::size_t const k : keep)
        CHECK(std::binary_search(kept.begin(), kept.end(), k));
    CHECK(kept.size() < 60);
    wedm::PairedPath const few = taken(fine, kept);
    for (double const share : {0.0, 0.3, 1.0}) {
        std::vector<Vec2> line;
        for (std::size_t i = 0; i < few.size(); ++i)
            line.push_back((1 - share) * few.lower[i] + share * few.upper[i]);
        for (std::size_t i = 0; i < fine.size(); ++i)
            CHECK(distance((1 - share) * fine.lower[i] + share * fine.upper[i], line) <= tolerance);
    }
}

TEST_CASE("a sound wire program passes every check", "[wedm]")
{
    wedm::WireFaces const faces = square_hole(5, 5 - 7 * std::tan(0.2 * pi / 180));
    WireProgram program = program_of(faces);
    CHECK(wedm::check_numbers(program).empty());
    CHECK(wedm::check_pairing(program).empty());
    CHECK(wedm::check_crossings(program).empty());
    CHECK(check_sweep(faces, program).empty());
    CHECK(program.figures.face_error < 0.0005);
    CHECK(wedm::check_rulings(program).empty());
    CHECK(program.figures.normal_angle < 1e-9);
    CHECK(wedm::check_machine({pi / 6, 100}, program).empty());
    CHECK(wedm::check_start(program).empty());
    CHECK(wedm::check_untilted(program).empty());
    // corners move by T tan(0.2 deg) in both directions
    CHECK(program.figures.guide_shift == Approx(std::sqrt(2.0) * 57 * std::tan(0.2 * pi / 180)).epsilon(1e-9));
    // the wire's centre in the corners of the square: 4 corners, start and end, hole twice
    CHECK(program.passes.front().moves.size() == 8);
}

TEST_CASE("each check finds what it is there for", "[wedm]")
{
    wedm::WireFaces const faces = square_hole(5, 4.9);
    WireProgram const sound = program_of(faces);
    auto const broken = [&](auto&& change) {
        WireProgram program = sound;
        change(program);
        return program;
    };
    CHECK_FALSE(wedm::check_numbers(broken([](auto& p) { p.spark_gap = -0.001; })).empty());
    CHECK_FALSE(wedm::check_numbers(broken([](auto& p) { p.machine.lower_guide = -1; })).empty());
    CHECK_FALSE(
        wedm::check_numbers(broken([](auto& p) { p.passes.front().moves[2].upper.x() = std::nan(""); })).empty());
    CHECK_FALSE(wedm::check_numbers(broken([](auto& p) { p.passes.clear(); })).empty());
    CHECK_FALSE(wedm::check_pairing(broken([](auto& p) { p.nominal.upper.pop_back(); })).empty());
    CHECK_FALSE(wedm::check_pairing(broken([](auto& p) {
                    p.passes.front().moves[3].upper = p.passes.front().moves[2].upper;
                })).empty());
    CHECK_FALSE(wedm::check_pairing(broken([](auto& p) { p.passes.front().moves.back().upper.x() += 1; })).empty());
    CHECK_FALSE(
        wedm::check_crossings(broken([](auto& p) { std::swap(p.nominal.upper[1], p.nominal.upper[2]); })).empty());
    CHECK_FALSE(wedm::check_crossings(broken([](auto& p) { p.passes.front().reversed = true; })).empty());
    auto wide = broken([](auto& p) { p.passes.front().moves[3].lower.x() += 0.001; });
    CHECK_FALSE(check_sweep(faces, wide).empty());
    auto backwards =
        broken([](auto& p) { std::swap(p.passes.front().moves[3].upper, p.passes.front().moves[4].upper); });
    CHECK_FALSE(wedm::check_rulings(backwards).empty());
    auto same = broken([](auto&) {});
    CHECK_FALSE(wedm::check_machine({0.01, 100}, same).empty());
    CHECK_FALSE(wedm::check_machine({1, 5}, same).empty());
    CHECK_FALSE(wedm::check_start(broken([](auto& p) { p.start_hole_radius = 4; })).empty());
    CHECK_FALSE(wedm::check_start(broken([](auto& p) { p.passes.front().moves.front().lower = Vec2(0, -6); })).empty());
    auto level = program_of(square_hole(5, 5));
    CHECK(wedm::check_untilted(level).empty());
    level.passes.front().moves[2].upper.x() = std::nextafter(level.passes.front().moves[2].upper.x(), 9.0);
    CHECK_FALSE(wedm::check_untilted(level).empty());
}

TEST_CASE("stop and overlap lie where they were asked for and move nothing else", "[wedm]")
{
    wedm::WireFaces const faces = square_hole(5, 4.9);
    wedm::PairedPath const path = wedm::offset_path(with_guards(faces), 0.062, 3e-5);
    WirePass const plain = wedm::wire_pass(path, faces, {0, {0, -1}, 0, 0, false});
    WirePass const pass = wedm::wire_pass(path, faces, {0, {0, -1}, 0.7, 1.3, false});
    double left = 0;
    auto const stop =
        std::find_if(pass.moves.begin(), pass.moves.end(), [](WireMove const& m) { return m.tag == WireTag::stop; });
    REQUIRE(stop != pass.moves.end());
    for (auto it = stop; (it + 1)->tag == WireTag::contour; ++it)
        left += ((it + 1)->lower - it->lower).norm();
    CHECK(left == Approx(1.3).epsilon(1e-12));
    double beyond = 0;
    for (std::size_t i = 1; i < pass.moves.size(); ++i)
        if (pass.moves[i].tag == WireTag::overlap)
            beyond += (pass.moves[i].lower - pass.moves[i - 1].lower).norm();
    CHECK(beyond == Approx(0.7).epsilon(1e-12));
    WirePass const back = wedm::wire_pass(path, faces, {0, {0, -1}, 0, 0, true});
    REQUIRE(back.moves.size() == plain.moves.size());
    for (std::size_t i = 0; i < plain.moves.size(); ++i)
        CHECK(back.moves[i].upper == plain.moves[plain.moves.size() - 1 - i].upper);
    CHECK_THROWS_AS(wire_pass(path, faces, {0, {0, -1}, 0, 1000, false}), std::invalid_argument);
}

TEST_CASE("short moves are joined to others where the tolerance allows it", "[wire]")
{
    // an arc whose last point is hardly beyond what one move from the start reaches
    wedm::PairedPath path;
    constexpr double radius = 1, sagitta = 1e-3, step = 1e-3;
    double const reach = 2 * std::acos(1 - sagitta / radius);
    for (double angle = 0; angle < reach + 2.5 * step; angle += step) {
        Vec2 const p = radius * Vec2(std::cos(angle), std::sin(angle));
        path.add(p, p);
    }
    auto const length = [&](std::size_t a, std::size_t b) { return (path.lower[b] - path.lower[a]).norm(); };
    auto const is_short = [&](std::size_t a, std::size_t b) { return length(a, b) < 0.02; };
    auto const greedy = wedm::thinned(path, sagitta);
    REQUIRE(std::ranges::adjacent_find(greedy, is_short) != greedy.end());
    auto const even = wedm::thinned_to_long_moves(path, sagitta, is_short);
    CHECK(even.size() == greedy.size());
    CHECK(std::ranges::adjacent_find(even, is_short) == even.end());
    CHECK(even.front() == 0);
    CHECK(even.back() == path.size() - 1);
    for (std::size_t i = 1; i < even.size(); ++i)
        for (std::size_t k = even[i - 1]; k <= even[i]; ++k)
            CHECK(wedm::from_move(path, k, even[i - 1], even[i]) <= sagitta);
}

TEST_CASE("a path a hundred times as fine has the same moves, and they are chosen among as many", "[wire]")
{
    std::size_t asked[2] = {}, moves[2] = {}, chosen[2] = {};
    for (std::size_t const fine : {0, 1}) {
        int const points = fine == 1 ? 200'000 : 2000;
        wedm::PairedPath path;
        for (int i = 0; i <= points; ++i) {
            double const x = 6.0 * i / points;
            path.add({x, 0.3 * std::sin(x)}, {x, 0.2 * std::cos(x)});
        }
        moves[fine] = wedm::thinned(path, 1e-3).size();
        chosen[fine] = wedm::thinned_to_long_moves(path, 1e-3, [&](std::size_t, std::size_t) {
                           ++asked[fine];
                           return false;
                       }).size();
    }
    CHECK(moves[1] <= moves[0] + 1);
    CHECK(moves[1] + 2 >= moves[0]);
    CHECK(chosen[1] <= chosen[0] + 2);  // points to choose from differ
    CHECK(asked[1] < 2 * asked[0]);
}

}  // namespace hdconj::test::wedm_cases
