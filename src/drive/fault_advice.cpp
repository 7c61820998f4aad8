// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_advice.hpp"

#include "scene/usual_drive.hpp"

namespace hdconj::drive {

void say_likely_cause(Scene const& scene, double w0, bool geometric, Faults& faults)
{
    if (faults.empty())
        return;
    Fault& first = faults.front();
    auto const unusual = scene::unusual_deformation(scene.drive, w0);
    scene::Advice usual = scene::usual_pair(scene, w0);
    if (!unusual || usual.set.empty())
        usual = {};
    else if (geometric)
        first.reason = *unusual + ", and so " + first.reason;
    if (!usual.set.empty() && geometric) {
        first.remedy = "write " + usual.words + "; with this deformation " + first.remedy;
        first.set.clear();
    }
    scene::add_pressure_angle(scene, usual);
    if (!usual.set.empty() && !geometric)
        first.remedy += "; usual is " + usual.words;
    first.set.insert(first.set.end(), usual.set.begin(), usual.set.end());
}

}  // namespace hdconj::drive
