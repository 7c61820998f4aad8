// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "clean_fits.hpp"
#include "common_errors.hpp"
#include "numeric/least_squares.hpp"
#include "placement_notes.hpp"
#include "plane_points.hpp"
#include "registration.hpp"
#include "ring_figures.hpp"

namespace hdconj::inspect {
namespace {

/// Registrations, the later ones without the strays that the fits before have found.
constexpr int most_rounds = 4;

/// The flanks that have points, by plane, tooth, left before right.
std::vector<FlankGroup> groups_of(std::vector<PlanePoint> const& points, std::vector<PointView> const& views,
                                  std::vector<bool> const& used)
{
    std::map<std::tuple<std::size_t, int, bool>, FlankGroup> groups;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!used[i] || !views[i].on)
            continue;
        auto& group = groups[{points[i].plane, views[i].tooth, views[i].right}];
        group.plane = points[i].plane;
        group.tooth = views[i].tooth;
        group.right = views[i].right;
        group.points.push_back(i);
    }
    std::vector<FlankGroup> all;
    for (auto& [key, group] : groups)
        all.push_back(std::move(group));
    return all;
}

/// Registration and fits that agree on the strays.
struct Fitted
{
    Placement placement;
    std::vector<PointView> views;
    std::vector<FlankFit> fits;
    std::vector<bool> used;  ///< whether a point is no stray
};

Fitted fitted(PointReader const& read, PlanePoints const& on, PointFile const& measured, InspectOptions const& options,
              int threads)
{
    Fitted found;
    found.used.assign(on.points.size(), true);
    for (int round = 0; round < most_rounds; ++round) {
        Registered what{read, {}, options.registration, threads, measured.file};
        for (std::size_t i = 0; i < on.points.size(); ++i)
            if (found.used[i])
                what.points.push_back(on.points[i]);
        if (round == 0) {
            refuse_exchanged_flanks(on, read, measured.file, threads);
            auto const views = views_of(read, on.points, {near_turn(what), Vec2::Zero()}, threads);
            refuse_foreign_points(on, views, read.part(), measured.file);
            refuse_mixed_teeth(on, views, measured, read.part());
        }
        found.placement = registered(what);
        found.views = views_of(read, on.points, found.placement, threads);
        std::vector<bool> used(on.points.size(), true);
        found.fits = fits_without_strays(read, on.points, groups_of(on.points, found.views, used), found.placement);
        for (FlankFit const& fit : found.fits)
            for (std::size_t const stray : fit.strays)
                used[stray] = false;
        if (std::exchange(found.used, used) == used)
            break;
    }
    return found;
}

/// Number of the tooth of each fit: that of the file where it names one, the place on the ring else.
std::vector<int> numbers_of(Fitted const& found, PlanePoints const& on, PointFile const& measured)
{
    std::vector<int> numbers;
    for (FlankFit const& fit : found.fits) {
        int const named = measured.points[on.origin[fit.group.points.front()]].tooth;
        numbers.push_back(named > 0 ? named : fit.group.tooth + 1);
    }
    return numbers;
}

void add_points(Inspection& result, Fitted const& found, PlanePoints const& on, PointFile const& measured,
                NominalPart const& part, std::vector<double> const& z)
{
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < on.points.size(); ++i) {
        PointView const& view = found.views[i];
        PartPoint const& origin = measured.points[on.origin[i]];
        PointFate const fate = !found.used[i] ? PointFate::stray : view.on ? PointFate::used : PointFate::beside;
        std::size_t const plane = on.points[i].plane;
        result.points.push_back({origin.line, z[plane], origin.tooth > 0 ? origin.tooth : view.tooth + 1, view.right,
                                 part.planes[plane].flank(view.right).arc_length(view.foot), view.deviation, fate});
        result.strays += fate == PointFate::stray ? 1U : 0U;
        result.beside += fate == PointFate::beside ? 1U : 0U;
        if (fate != PointFate::used)
            continue;
        PartPlacement& placement = result.placement;
        placement.least = count == 0 ? view.deviation : std::min(placement.least, view.deviation);
        placement.largest = count == 0 ? view.deviation : std::max(placement.largest, view.deviation);
        sum += view.deviation * view.deviation;
        ++count;
    }
    result.placement.rms = count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

/// Sum of @p own over the points of each fit, each times what a place of its flank changes there.
/// @param points  of the rows
Eigen::MatrixXd place_sums(Eigen::MatrixXd const& own, Eigen::VectorXd const& by_place,
                           std::vector<std::size_t> const& points, std::vector<FlankFit> const& fits)
{
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(own.cols(), static_cast<Eigen::Index>(fits.size()));
    for (std::size_t k = 0; k < fits.size(); ++k)
        for (std::size_t const point : fits[k].group.points) {
            auto const at = std::ranges::lower_bound(points, point);  // in the order of the file
            if (at == points.end() || *at != point)
                continue;
            Eigen::Index const row = at - points.begin();
            sums.col(static_cast<Eigen::Index>(k)) += by_place[row] * own.row(row).transpose();
        }
    return sums;
}

