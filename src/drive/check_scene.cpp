// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"
#include "elastic_cup.hpp"
#include "hdconj/check.hpp"

namespace hdconj {

Faults check_scene(Scene const& scene)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    wavegen::AnyWaveShape const shape = drive::wave_shape(scene, tooth, faults);
    if (tooth.pieces.empty() || !faults.empty())
        return faults;
    // without it there is no place to check the bearing at, and that it is missing is said elsewhere
    bool const placed = scene.coning && scene.coning->bottom_to_middle;
    if (scene.is_elastic() && placed)
        drive::validate_cup(scene, drive::ring_geometry(scene, tooth).flexspline_inner_radius, faults);
    else if (!scene.is_elastic())
        drive::validate_kinematics(scene, shape, faults);
    drive::validate_curvature(scene, tooth, shape, drive::ring_geometry(scene, tooth).r_m, faults);
    if (faults.empty())
        drive::validate_geometry(scene, tooth, drive::pair_geometry(scene, tooth, shape.amplitude()), faults);
    return faults;
}

}  // namespace hdconj
