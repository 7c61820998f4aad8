// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of flanks, teeth, sides and planes from the fits of the flanks, and the mean flank.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "flank_fit.hpp"
#include "intervals.hpp"

namespace hdconj::inspect {

/// A tooth with both flanks, and its outward shift.
struct ToothFit
{
    std::size_t left, right;                                     ///< indices of the fits
    double radial = 0;                                           ///< [mm]
    double radial_variance = 0;                                  ///< for noise of variance 1
    Eigen::RowVector2d by_middles = Eigen::RowVector2d::Zero();  ///< its change with a of the left, right parabola
};

/// What the registration makes of noise. Let S be the covariance of its unknowns, turn times reference radius and
/// shifts, for noise of variance 1. Of least squares they follow the points by -S J', J the derivatives of the
/// deviations without what CommonErrors explain. So the noise of a figure and that of the unknowns are not independent:
/// a figure that changes by g with the unknowns, and by h with what its own points have of J, has the variance
/// g S g' - 2 h S g' beside that of its own points.
struct RegistrationNoise
{
    static constexpr int size = 6;               ///< of (g, h)
    using Row = Eigen::Matrix<double, 1, size>;  ///< (g, h) of a figure
    Eigen::Matrix<double, size, size> covariance = Eigen::Matrix<double, size, size>::Zero();
    Eigen::Matrix<double, size, 3> explained = Eigen::Matrix<double, size, 3>::Zero();  ///< of J, by CommonErrors
    /// Change of the unknowns with the place of each fit's flank, an arc. Of least squares alone.
    Eigen::Matrix<double, 3, Eigen::Dynamic> by_places{};
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
    RegistrationNoise registration;

    [[nodiscard]] NominalPart const& part() const { return read.part(); }
    [[nodiscard]] double radius(FlankFit const& fit) const { return part().planes[fit.group.plane].reference_radius; }
    /// A shift of the measured part in the frame of a tooth.
    [[nodiscard]] Eigen::Matrix2d shift_of_tooth(int tooth) const;
    /// Rows of a, b and -c of a flank.
    [[nodiscard]] Eigen::Matrix<double, 3, RegistrationNoise::size> response(FlankFit const& fit) const;
    /// Rows of turn, b and -c of a flank.
    [[nodiscard]] Eigen::Matrix<double, 3, RegistrationNoise::size> by_registration(FlankFit const& fit) const
    {
        return fit.by_coefficients * response(fit);
    }
    /// What the registration adds to the variance of a figure.
    [[nodiscard]] double variance_of(RegistrationNoise::Row const& row) const
    {
        return row * registration.covariance * row.transpose();
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

/// The right flank of a symmetric tooth that is the mean of all flanks of the first plane, from tip to root. On the
/// circular spline that is the right wall of the mean tooth space.
///
/// The deviations of all flanks, each turned to its own position, are smoothed by a polynomial of least squares against
/// arc length: a parabola, or of the degree up to 5 whose highest term noise makes in fewer than one of 1000
/// measurements (Student). Waves that are shorter than about half a flank are left out with the noise. Beyond the
/// outermost points the parabola goes on that has value, slope and bend of the polynomial there. The flank is turned by
/// half the mean excess of the thickness. It is cut or continued straight at the heights at which the nominal one ends;
/// an end so nearly level that this would move it by more than 1/160 of the flank stays where it is, and what bends
/// back beyond the highest or the lowest point is left out. In NominalPart::frame.
/// @returns nothing where one side has no flank
[[nodiscard]] std::vector<Vec2> mean_flank(RingData const& data);

}  // namespace hdconj::inspect
