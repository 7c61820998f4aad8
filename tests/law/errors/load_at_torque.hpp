// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The built-in drive at one torque, small enough that a torque of the whole ring takes a second.
#pragma once

#include <string>
#include <vector>

#include "hdconj/load.hpp"
#include "hdconj/read_scene.hpp"
#include "hdconj/units.hpp"
#include "support/catch.hpp"

namespace hdconj::test {

/// Few slices, points and harmonics, no estimates of the figures' errors. The bearing presses at twice as many even
/// angles as there are harmonics: with 50 at every second tooth, a grid that is its own mirror image.
inline LoadStudy load_at_torque(double torque, std::vector<std::string> const& more = {})
{
    std::vector<std::string> keys{"slices.count=3", "contact.flank_points=80", "circular_spline.backlash_offset=0.09",
                                  "bearing.circles=5", "load.harmonics=50"};
    keys.insert(keys.end(), more.begin(), more.end());
    LoadOptions options;
    options.torque = torque * newton_metre;
    options.curve = options.errors = false;
    return study_load(builtin_scene(keys), options);
}

/// The same drive without errors at 15 N m.
inline LoadStudy const& plain_load()
{
    static LoadStudy const study = load_at_torque(15);
    return study;
}

inline LoadedState const& only_state(LoadStudy const& study)
{
    return study.cases.front().curve.front();
}

inline void check_same_state(LoadedState const& a, LoadedState const& b, double same = 1e-4)
{
    CHECK(a.twist == Approx(b.twist).epsilon(same));
    CHECK(a.largest_force == Approx(b.largest_force).epsilon(10 * same));
    CHECK(a.wave_generator_force == Approx(b.wave_generator_force).epsilon(same));
    CHECK(a.wave_generator_torque == Approx(b.wave_generator_torque).epsilon(10 * same));
    CHECK(a.teeth == b.teeth);
}

/// A list as it stands in a scene: "[1, 2]".
inline std::string scene_list(std::vector<double> const& numbers)
{
    std::string text;
    for (double const each : numbers)
        text += (text.empty() ? "[" : ", ") + std::to_string(each);
    return text + "]";
}

}  // namespace hdconj::test
