// SPDX-License-Identifier: GPL-3.0-or-later
// The deviations of flanks that a scene gives.
#pragma once

#include <optional>

#include "contact/flank_deviation.hpp"
#include "contact/flank_grid.hpp"
#include "contact/study/contact_context.hpp"

namespace hdconj::load {

/// Reliefs and errors of @p context in the planes of @p flanks; nothing where its scene has none.
///
/// Reliefs grow with the square of the distance from where they begin. The flank goes on smoothly there, so that the
/// relief makes no edge of its own.
[[nodiscard]] std::optional<contact::FlankDeviation> flank_deviation(contact::ContactContext const& context,
                                                                     contact::FlankGrid const& flanks);

}  // namespace hdconj::load
