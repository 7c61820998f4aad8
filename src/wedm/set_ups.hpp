// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From the passes along one tooth space to the checked programs of all set-ups.
#pragma once

#include "pitch_pass.hpp"

namespace hdconj::wedm {

/// The program of one set-up, checked.
/// @throws NumericalError  a check failed: all failures in one message
[[nodiscard]] WireProgram set_up_program(WireJob const& job, std::vector<PitchPass> const& passes,
                                         WireSetUp const& set_up);

/// The two set-ups, half the spaces each, of a part that a wire around it would cut off. Errors as above.
[[nodiscard]] WireSetUps half_programs(WireJob const& job, std::vector<PitchPass> const& passes);

}  // namespace hdconj::wedm
