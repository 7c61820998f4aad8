// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <utility>

#include "hdconj/read_scene.hpp"

namespace hdconj::python {

SceneHandle::SceneHandle(scene::SceneReading reading) : reading_(std::move(reading))
{
    examine_geometry(reading_);
    sort_by_place(reading_.faults);
}

SceneHandle SceneHandle::load(std::string const& file, std::vector<std::string> const& overrides)
{
    return SceneHandle(examine_scene_file(file, overrides));
}

SceneHandle SceneHandle::parse(std::string const& text, std::string const& name, std::string const& folder,
                               std::vector<std::string> const& overrides)
{
    return SceneHandle(examine_scene(text, name, folder, overrides));
}

Scene const& SceneHandle::sound() const
{
    refuse(reading_.faults);
    return reading_.scene;
}

void refuse(Faults const& faults)
{
    if (!faults.empty())
        throw InputError(faults);
}

}  // namespace hdconj::python
