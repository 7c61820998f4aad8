// SPDX-License-Identifier: GPL-3.0-or-later
// Means of a line load over a part of the face width.
#pragma once

#include <span>

namespace hdconj::load {

/// Largest mean of a function of z over an interval of the length @p width within [z.front(), z.back()]; over all of it
/// where it is shorter. Where the load is cut at an end it grows without bound with the number of slices; its mean
/// converges as the force does.
/// @param z       increasing [mm]
/// @param value   at z, linear between them; not negative
/// @param width   positive [mm]
/// Accuracy: exact where no more than one value lies within the interval of the largest mean, and else for intervals
/// that begin or end at one.
[[nodiscard]] double largest_mean(std::span<double const> z, std::span<double const> value, double width);

}  // namespace hdconj::load
