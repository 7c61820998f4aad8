// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of flanks, teeth, sides and planes from the fits of the flanks.
#pragma once

#include <vector>

#include "flank_fit.hpp"
#include "intervals.hpp"

namespace hdconj::inspect {

/// A tooth with both flanks, and its outward shift.
struct ToothFit
{
    std::size_t left, right;     ///< indices of the fits
    double radial = 0;           ///< [mm]
    double radial_variance = 0;  ///< for noise of variance 1
};

/// Everything that the figures are made of. Fits stand by plane, tooth, left before right.
struct RingData
{
    PointReader const& read;
    std::vector<PlanePoint> const& points;
    std::vector<double> const& z;  ///< of the planes
    Placement placement;
    std::vector<FlankFit> fits;
    std::vector<int> number;      ///< of the tooth of each fit
    std::vector<ToothFit> teeth;  ///< see tooth_fits()

    [[nodiscard]] NominalPart const& part() const { return read.part(); }
    [[nodiscard]] double radius(FlankFit const& fit) const { return part().planes[fit.group.plane].reference_radius; }
};

/// The teeth of @p data that have both flanks. Their outward shift is that of the shift in the plane which takes the
/// parabolas of both flanks through 0 at their middles.
[[nodiscard]] std::vector<ToothFit> tooth_fits(RingData const& data);

[[nodiscard]] std::vector<FlankFigures> flank_figures(RingData const& data, Intervals const& intervals);
[[nodiscard]] std::vector<ToothFigures> tooth_figures(RingData const& data, Intervals const& intervals);
[[nodiscard]] std::vector<SideFigures> side_figures(RingData const& data, std::vector<FlankFigures> const& flanks,
                                                    Intervals const& intervals);
[[nodiscard]] std::vector<PlaneFigures> plane_figures(RingData const& data, Intervals const& intervals);

}  // namespace hdconj::inspect
