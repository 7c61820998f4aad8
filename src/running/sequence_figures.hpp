// SPDX-License-Identifier: GPL-3.0-or-later
// What the positions of a sequence come to, and how sure it is.
#pragma once

#include <optional>

#include "running_motion.hpp"
#include "span_plan.hpp"

namespace hdconj::running {

/// Enters orders, peak to peak, rms, and the figures of the torque. Errors are those of the positions: how peak to peak
/// and rms change at most where either half of them, every second one, is left out; of an order, what higher ones look
/// like it. Those of the torque are the differences of both of its ways, that of its mean also the difference from T/i.
/// @param drift  of the error over a span that does not repeat, taken out of the orders [rad]; nothing: it is not
/// known,
///               and there are no orders
void enter_figures(RunSequence& sequence, SpanPlan const& plan, RunningMotion const& motion,
                   std::optional<double> drift = 0.0);

/// Of fewer than three positions nothing is known: all figures and their errors are NaN.
void leave_undetermined(RunSequence& sequence);

}  // namespace hdconj::running
