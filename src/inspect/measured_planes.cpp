// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured_planes.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <tuple>

#include "base/text.hpp"
#include "file/listed_faults.hpp"
#include "hdconj/error.hpp"
#include "hdconj/units.hpp"
#include "numeric/least_squares.hpp"

namespace hdconj::inspect {
namespace {

/// Up to this width a linear change of the outline along z follows it to some 0.1 um [mm].
constexpr double widest_followed = 0.1;

/// Heights of both faces of the teeth; none where the scene does not say them.
std::optional<std::array<double, 2>> faces_of(Scene const& scene, bool space)
{
    if (space || !scene.flexspline.cup) {
        auto const& width = scene.circular_spline.width;  // as a wire cuts either part
        return width ? std::optional(std::array{-*width / 2, *width / 2}) : std::nullopt;
    }
    Cup const& cup = *scene.flexspline.cup;
    double const end = cup.length - cup.front_land, begin = end - cup.tooth_width;
    bool const placed = scene.coning && scene.coning->bottom_to_middle;
    double const middle = placed ? *scene.coning->bottom_to_middle : (begin + end) / 2;
    return std::array{begin - middle, end - middle};
}

/// Whether the heights between @p below and @p above are no gap between planes.
bool are_one(MeasuredPlane const& below, MeasuredPlane const& above, double closely)
{
    constexpr double share = 0.5;  // of the wider plane
    return above.low - below.high <= std::max(closely, share * std::max(below.width(), above.width()));
}

/// All planes of the file. @param heights  sorted
std::vector<MeasuredPlane> all_planes(std::vector<double> const& heights)
{
    constexpr double scattered = 15;    // median distances: even 1e5 random heights are hardly further apart
    constexpr std::size_t enough = 20;  // of fewer heights the median distance may be one of planes
    double closely = plane_thickness;
    if (heights.size() >= enough) {
        std::vector<double> distances(heights.size());
        std::adjacent_difference(heights.begin(), heights.end(), distances.begin());
        auto const middle = distances.begin() + std::ssize(distances) / 2;
        std::nth_element(distances.begin() + 1, middle, distances.end());
        closely = std::max(closely, scattered * *middle);
    }
    std::vector<MeasuredPlane> planes;
    for (double const z : heights) {
        MeasuredPlane last{z, z, z};
        for (; !planes.empty() && are_one(planes.back(), last, closely); planes.pop_back())
            last.low = planes.back().low;
        planes.push_back(last);
    }
    for (MeasuredPlane& plane : planes) {
        auto const first = std::ranges::lower_bound(heights, plane.low),
                   last = std::ranges::upper_bound(heights, plane.high);
        plane.z = *(first + (last - first - 1) / 2);
    }
    return planes;
}

int line_at(PointFile const& measured, double z)
{
    auto const point = std::ranges::find(measured.points, z, &PartPoint::z);
    return point == measured.points.end() ? 0 : point->line;
}

std::string range_text(MeasuredPlane const& plane)
{
    return fmt::format("from z = {} to {} mm", short_number(plane.low, 3), short_number(plane.high, 3));
}

}  // namespace

std::vector<MeasuredPlane> planes_of(PointFile const& measured, InspectOptions const& options)
{
    if (!measured.has_z) {
        double const z = options.plane.value_or(0);
        return {{z, z, z}};
    }
    std::vector<double> heights;
    for (PartPoint const& point : measured.points)
        heights.push_back(point.z);
    std::sort(heights.begin(), heights.end());
    std::vector<MeasuredPlane> const planes = all_planes(heights);
    if (!options.plane)
        return planes;
    auto const chosen = std::ranges::find_if(planes, [&](MeasuredPlane const& plane) {
        return plane.low - plane_thickness <= *options.plane && *options.plane <= plane.high + plane_thickness;
    });
    if (chosen != planes.end())
        return {*chosen};
    std::string known;
    for (MeasuredPlane const& plane : planes)
        known += (known.empty() ? "" : ", ") + short_number(plane.z);
    throw InputError(Fault{"--plane", 0, short_number(*options.plane),
                           "the file has no points there; it has planes at " + known + " mm", "write one of them"});
}

void refuse_planes_outside(std::vector<MeasuredPlane> const& planes, Scene const& scene, PointFile const& measured,
                           InspectOptions const& options)
{
    bool const space = options.part == InspectedPart::circular_spline;
    auto const faces = faces_of(scene, space);
    if (!faces)
        return;
    std::string const place = fmt::format("{} between z = {} and {} mm",
                                          space ? "the circular spline stands" : "the teeth of the flexspline stand",
                                          short_number(faces->front()), short_number(faces->back()));
    std::string remedy = "measure within this width, z = 0 in the middle of the bearing";
    if (!space && !scene.flexspline.cup)
        remedy += ", or give the teeth their own width by flexspline.cup";
    file::ListedFaults faults(measured.file);
    for (MeasuredPlane const& plane : planes)
        for (double const each : std::set{plane.low, plane.high}) {
            if (each >= faces->front() - plane_thickness && each <= faces->back() + plane_thickness)
                continue;
            int const line = line_at(measured, each);
            bool const of_file = measured.has_z && line > 0;
            faults.add(
                {of_file ? "z" : "--plane", line, short_number(each), place, remedy, of_file ? measured.file : ""});
        }
    faults.refuse();
}

void refuse_wide_planes(std::vector<MeasuredPlane> const& planes, PointFile const& measured)
{
    file::ListedFaults faults(measured.file);
    for (MeasuredPlane const& plane : planes)
        if (plane.width() > widest_followed)
            faults.add({"z", line_at(measured, plane.high), short_number(plane.high),
                        fmt::format("the points of one plane run {}, and the outline of this part changes with z",
                                    range_text(plane)),
                        fmt::format("lay the part flat, and measure in planes no wider than {} mm",
                                    short_number(widest_followed)),
                        measured.file});
    faults.refuse();
}

PlanePoints points_on(std::vector<MeasuredPlane> const& planes, PointFile const& measured)
{
    PlanePoints on;
    std::set<std::tuple<double, double, double, int, std::optional<bool>>> known;
    for (std::size_t i = 0; i < measured.points.size(); ++i) {
        PartPoint const& point = measured.points[i];
        auto const plane =
            measured.has_z ? std::ranges::lower_bound(planes, point.z, {}, &MeasuredPlane::high) : planes.begin();
        if (plane == planes.end() || (measured.has_z && point.z < plane->low)) {
            ++on.elsewhere;
            continue;
        }
        if (!known.emplace(point.where.x(), point.where.y(), point.z, point.tooth, point.right).second) {
            ++on.repeated;
            continue;
        }
        on.points.push_back({point.where, static_cast<std::size_t>(plane - planes.begin()), point.right,
                             measured.has_z ? point.z - plane->z : 0});
        on.origin.push_back(i);
    }
    return on;
}

PlaneLean lean_of(MeasuredPlane const& plane, std::size_t index, PlanePoints const& on)
{
    constexpr double most_left = 0.5;  // of the squares of the heights, where they rise
    std::vector<Eigen::Vector3d> rows;
    std::vector<double> above;
    for (PlanePoint const& point : on.points)
        if (point.plane == index) {
            rows.emplace_back(1, point.where.x(), point.where.y());
            above.push_back(point.above);
        }
    if (rows.size() < 4 || plane.width() <= wide_plane)
        return {};
    auto const n = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd const basis = Eigen::Matrix3Xd::Map(rows.front().data(), 3, n).transpose();
    Eigen::VectorXd const z = Eigen::VectorXd::Map(above.data(), n);
    numeric::LeastSquares const fit(basis);
    if (fit.rank() < 3)
        return {};
    Eigen::Vector3d const found = fit.solve(z);
    Eigen::VectorXd const centred = z.array() - z.mean();
    if ((z - basis * found).squaredNorm() > most_left * centred.squaredNorm())
        return {};
    Eigen::VectorXd const along = basis.rightCols<2>() * found.tail<2>().normalized();
    double const angle = std::atan(found.tail<2>().norm());
    return {angle, (1 - std::cos(angle)) * (along.maxCoeff() - along.minCoeff())};
}

std::string note_of_wide_planes(std::vector<MeasuredPlane> const& planes, PlanePoints const& on)
{
    auto const widest = std::ranges::max_element(planes, {}, &MeasuredPlane::width);
    if (widest->width() <= wide_plane)
        return "";
    PlaneLean const lean = lean_of(*widest, static_cast<std::size_t>(widest - planes.begin()), on);
    std::string const how =
        lean.angle > 0
            ? fmt::format(
                  ": it leans by {} deg, which shortens the part by {} um across; the intervals contain that; "
                  "lay the part flat",
                  short_number(lean.angle / deg, 2), short_number(lean.shortened * per_um, 2))
            : "; what the flanks change along z counts as form and noise";
    return fmt::format("the points of {} run {}{}", planes.size() == 1 ? "the plane" : "the widest plane",
                       range_text(*widest), how);
}

}  // namespace hdconj::inspect
