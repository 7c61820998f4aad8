// SPDX-License-Identifier: GPL-3.0-or-later
// From the scene to the wire's moves.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wedm.hpp"
#include "support/catch.hpp"
#include "support/polyline.hpp"
#include "wedm/checks.hpp"
#include "wedm/faces.hpp"
#include "wedm/planes.hpp"
#include "wedm/seen_distance.hpp"

namespace hdconj::test::wedm_program_cases {

namespace {

using std::numbers::pi;

bool names(Faults const& faults, std::string const& path)
{
    return std::any_of(faults.begin(), faults.end(), [&](Fault const& fault) { return fault.path == path; });
}

Faults faults_of(std::vector<std::string> const& sets)
{
    try {
        return check_wedm(builtin_scene(sets));
    } catch (InputError const& error) {
        return error.faults();
    }
}

}  // namespace

TEST_CASE("the table wedm changes nothing of the solved drive", "[wedm]")
{
    Solution const with = solve(builtin_scene());
    Solution const without = solve(builtin_scene({"!wedm"}));
    CHECK(with.circular_spline.outline == without.circular_spline.outline);
    CHECK(with.plan.stages.size() == without.plan.stages.size());
    // nor does a wire that does not go with the drive keep it from being solved
    CHECK(solve(builtin_scene({"wedm.wire_diameter=5", "wedm.start_hole_radius=4", "wedm.lead_in=20"}))
              .circular_spline.outline == without.circular_spline.outline);
}

TEST_CASE("a ring that corners and lands alone make is cut", "[wedm]")
{
    Scene const scene = parse_scene(R"([drive]
name = "corners"
module = 0.7
flexspline_teeth = 120
circular_spline_teeth = 123
[flexspline]
wall = 1.1
[flexspline.profile]
family = "straight"
addendum = 0.5
dedendum = 0.7
pressure_angle_deg = 25
thickness = 1.0
[wave_generator]
family = "cosine"
radial_deformation = 0.72
waves = 3
[circular_spline]
width = 9.0
[wedm]
wire_diameter = 0.2
spark_gap = 0.012
residual_limit = 0.05
)",
                                    "corners");
    REQUIRE(solve(scene).flank_contact.angle == 0);
    WireProgram const program = wire_program(scene);
    CHECK(program.figures.face_error <= program.tolerance);
    CHECK(program.nominal.sync.size() == 3 * 123);
}

TEST_CASE("type-50 tilted by 0.2 degrees is cut to the tolerance and its numbers are those of the notes", "[wedm]")
{
    WireProgram const program = wire_program(builtin_scene({"tilt.angle_deg=0.2"}));
    WireFigures const& figures = program.figures;
    double const shift = 7 * std::tan(0.2 * pi / 180);
    CHECK(figures.face_shift == Approx(shift).epsilon(1e-9));            // 0.0244 mm
    CHECK(figures.guide_shift == Approx(shift * 57 / 7).epsilon(1e-4));  // 0.199 mm
    CHECK(figures.tilt == Approx(0.2 * pi / 180).epsilon(1e-4));
    CHECK(figures.upper.inner - figures.lower.inner == Approx(shift).epsilon(1e-9));
    CHECK(figures.larger_face() == LargerFace::upper);
    CHECK(figures.face_error <= program.tolerance);
    CHECK(figures.middle_error <= program.tolerance);
    CHECK(figures.ruling_error < 1e-12);
    // a constant taper moves the steepest flank point, 11.9 degrees from the radius, by shift (1 - sin 11.9 deg) too
    // far
    CHECK(figures.constant_taper_error == Approx(shift * (1 - std::sin(11.9 * pi / 180))).epsilon(0.02));
    // the contour turns by near 45 degrees in the corner of the root
    double const d = 0.056;
    double const corner = d * (1 / std::cos(pi / 8) - 1);
    CHECK(figures.residual == Approx(corner).epsilon(0.05));
    CHECK(program.residuals.size() % 202 == 0);
    CHECK(program.nominal.sync.size() == 5 * 202);
    CHECK(program.passes.front().offset == Approx(d).epsilon(1e-15));
    CHECK(std::count_if(program.passes.front().moves.begin(), program.passes.front().moves.end(),
                        [](WireMove const& m) { return m.tag == WireTag::stop; }) == 1);
}

