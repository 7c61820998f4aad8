// SPDX-License-Identifier: GPL-3.0-or-later
#include "running_motion.hpp"

#include <algorithm>
#include <vector>

namespace hdconj::running {

contact::FlankDeviation gone_back(contact::FlankDeviation deviation, int pitches)
{
    auto const go_back = [pitches](std::vector<contact::Displacement>& ring) {
        if (ring.empty())
            return;
        auto const count = static_cast<int>(ring.size());
        std::rotate(ring.begin(), ring.begin() + (pitches % count + count) % count, ring.end());
    };
    go_back(deviation.teeth);
    go_back(deviation.spaces);
    return deviation;
}

}  // namespace hdconj::running
