// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/section_displacement.hpp"

#include <cmath>
#include <deque>
#include <numbers>

#include "hdconj/motion/material_motion.hpp"
#include "hdconj/motion/parameter_at.hpp"
#include "hdconj/wavegen/displacement_of.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/coned_drive.hpp"
#include "support/type50.hpp"
#include "surface/section_poses.hpp"

namespace hdconj::test::section_displacement_cases {

namespace {

surface::ConingMode mode()
{
    return surface::coning_mode(Coning{ConingModel::linear, 9.0, 0.43, AxialShift::mapped, 0});
}

wavegen::NeutralCurve<wavegen::CosineCam> curve(double factor)
{
    return {wavegen::CosineCam{factor * type50_w0, 2}, type50_r_m};
}

surface::SectionDisplacement cone()
{
    return {-3.8, 3.8, [](double h) { return wavegen::displacement_of(curve(mode().factor(h))); }, 8};
}

}  // namespace

TEST_CASE("a section at one height is the slice there", "[axial]")
{
    surface::SectionDisplacement const wall = cone();
    for (double const h : {-3.5, 0.0, 1.7}) {
        wavegen::MaterialDisplacement const slice = wavegen::displacement_of(curve(mode().factor(h)));
        auto const section = wall.along([&](double) { return h; });
        REQUIRE(section.has_value());
        CHECK(is_symmetric(*section));
        for (double phi = -3.1; phi < 3.2; phi += 0.17) {
            auto const a = wavegen::displacement_at(*section, phi), b = wavegen::displacement_at(slice, phi);
            CHECK(a.w[0] == Approx(b.w[0]).margin(1e-13));
            CHECK(a.v[0] == Approx(b.v[0]).margin(1e-13));
            CHECK(a.w[1] == Approx(b.w[1]).margin(1e-12));
        }
    }
}

TEST_CASE("sections of a coned and shifted wall move as their single poses say", "[axial]")
{
    surface::LinearAxialShift<wavegen::CosineCam> const shift(wavegen::CosineCam{type50_w0, 2}, type50_r_m, mode());
    std::deque<Exact> kept;
    surface::SectionPoses const poses(mode().factor(-3.8), mode().factor(3.8), type50_ratio, [&](double factor) {
        return motion::AnyMotion(kept.emplace_back(curve(factor), type50_ratio));
    });
    surface::SectionDisplacement const wall = cone();
    double moved = 0;
    for (double const plane : {-3.5, -1.1, 0.0, 2.2, 3.5}) {
        auto const section = wall.along([&](double phi) { return plane - shift(phi).u_z; });
        REQUIRE(section.has_value());
        motion::MaterialMotion const motion(*section, type50_r_m, type50_ratio);
        motion::MaterialMotion const slice(wavegen::displacement_of(curve(mode().factor(plane))), type50_r_m,
                                           type50_ratio);
        CHECK(motion.symmetric());
        for (double phi = -1.5; phi < 1.6; phi += 0.13) {
            CAPTURE(plane, phi);
            Pose const one = poses(phi, mode().factor(plane - shift(phi).u_z), -mode().slope() * shift(phi).slope);
            Pose const all = motion.pose(phi);
            CHECK((all.origin - one.origin).norm() < 1e-12);
            CHECK(std::abs(all.sine - one.sine) < 1e-12);
            CHECK(std::abs(all.cosine - one.cosine) < 1e-12);
            moved = std::max(moved, (all.origin - slice.pose(phi).origin).norm());
        }
    }
    // w0 u_z/length, 5 um: not rounding
    CHECK(moved > 0.004);
}

TEST_CASE("a height that jumps has no series", "[axial]")
{
    CHECK_FALSE(cone()
                    .along([](double phi) { return std::abs(std::fmod(phi, std::numbers::pi)) < 1 ? 1.0 : 2.0; })
                    .has_value());
}

TEST_CASE("only sections that differ from their slices are made", "[axial]")
{
    auto const follows = [](std::vector<std::string> const& keys, int slices) {
        return ConedDrive(builtin_scene(keys), slices).maker->follows_sections();
    };
    CHECK(follows(coned("mapped"), 3));
    CHECK_FALSE(follows(coned("mapped"), 1));
    CHECK_FALSE(follows(coned("none"), 3));
    CHECK_FALSE(follows({}, 3));
    CHECK_FALSE(follows(with(coned("mapped"), {"solver.kinematics=first-order"}), 3));
    CHECK(follows(with(coned("mapped"), {"solver.kinematics=material"}), 3));
}

}  // namespace hdconj::test::section_displacement_cases