TEST_CASE("radii of the faces are those of the solved outline however coarse the moves", "[wedm]")
{
    for (std::string const tolerance : {"5e-3", "5e-4"})
        for (std::string const clearance : {"0", "0.03"}) {
            Scene const scene = builtin_scene({"wedm.tolerance=" + tolerance, "wedm.residual_limit=0.1",
                                               "circular_spline.root_clearance=" + clearance});
            WireProgram const program = wire_program(scene);
            double inner = std::numeric_limits<double>::infinity(), outer = 0;
            Solution const solution = solve(scene);
            for (Vec2 const& p : solution.circular_spline.outline.front()) {
                inner = std::min(inner, p.norm());
                outer = std::max(outer, p.norm());
            }
            INFO("tolerance " << tolerance << ", root clearance " << clearance);
            CHECK(std::abs(program.figures.lower.inner - inner) <= program.contour_error);
            CHECK(std::abs(program.figures.lower.outer - outer) <= program.contour_error);
        }
}

TEST_CASE(
    "contours with a side clearance that was found, and what constant taper would do, are known as well as they say",
    "[wedm]")
{
    std::vector<std::string> const coned{
        "coning.model=linear", "coning.bottom_to_middle=9.0", "slices.count=5",          "slices.surface=tilted",
        "tilt.kind=radial",    "tilt.angle_deg=0.2",          "wedm.residual_limit=0.05"};
    for (std::string const& side_clearance :
         {std::string("circular_spline.backlash_offset=auto"), std::string("circular_spline.backlash_offset=0.0")}) {
        INFO(side_clearance);
        auto const solved_to = [&](std::string const& tolerance) {
            std::vector<std::string> keys = coned;
            keys.push_back(side_clearance);
            keys.push_back("solver.tolerance=" + tolerance);
            return wire_program(builtin_scene(keys));
        };
        WireProgram const coarse = solved_to("4e-5"), fine = solved_to("1e-7");
        double const known = coarse.contour_error + fine.contour_error;
        CHECK((coarse.contour_error > 4e-5) == (side_clearance.find("auto") != std::string::npos));
        for (auto const face : {&PairedContour::lower, &PairedContour::upper}) {
            std::vector<Vec2> const& line = fine.nominal.*face;
            double worst = 0;
            for (std::size_t i = 0; i < 100; ++i) {
                double nearest = 1;
                for (std::size_t k = 0; k < line.size(); ++k)
                    nearest = std::min(nearest, test::distance_to_segment(line[k], line[(k + 1) % line.size()],
                                                                          (coarse.nominal.*face)[i]));
                worst = std::max(worst, nearest);
            }
            // the finer one is thinned to the tolerance of the cut
            CHECK(worst < known + fine.tolerance);
        }
        auto const taper = [](WireProgram const& program) { return program.figures.constant_taper_error; };
        CHECK(std::abs(taper(coarse) - taper(fine)) <=
              coarse.figures.constant_taper_spread + fine.figures.constant_taper_spread + 3 * known);
        CHECK(coarse.figures.constant_taper_spread > 0);
        CHECK(coarse.figures.constant_taper_spread < 0.2 * taper(coarse));
    }
}

namespace {

/// Straight flanks and a thin wire: edges of the contour are much longer than the wire is wide.
Scene thin_wire(std::vector<std::string> keys)
{
    for (char const* const key : {"wedm.wire_diameter=0.05", "wedm.spark_gap=0.004", "wedm.thickness=7"})
        keys.emplace_back(key);
    return read_scene(HDCONJ_SOURCE_DIR "/data/scenes/straight.toml", keys);
}

/// Distance of @p p from the edges of a closed contour.
double distance_to_contour(std::vector<Vec2> const& contour, Vec2 const& p)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contour.size(); ++i)
        nearest = std::min(nearest, test::distance_to_segment(contour[i], contour[(i + 1) % contour.size()], p));
    return nearest;
}

}  // namespace

