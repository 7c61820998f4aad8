// SPDX-License-Identifier: GPL-3.0-or-later
// The ring that solve makes of a designed scene is the one that was checked, and no tooth of the bent cup enters it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "hdconj/design_files.hpp"
#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"
#include "support/polyline.hpp"

namespace hdconj::test::designed_ring_cases {
namespace {

DesignWishes wishes_of(double ratio, double diameter, double length_ratio, double torque_nm)
{
    DesignWishes wishes;
    wishes.ratio = ratio;
    wishes.diameter = diameter;
    wishes.length_ratio = length_ratio;
    wishes.torque = torque_nm * newton_metre;
    return wishes;
}

/// Whether @p p lies inside the outline of one pitch, which is closed over the axis.
bool is_inside(std::vector<Vec2> const& outline, Vec2 const& p)
{
    bool inside = false;
    auto const pass = [&](Vec2 const& a, Vec2 const& b) {
        if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y()))
            inside = !inside;
    };
    for (std::size_t i = 1; i < outline.size(); ++i)
        pass(outline[i - 1], outline[i]);
    pass(outline.back(), Vec2::Zero());
    pass(Vec2::Zero(), outline.front());
    return inside;
}

double distance(std::vector<Vec2> const& outline, Vec2 const& p)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < outline.size(); ++i)
        least = std::min(least, distance_to_segment(outline[i - 1], outline[i], p));
    return least;
}

/// How deep the teeth of one lobe, at both ends of the width and where load puts them, enter the ring that solve made
/// [mm].
double depth_in(Solution const& made, LoadStudy const& loaded)
{
    LoadedTeeth const& teeth = loaded.teeth;
    std::vector<Vec2> const& ring = made.circular_spline.outline[made.circular_spline.outline.size() / 2];
    Drive const& drive = made.scene.drive;
    double const pitches = static_cast<double>(drive.flexspline_teeth) / drive.circular_spline_teeth;
    double deepest = 0;
    for (std::size_t i = 0; i < teeth.phi.size(); ++i) {
        if (std::abs(teeth.phi[i]) > std::numbers::pi / 2)  // in the other lobe it stands in another space
            continue;
        for (std::size_t const k : {std::size_t{0}, teeth.z.size() - 1}) {
            double const lean = teeth.lean[i * teeth.z.size() + k], space = teeth.phi[i] * pitches - teeth.turn;
            for (Vec2 const& q : made.flexspline_outline) {
                Vec2 const p(q.x(), q.y() + made.geometry.pitch_line);
                Vec2 const at =
                    teeth.origin[i * teeth.z.size() + k] + Vec2(p.x() * std::cos(lean) + p.y() * std::sin(lean),
                                                                p.y() * std::cos(lean) - p.x() * std::sin(lean));
                Vec2 const seen(at.x() * std::cos(space) - at.y() * std::sin(space),
                                at.x() * std::sin(space) + at.y() * std::cos(space));
                if (seen.norm() > ring.front().norm() && !is_inside(ring, seen))
                    deepest = std::max(deepest, distance(ring, seen));
            }
        }
    }
    return deepest;
}

/// What holds for the ring of the design of @p wishes, whatever verb makes it.
void check_ring(DesignWishes const& wishes)
{
    Scene const scene = parse_scene(scene_text(design_drive(wishes)), "designed");
    Solution const made = solve(scene);
    CHECK(warnings_of(made.judgement) == 0);
    LoadOptions options;
    options.curve = options.errors = false;
    options.torque = 0;  // the cup bends, and the teeth stand in the middle of their play
    LoadStudy const loaded = study_load(scene, options);
    PairGeometry const &a = made.geometry, &b = loaded.solution.geometry;
    CHECK(a.space_depth == Approx(b.space_depth).margin(1e-9));
    CHECK(a.land_half_angle == Approx(b.land_half_angle).margin(1e-9));
    CHECK(2 * a.land_half_angle * a.circular_spline_inner_radius >= wishes.land * scene.drive.module);
    REQUIRE_FALSE(loaded.teeth.phi.empty());
    CHECK(depth_in(made, loaded) < 1e-4);
}

}  // namespace

TEST_CASE("a design under torque: the ring of solve is that of load, and the bent cup goes into it", "[law][design]")
{
    check_ring(wishes_of(77, 41, 0.6, 12));
}

TEST_CASE("a design under torque keeps land and flanks that are asked for where the cup bends", "[law][design]")
{
    DesignWishes wishes = wishes_of(63, 28.5, 1, 1.5);
    wishes.family = "bezier";
    wishes.land = 0.2;
    wishes.clearance = 0.0186;
    check_ring(wishes);
}

TEST_CASE("a design under torque takes a mesh whose bent cup leaves a land at all", "[law][design]")
{
    DesignWishes wishes = wishes_of(120, 50, 0.2, 28);
    wishes.family = "bezier";
    check_ring(wishes);
}

}  // namespace hdconj::test::designed_ring_cases
