// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The pictures of a wire program as gnuplot scripts; private to src/io.
#pragma once

#include "hdconj/wedm/wire_program.hpp"
#include "picture_script.hpp"

namespace hdconj {

/// One tooth space in both faces, the wire of every pass and its circles.
[[nodiscard]] std::string wire_tooth_script(WireProgram const& program, PictureFormat format);

/// The whole contour, the start hole and the leads.
[[nodiscard]] std::string wire_ring_script(WireProgram const& program, PictureFormat format);

/// Height of what the last pass leaves, around the part, of all set-ups. Needs residuals.
[[nodiscard]] std::string wire_residual_script(WireSetUps const& programs, PictureFormat format);

}  // namespace hdconj
