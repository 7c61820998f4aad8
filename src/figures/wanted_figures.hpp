// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a neutral curve that was wanted.
#pragma once

#include "figure_of.hpp"
#include "hdconj/wanted_curve.hpp"

namespace hdconj::figures {

/// Of the curve as a whole.
[[nodiscard]] Rows<WantedCurve> wanted_figures();
/// At one angle.
[[nodiscard]] Rows<WantedCurveRow> wanted_rows();

}  // namespace hdconj::figures