TEST_CASE("leads keep the distance of the path from the edges of the part, or the overlap is refused", "[wedm]")
{
    int accepted = 0, refused = 0;
    for (char const* const overlap : {"1", "1.5", "1.75", "2", "3", "3.5"}) {
        INFO("overlap " << overlap);
        try {
            WireProgram const program =
                wire_program(thin_wire({"wedm.lead_in=1", std::string("wedm.overlap=") + overlap}));
            ++accepted;
            std::vector<WireMove> const& moves = program.passes.front().moves;
            std::pair<Vec2, Vec2> const leads[] = {{moves[0].lower, moves[1].lower},
                                                   {moves[moves.size() - 2].lower, moves.back().lower}};
            constexpr int parts = 500;
            for (auto const& [from, to] : leads)
                for (int k = 0; k <= parts; ++k)
                    CHECK(distance_to_contour(program.nominal.lower, from + (to - from) * k / parts) >=
                          program.passes.front().offset - 2 * program.tolerance);
        } catch (NumericalError const& error) {
            ++refused;
            std::string const advice = error.set().front();
            INFO(error.what());
            REQUIRE_THAT(advice, ContainsSubstring("wedm.overlap="));
            CHECK_NOTHROW(wire_program(thin_wire({"wedm.lead_in=1", advice})));
        }
    }
    CHECK(accepted == 3);
    CHECK(refused == 3);
}

TEST_CASE("the error in the faces is that of the worst place along every block", "[wedm]")
{
    std::vector<Vec2> const part = wire_program(thin_wire({"wedm.tolerance=1e-5", "wedm.decimals=6"})).nominal.lower;
    for (std::string const tolerance : {"5e-4", "2e-3"}) {
        WireProgram const program = wire_program(thin_wire({"wedm.tolerance=" + tolerance}));
        WirePass const& pass = program.passes.front();
        std::size_t const pitch = pass.moves.size() / 100;  // two tooth spaces
        double worst = 0;
        constexpr int parts = 40;
        for (std::size_t i = 2; i < pitch; ++i)
            for (int k = 0; k < parts; ++k) {
                Vec2 const at = pass.moves[i].lower + (pass.moves[i + 1].lower - pass.moves[i].lower) * k / parts;
                worst = std::max(worst, std::abs(distance_to_contour(part, at) - pass.offset));
            }
        INFO("tolerance " << tolerance);
        CHECK(program.figures.face_error == Approx(worst).epsilon(0.05));
    }
}

TEST_CASE("without tilt both faces are the same bits and so are the guides", "[wedm]")
{
    for (auto const& sets : {std::vector<std::string>{}, {"tilt.angle_deg=0", "slices.count=5"}}) {
        WireProgram const program = wire_program(builtin_scene(sets));
        CHECK(program.nominal.lower == program.nominal.upper);
        CHECK(program.figures.larger_face() == LargerFace::neither);
        for (WireMove const& move : program.passes.front().moves) {
            wedm::WirePoints const guides = wedm::guides_of(program.machine, {move.lower, move.upper});
            REQUIRE(guides.lower == guides.upper);
            REQUIRE(guides.lower == move.lower);
        }
    }
}

TEST_CASE("a tilt of the other sign exchanges the faces", "[wedm]")
{
    WireProgram const up = wire_program(builtin_scene({"tilt.angle_deg=0.2"}));
    WireProgram const down = wire_program(builtin_scene({"tilt.angle_deg=-0.2"}));
    CHECK(down.figures.larger_face() == LargerFace::lower);
    REQUIRE(up.nominal.lower.size() == down.nominal.lower.size());
    for (std::size_t i = 0; i < up.nominal.lower.size(); ++i) {
        CHECK((up.nominal.lower[i] - down.nominal.upper[i]).norm() < 1e-12);
        CHECK((up.nominal.upper[i] - down.nominal.lower[i]).norm() < 1e-12);
    }
}

TEST_CASE("passes leave their stock and the last one none", "[wedm]")
{
    WireProgram const program =
        wire_program(builtin_scene({"tilt.angle_deg=0.2", "wedm.passes=[[0.02], [0.005], [0]]",
                                    "wedm.direction=alternating", "wedm.start=5", "wedm.overlap=0.05"}));
    REQUIRE(program.passes.size() == 3);
    CHECK(program.passes[0].offset == Approx(0.076).epsilon(1e-14));
    CHECK(program.passes[2].stock == 0);
    CHECK(program.passes[1].reversed);
    CHECK_FALSE(program.passes[2].reversed);
    for (WirePass const& pass : program.passes) {
        // the lead-in ends on the tip land clockwise of space 5
        Vec2 const at = pass.moves[1].lower;
        CHECK(std::atan2(at.x(), at.y()) == Approx(5.5 * 2 * pi / 202).epsilon(1e-9));
        CHECK(std::any_of(pass.moves.begin(), pass.moves.end(),
                          [](WireMove const& m) { return m.tag == WireTag::overlap; }));
    }
    // what a wider pass leaves is more
    auto const worst = [&](int pass) {
        double height = 0;
        for (Residual const& r : program.residuals)
            height = std::max(height, r.pass == pass ? r.height : 0);
        return height;
    };
    CHECK(worst(1) > worst(2));
    CHECK(worst(2) > worst(3));
    CHECK(program.figures.residual == worst(3));
}

