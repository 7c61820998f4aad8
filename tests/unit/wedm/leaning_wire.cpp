// SPDX-License-Identifier: GPL-3.0-or-later
// Wires that lean: the ellipse that they cut in the plane of a face, what they cut between the faces, and what a
// constant taper would do in their place.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/wedm.hpp"
#include "hdconj/wire_files.hpp"
#include "support/catch.hpp"
#include "support/polyline.hpp"
#include "wedm/offset_path.hpp"

namespace hdconj::test::leaning_wire_cases {

namespace {

using Vec3 = Eigen::Vector3d;

/// The distance in space of the place @p p at height @p z from the nearest wire of the first @p count moves of a pass,
/// which is looked at in steps between them [mm].
double from_wire(WirePass const& pass, std::size_t count, double thickness, Vec2 const& p, double z)
{
    constexpr int steps = 8;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 2; i < count; ++i)
        for (int k = 0; k < steps; ++k) {
            double const share = static_cast<double>(k) / steps;
            WireMove const &a = pass.moves[i - 1], &b = pass.moves[i];
            Vec2 const low = a.lower + share * (b.lower - a.lower), up = a.upper + share * (b.upper - a.upper);
            Vec3 const foot(low.x(), low.y(), 0), along = Vec3(up.x(), up.y(), thickness) - foot;
            nearest = std::min(nearest, (Vec3(p.x(), p.y(), z) - foot).cross(along).norm() / along.norm());
        }
    return nearest;
}

WireProgram tilted(double degrees)
{
    return wire_program(builtin_scene({"tilt.angle_deg=" + std::to_string(degrees)}));
}

}  // namespace

TEST_CASE("a leaning wire keeps its distance in space from the part, not in the plane of a face", "[wedm]")
{
    WireProgram const program = tilted(29);
    WirePass const& pass = program.passes.front();
    double const thickness = program.machine.thickness;
    CHECK(program.figures.ellipse == Approx(0.056 * (1 / std::cos(29 * std::numbers::pi / 180) - 1)).epsilon(0.01));
    CHECK(program.figures.face_error <= program.tolerance);
    // two spaces of the path, and the nominal points of the first from land to land
    std::size_t const moves = 2 * pass.moves.size() / static_cast<std::size_t>(program.teeth);
    std::size_t const points = program.nominal.lower.size() / static_cast<std::size_t>(program.teeth);
    std::size_t touched = 0, looked = 0;
    for (bool const upper : {false, true})
        for (std::size_t i = 4; i < points; ++i) {
            Vec2 const& p = upper ? program.nominal.upper[i] : program.nominal.lower[i];
            double const away = from_wire(pass, moves, thickness, p, upper ? thickness : 0);
            INFO("point " << i << (upper ? " of the upper face" : " of the lower face"));
            CHECK(away >= pass.offset - program.tolerance);
            ++looked;
            touched += away <= pass.offset + 2 * program.tolerance ? 1 : 0;
        }
    CHECK(touched > looked / 2);  // the wire does not reach the corners of the root
}

TEST_CASE("the parallel of a wall is as far off as the ellipse of a leaning wire reaches", "[wedm]")
{
    double const d = 0.06, height = 7, slope = std::tan(0.5);
    for (double const turn : {0.0, 0.4, std::numbers::pi / 2}) {
        // a straight wall along x, the void above; the wire leans across it where the turn is 0
        Vec2 const shift = height * slope * Vec2(std::sin(turn), std::cos(turn));
        std::vector<Vec2> lower, upper;
        for (int i = 0; i <= 10; ++i) {
            lower.emplace_back(0.01 * i, 0);
            upper.emplace_back(lower.back() + shift);
        }
        wedm::PairedPath const path = wedm::offset_path({lower, upper}, d, 1e-6, height);
        double const across = slope * std::cos(turn);
        for (std::size_t i = 0; i < path.size(); ++i) {
            CHECK(path.lower[i].y() == Approx(d * std::sqrt(1 + across * across)).epsilon(1e-12));
            CHECK((path.upper[i] - path.lower[i] - shift).norm() < 1e-12);
        }
    }
}

