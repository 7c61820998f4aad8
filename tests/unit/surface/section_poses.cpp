// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/section_poses.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <deque>
#include <numbers>

#include "hdconj/motion/parameter_at.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"

namespace hdconj::test::section_poses_cases {

namespace {

using SliceExact = motion::ExactMotion<wavegen::CosineCam>;

SliceExact slice(double factor)
{
    return type50_motion(2, factor * type50_w0);
}

/// Keeps the motions that its sections are made from.
struct Sections
{
    Sections(double low, double high)
        : poses(low, high, type50_ratio,
                [this](double factor) { return motion::AnyMotion(kept.emplace_back(slice(factor))); })
    {
    }
    std::deque<SliceExact> kept;
    surface::SectionPoses poses;
};

Pose pose_at(SliceExact const& motion, double phi)
{
    return motion.pose(motion::parameter_at(motion, phi));
}

/// A point of the deformed wall in the fixed frame: a slice's neutral curve, made for this amplitude alone.
Vec2 wall(double phi, double factor)
{
    return turned_clockwise(pose_at(slice(factor), phi).origin, type50_ratio * phi);
}

double angle_of(Pose const& pose)
{
    return std::atan2(pose.sine, pose.cosine);
}

}  // namespace

TEST_CASE("section of a wall that has not moved along the axis is the slice itself", "[axial]")
{
    Sections const sections(0.55, 1.45);
    double worst = 0;
    for (double const factor : {0.55, 0.6, 0.8, 1.0, 1.23, 1.45}) {
        SliceExact const motion = slice(factor);
        for (double phi = -3.1; phi <= 3.15; phi += 0.29) {
            Pose const section = sections.poses(phi, factor, 0);
            Pose const own = pose_at(motion, phi);
            worst = std::max(worst, (section.origin - own.origin).norm());
            worst = std::max(worst, std::abs(angle_of(section) - angle_of(own)));
            CHECK(section.cosine * section.cosine + section.sine * section.sine == Approx(1).epsilon(1e-15));
        }
    }
    INFO("worst " << worst);
    CHECK(worst < 1e-12);
}

TEST_CASE("section of a coned and shifted wall is what a plane cuts from the deformed surface", "[axial]")
{
    surface::ConingMode const mode =
        surface::coning_mode(Coning{ConingModel::linear, 9.0, 0.43, AxialShift::mapped, 0});
    surface::LinearAxialShift<wavegen::CosineCam> const shift(wavegen::CosineCam{type50_w0, 2}, type50_r_m, mode);
    Sections const sections(mode.factor(-3.7), mode.factor(3.7));
    double largest_turn = 0;
    for (double const plane : {-3.5, -1.1, 0.0, 2.2, 3.5}) {
        // where the wall meets the plane: z + u_z(phi) = plane, solved by bisection although u_z does not depend on z
        auto const cut = [&](double phi) {
            double low = plane - 1, high = plane + 1;
            for (int i = 0; i < 60; ++i) {
                double const z = 0.5 * (low + high);
                (z + shift(phi).u_z < plane ? low : high) = z;
            }
            return 0.5 * (low + high);
        };
        for (double phi = -3.1; phi <= 3.15; phi += 0.31) {
            INFO("plane " << plane << " phi " << phi);
            double const factor = mode.factor(cut(phi));
            Pose const section =
                sections.poses(phi, mode.factor(plane - shift(phi).u_z), -mode.slope() * shift(phi).slope);
            Vec2 const origin = turned_clockwise(section.origin, type50_ratio * phi);
            Vec2 const outward = turned_clockwise(section.rotate({0, 1}), type50_ratio * phi);
            CHECK((origin - wall(phi, factor)).norm() < 1e-12);

            // along the section curve, by differences of fourth order
            constexpr double h = 1e-3;
            auto const on_curve = [&](double at) { return wall(at, mode.factor(cut(at))); };
            Vec2 const tangent =
                8 * (on_curve(phi + h) - on_curve(phi - h)) - (on_curve(phi + 2 * h) - on_curve(phi - 2 * h));
            CHECK((outward - left_of(tangent).normalized()).norm() < 1e-9);

            // the wall's normal in space, projected into the plane
            double const z = cut(phi);
            auto const surface = [&](double p, double axial) {
                Vec2 const xy = wall(p, mode.factor(axial));
                return Eigen::Vector3d{xy.x(), xy.y(), axial + shift(p).u_z};
            };
            Eigen::Vector3d const along =
                8 * (surface(phi + h, z) - surface(phi - h, z)) - (surface(phi + 2 * h, z) - surface(phi - 2 * h, z));
            Eigen::Vector3d const axial = surface(phi, z + h) - surface(phi, z - h);
            Eigen::Vector3d const normal = axial.cross(along);
            CHECK((outward - Vec2{normal.x(), normal.y()}.normalized()).norm() < 1e-7);

            largest_turn = std::max(largest_turn, std::abs(angle_of(section) - angle_of(pose_at(slice(factor), phi))));
        }
    }
    // the correction is no rounding: f' u_z' dP/df over r is some 1e-4 rad
    CHECK(largest_turn > 5e-5);
}

}  // namespace hdconj::test::section_poses_cases
