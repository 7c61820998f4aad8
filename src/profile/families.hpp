// SPDX-License-Identifier: GPL-3.0-or-later
// The tooth families: each stands in the source file of its name, a new one there and in two lists.
#pragma once

#include "hdconj/profile/builder.hpp"

namespace hdconj::profile {

/// What a scene may say of a family, and how its tooth is built.
struct Family
{
    scene::FamilyDescription description;
    Profile (*build)(scene::FamilyChoice const&, ToothPlace const&, Faults&);
};

[[nodiscard]] Family double_circular_arc();
[[nodiscard]] Family straight_sided();
[[nodiscard]] Family measured_points();
[[nodiscard]] Family b_spline();  ///< in measured_points.cpp
[[nodiscard]] Family involute();
[[nodiscard]] Family cycloid();
[[nodiscard]] Family s_tooth();
[[nodiscard]] Family arc_chain();
[[nodiscard]] Family bezier();

}  // namespace hdconj::profile
