// SPDX-License-Identifier: GPL-3.0-or-later
// Which sequences of positions a running drive calls for.
#pragma once

#include <vector>

#include "run_scene.hpp"
#include "span_plan.hpp"

namespace hdconj::running {

/// A sequence to compute: first contacts, or balances.
struct PlannedSequence
{
    SpanPlan plan;
    bool under_torque = false;
};

/// Sequences that @p scene calls for: over a tooth pitch always; over a turn of the wave generator against a ring that
/// has errors; until both rings meet as before, first contacts only, where both have. A balance of the whole ring takes
/// seconds, a first contact milliseconds: of the latter a turn has more.
[[nodiscard]] std::vector<PlannedSequence> planned_sequences(Scene const& scene, RunTask const& task);

}  // namespace hdconj::running