TEST_CASE("a drafted surface is what constant taper makes but for its corners", "[wedm]")
{
    WireProgram const program = wire_program(builtin_scene({"tilt.angle_deg=0.2", "tilt.kind=draft"}));
    CHECK(program.figures.constant_taper_error < program.tolerance);
    CHECK(program.figures.face_error <= program.tolerance);
    CHECK(program.tilt_kind == TiltKind::draft);
}

TEST_CASE("a wire too wide for the root is refused and a wider limit tells the residual", "[wedm]")
{
    try {
        (void)wire_program(builtin_scene({"wedm.wire_diameter=0.3"}));
        FAIL("a wire of 0.3 mm was accepted");
    } catch (InputError const& error) {
        CHECK(names(error.faults(), "wedm.wire_diameter"));
    }
    WireProgram const program = wire_program(builtin_scene({"wedm.wire_diameter=0.3", "wedm.residual_limit=1"}));
    CHECK(program.figures.residual > 0.01);
    CHECK(program.figures.residual < 0.05);
}

TEST_CASE("what is advised against a residual keeps the limit", "[wedm]")
{
    // without root clearance, with some, and with so much that the teeth stay clear of the corner behind it
    for (auto const& [sets, clear] : {std::pair<std::vector<std::string>, bool>{{"wedm.residual_limit=0.003"}, false},
                                      {{"wedm.residual_limit=0.003", "circular_spline.root_clearance=0.002"}, false},
                                      {{"circular_spline.root_clearance=0.02"}, true},
                                      {{"circular_spline.root_clearance=0.1"}, true},
                                      {{"wedm.part=flexspline", "wedm.wire_diameter=0.25"}, false}}) {
        INFO(sets.front());
        std::string remedy;
        try {
            (void)wire_set_ups(builtin_scene(sets));
            FAIL("was accepted");
        } catch (InputError const& error) {
            REQUIRE(error.faults().size() == 1);
            remedy = error.faults().front().remedy;
        }
        INFO(remedy);
        CHECK(remedy.find("root_clearance") == std::string::npos);
        CHECK((remedy.find("flexspline keep a distance of 0.0") != std::string::npos) == clear);
        for (std::string const key : {"wire_diameter", "residual_limit"}) {
            auto const at = remedy.find(key + " = ");
            REQUIRE(at != std::string::npos);
            std::vector<std::string> with = sets;
            with.push_back("wedm." + key + "=" + std::to_string(std::stod(remedy.substr(at + key.size() + 3))));
            CHECK_NOTHROW(wire_set_ups(builtin_scene(with)));
        }
    }
}

TEST_CASE("an outline solved before gives the same program", "[wedm]")
{
    Scene const scene = builtin_scene({"tilt.angle_deg=0.2"});
    Solution const solution = solve(wire_scene(scene));
    WireProgram const again = wire_program(scene, solution);
    WireProgram const once = wire_program(scene);
    CHECK(again.nominal.lower == once.nominal.lower);
    CHECK(again.passes.front().moves.size() == once.passes.front().moves.size());
    // the outline of one slice is no tilted part
    CHECK_THROWS_AS(wire_program(scene, solve(builtin_scene())), InputError);
}

