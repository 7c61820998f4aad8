// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "common_errors.hpp"
#include "hdconj/error.hpp"
#include "numeric/least_squares.hpp"
#include "numeric/quantile.hpp"

namespace hdconj::inspect {
namespace {

constexpr int settled_after = 12;             // steps in which points may come to a flank or leave it
constexpr int most_registration_steps = 300;  // far from the flanks a step gains little more than half a digit
constexpr double least_rank = 1e-7;           // of a column's pivot: a tooth alone fixes its lean to some 1e-2

/// Median of the distances from the nearest flank, which the search within a pitch compares: points beside the flanks,
/// as of a land, are fewer than those on them [mm].
double median_distance(Registered const& what, double turn)
{
    constexpr std::size_t most_probes = 600;
    std::size_t const step = what.points.size() / most_probes + 1;
    std::vector<double> distances;
    for (std::size_t i = 0; i < what.points.size(); i += step)
        distances.push_back(std::abs(what.read(what.points[i], {turn, Vec2::Zero()}).deviation));
    return numeric::quantile(std::move(distances), 0.5);
}

[[noreturn]] void refuse_loose(Registration registration)
{
    throw InputError(Fault{"--register", 0, std::string(to_string(registration)),
                           "the points on flanks do not determine the position of the part",
                           registration == Registration::turn
                               ? "write --register datum, or measure more of the flank"
                               : "write --register turn, or measure both flanks at more points"});
}

/// One Gauss-Newton step, the change of the common excess, and the largest change of a deviation that it makes.
struct LeastSquaresStep
{
    Eigen::VectorXd by;
    double excess;
    double change;
};
/// @returns nothing where the points do not tell the placement from the errors that are known beside it
std::optional<LeastSquaresStep> least_squares_step(std::vector<PointView> const& views, Placement const& placement,
                                                   Registered const& what, int unknowns)
{
    Eigen::MatrixXd const rows = jacobian(views, placement, what.read.part(), unknowns);
    Eigen::VectorXd towards(static_cast<Eigen::Index>(views.size()));
    for (std::size_t i = 0; i < views.size(); ++i)
        towards[static_cast<Eigen::Index>(i)] = -views[i].deviation;
    bool const one_flank = std::ranges::all_of(views, [&](PointView const& view) {
        return view.tooth == views.front().tooth && view.right == views.front().right;
    });
    if (rows.rows() < unknowns || (one_flank && unknowns == most_unknowns))
        return std::nullopt;
    CommonErrors const common(views, what.read.part(), placement.known);
    Eigen::MatrixXd const own = common.without(rows);
    numeric::LeastSquares const fit(own, least_rank);
    if (fit.rank() < unknowns || own.norm() < least_rank * rows.norm())
        return std::nullopt;
    Eigen::VectorXd by = fit.solve(Eigen::VectorXd(common.without(towards)));
    double const excess = common.excess(towards - rows * by);
    double const change = (rows * by).cwiseAbs().maxCoeff() + std::abs(excess);
    return LeastSquaresStep{std::move(by), excess, change};
}

/// How far the points lie off the flanks, after the steps in which they settle: by root mean square about the mean,
/// since the centres of a ball of unknown radius stand off everywhere [mm].
double distance_off(std::vector<PointView> const& views)
{
    auto const count = static_cast<double>(views.size());
    double sum = 0, squares = 0;
    for (PointView const& view : views) {
        sum += view.deviation;
        squares += view.deviation * view.deviation;
    }
    return std::sqrt(std::max(0.0, (squares - sum * sum / count) / count));
}

/// @param off     distance_off() [mm]
/// @param shifts  whether the registration shifts the part
[[noreturn]] void refuse_other_teeth(double off, NominalPart const& part, std::string const& file, bool shifts)
{
    throw InputError(Fault{"POINTS", 0, file,
                           fmt::format("the points lie {} mm (rms) off the flanks of the part, wherever it is turned{} "
                                       "to: are they of another number of teeth than {}?",
                                       short_number(off, 2), shifts ? " and shifted" : "", part.teeth),
                           std::string("give the points of this part, and the part by --part") +
                               (shifts ? "" : ", or write --register least-squares if its axis is not known")});
}

/// Keeps the views on a flank, and the same points.
void keep_settled(std::vector<PointView>& views, std::vector<PlanePoint>* points)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (!views[i].on)
            continue;
        views[kept] = views[i];
        if (points != nullptr)
            (*points)[kept] = (*points)[i];
        ++kept;
    }
    views.resize(kept);
    if (points != nullptr)
        points->resize(kept);
}

}  // namespace

