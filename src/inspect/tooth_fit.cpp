// SPDX-License-Identifier: GPL-3.0-or-later
// Teeth of both flanks, and what a registration does to their fits.
#include <Eigen/LU>

#include "hdconj/base/rigid_motion.hpp"
#include "ring_figures.hpp"

namespace hdconj::inspect {
namespace {

/// Completes @p tooth. @returns whether its parabolas can be taken through 0
bool find_radial_shift(RingData const& data, ToothFit& tooth)
{
    FlankGroup const &left_group = data.fits[tooth.left].group, &right_group = data.fits[tooth.right].group;
    constexpr int most_steps = 60;
    double const rounding = data.part().tolerance().roundoff();
    Placement at = data.placement;
    Vec2 shift = Vec2::Zero();
    for (int step = 0; step < most_steps; ++step) {
        auto const left = flank_parabola(data.read, data.points, left_group, at);
        auto const right = flank_parabola(data.read, data.points, right_group, at);
        if (!left || !right)
            return false;
        Eigen::Matrix2d slopes;
        slopes << left->by_shift.row(0), right->by_shift.row(0);
        Eigen::Matrix2d const inverse = slopes.inverse();
        Vec2 const by = -inverse * Vec2(left->coefficient[0], right->coefficient[0]);
        if (!by.allFinite())
            return false;
        shift += by;
        at.shift =
            data.placement.shift + turned_clockwise(data.read.from_tooth(shift, left_group.tooth), data.placement.turn);
        if (by.norm() <= rounding || step + 1 == most_steps) {
            tooth.by_middles = -inverse.row(1);
            Vec2 const squares = tooth.by_middles.transpose().cwiseAbs2();
            tooth.radial = shift.y();
            tooth.radial_variance = squares.x() * left->covariance(0, 0) + squares.y() * right->covariance(0, 0);
            return true;
        }
    }
    return false;
}

}  // namespace

Eigen::Matrix2d RingData::shift_of_tooth(int tooth) const
{
    Eigen::Matrix2d columns;
    for (Eigen::Index k = 0; k < 2; ++k)
        columns.col(k) = read.to_tooth(turned_clockwise(Vec2::Unit(k), -placement.turn), tooth);
    return columns;
}

Eigen::Matrix<double, 3, RegistrationNoise::size> RingData::response(FlankFit const& fit) const
{
    Eigen::Matrix3d by, terms = Eigen::Matrix3d::Identity();
    by.col(0) = fit.parabola.by_turn / part().planes.front().reference_radius;
    by.rightCols<2>() = fit.parabola.by_shift * shift_of_tooth(fit.group.tooth);
    terms.col(0) = by.col(0);
    Eigen::Matrix<double, 3, RegistrationNoise::size> response;
    response << by, by - terms * registration.explained.middleRows<3>(fit.group.right ? 3 : 0);
    return response;
}

std::vector<ToothFit> tooth_fits(RingData const& data)
{
    std::vector<ToothFit> teeth;
    for (std::size_t i = 1; i < data.fits.size(); ++i) {
        FlankGroup const &a = data.fits[i - 1].group, &b = data.fits[i].group;
        ToothFit tooth{i - 1, i};
        if (a.plane == b.plane && a.tooth == b.tooth && !a.right && b.right && find_radial_shift(data, tooth))
            teeth.push_back(tooth);
    }
    return teeth;
}

}  // namespace hdconj::inspect
