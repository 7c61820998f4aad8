// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Seeded random drives of the reverse problem: a circular-spline tooth and the heights of the flexspline's.
///
/// A design is valid by the oracle's judgement alone: the given tooth is a tooth, either member's tips clear the
/// other's roots, and the middle of the flexspline's tip is not swept.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>

#include "random_designs.hpp"
#include "support/oracle/reverse_touch.hpp"

namespace designs {

/// The scene as TOML.
inline std::string reverse_toml_of(Scene const& scene)
{
    // the tooth is written where the forward problem has it, and then moved
    Scene forward = scene;
    forward.flexspline.profile = *scene.circular_spline.profile;
    std::string text = toml_of(forward);
    auto const replace = [&text](std::string const& from, std::string const& to) {
        text.replace(text.find(from), from.size(), to);
    };
    replace("[flexspline.profile]", "[circular_spline.profile]");
    replace("[flexspline]\n", "[flexspline]\naddendum = " + text_of(*scene.flexspline.addendum) +
                                  "\ndedendum = " + text_of(*scene.flexspline.dedendum) + "\n");
    replace("root_clearance = 0.0\n", "");
    return text;
}

class RandomReverseDesigns
{
  public:
    explicit RandomReverseDesigns(std::uint64_t seed) : draws_(seed) {}

    /// The next valid design.
    Scene next()
    {
        for (;;) {
            Scene const scene = draw();
            ++drawn;
            if (valid(scene))
                return scene;
        }
    }

    int drawn = 0;

  private:
    Scene draw()
    {
        Scene scene;
        scene.drive.name = "random reverse";
        double const w0 = draw_pair(draws_, scene), m = scene.drive.module;
        auto& profile = scene.circular_spline.profile.emplace();
        profile.path = "circular_spline.profile";
        auto const put = [&](char const* key, hdconj::scene::ParameterValue const& value) {
            profile.given[key] = {value, 0};
        };
        double const tallest = 0.95 * w0;
        double addendum = 0, dedendum = 0;
        if (draws_.chance(0.35)) {
            profile.family = "straight";
            addendum = std::min(m * draws_.between(0.4, 1.0), tallest);
            dedendum = addendum * draws_.between(1.1, 1.5);
            put("thickness", m * oracle::pi<double>() * draws_.between(0.35, 0.6));
            put("pressure_angle_deg", draws_.between(10, 35));
        } else {
            // the tooth of data/scenes/circular-spline-given.toml, scaled and disturbed
            double const scale = m / 0.25;
            auto const length = [&](double value, double share) { return scale * draws_.about(value, share); };
            profile.family = "double-circular-arc";
            addendum = std::min(length(0.2, 0.15), tallest);
            dedendum = std::max(length(0.29, 0.1), 1.05 * addendum);
            put("convex_radius", length(0.6, 0.1));
            put("convex_offset", length(0.366, 0.07));
            put("convex_rise", -length(0.15, 0.2));
            put("concave_radius", length(0.5, 0.1));
            put("concave_rise", length(0.052, 0.3));
            put("concave_offset", std::string("tangent"));
            if (draws_.chance(0.3))
                put("tip_line_from", addendum * draws_.between(0.55, 0.95));
        }
        put("addendum", addendum);
        put("dedendum", dedendum);
        scene.flexspline.addendum = std::min(dedendum * draws_.between(0.6, 0.95), tallest);
        scene.flexspline.dedendum = addendum * draws_.between(1.1, 1.6);
        draw_options(draws_, scene, *scene.flexspline.dedendum);
        if (draws_.chance(0.4))
            scene.solver.kinematics = hdconj::Kinematics::first_order;
        scene.solver.tolerance = 1e-6 * std::max(1.0, m);
        return scene;
    }

    static bool valid(Scene const& scene)
    {
        double const m = scene.drive.module;
        try {
            oracle::GivenTeeth<double> const teeth(scene);
            if (!is_gently_bent(teeth.motion) || !is_upright(teeth.tooth, m))
                return false;
            if (*scene.flexspline.dedendum < teeth.tooth.addendum + 0.02 * m ||
                *scene.flexspline.addendum > teeth.tooth.dedendum - 0.02 * m)
                return false;
            oracle::ReverseTouchScan scan(scene, 800);
            double const tip = scan.nearest({0, *scene.flexspline.addendum}).distance;
            return tip > scene.circular_spline.backlash_offset + 0.02 * m;
        } catch (std::exception const&) {
            return false;
        }
    }

    Draws draws_;
};

}  // namespace designs
