// SPDX-License-Identifier: GPL-3.0-or-later
// Reliefs: how far flanks stand back from their nominal form.
#include <algorithm>
#include <string>

#include "base/text.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// Refuses an amount that makes another tooth of it.
void check_amount(SceneReading const& reading, std::string const& key, double amount, Faults& faults)
{
    constexpr double largest = 0.1;  // of the module
    double const module = reading.scene.drive.module;
    if (knows(reading, {key, "drive.module"}) && amount > largest * module)
        add_at(faults, key, number_text(amount), "a relief of more than a tenth of the module makes another tooth",
               "write at most " + at_most_text(largest * module) + ", such as " + number_text(0.016 * module));
}

}  // namespace

void add_relief_faults(SceneReading const& reading, Faults& faults)
{
    Scene const& scene = reading.scene;
    if (scene.tip_relief)
        check_amount(reading, "tip_relief.amount", scene.tip_relief->amount, faults);
    if (!scene.end_relief)
        return;
    check_amount(reading, "end_relief.amount", scene.end_relief->amount, faults);
    if (knows(reading, {"end_relief.length", "circular_spline.width"}) &&
        scene.end_relief->length > *scene.circular_spline.width / 2)
        add_at(faults, "end_relief.length", number_text(scene.end_relief->length),
               "the reliefs of both ends would overlap",
               "write at most " + at_most_text(*scene.circular_spline.width / 2) +
                   ", half the width of the circular spline");
}

}  // namespace hdconj::scene