/// Turn and shift with what noise makes of them.
RegistrationNoise add_placement(Inspection& result, Fitted const& found, NominalPart const& part,
                                Intervals const& intervals, int threads)
{
    int const unknowns = unknowns_of(result.options.registration);
    PartPlacement& placement = result.placement;
    Placement const& at = found.placement;
    placement.deviation_error = intervals.half_width(1);
    placement.turn.value = at.turn;
    placement.shift_x.value = at.shift.x();
    placement.shift_y.value = at.shift.y();
    RegistrationNoise of_figures;
    if (unknowns == 0)
        return of_figures;
    std::vector<PointView> used;
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < found.views.size(); ++i)
        if (found.used[i] && found.views[i].on) {
            used.push_back(found.views[i]);
            points.push_back(i);
        }
    Eigen::MatrixXd const rows = jacobian(used, at, part, unknowns);
    Eigen::MatrixXd own = rows;
    bool const zone = result.options.registration == Registration::minimum_zone;
    if (unknowns == most_unknowns) {
        CommonErrors const common(used, part, zone ? CommonErrorsKnown::all : at.known);
        if (Eigen::MatrixXd const without = common.without(rows); numeric::LeastSquares(without).rank() == unknowns) {
            of_figures.explained = common.explained(rows);
            own = without;
        }
    }
    Eigen::MatrixXd const inverse = numeric::covariance(own);
    add_note_of_sector(result, at.known, inverse, rows);
    Eigen::Vector3d error = Eigen::Vector3d::Zero();
    double const noise = intervals.noise();
    auto& covariance = of_figures.covariance;
    if (zone && noise > part.tolerance().roundoff()) {
        ZoneError const off = zone_error(rows, without_noise(points, used, found.fits, noise), noise, threads);
        error = off.half_width.array() + intervals.systematic();
        covariance.topLeftCorner<most_unknowns, most_unknowns>() = off.covariance / (noise * noise);
    } else {
        for (Eigen::Index i = 0; i < unknowns; ++i)
            error[i] = intervals.half_width(inverse(i, i));
        covariance.topLeftCorner(unknowns, unknowns) = inverse;
        covariance.block(0, most_unknowns, unknowns, unknowns) = -inverse;
        covariance.block(most_unknowns, 0, unknowns, unknowns) = -inverse;
        if (unknowns == most_unknowns)
            of_figures.by_places = inverse * place_sums(own, rows.col(0), points, found.fits);
    }
    placement.turn.error = error[0] / part.planes.front().reference_radius;
    if (unknowns == most_unknowns) {
        placement.shift_x.error = error[1];
        placement.shift_y.error = error[2];
    }
    return of_figures;
}

void add_nominal(Inspection& result, NominalPart const& part, std::vector<double> const& z)
{
    for (std::size_t i = 0; i < z.size(); ++i) {
        NominalPlane const& plane = part.planes[i];
        result.nominal.push_back({z[i], 0.5 * (plane.left.length() + plane.right.length()), plane.reference_radius,
                                  plane.thickness(), plane.error});
    }
}

}  // namespace

Inspection evaluated(Scene const& scene, NominalPart const& part, std::vector<MeasuredPlane> const& planes,
                     PointFile const& measured, InspectOptions const& options)
{
    Inspection result;
    result.scene = scene;
    result.options = options;
    result.file = measured.file;
    std::vector<double> z;
    for (MeasuredPlane const& plane : planes)
        z.push_back(plane.z);
    add_nominal(result, part, z);
    PlanePoints const on = points_on(planes, measured);
    result.elsewhere = on.elsewhere;
    result.repeated = on.repeated;
    PointReader const read(part, options.probe);
    Fitted const found = fitted(read, on, measured, options, scene.solver.threads);
    NoiseSum sum;
    double freedom = 0;
    for (FlankFit const& fit : found.fits) {
        NoiseSum const each = noise_of(fit.parabola);
        sum.squares += each.squares;
        sum.differences += each.differences;
        freedom += static_cast<double>(fit.parabola.points.size()) - 3;
    }
    // two components of a shift change the remainders too: much of those of one tooth
    double const left = unknowns_of(options.registration) == most_unknowns ? 1 - 2 / freedom : 1;
    double error = 0;
    for (std::size_t i = 0; i < planes.size(); ++i)
        error = std::max(error, part.planes[i].error + lean_of(planes[i], i, on).shortened);
    Intervals const intervals(sum.squares, left * static_cast<double>(sum.differences),
                              error + part.tolerance().roundoff());
    result.noise = intervals.noise();
    result.freedom = intervals.freedom();
    add_points(result, found, on, measured, part, z);
    RegistrationNoise const registration = add_placement(result, found, part, intervals, scene.solver.threads);
    RingData data{read, on.points, z, found.placement, found.fits, numbers_of(found, on, measured), {}, registration};
    data.teeth = tooth_fits(data);
    result.flanks = flank_figures(data, intervals);
    result.teeth = tooth_figures(data, intervals);
    result.sides = side_figures(data, result.flanks, intervals);
    result.planes = plane_figures(data, intervals);
    result.mean_flank = mean_flank(data);
    add_note_of_places(result, data);
    if (std::string note = note_of_wide_planes(planes, on); !note.empty())
        result.notes.push_back(std::move(note));
    add_note_of_strays(result);
    add_notes_of_points(result, groups_of(on.points, found.views, found.used).size());
    return result;
}

}  // namespace hdconj::inspect
