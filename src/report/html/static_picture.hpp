// SPDX-License-Identifier: GPL-3.0-or-later
// The teeth at the major axis as a picture that needs no script.
#pragma once

#include <string>

#include "hdconj/report.hpp"

namespace hdconj::report {

/// SVG of some teeth about the major axis in the middle plane, the wave generator under them; empty without teeth in
/// mesh.
[[nodiscard]] std::string static_picture(ReportedDrive const& drive);

}  // namespace hdconj::report
