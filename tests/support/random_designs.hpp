// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Seeded random drives as TOML text, and scenes changed as data (scaled, other kinematics).
///
/// A design is valid by the oracle's judgement alone: the tooth is a tooth, and the middle of the
/// circular spline's land is not swept. A solver that refuses such a design has to say why, and the
/// share of refusals is tested.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>

#include "hdconj/scene.hpp"
#include "random_pairs.hpp"
#include "support/oracle/touch.hpp"

namespace designs {

/// Shortest text that reads back as the same number.
inline std::string text_of(double value)
{
    for (int digits = 1; digits < 17; ++digits) {
        char text[64];
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (std::stod(text) == value) {
            std::string const found = text;
            // A TOML float has a fraction or an exponent.
            return found.find_first_of(".e") == std::string::npos ? found + ".0" : found;
        }
    }
    char text[64];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

/// A list of lists of numbers, one row a line.
inline std::string text_of(hdconj::scene::NumberRows const& rows)
{
    std::string text = "[\n";
    for (auto const& row : rows) {
        text += "  [";
        for (std::size_t i = 0; i < row.size(); ++i)
            text += (i > 0 ? ", " : "") + text_of(row[i]);
        text += "],\n";
    }
    return text + "]";
}

/// The scene as TOML.
inline std::string toml_of(Scene const& scene)
{
    std::string text;
    auto const line = [&](std::string const& key, std::string const& value) { text += key + " = " + value + "\n"; };
    auto const family = [&](hdconj::scene::FamilyChoice const& choice) {
        line("family", "\"" + choice.family + "\"");
        for (auto const& [key, parameter] : choice.given) {
            if (auto const* word = std::get_if<std::string>(&parameter.value))
                line(key, "\"" + *word + "\"");
            else if (auto const* rows = std::get_if<hdconj::scene::NumberRows>(&parameter.value))
                line(key, text_of(*rows));
            else if (key == "degree")
                line(key, std::to_string(static_cast<int>(std::get<double>(parameter.value))));
            else
                line(key, text_of(std::get<double>(parameter.value)));
        }
    };
    text += "[drive]\n";
    line("name", "\"" + scene.drive.name + "\"");
    line("module", text_of(scene.drive.module));
    line("flexspline_teeth", std::to_string(scene.drive.flexspline_teeth));
    line("circular_spline_teeth", std::to_string(scene.drive.circular_spline_teeth));
    text += "[flexspline]\n";
    line("wall", text_of(scene.flexspline.wall));
    if (scene.flexspline.inner_radius)
        line("inner_radius", text_of(*scene.flexspline.inner_radius));
    if (scene.flexspline.neutral_offset != 0)
        line("neutral_offset", text_of(scene.flexspline.neutral_offset));
    text += "[flexspline.profile]\n";
    family(scene.flexspline.profile);
    text += "[wave_generator]\n";
    family(scene.wave_generator.shape);
    line("waves", std::to_string(scene.wave_generator.waves));
    text += "[circular_spline]\n";
    line("backlash_offset", text_of(scene.circular_spline.backlash_offset));
    line("root_clearance", text_of(scene.circular_spline.root_clearance));
    if (scene.circular_spline.inner_radius)
        line("inner_radius", text_of(*scene.circular_spline.inner_radius));
    text += "[solver]\n";
    line("kinematics", "\"" + std::string(hdconj::to_string(scene.solver.kinematics)) + "\"");
    line("tolerance", text_of(scene.solver.tolerance));
    line("threads", std::to_string(scene.solver.threads));
    return text;
}

/// Every length of the scene times @p factor.
inline Scene scaled(Scene scene, double factor)
{
    scene.drive.module *= factor;
    scene.flexspline.wall *= factor;
    scene.flexspline.neutral_offset *= factor;
    if (scene.flexspline.inner_radius)
        *scene.flexspline.inner_radius *= factor;
    for (auto* choice : {&scene.flexspline.profile, &scene.wave_generator.shape})
        for (auto& [key, parameter] : choice->given)
            if (auto* number = std::get_if<double>(&parameter.value))
                *number *= key.ends_with("_deg") || key == "deflection" || key == "degree" ? 1 : factor;
            else if (auto* rows = std::get_if<hdconj::scene::NumberRows>(&parameter.value))
                for (auto& row : *rows)
                    for (std::size_t i = 0; i < row.size(); ++i)
                        row[i] *= key == "pieces" && i == 1 ? 1 : factor;
    if (scene.circular_spline.width)
        *scene.circular_spline.width *= factor;
    scene.circular_spline.backlash_offset *= factor;
    scene.circular_spline.root_clearance *= factor;
    if (scene.circular_spline.inner_radius)
        *scene.circular_spline.inner_radius *= factor;
    scene.solver.tolerance *= factor;
    return scene;
}

/// Radius of the circular spline's tip circle.
inline double tip_circle(Scene const& scene)
{
    if (scene.circular_spline.inner_radius)
        return *scene.circular_spline.inner_radius;
    oracle::Tooth<double> const tooth(scene);
    oracle::Motion<double> const motion(scene);
    return motion.r_m + tooth.pitch_line - scene.flexspline.neutral_offset + scene.flexspline.neutral_offset +
           motion.w0 - tooth.addendum;
}

[[nodiscard]] inline bool is_valid(Scene const& scene);

class RandomDesigns
{
  public:
    explicit RandomDesigns(std::uint64_t seed) : draws_(seed) {}

    /// The next valid design.
    Scene next()
    {
        for (;;) {
            Scene const scene = draw();
            ++drawn;
            if (is_valid(scene))
                return scene;
        }
    }

    int drawn = 0;  ///< designs drawn so far, valid or not

  private:
    Scene draw()
    {
        Scene scene;
        scene.drive.name = "random";
        double const w0 = draw_pair(draws_, scene), m = scene.drive.module;
        auto& profile = scene.flexspline.profile;
        auto const put = [&](char const* key, hdconj::scene::ParameterValue const& value) {
            profile.given[key] = {value, 0};
        };
        double const tallest = 0.95 * w0;
        double dedendum = 0;
        if (draws_.chance(0.3)) {
            profile.family = "straight";
            double const addendum = std::min(m * draws_.between(0.4, 1.0), tallest);
            dedendum = addendum * draws_.between(1.1, 1.5);
            put("addendum", addendum);
            put("dedendum", dedendum);
            put("thickness", m * oracle::pi<double>() * draws_.between(0.35, 0.6));
            put("pressure_angle_deg", draws_.between(10, 35));
        } else {
            // type-50 or Liu's set, scaled to the module and disturbed.
            bool const liu = draws_.chance(0.5);
            double const scale = m / (liu ? 0.5 : 0.25);
            auto const length = [&](double from_type_50, double from_liu, double share) {
                return scale * draws_.about(liu ? from_liu : from_type_50, share);
            };
            profile.family = "double-circular-arc";
            double const addendum = std::min(length(0.2250, 0.29316387, 0.15), tallest);
            dedendum = std::max(length(0.3030, 0.35425825, 0.15), 1.05 * addendum);
            put("addendum", addendum);
            put("dedendum", dedendum);
            double const ra = length(0.2701, 0.68517449, 0.15), rf = length(0.5145, 0.78482551, 0.15);
            double const offset = length(0.0982, 0.33183981, 0.1);
            double const convex_rise = length(0, -0.15535155, 0.2), rise = length(0.0671, 0.13439061, 0.2);
            put("convex_radius", ra);
            put("convex_offset", offset);
            if (convex_rise != 0)
                put("convex_rise", convex_rise);
            put("concave_radius", rf);
            put("concave_rise", rise);
            if (draws_.chance(0.5))
                put("concave_offset", std::string("tangent"));
            else {
                double const line = m * draws_.between(0.01, 0.4);
                put("concave_offset",
                    std::sqrt((ra + rf) * (ra + rf) + line * line - (rise - convex_rise) * (rise - convex_rise)) -
                        offset);
            }
            if (draws_.chance(0.5))
                put("tip_line_from", addendum * draws_.between(0.55, 0.95));
        }
        draw_options(draws_, scene, dedendum);
        if (draws_.chance(0.15))
            scene.circular_spline.root_clearance = m * draws_.between(0, 0.2);
        if (draws_.chance(0.4))
            scene.solver.kinematics = hdconj::Kinematics::first_order;
        if (draws_.chance(0.2))
            scene.circular_spline.inner_radius = tip_circle(scene) + m * draws_.between(0, 0.15);
        scene.solver.tolerance = 1e-6 * std::max(1.0, m);
        return scene;
    }

    Draws draws_;
};

/// Whether the oracle takes the design for a drive: the tooth is a tooth, and the middle of the land is not swept.
inline bool is_valid(Scene const& scene)
{
    double const m = scene.drive.module;
    try {
        oracle::Tooth<double> const tooth(scene);
        oracle::Motion<double> const motion(scene);
        if (!is_gently_bent(motion) || !is_upright(tooth, m))
            return false;
        // A formula that does not come up to the tip, or down to the root.
        if (!(std::abs(tooth.tip_corner().y - tooth.addendum) < 1e-9 * m) ||
            !(std::abs(tooth.root().y + tooth.dedendum) < 1e-9 * m))
            return false;
        // The middle of the land must stay.
        double const tip = tip_circle(scene), half_pitch = motion.pitch() / 2;
        oracle::TouchScan scan(scene, 1200);
        double const land = scan.nearest({tip * std::sin(half_pitch), tip * std::cos(half_pitch)}).distance;
        return land > scene.circular_spline.backlash_offset + 0.02 * m;
    } catch (std::exception const&) {
        return false;
    }
}

}  // namespace designs
