// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold between values. The geometry of tooth and neutral curve is checked where it is built.
#include "cross_faults.hpp"

#include <algorithm>
#include <utility>

namespace hdconj::scene {
bool knows(SceneReading const& reading, std::initializer_list<std::string_view> paths)
{
    return std::all_of(paths.begin(), paths.end(),
                       [&reading](std::string_view path) { return reading.known.contains(path); });
}

Fault fault_at(std::string path, std::string value, std::string reason, std::string remedy)
{
    return {std::move(path), 0, std::move(value), std::move(reason), std::move(remedy)};
}

Faults cross_faults(SceneReading const& reading)
{
    Faults faults;
    add_pair_faults(reading, faults);
    add_cup_faults(reading, faults);
    add_axial_faults(reading, faults);
    if (reading.scene.wedm)
        add_wedm_faults(reading, faults);
    locate(faults, reading.scene);
    return faults;
}

}  // namespace hdconj::scene
