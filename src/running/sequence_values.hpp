// SPDX-License-Identifier: GPL-3.0-or-later
// Values at the positions of a sequence: spread, harmonics, sizes.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/running.hpp"
#include "spectrum.hpp"

namespace hdconj::running {

/// Peak to peak and root mean square about the mean.
struct Spread
{
    double peak_to_peak = 0, mean = 0, rms = 0;
};

/// Of no values: zeros.
[[nodiscard]] Spread spread_of(std::vector<double> const& values);

/// Harmonics of @p values at the positions of @p sequence.
/// @param per_input  periods in a turn of the wave generator
/// @param highest    order
[[nodiscard]] std::vector<Harmonic> harmonics_at_positions(RunSequence const& sequence,
                                                           std::vector<double> const& values, double per_input,
                                                           std::size_t highest);

/// How large each of @p values may be: no less than both neighbours, or the root mean square of all, since a single one
/// may be small by chance.
[[nodiscard]] std::vector<double> sizes_of(std::vector<double> const& values);

/// Adds @p error to that of an order's amplitude; its phase follows.
void add_amplitude_error(RunOrder& order, double error);

}  // namespace hdconj::running
