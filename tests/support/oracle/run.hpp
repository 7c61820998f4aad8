// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The only calls into the program that the oracle's tests make: text to scene, scene to solution.
#pragma once

#include <string>

#include "hdconj/read_scene.hpp"
#include "hdconj/solve.hpp"
#include "support/random_designs.hpp"

namespace oracle {

/// The scene as the program reads it.
inline hdconj::Scene as_read(hdconj::Scene const& scene)
{
    return hdconj::parse_scene(designs::toml_of(scene), "generated scene");
}

inline hdconj::Solution solved(hdconj::Scene const& scene)
{
    return hdconj::solve(as_read(scene));
}

inline hdconj::Scene type_50(hdconj::Kinematics kinematics = hdconj::Kinematics::exact)
{
    hdconj::Scene scene = hdconj::builtin_scene();
    scene.solver.kinematics = kinematics;
    return scene;
}

inline hdconj::Scene liu_2025(hdconj::Kinematics kinematics = hdconj::Kinematics::exact)
{
    hdconj::Scene scene = hdconj::read_scene(std::string(HDCONJ_SOURCE_DIR) + "/data/scenes/liu-2025.toml");
    scene.solver.kinematics = kinematics;
    return scene;
}

}  // namespace oracle
