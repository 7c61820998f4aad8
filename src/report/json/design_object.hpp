// SPDX-License-Identifier: GPL-3.0-or-later
// A design as an object that summary and page share.
#pragma once

#include "hdconj/design.hpp"
#include "summary_object.hpp"

namespace hdconj::report {

/// Rows, trials, remarks and differences; keys in docs/reference/json.md.
[[nodiscard]] Json design_object(Design const& design);

/// The same of a drive beside its design: each row with its texts, the drive's own value and where it stands; and what
/// the wishes were taken from.
[[nodiscard]] Json beside_object(SceneDesign const& made);

}  // namespace hdconj::report