TEST_CASE("a thicker workpiece has the same toothing", "[wedm]")
{
    using Sets = std::vector<std::string>;
    Sets const cut{"wedm.wire_diameter=0.1", "wedm.spark_gap=0.006", "wedm.surface_limit=0.01"};
    for (Sets sets :
         {Sets{"coning.model=linear", "coning.bottom_to_middle=18", "slices.count=3", "slices.surface=ruled"},
          Sets{"tilt.angle_deg=0.2", "slices.count=3", "circular_spline.backlash_offset=\"auto\""},
          Sets{"tilt.angle_deg=-0.3", "tilt.kind=draft"}}) {
        INFO(sets.front());
        sets.insert(sets.end(), cut.begin(), cut.end());
        Scene const scene = builtin_scene(sets);
        double const width = *scene.circular_spline.width, thickness = width + 2;
        CircularSplineOutline const outline = solve(wire_scene(scene)).circular_spline;
        wedm::WireFaces const thin = wedm::wire_faces(outline, 202, width),
                              thick = wedm::wire_faces(outline, 202, thickness);
        REQUIRE(thick.between.size() == thin.between.size() + 2);
        auto const section = [&](double z) {
            std::vector<Vec2> line = thick.pitch.lower;
            for (std::size_t i = 0; i < line.size(); ++i)
                line[i] += (z / thickness + 0.5) * (thick.pitch.upper[i] - line[i]);
            return region::SegmentTree(std::move(line));
        };
        region::SegmentTree const lower = section(-width / 2), upper = section(width / 2);
        std::vector<double> off;
        for (std::size_t i = 0; i < thin.pitch.size(); ++i)
            if (thin.meshing[i] != 0)
                off.push_back(std::max(wedm::seen_distance(lower, thin.pitch.lower[i]),
                                       wedm::seen_distance(upper, thin.pitch.upper[i])));
        // a loop that only the faces of the thick one have is cut off, and with it the rulings there
        std::ranges::sort(off);
        CHECK(off[off.size() * 98 / 100] < 1e-12);
        CHECK(off.back() < scene.wedm->tolerance);
        // tip circles, side clearance "auto" and the checks between the faces are those of the toothing
        WireProgram const a = wire_program(scene);
        sets.push_back("wedm.thickness=" + std::to_string(thickness));
        WireProgram const b = wire_program(builtin_scene(sets));
        CHECK(b.notes == a.notes);
        double const extra = 0.5 * (thickness / width - 1);
        CHECK(b.figures.lower.inner ==
              Approx(std::lerp(a.figures.lower.inner, a.figures.upper.inner, -extra)).epsilon(1e-9));
        CHECK(b.figures.upper.inner ==
              Approx(std::lerp(a.figures.lower.inner, a.figures.upper.inner, 1 + extra)).epsilon(1e-9));
        CHECK(b.figures.tilt == Approx(a.figures.tilt).epsilon(0.02));
        CHECK(b.contour_error >= a.contour_error);
    }
}

TEST_CASE("a block that rounding may turn anywhere is said to", "[wedm]")
{
    // 0.0001 mm: a block of one unit, whose ends are half a unit off along both axes, may point backwards
    auto const turns = [](double length) {
        WireProgram program;
        program.machine = {1, 1, 1};
        program.passes = {{}};
        program.passes[0].moves = {{{0, 0}, {0, 0}}, {{length, 0}, {length, 0}}};
        return wedm::short_block_warnings(program).front();
    };
    CHECK(turns(0.0001).find("by up to 180 deg") != std::string::npos);
    CHECK(turns(std::numbers::sqrt2 * 0.0002).find("by up to 30 deg") != std::string::npos);
}

TEST_CASE("a pitch of the flexspline is its profile on the round neutral circle and the root's arc", "[wedm]")
{
    Scene const scene = builtin_scene({"wedm.part=flexspline"});
    wedm::WireFaces const faces = wedm::flexspline_faces(scene);
    Solution const drive = solve(scene);
    CHECK(faces.external);
    CHECK(faces.teeth == 200);
    CHECK(faces.pitch.lower == faces.pitch.upper);
    // the lowest points of the profile lie on the rim, half the wall and the pitch line's height beside r_m
    Vec2 const foot = drive.flexspline_outline.front();
    double const rim = drive.geometry.r_m + drive.geometry.pitch_line + foot.y();
    CHECK(rim == Approx(drive.geometry.flexspline_inner_radius + 0.7).epsilon(1e-14));
    double const root = std::hypot(rim, foot.x());
    REQUIRE(faces.marks.size() == 5);
    for (std::size_t i = faces.marks[1]; i <= faces.marks[3]; ++i)
        CHECK(faces.pitch.lower[i].norm() == Approx(root).epsilon(1e-14));
    CHECK(std::abs(faces.pitch.lower[faces.marks[2]].x()) < 1e-12);
    // every point of the profile, turned by half a pitch, is there
    for (std::size_t i = 0; i < drive.flexspline_outline.size(); i += 37) {
        Vec2 const p = drive.flexspline_outline[i] + Vec2(0, drive.geometry.r_m + drive.geometry.pitch_line);
        double const half = pi / 200 * (p.x() <= 0 ? 1 : -1);
        Vec2 const there(std::cos(half) * p.x() + std::sin(half) * p.y(),
                         -std::sin(half) * p.x() + std::cos(half) * p.y());
        CHECK(std::any_of(faces.pitch.lower.begin(), faces.pitch.lower.end(),
                          [&](Vec2 const& q) { return (q - there).norm() < 1e-12; }));
    }
    // pitches join
    CHECK((wedm::turned_to(faces.pitch.lower.front(), 1, 200) - faces.pitch.lower.back()).norm() < 1e-12);
}

