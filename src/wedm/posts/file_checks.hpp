// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of a program before its files are written, of their texts, and of what is read back from them.
#pragma once

#include <vector>

#include "post.hpp"

namespace hdconj::wedm {

/// The program itself, so far as its numbers and the pairing of its points tell. @throws NumericalError
void check_program(WireProgram const& program);

/// A text: characters of its dialect, line lengths, printable ASCII. @throws NumericalError
void check_text(WirePost const& post, WireText const& file);

/// What was read back against what should be there: as many points, each as near as the last digit allows, the same
/// stops; equal faces must be read as equal.
/// @return largest distance along the whole path in both faces [mm] @throws NumericalError
double check_paths(WirePost const& post, WireProgram const& program, std::vector<FacePath> const& read);

}  // namespace hdconj::wedm
