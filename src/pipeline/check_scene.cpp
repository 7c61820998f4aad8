// SPDX-License-Identifier: GPL-3.0-or-later
#include "drive.hpp"
#include "hdconj/pipeline/solve.hpp"

namespace hdconj {

Faults check_scene(Scene const& scene)
{
    Faults faults;
    Profile const tooth = detail::flexspline_tooth(scene, faults);
    AnyWaveShape const shape = build_wave_shape(scene.wave_generator.shape, scene.wave_generator.waves, faults);
    if (tooth.pieces.empty() || !faults.empty())
        return faults;
    double const amplitude = std::visit([](auto const& s) { return s.amplitude(); }, shape);
    detail::judge_geometry(scene, tooth, detail::pair_geometry(scene, tooth, amplitude), faults);
    return faults;
}

}  // namespace hdconj
