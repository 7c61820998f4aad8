// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/distance/any_full_turn.hpp"

namespace hdconj::distance {

template class ClearanceMarcher<motion::AnyMotion>;
template class ClearanceMarcher<motion::InverseMotion<motion::AnyMotion>>;
template class FullTurnClearance<motion::AnyMotion>;
template class ReverseFullTurnClearance<motion::AnyMotion>;

}  // namespace hdconj::distance
