// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Seeded first designs of people who know spur gears and the catalogue of harmonic drives, as TOML text: sizes of the
/// catalogue, habits of spur gears, and the mistakes that go with them.
#pragma once

#include <array>
#include <cmath>
#include <string>

#include "draws.hpp"

namespace designs {

/// One first design.
class Novice
{
  public:
    explicit Novice(unsigned seed) : draws_(seed) {}

    /// The whole scene.
    [[nodiscard]] std::string operator()()
    {
        choose_size();
        choose_teeth();
        std::string const profile = tooth();
        return "[drive]\nname = \"novice\"\n" + line("module", module_) + count("flexspline_teeth", z_f_) +
               count("circular_spline_teeth", z_c_) + "[flexspline]\n" + line("wall", wall()) + profile +
               "[wave_generator]\nfamily = \"cosine\"\n" + line("radial_deformation", deformation()) +
               count("waves", waves_) + "[circular_spline]\n" + tip_circle() + "[solver]\ntolerance = 1e-5\n";
    }

  private:
    template <class Value, std::size_t count>
    [[nodiscard]] Value one_of(std::array<Value, count> const& values)
    {
        return values[pick(count)];
    }
    [[nodiscard]] std::size_t pick(std::size_t count)
    {
        return static_cast<std::size_t>(draws_.whole(0, static_cast<int>(count) - 1));
    }
    [[nodiscard]] double between(double low, double high) { return draws_.between(low, high); }
    /// As a person writes it: three digits.
    [[nodiscard]] static double written(double value)
    {
        double const step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
        return std::round(value / step) * step;
    }
    [[nodiscard]] static std::string line(std::string const& key, double value)
    {
        return key + " = " + std::to_string(written(value)) + "\n";
    }
    [[nodiscard]] static std::string count(std::string const& key, int value)
    {
        return key + " = " + std::to_string(value) + "\n";
    }

    void choose_size()
    {
        // printed drives, then sizes 14 to 40 of the catalogues with their pitch diameters and ratios
        if (pick(3) == 0) {
            module_ = one_of(std::array{1.0, 1.0, 0.8, 0.5});
            z_f_ = one_of(std::array{60, 60, 80, 100});
        } else {
            z_f_ = 2 * one_of(std::array{30, 50, 80, 100, 120});
            module_ = written(one_of(std::array{35.0, 43.0, 51.0, 63.0, 82.0, 102.0}) / z_f_);
        }
    }
    void choose_teeth()
    {
        waves_ = pick(8) == 0 ? one_of(std::array{1, 3}) : 2;
        z_c_ = z_f_ + (pick(6) == 0 ? one_of(std::array{1, 3, 4, 4, 6}) : 2);
    }
    [[nodiscard]] double wall()
    {
        return pick(4) == 0 ? one_of(std::array{0.8, 1.0, 1.5}) : between(0.010, 0.018) * module_ * z_f_;
    }
    [[nodiscard]] double deformation()
    {
        double const usual = pick(3) == 0 ? module_ : module_ * (z_c_ - z_f_) / 2;
        return usual * (pick(2) == 0 ? 1.0 : one_of(std::array{0.1, 0.5, 0.7, 0.85, 1.15, 1.3, 2.0, 10.0}));
    }
    [[nodiscard]] std::string tip_circle()
    {
        double const pitch = module_ * z_c_ / 2;
        switch (pick(5)) {
            case 0:
                return line("inner_radius", pitch - module_);  // that of a spur gear
            case 1:
                return line("inner_radius", pitch - between(0.3, 0.9) * module_);
            default:
                return "";
        }
    }
    [[nodiscard]] std::string tooth()
    {
        std::string const table = "[flexspline.profile]\nfamily = ";
        double const m = module_;
        addendum_ = one_of(std::array{0.7, 0.8, 0.9, 1.0}) * m;
        std::string const heights =
            line("addendum", addendum_) + line("dedendum", one_of(std::array{1.0, 1.1, 1.25}) * m);
        switch (pick(6)) {
            case 0:
            case 1:
                return table + "\"straight\"\n" + heights + line("thickness", between(1.35, 1.65) * m) +
                       line("pressure_angle_deg", one_of(std::array{14.5, 20.0, 25.0, 28.6, 30.0}));
            case 2:
            case 3:
                return table + "\"involute\"\n" + heights + line("thickness", between(1.35, 1.65) * m) +
                       line("pressure_angle_deg", one_of(std::array{14.5, 20.0, 25.0, 28.6, 30.0}));
            case 4:
                return table + "\"s-tooth\"\n" + heights + line("thickness", between(1.4, 1.6) * m) +
                       line("pressure_angle_deg", one_of(std::array{8.0, 9.0, 12.0})) + "deflection = 1.0\n";
            default:
                return table + "\"double-circular-arc\"\n" + line("addendum", 0.9 * m) + line("dedendum", 1.212 * m) +
                       line("convex_radius", between(0.9, 1.2) * m) + line("convex_offset", between(0.3, 0.5) * m) +
                       line("concave_radius", between(1.8, 2.2) * m) + "concave_offset = \"tangent\"\n" +
                       line("concave_rise", between(0.2, 0.3) * m);
        }
    }

    Draws draws_;
    double module_ = 1, addendum_ = 1;
    int z_f_ = 60, z_c_ = 62, waves_ = 2;
};

}  // namespace designs
