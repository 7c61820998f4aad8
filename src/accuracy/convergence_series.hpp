// SPDX-License-Identifier: GPL-3.0-or-later
// From records to curves: medians, observed order, floors, and what to set for a wanted error or time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hdconj/accuracy.hpp"

namespace hdconj::accuracy {

/// Name of the series that take the worst design of the sample at every level.
inline constexpr char const* worst_of_sample = "worst of the sample";

/// Name of the knob that an error falls with exponentially.
inline constexpr char const* polynomial_degree = "degree";

/// One series for each study, method and knob of the scene itself, and one for the sample, in the order of the records.
[[nodiscard]] std::vector<ConvergenceSeries> convergence_series(AccuracyReport const& report);

/// A setting with what it was measured to cost and to reach.
struct Recommendation
{
    ConvergenceLevel level;
    bool reaches = false;                ///< whether it keeps what was asked; else it is the nearest that was measured
    double sample_error = not_measured;  ///< the worst of the sample with the same setting
};

/// The fastest setting of the whole program with an error of @p error [mm] or less in the three digits that are told,
/// on the scene and on the sample.
[[nodiscard]] std::optional<Recommendation> fastest_within(std::vector<ConvergenceSeries> const& series_list,
                                                           double error);

/// The most accurate setting of the whole program that takes @p seconds or less.
[[nodiscard]] std::optional<Recommendation> finest_within(std::vector<ConvergenceSeries> const& series_list,
                                                          double seconds);

/// Slope of log(error) against log(value) by least squares over the levels that stand above @p floor; not_measured with
/// fewer than three.
[[nodiscard]] double observed_order(std::vector<ConvergenceLevel> const& levels, double floor);

/// Why levels have no order though three or more stand above @p floor: their errors do not fall from each to the next,
/// by a twentieth at least; else empty.
[[nodiscard]] std::string why_no_order(std::vector<ConvergenceLevel> const& levels, double floor);

/// By how much the error falls for each step of a knob that it falls with exponentially, such as the degree of a
/// polynomial, and until which value of it.
struct ErrorPerStep
{
    double factor = 1;
    double until = 0;
};
/// From the first level to the best one; nothing where errors do not fall from each level between them to the next.
[[nodiscard]] std::optional<ErrorPerStep> error_per_step(std::vector<ConvergenceLevel> const& levels);

/// The error at which a series stays: the smallest, where the last two levels differ by less than a tenth; else
/// not_measured.
[[nodiscard]] double floor_of(std::vector<ConvergenceLevel> const& levels);

}  // namespace hdconj::accuracy
