// SPDX-License-Identifier: GPL-3.0-or-later
// What the planes of a gap field leave open about the gaps between them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "gap_field.hpp"

namespace hdconj::contact {

/// One flank of one space at one turn.
struct OpenGap
{
    double lowest = 0;  ///< smallest gap in any plane, between the points too [mm]
    double second = 0;  ///< the same of every second plane [mm]
    double least = 0;   ///< estimated: no smaller than this between the planes either [mm]
    double lever = 0;   ///< how fast the gap changes there with the turn [mm/rad]
    double missed = 0;  ///< area of the patches within the limit that no plane shows [mm^2]
};

/// The flank @p flank of the spaces @p spaces at @p turn, in this order.
///
/// Between planes the smallest gap follows parabolas whose curvature the planes show (between_places()). Where one
/// falls below @p limit between two planes that are above it, a patch of contact may lie there: as wide as the parabola
/// is below the limit, as long as the flank in the nearer plane is within the same depth of its own smallest gap. The
/// lever is that of the normal at the smallest gap, no less than a twentieth of the radius. Same bits for any number of
/// threads.
[[nodiscard]] std::vector<OpenGap> open_gaps(GapField const& field, std::vector<std::size_t> const& spaces, int flank,
                                             double turn, double limit, int threads);

/// The gaps of some spaces at one turn, and what their planes leave open of them.
///
/// Surfaces that are straight between slices have gaps that are smooth in z, whose curvature the planes tell:
/// OpenGap::least. Planes that are solved anew have gaps that begin and end at zero, with bends there: for those, what
/// the second half of the planes has found within the limit of contact is taken twice again where that is less. And no
/// gap is smaller than a full turn has shown.
class OpenGaps
{
  public:
    /// @param level  gaps up to this count [mm]
    /// @param floor  known to be no more than any gap [mm]
    /// @param lobes  for so many lobes the spaces of one stand
    OpenGaps(std::vector<OpenGap> open, bool anew, double level, double floor, int lobes = 1) : open_(std::move(open))
    {
        double more = 0, parabolas = std::numeric_limits<double>::infinity();
        for (OpenGap const& each : open_) {
            lowest_ = std::min(lowest_, each.lowest);
            parabolas = std::min(parabolas, each.least);
            more = std::max(more, std::min(each.second, level) - std::min(each.lowest, level));
            missed_ = anew ? std::max(missed_, each.missed) : missed_ + lobes * each.missed;
        }
        least_ = std::min(lowest_, std::max({parabolas, anew ? lowest_ - 2 * more : parabolas, floor}));
        for (OpenGap const& each : open_)
            if (each.lowest <= level)
                lever_ = std::min(lever_, each.lever);
    }

    /// Estimated: no gap is smaller [mm].
    [[nodiscard]] double least() const { return least_; }
    /// How much enters, estimated [mm].
    [[nodiscard]] double enters() const { return std::max(0.0, -least_); }
    /// How far a turn to first contact here may be from the true one, with gaps known to @p off [rad].
    [[nodiscard]] double turn_error(double off) const { return open_.empty() ? 0 : (enters() + off) / lever_; }
    /// Area of contact that no plane may have met: the patches of all spaces together, or where bends are taken for
    /// them the largest [mm^2].
    [[nodiscard]] double missed() const { return missed_; }
    [[nodiscard]] std::vector<OpenGap> const& spaces() const { return open_; }

  private:
    std::vector<OpenGap> open_;
    double lowest_ = std::numeric_limits<double>::infinity(), least_ = lowest_, lever_ = lowest_;
    double missed_ = 0;
};

}  // namespace hdconj::contact