TEST_CASE("set-ups of the flexspline run from land to land and back where passes alternate", "[wedm]")
{
    WireSetUps const set_ups = wire_set_ups(builtin_scene(
        {"wedm.part=flexspline", "wedm.passes=[[0.02], [0]]", "wedm.direction=alternating", "wedm.overlap=0.05"}));
    REQUIRE(set_ups.size() == 2);
    for (WireProgram const& program : set_ups) {
        CHECK_FALSE(program.closed());
        CHECK(program.figures.face_error <= program.tolerance);
        auto const& there = program.passes[0].moves;
        auto const& back = program.passes[1].moves;
        CHECK(back.front().lower == there.back().lower);
        CHECK(back.back().lower == there.front().lower);
        CHECK(program.passes[1].reversed);
        // the ends lie lead_in off the middle of a tip land, r_m + pitch line + addendum from the axis, half a turn
        // apart
        CHECK(there.front().lower.norm() == Approx(24.347 + 0.653 + 0.225 + 3).epsilon(1e-12));
        CHECK((there.front().lower + there.back().lower).norm() < 1e-12);
    }
    // half a turn is 100 pitches: in the machine both are one program, and no coordinate is a negative zero
    auto const& one = set_ups[0].passes[0].moves;
    auto const& two = set_ups[1].passes[0].moves;
    REQUIRE(one.size() == two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK((one[i].lower - two[i].lower).norm() < 1e-12);
        CHECK_FALSE((two[i].lower.x() == 0 && std::signbit(two[i].lower.x())));
    }
    CHECK(wire_set_ups(builtin_scene()).size() == 1);
}

TEST_CASE("wire data that cannot be right is refused with its key", "[wedm]")
{
    std::vector<std::pair<std::vector<std::string>, std::string>> const wrong{
        {{"!wedm"}, "wedm"},
        {{"!wedm.wire_diameter"}, "wedm.wire_diameter"},
        {{"!wedm.spark_gap"}, "wedm.spark_gap"},
        {{"wedm.wire_diameter=0"}, "wedm.wire_diameter"},
        {{"wedm.wire_diameter=0.8"}, "wedm.wire_diameter"},
        {{"wedm.spark_gap=-0.001"}, "wedm.spark_gap"},
        {{"wedm.spark_gap=0.2"}, "wedm.spark_gap"},
        {{"wedm.decimals=3"}, "wedm.decimals"},
        {{"wedm.tolerance=0.00005"}, "wedm.tolerance"},
        {{"wedm.tolerance=0.03"}, "wedm.tolerance"},
        {{"wedm.tolerance=0.000005", "wedm.decimals=7"}, "wedm.tolerance"},
        {{"wedm.passes=[[0.005], [0.02], [0]]"}, "wedm.passes"},
        {{"wedm.passes=[[0.02], [0.005]]"}, "wedm.passes"},
        {{"wedm.passes=[[0.3], [0]]"}, "wedm.passes"},
        {{"wedm.passes=[]"}, "wedm.passes"},
        {{"wedm.lower_guide=-1"}, "wedm.lower_guide"},
        {{"wedm.thickness=6"}, "wedm.thickness"},
        {{"!circular_spline.width"}, "wedm.thickness"},
        {{"wedm.start_hole_radius=0.05"}, "wedm.start_hole_radius"},
        {{"wedm.lead_in=0.5"}, "wedm.lead_in"},
        {{"wedm.lead_in=40"}, "wedm.lead_in"},
        {{"wedm.start=202"}, "wedm.start"},
        {{"wedm.overlap=100"}, "wedm.overlap"},
        {{"tilt.angle_deg=31"}, "tilt.angle_deg"},
    };
    for (auto const& [sets, path] : wrong) {
        INFO(sets.front());
        CHECK(names(faults_of(sets), path));
    }
    CHECK(faults_of({"tilt.angle_deg=0.2"}).empty());
    CHECK_THROWS_AS(wire_program(builtin_scene({"wedm.largest_travel=20"})), NumericalError);
}

}  // namespace hdconj::test::wedm_program_cases
