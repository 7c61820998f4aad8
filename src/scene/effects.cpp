// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/effects.hpp"

#include <string>

namespace hdconj {
namespace {

template <class Effect>
void refuse(Faults& faults, std::string const& table, Effect const& effect)
{
    if (effect) {
        faults.push_back({table, effect->line, "", "this version does not compute [" + table + "] yet",
                          "remove the table [" + table + "] to solve the base case", effect->line > 0 ? "" : "--set"});
    }
}

}  // namespace

Faults uncomputed_effects(Scene const& scene)
{
    Faults faults;
    refuse(faults, "coning", scene.coning);
    refuse(faults, "tilt", scene.tilt);
    refuse(faults, "slices", scene.slices);
    return faults;
}

}  // namespace hdconj
