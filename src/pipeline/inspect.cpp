// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/solve.hpp"
#include "inspect/evaluation.hpp"

namespace hdconj {
namespace {

using inspect::NominalPart;

/// A measured plane that is as near a slice as this is that slice [mm].
constexpr double slice_thickness = 1e-6;

/// The outline of the circular spline at height @p z: that of a slice, or between two the points between matched ones.
std::vector<Vec2> outline_at(CircularSplineOutline const& spline, double z)
{
    if (spline.z.size() < 2)
        return spline.outline.front();
    if (z < spline.z.front() - slice_thickness || z > spline.z.back() + slice_thickness)
        throw InputError(Fault{"--plane", 0, short_number(z),
                               fmt::format("the circular spline stands between z = {} and {} mm",
                                           short_number(spline.z.front()), short_number(spline.z.back())),
                               "measure within its width, z = 0 in the middle of the bearing"});
    std::size_t above = 1;
    while (above + 1 < spline.z.size() && spline.z[above] < z)
        ++above;
    double const share = std::clamp((z - spline.z[above - 1]) / (spline.z[above] - spline.z[above - 1]), 0.0, 1.0);
    std::vector<Vec2> outline = spline.outline[above - 1];
    for (std::size_t i = 0; i < outline.size(); ++i)
        outline[i] += share * (spline.outline[above][i] - outline[i]);
    return outline;
}

/// Error of an outline between two slices whose points do not move along straight lines: what the line from every
/// second slice misses. The ruled and the tilted surface have straight lines.
double error_between(CircularSplineOutline const& spline)
{
    double worst = 0;
    for (std::size_t k = 1; k + 1 < spline.z.size(); ++k) {
        double const share = (spline.z[k] - spline.z[k - 1]) / (spline.z[k + 1] - spline.z[k - 1]);
        for (std::size_t i = 0; i < spline.outline[k].size(); ++i) {
            Vec2 const& before = spline.outline[k - 1][i];
            worst =
                std::max(worst, (before + share * (spline.outline[k + 1][i] - before) - spline.outline[k][i]).norm());
        }
    }
    return worst / 4;
}

void add_spline_planes(NominalPart& part, Solution const& solution, std::vector<double> const& z)
{
    auto const& spline = solution.circular_spline;
    part.frame = drive::spline_tooth_frame(solution.scene, solution.geometry);
    for (double const each : z) {
        bool const slice = std::any_of(spline.z.begin(), spline.z.end(),
                                       [&](double s) { return std::abs(s - each) <= slice_thickness; });
        double const error = solution.error.point + (slice ? 0 : error_between(spline));
        part.planes.push_back(
            inspect::plane_of_outline(outline_at(spline, each), spline.pieces, part.seat, true, error));
    }
}

/// The flexspline before assembly: its neutral layer is a circle, its teeth are the same in each plane.
void add_flexspline_planes(NominalPart& part, Scene const& scene, std::vector<double> const& z)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    part.seat = drive::ring_geometry(scene, tooth).r_m;
    part.frame.origin.y() = part.seat + tooth.pitch_line;
    for (std::size_t i = 0; i < z.size(); ++i)
        part.planes.push_back(inspect::plane_of_profile(tooth, part.seat));
}

/// The same of a flexspline whose tooth is solved for.
void add_flexspline_planes(NominalPart& part, Solution const& solution, std::vector<double> const& z)
{
    part.seat = solution.geometry.r_m + solution.geometry.pitch_line;
    part.frame.origin.y() = part.seat;
    for (std::size_t i = 0; i < z.size(); ++i)
        part.planes.push_back(inspect::plane_of_outline(solution.flexspline_outline, solution.flexspline_pieces,
                                                        part.seat, false, solution.error.point));
}

}  // namespace

Inspection inspect_points(Scene const& scene, PointFile const& measured, InspectOptions const& options,
                          StageObserver const& on_stage)
{
    if (Faults const faults = check_scene(scene); !faults.empty())
        throw InputError(faults);
    std::vector<double> const z = inspect::planes_of(measured, options);
    NominalPart part;
    part.space = options.part == InspectedPart::circular_spline;
    part.teeth = part.space ? scene.drive.circular_spline_teeth : scene.drive.flexspline_teeth;
    PairGeometry geometry;
    if (part.space || scene.is_reverse()) {
        Solution const solution = solve(scene, on_stage);
        geometry = solution.geometry;
        part.space ? add_spline_planes(part, solution, z) : add_flexspline_planes(part, solution, z);
    } else {
        add_flexspline_planes(part, scene, z);
    }
    part.scale = part.planes.front().reference_radius;
    Inspection result = inspect::evaluated(scene, part, z, measured, options);
    result.geometry = geometry;
    return result;
}

}  // namespace hdconj
