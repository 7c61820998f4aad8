// SPDX-License-Identifier: GPL-3.0-or-later
// Where along an arc its chords must stand so that all have the same error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace hdconj::envelope {

/// How many chords of a wanted error an arc takes up to each of some stations along it. A chord's error is of second
/// order in its length. A cell between two stations whose chord has the error e therefore takes sqrt(e / wanted) of
/// them. Inside a cell their density is taken as linear.
///
/// Accuracy: the density's is of second order in the cells; chords placed by it differ in error by twice that.
class ChordMeasure
{
  public:
    /// @param stations  parameter of the arc, ascending, two or more
    /// @param errors    of the chords between them [mm]
    /// @param wanted    error of a chord [mm]
    ChordMeasure(std::vector<double> stations, std::span<double const> errors, double wanted)
        : stations_(std::move(stations)), chords_(stations_.size(), 0), density_(stations_.size())
    {
        for (std::size_t i = 1; i < stations_.size(); ++i)
            chords_[i] = chords_[i - 1] + std::sqrt(errors[i - 1] / wanted);
        for (std::size_t i = 0; i < stations_.size(); ++i) {
            std::size_t const low = i == 0 ? 0 : i - 1;
            std::size_t const high = std::min(i + 1, stations_.size() - 1);
            density_[i] = (chords_[high] - chords_[low]) / (stations_[high] - stations_[low]);
        }
    }

    /// Chords that the whole arc takes.
    [[nodiscard]] double total() const { return chords_.back(); }

    /// Stations @p first, @p first + 1, ... of those that cut the arc into @p count equal shares; 0 and @p count are
    /// its ends. No station depends on which others are asked for.
    void shares(std::size_t count, std::size_t first, std::span<double> result) const
    {
        auto const wanted_at = [&](std::size_t k) {
            return chords_.back() * static_cast<double>(k) / static_cast<double>(count);
        };
        auto const found = std::lower_bound(chords_.begin() + 1, chords_.end() - 1, wanted_at(first));
        auto cell = static_cast<std::size_t>(found - chords_.begin());
        for (std::size_t i = 0; i < result.size(); ++i) {
            double const wanted = wanted_at(first + i);
            while (cell + 1 < chords_.size() && chords_[cell] < wanted)
                ++cell;
            double const width = chords_[cell] - chords_[cell - 1];
            double const filled = width > 0 ? std::clamp((wanted - chords_[cell - 1]) / width, 0.0, 1.0) : 0.0;
            double const r0 = density_[cell - 1];
            double const r1 = density_[cell];
            double const half_full = filled * 0.5 * (r0 + r1);
            double const below = r0 + std::sqrt(std::max(0.0, r0 * r0 + 2 * (r1 - r0) * half_full));
            double const share = below > 0 ? std::clamp(2 * half_full / below, 0.0, 1.0) : filled;
            result[i] = stations_[cell - 1] + share * (stations_[cell] - stations_[cell - 1]);
        }
        if (first == 0 && !result.empty())
            result.front() = stations_.front();
        if (first + result.size() == count + 1)
            result.back() = stations_.back();
    }

  private:
    std::vector<double> stations_;
    std::vector<double> chords_;
    std::vector<double> density_;
};

}  // namespace hdconj::envelope
