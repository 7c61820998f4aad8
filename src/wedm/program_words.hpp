// SPDX-License-Identifier: GPL-3.0-or-later
// What people read of a wire program, in files and summaries.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hdconj/wedm.hpp"

namespace hdconj::wedm {

/// What machine operators must see before they cut, one short line each: part, pass, wire and gap, planes, which face
/// is larger. @param pass  null: all of them
[[nodiscard]] std::vector<std::string> heading(WireProgram const& program, WirePass const* pass);

/// "SMALLER than the lower face", "LARGER ...", "as ...": of the upper face.
[[nodiscard]] std::string upper_face_words(WireFigures const& figures);

/// "set-up 1 of 2: 100 spaces from 0 clockwise, part turned 0 deg"
[[nodiscard]] std::string set_up_words(WireProgram const& program);

/// Word of a tag in files: "lead_in".
[[nodiscard]] std::string_view to_string(WireTag tag);

/// Estimated error of WireFigures::constant_taper_error: between its points, and by that of both contours and of what
/// the tip land moves [mm].
[[nodiscard]] inline double taper_known_to(WireProgram const& program, WireFigures const& figures)
{
    return figures.constant_taper_spread + 3 * program.contour_error;
}

}  // namespace hdconj::wedm
