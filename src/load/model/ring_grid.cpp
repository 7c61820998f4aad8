// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_grid.hpp"

#include <numeric>

namespace hdconj::load {

RingGrid ring_grid(Scene const& scene)
{
    constexpr int fewest_angles = 96;  // of the wave generator's contact in one sector
    int const teeth = scene.drive.flexspline_teeth;
    int const lobes = std::gcd(teeth, scene.wave_generator.waves);
    int const sectors = scene.bearing && scene.bearing->balls ? std::gcd(lobes, *scene.bearing->balls) : lobes;
    int const per_sector = teeth / sectors;
    return {lobes, sectors, per_sector, (fewest_angles + per_sector - 1) / per_sector};
}

int highest_harmonic(RingGrid const& grid)
{
    return grid.angles() * grid.sectors / 2;
}

}  // namespace hdconj::load
