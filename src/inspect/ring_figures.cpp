// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hdconj/base/rigid_motion.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double position_of(RingData const& data, FlankFit const& fit)
{
    return data.radius(fit) * fit.turn;
}

RegistrationNoise::Row position_row(RingData const& data, FlankFit const& fit)
{
    return data.radius(fit) * data.by_registration(fit).row(0);
}

/// Of the noise of its own points.
double own_variance(RingData const& data, FlankFit const& fit)
{
    return data.radius(fit) * data.radius(fit) * fit.covariance(0, 0);
}

double position_variance(RingData const& data, FlankFit const& fit)
{
    return own_variance(data, fit) + data.variance_of(position_row(data, fit));
}

/// Of the difference between the positions of two flanks.
double difference_variance(RingData const& data, FlankFit const& a, FlankFit const& b)
{
    return own_variance(data, a) + own_variance(data, b) +
           data.variance_of(position_row(data, b) - position_row(data, a));
}

/// Values along a flank of @p tooth: each point has the variance 1.
std::vector<Candidate> along(std::vector<double> const& values, int tooth)
{
    std::vector<Candidate> candidates;
    for (double const value : values)
        candidates.push_back({value, 1, tooth});
    return candidates;
}

RegistrationNoise::Row radial_row(RingData const& data, ToothFit const& tooth)
{
    return tooth.by_middles[0] * data.response(data.fits[tooth.left]).row(0) +
           tooth.by_middles[1] * data.response(data.fits[tooth.right]).row(0);
}

/// Amplitude and direction of the first harmonic of radial shifts round the ring.
/// @param rows  of the radial shifts
/// @param own   variance of a tooth's radial shift by the noise of its own points, in the mean
void add_eccentricity(RingData const& data, PlaneFigures& plane, std::vector<Candidate> const& radial,
                      std::vector<double> const& angle, Eigen::MatrixXd const& rows, double own,
                      Intervals const& intervals)
{
    constexpr std::size_t fewest_teeth = 4;  // one more than a mean and a harmonic have coefficients
    constexpr double least_spread = 1e-3;    // of the pivots: some eighth of a turn
    auto const n = static_cast<Eigen::Index>(radial.size());
    Eigen::MatrixXd basis(n, 3);
    Eigen::VectorXd value(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        auto const k = static_cast<std::size_t>(i);
        basis.row(i) << 1, std::sin(angle[k]), std::cos(angle[k]);
        value[i] = radial[k].value;
    }
    numeric::LeastSquares const fit(basis, least_spread);
    if (radial.size() < fewest_teeth || fit.rank() < 3) {
        plane.eccentricity = {unknown, unknown};
        plane.direction = unknown;
        return;
    }
    Eigen::Vector3d const harmonic = fit.solve(value);
    Eigen::Matrix3d const inverse = numeric::covariance(basis);
    double const size = harmonic.tail<2>().norm();
    Vec2 const along = size > 0 ? Vec2(harmonic.tail<2>() / size) : Vec2(0, 1);
    plane.circle = true;
    RegistrationNoise::Row const row = along.transpose() * fit.solve(rows).bottomRows<2>();
    plane.eccentricity =
        intervals.amplitude(size, own * along.dot(inverse.bottomRightCorner<2, 2>() * along) + data.variance_of(row));
    plane.direction = std::atan2(harmonic[1], harmonic[2]);
}

/// Pitches between neighbours of one side, as sizes; the wrap from the last tooth to the first among them.
std::vector<Candidate> pitches_of(RingData const& data, std::vector<std::size_t> const& side)
{
    std::vector<Candidate> pitches;
    for (std::size_t k = 0; k < side.size(); ++k) {
        FlankFit const& before = data.fits[side[k]];
        FlankFit const& after = data.fits[side[(k + 1) % side.size()]];
        int const step = (after.group.tooth - before.group.tooth + data.part().teeth) % data.part().teeth;
        if (step != 1 || side.size() < 2)
            continue;
        pitches.push_back({std::abs(position_of(data, after) - position_of(data, before)),
                           difference_variance(data, before, after), data.number[side[(k + 1) % side.size()]]});
    }
    return pitches;
}

Uncertain mean_of(std::vector<Uncertain const*> const& each, double variance, Intervals const& intervals)
{
    double sum = 0;
    for (auto const* one : each)
        sum += one->value;
    auto const n = static_cast<double>(each.size());
    return intervals.figure(sum / n, variance / (n * n));
}

