// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/effects.hpp"

#include <string>

namespace hdconj {

Faults uncomputed_effects(Scene const& scene)
{
    Faults faults;
    if (scene.coning && scene.coning->model == "elastic") {
        faults.push_back({"coning.model", scene.coning->line, "\"elastic\"", "this version does not compute the elastic cup yet",
                          "write model = \"linear\" and bottom_to_middle, the distance from the cup's bottom",
                          scene.coning->line > 0 ? "" : "--set"});
    }
    return faults;
}

}  // namespace hdconj
