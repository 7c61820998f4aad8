// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "drive/drive.hpp"
#include "support/catch.hpp"
#include "support/type50.hpp"
#include "surface/cone.hpp"
#include "surface/coning.hpp"
#include "surface/slice_places.hpp"

namespace hdconj::test::axial_cases {

namespace {

using std::numbers::pi;

surface::ConingMode type50_mode()
{
    return surface::coning_mode(Coning{ConingModel::linear, 9.0, 0.43, AxialShift::mapped, 0});
}

wavegen::AnyWaveShape shape_of(std::string const& scene_name)
{
    Scene const scene = read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/" + scene_name + ".toml");
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    wavegen::AnyWaveShape shape = drive::wave_shape(scene, tooth, faults);
    REQUIRE(faults.empty());
    return shape;
}

}  // namespace

TEST_CASE("the coning mode is one in the middle and zero at the apex, and straight between", "[axial]")
{
    surface::ConingMode const mode = type50_mode();
    CHECK(mode.apex == Approx(0.43 - 9).epsilon(1e-15));
    CHECK(mode.factor(0) == 1);
    CHECK(mode.factor(-8.57) == Approx(0).margin(1e-15));
    CHECK(mode.factor(8.57) == Approx(2).epsilon(1e-15));
    // design 3.4: w0 runs from 0.148 to 0.352 mm over 7 mm
    CHECK(0.25 * mode.factor(-3.5) == Approx(0.148).margin(5e-4));
    CHECK(0.25 * mode.factor(3.5) == Approx(0.352).margin(5e-4));
    CHECK(mode.slope() == Approx((mode.factor(2.0) - mode.factor(-1.0)) / 3).epsilon(1e-14));
    CHECK(mode.slope() > 0);
}

TEST_CASE("slices lie symmetrically about the middle bit for bit, end planes among them", "[axial]")
{
    for (double const width : {7.0, 0.1, 3.3, 1e-3}) {
        for (int const count : {2, 3, 4, 5, 9, 10, 17, 100}) {
            std::vector<double> const z = surface::slice_places(count, width);
            REQUIRE(z.size() == static_cast<std::size_t>(count));
            CHECK(z.front() == -width / 2);
            CHECK(z.back() == width / 2);
            for (std::size_t k = 0; k < z.size(); ++k)
                CHECK(z[k] == -z[z.size() - 1 - k]);
            for (std::size_t k = 0; k + 1 < z.size(); ++k)
                CHECK(z[k + 1] - z[k] == Approx(width / (count - 1)).epsilon(1e-13));
            if (count % 2 == 1)
                CHECK(z[z.size() / 2] == 0);
        }
    }
    CHECK(surface::slice_places(1, 7.0) == std::vector<double>{0.0});
}

TEST_CASE("axial shift of a cosine cam is its closed form for one and two and three waves", "[axial]")
{
    surface::ConingMode const mode = type50_mode();
    for (int const n : {1, 2, 3}) {
        surface::LinearAxialShift<wavegen::CosineCam> const shift(wavegen::CosineCam{type50_w0, n}, type50_r_m, mode);
        double const amplitude = -type50_r_m * mode.slope() * type50_w0 / (n * n);
        for (double phi = -4; phi < 7; phi += 0.37) {
            INFO("waves " << n << " phi " << phi);
            CHECK(shift(phi).u_z == Approx(amplitude * std::cos(n * phi)).margin(1e-14));
            CHECK(shift(phi).slope == Approx(-amplitude * n * std::sin(n * phi)).margin(1e-14));
        }
    }
    // design 3.4: -+0.18 mm on type-50, towards the bottom at the major axis
    surface::LinearAxialShift<wavegen::CosineCam> const shift(wavegen::CosineCam{type50_w0, 2}, type50_r_m, mode);
    CHECK(shift(0).u_z == Approx(-0.18).margin(0.005));
    CHECK(shift(pi / 2).u_z == Approx(0.18).margin(0.005));
}

TEST_CASE("axial shift of any cam leaves no shear between axis and circumference", "[axial]")
{
    surface::ConingMode const mode = type50_mode();
    for (std::string const name :
         {"type-50", "ellipse", "four-roller", "two-disc", "ring-on-cosine-cam", "cam-table"}) {
        wavegen::AnyWaveShape const shape = shape_of(name);
        surface::LinearAxialShift<wavegen::AnyWaveShape> const shift(shape, type50_r_m, mode);
        // V from w by Simpson's rule over one period, less its mean: another path than the program's series and panels
        double const period = 2 * pi / shape.waves();
        constexpr int panels = 4096;
        double const h = period / panels;
        std::vector<double> v(panels + 1, 0.0);
        double mean_w = 0;
        for (int i = 0; i < panels; ++i) {
            double const simpson = h / 6 * (shape(h * i).w + 4 * shape(h * (i + 0.5)).w + shape(h * (i + 1)).w);
            v[static_cast<std::size_t>(i) + 1] = v[static_cast<std::size_t>(i)] + simpson;
            mean_w += simpson / period;
        }
        double mean_v = 0;
        for (int i = 0; i <= panels; ++i) {
            v[static_cast<std::size_t>(i)] -= mean_w * h * i;
            mean_v += v[static_cast<std::size_t>(i)] * (i == 0 || i == panels ? 0.5 : 1.0) / panels;
        }
        double mean_u = 0, worst_shear = 0, worst_slope = 0, largest = 0;
        constexpr double z = 1.3, dz = 0.5;
        for (int i = 0; i < panels; ++i) {
            double const phi = h * i;
            double const dv_dz =
                -(mode.factor(z + dz) - mode.factor(z - dz)) / (2 * dz) * (v[static_cast<std::size_t>(i)] - mean_v);
            double const du_dphi = (shift(phi + h).u_z - shift(phi - h).u_z) / (2 * h);
            worst_shear = std::max(worst_shear, std::abs(dv_dz + shift(phi).slope / type50_r_m));
            worst_slope = std::max(worst_slope, std::abs(du_dphi - shift(phi).slope));
            largest = std::max(largest, std::abs(shift(phi).slope));
            mean_u += shift(phi).u_z / panels;
        }
        INFO(name << ": largest slope " << largest);
        CHECK(largest > 0.1);
        CHECK(worst_shear * type50_r_m < 1e-8 * largest);
        CHECK(worst_slope < 2e-6 * largest * shape.waves() * shape.waves());  // h^2/6 times the third derivative
        CHECK(std::abs(mean_u) < 1e-9);
        CHECK(shift(0.4 + 2 * pi).u_z == Approx(shift(0.4).u_z).margin(1e-13));
    }
}

TEST_CASE("points moved radially by nothing keep their bits and otherwise move by the distance", "[axial]")
{
    for (Vec2 const& p : {Vec2{0.1, 25.3}, Vec2{-0.29799, 25.02}, Vec2{1.0 / 3, 77.7}}) {
        CHECK(surface::moved_radially(p, 0) == p);
        for (double const distance : {0.01, -0.05, 1.0}) {
            Vec2 const q = surface::moved_radially(p, distance);
            CHECK(q.norm() == Approx(p.norm() + distance).epsilon(1e-15));
            CHECK(std::abs(cross(q, p)) < 1e-13);
        }
    }
}

TEST_CASE("normal of a curve moved radially is that of its moved points", "[axial]")
{
    auto const curve = [](double t) { return Vec2{0.3 * t + 0.02 * std::sin(5 * t), 25.2 - 0.4 * t * t}; };
    for (double const distance : {0.0, 0.1, -0.08, 5.0}) {
        for (double t = -1; t <= 1; t += 0.21) {
            constexpr double h = 1e-5;
            Vec2 const before = curve(t + h) - curve(t - h);
            Vec2 const after =
                surface::moved_radially(curve(t + h), distance) - surface::moved_radially(curve(t - h), distance);
            Vec2 const n = surface::normal_moved_radially(curve(t), left_of(before).normalized(), distance);
            INFO("distance " << distance << " t " << t);
            CHECK(n.norm() == Approx(1).epsilon(1e-15));
            CHECK((n - left_of(after).normalized()).norm() < 1e-9);
            if (std::abs(distance) > 1 && std::abs(t) > 0.3)
                CHECK((n - left_of(before).normalized()).norm() > 1e-3);
        }
    }
}

}  // namespace hdconj::test::axial_cases
