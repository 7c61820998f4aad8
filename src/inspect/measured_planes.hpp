// SPDX-License-Identifier: GPL-3.0-or-later
// The planes in which points were measured.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hdconj/inspect.hpp"
#include "placement.hpp"

namespace hdconj::inspect {

/// Heights that differ by less are one plane [mm]: a probe's path is no plane to the last micrometre.
inline constexpr double plane_thickness = 0.02;

/// Points whose heights follow each other closely, from the lowest to the highest [mm].
struct MeasuredPlane
{
    double z = 0;  ///< median
    double low = 0, high = 0;

    [[nodiscard]] double width() const { return high - low; }
};

/// The planes of a file, from the lowest up; each height of it is in one of them. Heights apart by less than a plane's
/// thickness are of one plane, however many there are. So are heights no further apart than half the width of a plane
/// beside them or, of 20 heights and more, than 15 times their median distance, as those of a scanned flank.
/// @returns of several planes that which options.plane names
/// @throws InputError where no plane is there
[[nodiscard]] std::vector<MeasuredPlane> planes_of(PointFile const& measured, InspectOptions const& options);

/// @throws InputError where a plane lies beside the teeth, as far as @p scene says where they stand
void refuse_planes_outside(std::vector<MeasuredPlane> const& planes, Scene const& scene, PointFile const& measured,
                           InspectOptions const& options);

/// @throws InputError where a plane is wider than an outline that changes along z can be followed
void refuse_wide_planes(std::vector<MeasuredPlane> const& planes, PointFile const& measured);

/// The points of the planes that are evaluated, and where each stands in the file.
struct PlanePoints
{
    std::vector<PlanePoint> points;
    std::vector<std::size_t> origin;
    std::size_t repeated = 0;   ///< points left out, because the same stands in the file before
    std::size_t elsewhere = 0;  ///< points of other planes
};

/// The points of @p planes, each once.
[[nodiscard]] PlanePoints points_on(std::vector<MeasuredPlane> const& planes, PointFile const& measured);

/// How a wide plane lies. A part that leans is seen shortened.
struct PlaneLean
{
    double angle = 0;      ///< against the axis; 0 where heights scatter more than they rise [rad]
    double shortened = 0;  ///< by which the part is seen too short across [mm]
};
[[nodiscard]] PlaneLean lean_of(MeasuredPlane const& plane, std::size_t index, PlanePoints const& on);

/// From this width on a plane is told to be no plane [mm].
inline constexpr double wide_plane = 2 * plane_thickness;

/// What to know of the widest plane, where it is wide. Empty: nothing.
[[nodiscard]] std::string note_of_wide_planes(std::vector<MeasuredPlane> const& planes, PlanePoints const& on);

}  // namespace hdconj::inspect
