// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iterator>

#include "hdconj/check.hpp"
#include "hdconj/error.hpp"
#include "hdconj/read_scene.hpp"

namespace hdconj {
namespace {

/// An InputError on the way is a list of faults as well.
Faults geometry_faults(Scene const& scene)
{
    try {
        return check_scene(scene);
    } catch (InputError const& error) {
        return error.faults();
    }
}

}  // namespace

void examine_geometry(scene::SceneReading& reading)
{
    if (!reading.geometry_known)
        return;
    auto found = geometry_faults(reading.scene);
    scene::locate(found, reading.scene);
    std::erase_if(found, [&reading](Fault const& fault) {
        return std::any_of(reading.faults.begin(), reading.faults.end(),
                           [&fault](Fault const& other) { return other.path == fault.path; });
    });
    std::move(found.begin(), found.end(), std::back_inserter(reading.faults));
    sort_by_place(reading.faults);
}

}  // namespace hdconj
