// SPDX-License-Identifier: GPL-3.0-or-later
#include "placement_notes.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "measured_planes.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

/// Whether all points lie off the flanks to one side, as centres of a ball do whose radius is not given.
void add_note_of_probe(Inspection& result)
{
    constexpr double far = 4;  // in standard deviations: errors of a part go to both sides
    double sum = 0, squares = 0, count = 0;
    for (PointDeviation const& point : result.points)
        if (point.fate == PointFate::used) {
            sum += point.deviation;
            squares += point.deviation * point.deviation;
            ++count;
        }
    double const mean = count > 0 ? sum / count : 0;
    double const deviation = count > 0 ? std::sqrt(std::max(0.0, squares / count - mean * mean)) : 0;
    if (std::abs(mean) > far * deviation && std::abs(mean) > plane_thickness)
        result.notes.push_back(fmt::format(
            "all points lie about {} mm {} the material: is the probe's radius missing, or of the other sign?",
            short_number(std::abs(mean), 2), mean > 0 ? "outside" : "inside"));
}

/// Errors that come into a figure so many times as large are told.
constexpr double weak = 2;

/// Two digits, without an exponent for what parts have.
std::string two_digits(double value)
{
    constexpr double three_digits = 99.5;
    return value < three_digits ? short_number(value, 2) : fmt::format("{:.0f}", value);
}

/// Where the flanks of one side of a tooth stand in the mean of the planes.
struct FlankPlace
{
    double count = 0, place = 0;                         ///< arc, sums over the planes [mm]
    double variance = 0;                                 ///< by the noise of its points
    Vec2 by_shift = Vec2::Zero();                        ///< its change with a shift
    Eigen::Vector3d unknowns = Eigen::Vector3d::Zero();  ///< their change with the places of these flanks
};
/// The left and the right side of a tooth.
using ToothPlace = std::array<FlankPlace, 2>;

std::map<int, ToothPlace> tooth_places(RingData const& data)
{
    std::map<int, ToothPlace> teeth;
    std::array<double, 2> sum{0, 0}, count{0, 0};
    for (std::size_t i = 0; i < data.fits.size(); ++i) {
        FlankFit const& fit = data.fits[i];
        double const radius = data.radius(fit);
        std::size_t const side = fit.group.right ? 1 : 0;
        FlankPlace& place = teeth[fit.group.tooth][side];
        place.count += 1;
        place.place += radius * fit.turn;
        place.variance += radius * radius * fit.covariance(0, 0);
        place.by_shift += radius * data.by_registration(fit).block<1, 2>(0, 1).transpose();
        place.unknowns += data.registration.by_places.col(static_cast<Eigen::Index>(i));
        sum[side] += radius * fit.turn;
        count[side] += 1;
    }
    for (auto& [tooth, sides] : teeth)
        for (std::size_t side = 0; side < 2; ++side) {
            FlankPlace& place = sides[side];
            if (place.count == 0)
                continue;
            place.place = place.place / place.count - sum[side] / count[side];
            place.variance /= place.count * place.count;
            place.by_shift /= place.count;
        }
    return teeth;
}

/// How teeth stand off their places in one way, and what this makes of the unknowns.
struct PlaceScatter
{
    int freedom = 0;
    double variance = 0;                                 ///< of a place [mm^2]
    double noise = 0;                                    ///< of that by the noise of points, for noise of variance 1
    Eigen::Matrix3d unknowns = Eigen::Matrix3d::Zero();  ///< their covariance for places of variance 1
};

