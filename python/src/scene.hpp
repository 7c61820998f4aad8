// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as Python holds it: as far as it could be read, and its faults.
#pragma once

#include <string>
#include <vector>

#include <nanobind/nanobind.h>

#include "hdconj/scene/reading.hpp"

namespace hdconj::python {

class SceneHandle
{
  public:
    /// Reads @p file. Texts come as bytes, which need not be UTF-8.
    [[nodiscard]] static SceneHandle load(nanobind::bytes const& file);
    /// Reads @p text, called @p name, with the overrides of --set; relative file names start at @p folder.
    [[nodiscard]] static SceneHandle parse(nanobind::bytes const& text, nanobind::bytes const& name,
                                           nanobind::bytes const& folder,
                                           std::vector<nanobind::bytes> const& overrides);

    /// Every fault, in order of place.
    [[nodiscard]] Faults const& faults() const { return reading_.faults; }
    /// As far as it could be read.
    [[nodiscard]] Scene const& as_read() const { return reading_.scene; }
    /// Names of CSV files in it, by the paths of their keys.
    [[nodiscard]] auto const& file_names() const { return reading_.file_names; }
    /// @throws InputError where there are faults
    [[nodiscard]] Scene const& sound() const;

  private:
    explicit SceneHandle(scene::SceneReading reading);

    scene::SceneReading reading_;
};

/// @throws InputError where there are @p faults
void refuse(Faults const& faults);

}  // namespace hdconj::python
