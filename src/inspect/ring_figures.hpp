// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of flanks, teeth, sides and planes from the fits of the flanks.
#pragma once

#include <Eigen/Core>
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
    /// Of the unknowns of the registration, turn times reference radius and shifts, for noise of variance 1. 0 where
    /// points share a registration so widely that their own noise is all.
    Eigen::Matrix3d registration = Eigen::Matrix3d::Zero();

    [[nodiscard]] NominalPart const& part() const { return read.part(); }
    [[nodiscard]] double radius(FlankFit const& fit) const { return part().planes[fit.group.plane].reference_radius; }
    /// A shift of the measured part in the frame of a tooth.
    [[nodiscard]] Eigen::Matrix2d shift_of_tooth(int tooth) const;
    /// Change of turn, b and -c of a flank with the unknowns of the registration.
    [[nodiscard]] Eigen::Matrix3d by_registration(FlankFit const& fit) const;
    /// Variance of what changes by @p row with the unknowns of the registration.
    [[nodiscard]] double variance_of(Eigen::RowVector3d const& row) const
    {
        return row * registration * row.transpose();
    }
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