TEST_CASE("what constant taper would be wrong by grows with the tilt until it would cut the flanks away", "[wedm]")
{
    // the largest distance of the upper flanks from the lower ring buffered by what the tip land moves, by Shapely [um]
    for (auto const& [degrees, buffered] :
         {std::pair(0.2, 19.25), {0.5, 47.54}, {1.0, 92.25}, {1.5, 133.61}, {-0.8, 74.76}, {-1.5, 133.61}}) {
        INFO(degrees);
        CHECK(tilted(degrees).figures.constant_taper_error * 1000 == Approx(buffered).epsilon(2e-3));
    }
    for (double const degrees : {2.0, 3.0, -3.0, 10.0, 20.0}) {
        INFO(degrees);
        WireProgram const program = tilted(degrees);
        CHECK(std::isnan(program.figures.constant_taper_error));
        CHECK(nlohmann::json::parse(summary_json({program})).at("checks").at("constant_taper_error_um").is_null());
        CHECK_THAT(summary_text({program}), ContainsSubstring("not determined   G51 would cut the flanks away"));
    }
}

TEST_CASE("where corners alone make the walls, constant taper is measured on these", "[wedm]")
{
    for (std::string const w0 : {"0.15", "0.165"}) {
        INFO(w0);
        WireProgram const program =
            wire_program(read_scene(HDCONJ_SOURCE_DIR "/data/scenes/straight.toml",
                                    {"tilt.angle_deg=0.5", "wedm.wire_diameter=0.05", "wedm.spark_gap=0.004",
                                     "wedm.residual_limit=0.1", "circular_spline.width=7",
                                     "flexspline.profile.addendum=0.12", "wave_generator.radial_deformation=" + w0}));
        std::vector<Vec2> const &lower = program.nominal.lower, &upper = program.nominal.upper;
        FaceRadii const& face = program.figures.upper;
        double const shift = face.inner - program.figures.lower.inner, depth = face.outer - face.inner;
        double wrong = 0;
        std::size_t const pitch = lower.size() / static_cast<std::size_t>(program.teeth);
        for (std::size_t i = pitch; i < 2 * pitch; ++i) {
            double const height = (upper[i].norm() - face.inner) / depth;
            if (height < 1e-3 || height > 0.95)
                continue;
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t k = 1; k < 3 * pitch; ++k)
                nearest = std::min(nearest, distance_to_segment(lower[k - 1], lower[k], upper[i]));
            wrong = std::max(wrong, std::abs(shift - nearest));
        }
        CHECK(wrong > 0.3 * shift);
        CHECK(program.figures.constant_taper_error == Approx(wrong).margin(2 * program.tolerance));
    }
}

TEST_CASE("the setup sheet says how far the cut is off between the faces, and warns beyond the tolerance", "[wedm]")
{
    std::vector<std::string> const drafted{"tilt.angle_deg=1", "tilt.kind=draft", "wedm.surface_limit=0.1"};
    WireProgram const wrong = wire_program(builtin_scene(drafted)),
                      good = wire_program(builtin_scene({"tilt.angle_deg=0.2"})),
                      upright = wire_program(builtin_scene());
    REQUIRE(wrong.figures.middle_error > wrong.tolerance);
    std::string const told = "a straight wire cuts up to ";
    CHECK_THAT(setup_sheet_text({wrong}, {}), ContainsSubstring("off the true sections between the faces, corners") &&
                                                  ContainsSubstring("WARNING") && ContainsSubstring(told));
    CHECK_THAT(setup_sheet_text({good}, {}),
               ContainsSubstring("off the true sections between the faces, corners") && !ContainsSubstring(told));
    CHECK_THAT(setup_sheet_text({upright}, {}), !ContainsSubstring("between the faces"));
    std::vector<std::string> sets = drafted;
    sets.emplace_back("slices.count=2");
    WireProgram const unchecked = wire_program(builtin_scene(drafted), solve(builtin_scene(sets)));
    CHECK_THAT(setup_sheet_text({unchecked}, {}), ContainsSubstring("the cut between the faces was NOT CHECKED") &&
                                                      ContainsSubstring("slices.count = 3 or more"));
    CHECK_THAT(nlohmann::json::parse(summary_json({unchecked})).at("warnings").dump(),
               ContainsSubstring("the cut between the faces was not checked"));
}

}  // namespace hdconj::test::leaning_wire_cases
