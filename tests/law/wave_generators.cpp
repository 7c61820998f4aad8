// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The touch law for every wave generator family: the oracle has its own neutral curves, arc lengths and teeth.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <random>
#include <string>

#include "hdconj/numeric/error.hpp"
#include "support/catch.hpp"
#include "support/oracle/run.hpp"
#include "support/oracle/touch_law.hpp"
#include "support/temporary_folder.hpp"

using namespace oracle;
using hdconj::Scene;
using hdconj::Solution;

namespace {

/// Random parameters of a family on a drive that was drawn for a cosine cam.
class Draw
{
  public:
    Draw(std::string family, std::uint64_t seed) : family_(std::move(family)), engine_(seed), drives_(seed) {}

    /// A drive with this wave generator; by the oracle's judgement alone the middle of its land stays unswept.
    Scene next(std::filesystem::path const& folder)
    {
        for (;;) {
            Scene scene = drives_.next();
            auto& generator = scene.wave_generator;
            double const w0 = std::get<double>(generator.shape.given.at("radial_deformation").value);
            if (family_ == "ellipse" ? generator.waves != 2 : (family_ == "four-roller" || family_ == "two-disc") && generator.waves < 2)
                continue;
            hdconj::FamilyChoice shape;
            shape.family = family_;
            shape.path = generator.shape.path;
            auto const put = [&](char const* key, double value) { shape.given[key] = {value, 0}; };
            if (family_ != "table")
                put("radial_deformation", w0);
            if (family_ == "four-roller")
                put("roller_angle_deg", chance(0.15) ? 0.0 : between(10, 75.0 / generator.waves));
            if (family_ == "two-disc")
                put("wrap_angle_deg", between(16.0, 70.0) / generator.waves);
            if (family_ == "ring-on-cosine-cam")
                put("ring_thickness", scene.drive.module * between(1, 30));
            if (family_ == "table") {
                // a cosine with a little of its second harmonic, and in half of the cams of a skew one
                double const second = between(-0.02, 0.02), skew = chance(0.5) ? between(-0.02, 0.02) : 0;
                int const rows = 36 + static_cast<int>(between(0, 40)), n = generator.waves;
                std::string const name = "cam" + std::to_string(++tables_) + ".csv";
                std::ofstream out(folder / name);
                out.precision(17);
                out << "angle_deg,w_mm\n";
                for (int i = 0; i <= rows; ++i) {
                    double const x = 2 * std::numbers::pi * i / rows;
                    out << 360.0 * i / (n * rows) << "," << 7 + w0 * (std::cos(x) + second * std::cos(2 * x) + skew * std::sin(2 * x)) << "\n";
                }
                shape.given["file"] = {name, 0};
                scene.folder = folder;
            }
            generator.shape = shape;
            if (valid(scene))
                return scene;
        }
    }

  private:
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
    bool chance(double share) { return between(0, 1) < share; }

    static bool valid(Scene const& scene)
    {
        double const m = scene.drive.module;
        double const tip = designs::tip_circle(scene);
        TouchScan scan(scene, 600);
        // the ring stays convex: curvature from the slope of the tangent's angle
        double const half = scan.motion.half_lobe();
        for (int i = -200; i < 200; ++i) {
            auto const a = scan.motion.pose(half * i / 200).along, b = scan.motion.pose(half * (i + 1) / 200).along;
            double const turn = std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
            double const turned_back = scan.motion.turn_ratio * (scan.motion.phi(half * (i + 1) / 200) - scan.motion.phi(half * i / 200));
            if (!(turned_back - turn > 0.1 * half / 200))
                return false;
        }
        double const half_pitch = scan.motion.pitch() / 2;
        double const land = scan.nearest({tip * std::sin(half_pitch), tip * std::cos(half_pitch)}).distance;
        return land > scene.circular_spline.backlash_offset + 0.03 * m;
    }

    std::string family_;
    std::mt19937_64 engine_;
    designs::RandomDesigns drives_;
    int tables_ = 0;
};

void touch_law_holds(std::string const& family, std::uint64_t seed)
{
    hdconj::test::TemporaryFolder const folder;
    Draw draw(family, seed);
    std::size_t const most = full_run() ? static_cast<std::size_t>(-1) : 16;
    int const wanted = 100;
    int refused = 0;
    std::size_t points = 0;
    double worst = 0;
    for (int i = 0; i < wanted; ++i) {
        Scene const scene = draw.next(folder.path());
        INFO(designs::toml_of(scene));
        try {
            Solution const solution = hdconj::solve(hdconj::parse_scene(designs::toml_of(scene), "generated scene", folder.path()));
            TouchScan scan(solution.scene, 1200);
            auto const report = touch_law(solution, scan, most, static_cast<std::uint64_t>(i));
            INFO("touched: " << report.touched);
            INFO("entered: " << report.entered);
            CHECK(report.touched.deviation <= touch_limit);
            CHECK(report.entered.deviation <= touch_limit);
            worst = std::max({worst, report.touched.deviation, report.entered.deviation});
            points += report.entered.points;
        } catch (std::runtime_error const& error) {
            ++refused;
            std::cout << family << ", refused: " << error.what() << "\n" << designs::toml_of(scene) << "\n";
        }
    }
    std::cout << "touch law, " << family << ": " << wanted - refused << " designs, " << refused << " refused, " << points << " points, worst "
              << worst << " mm\n";
    CHECK(refused == 0);
}

}  // namespace

TEST_CASE("touch law: ellipse", "[touch][wavegen]")
{
    touch_law_holds("ellipse", 11);
}

TEST_CASE("touch law: rollers", "[touch][wavegen]")
{
    touch_law_holds("four-roller", 12);
}

TEST_CASE("touch law: discs", "[touch][wavegen]")
{
    touch_law_holds("two-disc", 13);
}

TEST_CASE("touch law: ring on a cosine cam", "[touch][wavegen]")
{
    touch_law_holds("ring-on-cosine-cam", 14);
}

TEST_CASE("touch law: cam from a table", "[touch][wavegen]")
{
    touch_law_holds("table", 15);
}
