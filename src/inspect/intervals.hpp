// SPDX-License-Identifier: GPL-3.0-or-later
// Intervals of figures from the noise of the points.
#pragma once

#include <cstddef>
#include <vector>

#include "hdconj/inspect.hpp"

namespace hdconj::inspect {

/// The noise of a point as estimated, and what of a figure's error does not come from it.
class Intervals
{
  public:
    /// @param squares      sum over the second differences, see noise_of()
    /// @param differences  how many there are, less the share that a fit has taken
    /// @param systematic   error of the nominal outline and of rounding, in every figure [mm]
    Intervals(double squares, double differences, double systematic);

    /// Standard deviation of a point [mm].
    [[nodiscard]] double noise() const { return noise_; }
    [[nodiscard]] double freedom() const { return freedom_; }
    [[nodiscard]] double systematic() const { return systematic_; }
    /// Half width of the 95 % interval of a figure of @p variance for noise of variance 1, by Student's distribution.
    /// NaN without an estimate of the noise.
    [[nodiscard]] double half_width(double variance) const { return half_width(variance, 1); }
    /// The same of the largest of @p rivals figures that may each be the largest: what it exceeds the true one by
    /// in 2.5 of 100 cases at most (Bonferroni).
    [[nodiscard]] double half_width(double variance, std::size_t rivals) const;
    /// The amplitude of a vector of two components, each of @p variance. Noise alone makes an amplitude, so that small
    /// ones have a wider interval: let a be what the amplitude of a zero vector stays below in 95 of 100 cases. Up to 2
    /// a the half width is a; beyond, it is that of the component along the vector.
    [[nodiscard]] Uncertain amplitude(double value, double variance) const;
    [[nodiscard]] Uncertain figure(double value, double variance) const { return {value, half_width(variance)}; }

  private:
    double noise_ = 0, freedom_ = 0, systematic_ = 0;
};

/// A figure and its variance for noise of variance 1, and whose it is.
struct Candidate
{
    double value = 0;
    double variance = 0;
    int tooth = 0;  ///< number
};

/// The largest of some figures. Those whose interval reaches that of the largest are its rivals.
struct LargestFigure
{
    Uncertain figure;
    int tooth = 0;
};
/// Domain: at least one candidate.
[[nodiscard]] LargestFigure largest_of(std::vector<Candidate> const& candidates, Intervals const& intervals);

/// LargestFigure less smallest of some figures; rivals are all pairs whose difference may be the largest.
struct FigureRange
{
    Uncertain figure;
    int from = 0;  ///< tooth of the smallest
    int to = 0;    ///< tooth of the largest
};
/// Domain: at least one candidate.
[[nodiscard]] FigureRange range_of(std::vector<Candidate> const& candidates, Intervals const& intervals);

/// The largest range of several groups, here flanks, and whose it is; rivals are the pairs of all groups whose
/// difference may be the largest. Domain: at least one group, and one candidate in each.
[[nodiscard]] LargestFigure largest_range_of(std::vector<std::vector<Candidate>> const& groups,
                                             Intervals const& intervals);

}  // namespace hdconj::inspect
