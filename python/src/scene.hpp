// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as Python holds it: as far as it could be read, and its faults.
#pragma once

#include <string>
#include <vector>

#include "hdconj/scene/reading.hpp"

namespace hdconj::python {

class SceneHandle
{
  public:
    /// Reads @p file with the overrides of --set.
    [[nodiscard]] static SceneHandle load(std::string const& file, std::vector<std::string> const& overrides);
    /// Reads @p text, called @p name; relative file names start at @p folder.
    [[nodiscard]] static SceneHandle parse(std::string const& text, std::string const& name, std::string const& folder,
                                           std::vector<std::string> const& overrides);

    /// Every fault, in order of place.
    [[nodiscard]] Faults const& faults() const { return reading_.faults; }
    /// As far as it could be read.
    [[nodiscard]] Scene const& as_read() const { return reading_.scene; }
    /// @throws InputError where there are faults
    [[nodiscard]] Scene const& sound() const;

  private:
    explicit SceneHandle(scene::SceneReading reading);

    scene::SceneReading reading_;
};

/// @throws InputError where there are @p faults
void refuse(Faults const& faults);

}  // namespace hdconj::python
