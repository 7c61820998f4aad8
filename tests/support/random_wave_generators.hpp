// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Seeded random drives with a wave generator of one family, valid by the oracle's judgement.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "random_designs.hpp"
#include "support/oracle/touch.hpp"

namespace designs {

/// Random parameters of a family on a drive that was drawn for a cosine cam.
class WaveGeneratorDesigns
{
  public:
    WaveGeneratorDesigns(std::string family, std::uint64_t seed)
        : family_(std::move(family)), engine_(seed), drives_(seed)
    {
    }

    /// A drive with this wave generator; by the oracle's judgement alone the middle of its land stays unswept.
    Scene next(std::filesystem::path const& folder)
    {
        for (;;) {
            Scene scene = drives_.next();
            auto& generator = scene.wave_generator;
            double const w0 = std::get<double>(generator.shape.given.at("radial_deformation").value);
            if (family_ == "ellipse" ? generator.waves != 2
                                     : (family_ == "four-roller" || family_ == "two-disc") && generator.waves < 2)
                continue;
            hdconj::scene::FamilyChoice shape;
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
                    out << 360.0 * i / (n * rows) << ","
                        << 7 + w0 * (std::cos(x) + second * std::cos(2 * x) + skew * std::sin(2 * x)) << "\n";
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
        double const tip = tip_circle(scene);
        oracle::TouchScan scan(scene, 600);
        // the ring stays convex: curvature from the slope of the tangent's angle
        double const half = scan.motion.half_lobe();
        for (int i = -200; i < 200; ++i) {
            auto const a = scan.motion.pose(half * i / 200).along, b = scan.motion.pose(half * (i + 1) / 200).along;
            double const turn = std::atan2(a.x * b.y - a.y * b.x, oracle::dot(a, b));
            double const turned_back =
                scan.motion.turn_ratio * (scan.motion.phi(half * (i + 1) / 200) - scan.motion.phi(half * i / 200));
            if (!(turned_back - turn > 0.1 * half / 200))
                return false;
        }
        double const half_pitch = scan.motion.pitch() / 2;
        double const land = scan.nearest({tip * std::sin(half_pitch), tip * std::cos(half_pitch)}).distance;
        return land > scene.circular_spline.backlash_offset + 0.03 * m;
    }

    std::string family_;
    std::mt19937_64 engine_;
    RandomDesigns drives_;
    int tables_ = 0;
};

}  // namespace designs
