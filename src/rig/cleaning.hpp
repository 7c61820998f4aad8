// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a log before it says anything of a drive: coarse steps, stray readings and drift.
#pragma once

#include <optional>
#include <vector>

#include "branches.hpp"
#include "found.hpp"

namespace hdconj::rig {

/// Standard deviation of normal noise about zero by the upper quartile of its size, on which a fifth of strays has
/// little influence. The median would be zero for readings in coarse steps. Domain: not empty.
[[nodiscard]] double deviation_of(std::vector<double> values);

/// The smallest difference of two values; two that differ by less than 1e-9 of their range are one. Domain: not empty.
[[nodiscard]] double smallest_step(std::vector<double> values);

/// Standard deviation of rounding to @p step, step/sqrt(12), where all values lie on a lattice of that step; 0 else.
[[nodiscard]] double rounding_of(std::vector<double> const& values, double step);

/// Positions of the stray readings, ascending: those that leave the run of their neighbours in angle or torque.
///
/// Hampel's filter: a reading is compared with the median of the seven readings about it. It is a stray where it
/// differs by more than the sum of five standard deviations of the noise, three of its neighbours', and two steps of
/// the reading. The noise is what readings differ by from the middle of both neighbours, by the upper quartile, so that
/// strays do not widen it: on a steep stretch, where a reading is the median of its neighbours whatever its noise, as
/// well as where the angle rests. Of 1000 logs with normal noise fewer than 10 lose a reading. A jump from one side of
/// the backlash to the other is no stray, since half of the neighbours make it too. The three readings at either end
/// have no neighbours on one side and are kept.
[[nodiscard]] std::vector<std::size_t> stray_readings(MeasuredCurve const& curve);

/// The slope of the angle over time that all cycles share [rad per reading]; nothing where no part of the cycle is
/// repeated.
///
/// Each branch is compared with the next one of the same sense at the same torques: between samples of the earlier one
/// the angle is interpolated. The mean of the differences over their time is the drift. The first branch of a log
/// that begins without load is left out: it is the only one that does not come from the other side.
[[nodiscard]] std::optional<Found> drift_of(Samples const& samples, std::vector<LoadBranch> const& branches,
                                            double largest_torque);

}  // namespace hdconj::rig
