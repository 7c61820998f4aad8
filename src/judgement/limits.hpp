// SPDX-License-Identifier: GPL-3.0-or-later
// Figures against their limits.
#pragma once

#include <optional>

#include "hdconj/judgement.hpp"

namespace hdconj::judgement {

/// The limits of @p code.
[[nodiscard]] DesignLimit const& limit_of(NoteCode code);

/// A note on @p figure with code, level, figure, limit and unit, which the caller completes; nothing where the figure
/// lies in its usual range.
[[nodiscard]] std::optional<Note> note_on(NoteCode code, double figure);
[[nodiscard]] std::optional<Note> note_on(DesignLimit const& limit, double figure);

}  // namespace hdconj::judgement
