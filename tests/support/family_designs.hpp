// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Seeded random drives of one tooth family, valid by the oracle's judgement.
#pragma once

#include <fstream>
#include <string>

#include "random_designs.hpp"

namespace designs {

class FamilyDesigns
{
  public:
    /// @param folder  where family "points" writes its files
    FamilyDesigns(std::string family, std::uint64_t seed, std::filesystem::path folder = {})
        : family_(std::move(family)), folder_(std::move(folder)), draws_(seed)
    {
    }

    Scene next()
    {
        for (;;) {
            Scene const scene = draw();
            ++drawn;
            if (is_valid(scene))
                return scene;
        }
    }

    int drawn = 0;

  private:
    Scene draw()
    {
        Scene scene;
        scene.drive.name = family_;
        double const m = scene.drive.module = std::exp(draws_.between(std::log(0.1), std::log(2.0)));
        int const n = scene.wave_generator.waves = draws_.chance(0.7) ? 2 : draws_.chance(0.5) ? 1 : 3;
        int const difference = draws_.chance(0.75) ? n : 2 * n;
        scene.drive.flexspline_teeth = draws_.whole(60, 320);
        scene.drive.circular_spline_teeth = scene.drive.flexspline_teeth + difference;
        rolling_ = m * difference / 2;
        w0_ = rolling_ * draws_.between(0.75, 1.15);
        scene.wave_generator.shape.family = "cosine";
        scene.wave_generator.shape.given["radial_deformation"] = {w0_, 0};
        scene.flexspline.wall = m * draws_.between(0.5, 3);
        scene.flexspline.profile.family = family_;
        scene.folder = folder_;
        tooth(scene, m, n);
        if (draws_.chance(0.3))
            scene.flexspline.neutral_offset = scene.flexspline.wall * draws_.between(-0.2, 0.3);
        if (draws_.chance(0.25))
            scene.circular_spline.backlash_offset = m * draws_.between(0, 0.03);
        if (draws_.chance(0.3))
            scene.solver.kinematics = hdconj::Kinematics::first_order;
        scene.solver.tolerance = 1e-6 * std::max(1.0, m);
        return scene;
    }

    void tooth(Scene& scene, double m, int n)
    {
        auto& given = scene.flexspline.profile.given;
        auto const put = [&](char const* key, hdconj::scene::ParameterValue value) {
            given[key] = {std::move(value), 0};
        };
        double const pi = oracle::pi<double>();
        double const addendum = std::min(m * draws_.between(0.4, 0.95), 0.95 * w0_);
        double const dedendum = addendum * draws_.between(1.1, 1.5);
        double const thickness = m * pi * draws_.between(0.4, 0.58);
        bool const of_points = family_ == "points" || family_ == "b-spline" || family_ == "bezier";
        if (!of_points) {
            put("addendum", addendum);
            put("dedendum", dedendum);
        }
        if (family_ == "straight") {
            put("thickness", thickness);
            put("pressure_angle_deg", draws_.between(10, 35));
        } else if (family_ == "involute") {
            if (draws_.chance(0.8))
                put("thickness", thickness);
            put("pressure_angle_deg", draws_.chance(0.2) ? draws_.between(3, 12) : draws_.between(12, 32));
        } else if (family_ == "cycloid") {
            put("thickness", thickness);
            put("addendum_rolling_radius", addendum * draws_.between(0.65, 1.2));
            put("dedendum_rolling_radius", dedendum * draws_.between(0.65, 1.5));
        } else if (family_ == "s-tooth") {
            double const kappa = w0_ / rolling_ * (draws_.chance(0.5) ? 1.0 : draws_.between(0.95, 1.05));
            double const least = kappa < 1 ? std::atan(std::sqrt(1 - kappa * kappa) / (n * kappa)) * 180 / pi : 0;
            put("deflection", kappa);
            if (kappa > 0.97 || draws_.chance(0.5))
                put("pressure_angle_deg", std::max(least * 1.02, 3.0) + draws_.between(0, 8));
            if (draws_.chance(0.8))
                put("thickness", thickness);
            if (draws_.chance(0.3))
                put("datum_rise", addendum * draws_.between(0, 0.3));
        } else if (family_ == "arc-chain") {
            put("tip_thickness", m * draws_.between(0.15, 0.7));
            double left = draws_.between(25, 50);
            put("tip_angle_deg", left);
            hdconj::scene::NumberRows rows;
            if (draws_.chance(0.2))
                rows.push_back({m * draws_.between(0.01, 0.1)});
            for (int i = draws_.whole(1, 3); i > 0; --i) {
                double const sweep = left * draws_.between(0.2, 0.6);
                rows.push_back({m * draws_.between(0.4, 2.0), sweep});
                left -= sweep;
            }
            if (draws_.chance(0.5))
                rows.push_back({m * draws_.between(0.01, 0.3)});
            rows.push_back({-m * draws_.between(1, 3), 85.0 - left});
            put("pieces", rows);
        } else if (family_ == "bezier") {
            double const tip = m * draws_.between(0.1, 0.35), mid = thickness / 2,
                         root = std::min(mid + dedendum * draws_.between(0.2, 0.6), 0.48 * pi * m);
            hdconj::scene::NumberRows rows{{tip, addendum},
                                           {mid * draws_.between(0.7, 0.95), addendum * draws_.between(0.4, 0.7)},
                                           {mid * draws_.between(0.8, 1.05), -dedendum * draws_.between(0.0, 0.5)},
                                           {root, -dedendum}};
            if (draws_.chance(0.5))
                rows.insert(rows.begin() + 2, {mid * draws_.between(0.85, 1.0), addendum * draws_.between(-0.1, 0.3)});
            put("points", rows);
        } else {
            put_points(scene, m, addendum, dedendum, thickness);
        }
    }

    /// A flank from a smooth function, its points displaced by at most 0.2 % of the module.
    void put_points(Scene& scene, double m, double addendum, double dedendum, double thickness)
    {
        int const count = draws_.whole(5, 12);
        double const lean = std::tan(draws_.between(5, 20) * oracle::pi<double>() / 180),
                     head = draws_.between(0.0, 0.5) / m, foot = draws_.between(0.0, 0.4) / m;
        hdconj::scene::NumberRows rows;
        for (int i = 0; i < count; ++i) {
            double const y = addendum - (addendum + dedendum) * i / (count - 1);
            double const x = thickness / 2 - lean * y - (y > 0 ? head * y * y : -foot * y * y);
            rows.push_back({x + m * draws_.between(-0.002, 0.002), y});
        }
        auto& given = scene.flexspline.profile.given;
        if (family_ == "b-spline") {
            given["points"] = {rows, 0};
            return;
        }
        std::string const name = "flank-" + std::to_string(drawn) + ".csv";
        std::ofstream file(folder_ / name);
        for (auto const& row : rows)
            file << text_of(row[0]) << "," << text_of(row[1]) << "\n";
        given["file"] = {name, 0};
    }

    std::string family_;
    std::filesystem::path folder_;
    Draws draws_;
    double rolling_ = 0, w0_ = 0;
};

}  // namespace designs
