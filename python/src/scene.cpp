// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <utility>

#include "hdconj/read_scene.hpp"

namespace hdconj::python {
namespace {

std::string text_of(nanobind::bytes const& bytes)
{
    return {bytes.c_str(), bytes.size()};
}

}  // namespace

SceneHandle::SceneHandle(scene::SceneReading reading) : reading_(std::move(reading))
{
    examine_geometry(reading_);
    sort_by_place(reading_.faults);
}

SceneHandle SceneHandle::load(nanobind::bytes const& file)
{
    return SceneHandle(examine_scene_file(text_of(file)));
}

SceneHandle SceneHandle::parse(nanobind::bytes const& text, nanobind::bytes const& name, nanobind::bytes const& folder,
                               std::vector<nanobind::bytes> const& overrides)
{
    std::vector<std::string> changes;
    for (auto const& each : overrides)
        changes.push_back(text_of(each));
    return SceneHandle(examine_scene(text_of(text), text_of(name), text_of(folder), changes));
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
