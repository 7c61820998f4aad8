// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of a load that is known in slices, over a part of the face width.
#pragma once

#include <span>
#include <vector>

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

/// Largest value of a function of z over [@p from, @p to]. It converges with the number of slices as the function does,
/// which the largest value at the slices between both places does not where it falls or rises towards them.
/// @param z      increasing [mm]
/// @param value  at z, linear between them; not negative
/// @param from   within [z.front(), z.back()], no more than @p to, which is within them too [mm]
[[nodiscard]] double largest_between(std::span<double const> z, std::span<double const> value, double from, double to);

/// The part of the force of each slice that acts within @p width of either end of [z.front(), z.back()], where the line
/// load is linear between slices: the integral of the slice's hat function over both ends, over that of all of it. So
/// the force at the ends converges with the number of slices, wherever they stand.
/// @param z       increasing [mm]
/// @param width   not negative [mm]
/// @returns 1 everywhere where both ends meet, 0 for a single slice
[[nodiscard]] std::vector<double> shares_at_ends(std::span<double const> z, double width);

}  // namespace hdconj::load
