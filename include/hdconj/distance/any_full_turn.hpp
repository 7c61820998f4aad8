// SPDX-License-Identifier: GPL-3.0-or-later
// Clearance of full turns under a motion of any model: compiled once, in the library.
#pragma once

#include "hdconj/distance/full_turn.hpp"
#include "hdconj/motion/any_motion.hpp"

namespace hdconj::distance {

extern template class ClearanceMarcher<motion::AnyMotion>;
extern template class ClearanceMarcher<motion::InverseMotion<motion::AnyMotion>>;
extern template class FullTurnClearance<motion::AnyMotion>;
extern template class ReverseFullTurnClearance<motion::AnyMotion>;

}  // namespace hdconj::distance
