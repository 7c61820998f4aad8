// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/scene/effects.hpp"

namespace hdconj {

Faults uncomputed_effects(Scene const&)
{
    return {};
}

}  // namespace hdconj
