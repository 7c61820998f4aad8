// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"
#include "elastic_cup.hpp"
#include "hdconj/pipeline/solve.hpp"

namespace hdconj {

Faults check_scene(Scene const& scene)
{
    Faults faults;
    Profile const tooth = detail::given_tooth(scene, faults);
    AnyWaveShape const shape = detail::wave_shape(scene, tooth, faults);
    if (tooth.pieces.empty() || !faults.empty())
        return faults;
    // without it there is no place to judge the bearing at, and that it is missing is said elsewhere
    bool const placed = scene.coning && scene.coning->bottom_to_middle;
    if (scene.is_elastic() && placed)
        detail::judge_cup(scene, detail::ring_geometry(scene, tooth).flexspline_inner_radius, faults);
    else if (!scene.is_elastic())
        detail::judge_kinematics(scene, shape, faults);
    detail::judge_curvature(scene, tooth, shape, detail::ring_geometry(scene, tooth).r_m, faults);
    if (faults.empty())
        detail::judge_geometry(scene, tooth, detail::pair_geometry(scene, tooth, shape.amplitude()), faults);
    return faults;
}

}  // namespace hdconj