SideFigures figures_of_side(RingData const& data, std::vector<FlankFigures> const& flanks,
                            std::vector<std::size_t> const& side, Intervals const& intervals)
{
    SideFigures found;
    found.z = flanks[side.front()].z;
    found.right = flanks[side.front()].right;
    found.flanks = side.size();
    std::vector<Uncertain const*> slopes, crownings;
    std::vector<Candidate> positions;
    std::vector<std::vector<Candidate>> remainders, deviations;  // by flank
    double slope_variance = 0, crowning_variance = 0;
    Eigen::Matrix<double, 3, RegistrationNoise::size> by_registration;
    by_registration.setZero();
    for (std::size_t const i : side) {
        FlankFigures const& each = flanks[i];
        slopes.push_back(&each.slope);
        crownings.push_back(&each.crowning);
        slope_variance += 4 * data.fits[i].covariance(1, 1);
        crowning_variance += data.fits[i].covariance(2, 2);
        by_registration += data.by_registration(data.fits[i]);
        positions.push_back({each.position.value, position_variance(data, data.fits[i]), each.tooth});
        remainders.push_back(along(data.fits[i].parabola.remainder, each.tooth));
        deviations.push_back(along(data.fits[i].parabola.deviation, each.tooth));
    }
    LargestFigure const form = largest_range_of(remainders, intervals), total = largest_range_of(deviations, intervals);
    found.form = form.figure;
    found.form_tooth = form.tooth;
    found.total = total.figure;
    found.total_tooth = total.tooth;
    found.slope = mean_of(slopes, slope_variance + 4 * data.variance_of(by_registration.row(1)), intervals);
    found.crowning = mean_of(crownings, crowning_variance + data.variance_of(by_registration.row(2)), intervals);
    auto const pitches = pitches_of(data, side);
    found.pitches = pitches.size();
    if (pitches.empty()) {
        found.single_pitch = found.total_pitch = {unknown, unknown};
        return found;
    }
    LargestFigure const single = largest_of(pitches, intervals);
    FigureRange const whole = range_of(positions, intervals);
    found.single_pitch = single.figure;
    found.pitch_tooth = single.tooth;
    found.total_pitch = whole.figure;
    found.from_tooth = whole.from;
    found.to_tooth = whole.to;
    return found;
}

}  // namespace

std::vector<FlankFigures> flank_figures(RingData const& data, Intervals const& intervals)
{
    std::vector<FlankFigures> figures;
    for (std::size_t i = 0; i < data.fits.size(); ++i) {
        FlankFit const& fit = data.fits[i];
        FlankParabola const& parabola = fit.parabola;
        auto const by_registration = data.by_registration(fit);
        figures.push_back({data.z[fit.group.plane], data.number[i], fit.group.right, parabola.points.size(),
                           intervals.figure(position_of(data, fit), position_variance(data, fit)),
                           range_of(along(parabola.deviation, 0), intervals).figure,
                           intervals.figure(2 * parabola.coefficient[1],
                                            4 * (fit.covariance(1, 1) + data.variance_of(by_registration.row(1)))),
                           intervals.figure(-parabola.coefficient[2],
                                            fit.covariance(2, 2) + data.variance_of(by_registration.row(2))),
                           range_of(along(parabola.remainder, 0), intervals).figure});
    }
    return figures;
}

std::vector<ToothFigures> tooth_figures(RingData const& data, Intervals const& intervals)
{
    std::vector<ToothFigures> figures;
    for (ToothFit const& tooth : data.teeth) {
        FlankFit const &left = data.fits[tooth.left], &right = data.fits[tooth.right];
        NominalPlane const& plane = data.part().planes[left.group.plane];
        figures.push_back(
            {data.z[left.group.plane], data.number[tooth.left],
             intervals.figure(plane.thickness() + position_of(data, right) - position_of(data, left),
                              difference_variance(data, left, right)),
             intervals.figure(tooth.radial, tooth.radial_variance + data.variance_of(radial_row(data, tooth)))});
    }
    return figures;
}

std::vector<SideFigures> side_figures(RingData const& data, std::vector<FlankFigures> const& flanks,
                                      Intervals const& intervals)
{
    std::vector<SideFigures> figures;
    for (std::size_t plane = 0; plane < data.z.size(); ++plane)
        for (bool const right : {false, true}) {
            std::vector<std::size_t> side;
            for (std::size_t i = 0; i < data.fits.size(); ++i)
                if (data.fits[i].group.plane == plane && data.fits[i].group.right == right)
                    side.push_back(i);
            if (!side.empty())
                figures.push_back(figures_of_side(data, flanks, side, intervals));
        }
    return figures;
}

std::vector<PlaneFigures> plane_figures(RingData const& data, Intervals const& intervals)
{
    std::vector<PlaneFigures> figures;
    for (std::size_t plane = 0; plane < data.z.size(); ++plane) {
        std::vector<Candidate> radial;
        std::vector<double> angle;
        double wider = 0, variance = 0, own = 0;
        RegistrationNoise::Row row = RegistrationNoise::Row::Zero();
        Eigen::MatrixXd rows(static_cast<Eigen::Index>(data.teeth.size()), RegistrationNoise::size);
        for (ToothFit const& tooth : data.teeth) {
            FlankFit const &left = data.fits[tooth.left], &right = data.fits[tooth.right];
            if (left.group.plane != plane)
                continue;
            RegistrationNoise::Row const of_radial = radial_row(data, tooth);
            rows.row(static_cast<Eigen::Index>(radial.size())) = of_radial;
            radial.push_back(
                {tooth.radial, tooth.radial_variance + data.variance_of(of_radial), data.number[tooth.left]});
            own += tooth.radial_variance;
            angle.push_back(left.group.tooth * data.part().pitch());
            wider += position_of(data, right) - position_of(data, left);
            variance += own_variance(data, right) + own_variance(data, left);
            row += position_row(data, right) - position_row(data, left);
        }
        if (radial.empty())
            continue;
        auto const n = static_cast<double>(radial.size());
        PlaneFigures found;
        found.z = data.z[plane];
        found.teeth = radial.size();
        found.thickness = intervals.figure(data.part().planes[plane].thickness() + wider / n,
                                           (variance + data.variance_of(row)) / (n * n));
        FigureRange const runout = range_of(radial, intervals);
        found.runout = runout.figure;
        found.near_tooth = runout.from;
        found.far_tooth = runout.to;
        rows.conservativeResize(static_cast<Eigen::Index>(radial.size()), Eigen::NoChange);
        add_eccentricity(data, found, radial, angle, rows, own / n, intervals);
        figures.push_back(found);
    }
    return figures;
}

}  // namespace hdconj::inspect