/// @param apart  whether the flanks of a tooth stand off apart from each other; else together
PlaceScatter scatter_of(std::map<int, ToothPlace> const& teeth, bool apart)
{
    std::vector<double> places;
    std::vector<Eigen::Vector3d> pattern;
    PlaceScatter scatter;
    for (auto const& [tooth, sides] : teeth) {
        auto const& [left, right] = sides;
        bool const both = left.count > 0 && right.count > 0;
        if (apart && !both)
            continue;
        double const sign = apart ? -1 : 1, share = both ? 0.5 : 1;
        Vec2 const by_shift = share * (right.by_shift + sign * left.by_shift);
        places.push_back(share * (right.place + sign * left.place));
        pattern.emplace_back(1, by_shift.x(), by_shift.y());
        scatter.noise += share * share * (right.variance + left.variance);
        Eigen::Vector3d const by = right.unknowns + sign * left.unknowns;
        scatter.unknowns += by * by.transpose();
    }
    if (places.empty())
        return scatter;
    auto const n = static_cast<Eigen::Index>(places.size());
    scatter.noise /= static_cast<double>(n);
    Eigen::MatrixXd const basis = Eigen::Matrix3Xd::Map(pattern.front().data(), 3, n).transpose();
    Eigen::VectorXd const place = Eigen::VectorXd::Map(places.data(), n);
    numeric::LeastSquares const fit(basis);
    scatter.freedom = static_cast<int>(n - fit.rank());
    if (scatter.freedom > 0)
        scatter.variance = (place - basis * fit.solve(place)).squaredNorm() / scatter.freedom;
    return scatter;
}

/// What the places of teeth make of a figure, beside its interval.
struct PlaceEffect
{
    std::string name;
    double size = 0;      ///< half width of a 95 % interval [mm]
    double interval = 0;  ///< as stated [mm]
};

void take_larger(PlaceEffect& largest, Eigen::RowVector3d const& row, Eigen::Matrix3d const& unknowns, double interval)
{
    double const size = std::sqrt(row * unknowns * row.transpose());
    if (size >= largest.size) {
        largest.size = size;
        largest.interval = interval;
    }
}

/// Shift, slope, crowning and thickness. @param unknowns  their covariance
std::array<PlaceEffect, 4> effects_of(Inspection const& result, RingData const& data, Eigen::Matrix3d const& unknowns)
{
    PlaceEffect shift{"shift"}, slope{"slope"}, crowning{"crowning"}, thickness{"thickness"};
    take_larger(shift, Eigen::RowVector3d::Unit(1), unknowns, result.placement.shift_x.error);
    take_larger(shift, Eigen::RowVector3d::Unit(2), unknowns, result.placement.shift_y.error);
    for (SideFigures const& side : result.sides) {
        Eigen::Matrix3d rows = Eigen::Matrix3d::Zero();
        for (FlankFit const& fit : data.fits)
            if (data.z[fit.group.plane] == side.z && fit.group.right == side.right)
                rows += data.by_registration(fit).leftCols<3>() / static_cast<double>(side.flanks);
        take_larger(slope, 2 * rows.row(1), unknowns, side.slope.error);
        take_larger(crowning, rows.row(2), unknowns, side.crowning.error);
    }
    for (PlaneFigures const& plane : result.planes) {
        Eigen::RowVector3d row = Eigen::RowVector3d::Zero();
        for (ToothFit const& tooth : data.teeth) {
            FlankFit const &left = data.fits[tooth.left], &right = data.fits[tooth.right];
            if (data.z[left.group.plane] == plane.z)
                row += data.radius(left) *
                       (data.by_registration(right) - data.by_registration(left)).topLeftCorner<1, 3>() /
                       static_cast<double>(plane.teeth);
        }
        take_larger(thickness, row, unknowns, plane.thickness.error);
    }
    return {shift, slope, crowning, thickness};
}

}  // namespace

void add_note_of_sector(Inspection& result, CommonErrorsKnown known, Eigen::MatrixXd const& inverse,
                        Eigen::MatrixXd const& rows)
{
    constexpr double small_part = 0.05;
    if (result.options.registration == Registration::least_squares && known != CommonErrorsKnown::all)
        result.notes.push_back(fmt::format(
            "the points do not tell {}slope and crowning from the position of the part: what flanks have of these in "
            "common changes it, beyond the intervals; write --register turn if the axis is known",
            known == CommonErrorsKnown::none ? "thickness, " : ""));
    // its eigenvalues are 1 over the squared sines of the angles between both; the largest is hardly below this
    double const squared = (inverse * (rows.transpose() * rows)).trace() - static_cast<double>(rows.cols() - 1);
    double const part = 1 - 1 / squared;
    bool const zone = result.options.registration == Registration::minimum_zone;
    if (zone && part > small_part)
        result.notes.push_back(fmt::format(
            "a minimum zone of these teeth takes up to {:.0f} % of what all flanks have in common (thickness, slope, "
            "crowning) for a shift: write --register turn if the axis is known, else least-squares",
            100 * part));
    else if (!zone && squared > weak * weak)
        result.notes.push_back(fmt::format(
            "the teeth hardly tell a shift from thickness, slope and crowning: errors of another form that all flanks "
            "share come into these up to {:.0f}-fold, beyond the intervals; write --register turn if the axis is known",
            std::sqrt(squared)));
}