double near_turn(Registered const& what)
{
    if (what.registration == Registration::datum || what.points.empty())
        return 0;
    constexpr int turns = 24;  // of half a pitch to either side
    constexpr double much_better = 2;
    double best = 0, least = median_distance(what, 0) / much_better;
    for (int i = 1; i <= turns; ++i)
        for (int const sign : {1, -1}) {
            double const turn = sign * i * what.read.part().pitch() / (2 * turns);
            double const distance = median_distance(what, turn);
            best = distance < least ? turn : best;
            least = std::min(least, distance);
        }
    return best;
}

int unknowns_of(Registration registration)
{
    return registration == Registration::datum ? 0 : registration == Registration::turn ? 1 : most_unknowns;
}

Eigen::MatrixXd jacobian(std::vector<PointView> const& views, Placement const& placement, NominalPart const& part,
                         int unknowns)
{
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(views.size()), unknowns);
    double const radius = part.planes.front().reference_radius;
    for (std::size_t i = 0; i < views.size(); ++i) {
        auto row = rows.row(static_cast<Eigen::Index>(i));
        if (unknowns > 0)
            row[0] = views[i].by_turn() / radius;
        if (unknowns == most_unknowns)
            row.tail<2>() = by_shift(views[i], placement).transpose();
    }
    return rows;
}

Placement moved(Placement placement, Eigen::VectorXd const& step, NominalPart const& part)
{
    placement.turn += step[0] / part.planes.front().reference_radius;
    if (step.size() == most_unknowns)
        placement.shift += step.tail<2>();
    return placement;
}

namespace {

/// Where the steps of least squares end from @p placement on.
struct Steps
{
    bool determined = true;
    std::optional<Placement> end;  ///< nothing where they come to none
};

/// @param used  the points, of which those that settle stay
Steps steps_from(Placement placement, Registered const& what, Registered& used)
{
    NominalPart const& part = what.read.part();
    int const unknowns = unknowns_of(what.registration);
    double const rounding = part.tolerance().roundoff();
    double before = std::numeric_limits<double>::infinity();
    std::size_t first = 0;  // points on flanks
    for (int step = 0; step < most_registration_steps; ++step) {
        std::vector<PointView> views = views_of(used.read, used.points, placement, used.threads);
        keep_settled(views, step == settled_after ? &used.points : nullptr);
        first = step == 0 ? views.size() : first;
        // the steps of a ring of another number of teeth often do not converge after these
        constexpr double share = 1.0 / 12;  // of a pitch, a quarter of the module: no such ring would mesh
        constexpr double most = 0.9;        // of the points: where others are lost, noise has moved the part off them
        bool const off = distance_off(views) > share * part.pitch() * part.planes.front().reference_radius,
                   lost = static_cast<double>(views.size()) < most * static_cast<double>(first);
        if (step == settled_after && placement.known != CommonErrorsKnown::none && (off || lost))
            return {};
        if (step == settled_after && off)
            refuse_other_teeth(distance_off(views), part, what.file, unknowns == most_unknowns);
        auto const found = least_squares_step(views, placement, what, unknowns);
        if (!found)
            return {false, std::nullopt};
        auto const& [by, excess, change] = *found;
        placement = moved(placement, by, part);
        placement.excess += excess / part.planes.front().reference_radius;
        // a direction that the points hardly determine, such as the lean of one tooth, changes by rounding at each step
        bool const only_rounding = change <= rounding && by.norm() >= before;
        before = by.norm();
        if (step <= settled_after || (std::max(before, std::abs(excess)) > rounding && !only_rounding))
            continue;
        placement.excess = 0;
        return {true, placement};
    }
    return {};
}

}  // namespace

Placement registered(Registered const& what)
{
    if (unknowns_of(what.registration) == 0)
        return {};
    Placement start{near_turn(what), Vec2::Zero()};
    // points of one tooth may not tell its place from its form: then less of that is known
    std::vector<CommonErrorsKnown> known{CommonErrorsKnown::none};
    if (what.registration == Registration::least_squares)
        known = {CommonErrorsKnown::all, CommonErrorsKnown::thickness, CommonErrorsKnown::none};
    Steps steps;
    for (CommonErrorsKnown const each : known) {
        Registered used = what;
        start.known = each;
        steps = steps_from(start, what, used);
        if (steps.end)
            return what.registration == Registration::minimum_zone ? minimum_zone(used, *steps.end) : *steps.end;
    }
    if (!steps.determined)
        refuse_loose(what.registration);
    throw NumericalError(ErrorCode::not_converged, "registration", std::string(to_string(what.registration)),
                         "the steps do not come to an end",
                         "write the radius of the ball by --probe, or --register datum to see how the points lie");
}

}  // namespace hdconj::inspect
