// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What must hold before a wire program may reach a machine. Each throws NumericalError with place
/// and cause.
#pragma once

#include "post.hpp"

namespace hdconj::wedm {

/// The program itself: numbers finite and of the right sign, faces paired, every pass from and back to one vertical
/// wire at the start hole, offsets that are wire radius, gap and stock.
void check_program(WireProgram const& program);

/// A text: characters of its dialect, line lengths, printable ASCII.
void check_text(WirePost const& post, WireText const& file);

/// What was read back against what should be there: as many points, each as near as the last digit allows; equal faces
/// must be read as equal.
/// @return largest distance along the whole path in both faces [mm]
double check_paths(WirePost const& post, WireProgram const& program, std::vector<FacePath> const& read);

}  // namespace hdconj::wedm