void add_note_of_places(Inspection& result, RingData const& data)
{
    constexpr double outside = 0.05, by_chance = 0.01;
    constexpr int few = 4;  // too little freedom for chance to tell
    if (result.options.registration != Registration::least_squares || !(result.freedom > 0))
        return;
    auto const teeth = tooth_places(data);
    PlaceScatter const together = scatter_of(teeth, false), apart = scatter_of(teeth, true);
    auto const more_than_noise = [&](PlaceScatter const& scatter) {
        double const noise = result.noise * result.noise * scatter.noise;
        return scatter.freedom > 0 &&
               scatter.variance > noise * gsl_cdf_fdist_Qinv(by_chance, scatter.freedom, result.freedom);
    };
    int const freedom = apart.noise > 0 ? std::min(together.freedom, apart.freedom) : together.freedom;
    double const times = freedom > 0 ? gsl_cdf_tdist_Qinv(outside / 2, freedom) : 1;
    auto const variance = [&](PlaceScatter const& scatter) {
        return freedom > 0 ? times * times * scatter.variance : 1 / (per_um * per_um);
    };
    auto const effects =
        effects_of(result, data, variance(together) * together.unknowns + variance(apart) * apart.unknowns);
    bool const enlarged = (together.unknowns + apart.unknowns).bottomRightCorner<2, 2>().trace() > weak * weak;
    bool const scatters = more_than_noise(together) || more_than_noise(apart);
    auto const exceeds = [](PlaceEffect const& effect) { return effect.size > effect.interval; };
    // what a whole ring has of a shift by the places of its teeth is its eccentricity
    if (enlarged ? !scatters && freedom >= few : !scatters || std::none_of(effects.begin() + 1, effects.end(), exceeds))
        return;
    std::string list;
    for (PlaceEffect const& effect : effects)
        if (exceeds(effect))
            list +=
                fmt::format("{}{} +- {} um", list.empty() ? "" : ", ", effect.name, two_digits(effect.size * per_um));
    if (!list.empty())
        result.notes.push_back(fmt::format(
            "{}, come into the shift, beyond the intervals: {}; measure both flanks, or more teeth, or write "
            "--register "
            "turn if the axis is known",
            freedom > 0 ? fmt::format("the places of single teeth, which scatter by {} um",
                                      two_digits(std::sqrt(together.variance) * per_um))
                        : "the places of single teeth, of which so few do not tell how far they scatter, for each um",
            list));
}

void add_notes_of_points(Inspection& result, std::size_t groups)
{
    std::map<int, double> plane_of;
    bool const shared = std::ranges::any_of(result.flanks, [&](FlankFigures const& flank) {
        return plane_of.emplace(flank.tooth, flank.z).first->second != flank.z;
    });
    if (result.nominal.size() > 1 && !shared)
        result.notes.push_back(fmt::format(
            "the {} planes have no tooth in common, and pitch and runout are those within a plane: if they are one "
            "plane of a part that leans, lay it flat or leave the column z out",
            result.nominal.size()));
    if (result.repeated > 0)
        result.notes.push_back(fmt::format("{} {} in the file again, and {} used once", result.repeated,
                                           result.repeated == 1 ? "point stands" : "points stand",
                                           result.repeated == 1 ? "is" : "are"));
    add_note_of_probe(result);
    if (result.flanks.empty())
        result.notes.push_back(fmt::format(
            "no flank has {} points over {:g} % of its length: there are deviations, but no figures of flanks",
            fewest_points, 100 * least_cover));
    else if (groups > result.flanks.size())
        result.notes.push_back(
            fmt::format("{} of {} flanks have fewer than {} points, or points over less than {:g} % "
                        "of their length: they have no figures",
                        groups - result.flanks.size(), groups, fewest_points, 100 * least_cover));
}

}  // namespace hdconj::inspect
