// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "base/text.hpp"
#include "drive/drive.hpp"
#include "hdconj/check.hpp"
#include "hdconj/scene/reading.hpp"
#include "hdconj/solve.hpp"
#include "inspect/evaluation.hpp"
#include "inspect/plane_points.hpp"
#include "surface/build_slices.hpp"

namespace hdconj {
namespace {

using inspect::MeasuredPlane;
using inspect::NominalPart;

/// A measured plane that is as near a slice as this is that slice [mm].
constexpr double slice_thickness = 1e-6;
/// The outline of a plane is not followed along z where the plane is thinner on either side [mm].
constexpr double least_raise = 1e-5;

/// The slice at @p height, of heights beyond an end the last one; none where no slice is there.
std::optional<std::size_t> slice_at(CircularSplineOutline const& spline, double height)
{
    double const z = std::clamp(height, spline.z.front(), spline.z.back());
    auto const found = std::ranges::find_if(spline.z, [&](double s) { return std::abs(s - z) <= slice_thickness; });
    return found == spline.z.end() ? std::nullopt : std::optional<std::size_t>(found - spline.z.begin());
}

/// Gives the circular spline a slice in each of the measured planes @p z.
void take_measured_planes(Solution& solution, std::vector<double> const& z)
{
    auto const& spline = solution.circular_spline;
    double const first = spline.z.front(), last = spline.z.back();
    std::vector<double> places{first, last};
    for (double const each : z) {
        if (std::min(each - first, last - each) > slice_thickness)
            places.push_back(each);
    }
    if (std::ranges::all_of(z, [&](double each) { return slice_at(spline, each).has_value(); }))
        return;
    std::ranges::sort(places);
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(solution.scene, faults);
    surface::move_slices(solution, tooth, drive::wave_shape(solution.scene, tooth, faults), places);
}

void add_spline_planes(NominalPart& part, Solution solution, std::vector<MeasuredPlane> const& planes,
                       PointFile const& measured)
{
    part.frame = drive::spline_tooth_frame(solution.scene, solution.geometry);
    auto const& spline = solution.circular_spline;
    bool const sliced = spline.z.size() > 1;  // else the outline is the same at any height
    auto const drawn = [&](std::size_t slice) {
        return inspect::plane_of_outline(spline.outline[slice], spline.pieces, part.seat, true, solution.error.point);
    };
    if (!sliced) {
        std::ranges::generate_n(std::back_inserter(part.planes), std::ssize(planes), [&] { return drawn(0); });
        return;
    }
    inspect::refuse_wide_planes(planes, measured);
    auto const inside = [first = spline.z.front(), last = spline.z.back()](double z) {
        return std::clamp(z, first, last);
    };
    std::vector<double> z;
    std::vector<double> raise;  // to the end of each plane that is further away
    for (MeasuredPlane const& plane : planes) {
        double const down = inside(plane.low) - inside(plane.z), up = inside(plane.high) - inside(plane.z);
        raise.push_back(up > -down ? up : down);
        z.push_back(plane.z);
        if (std::abs(raise.back()) > least_raise)
            z.push_back(inside(plane.z) + raise.back());
    }
    take_measured_planes(solution, z);
    for (std::size_t i = 0; i < planes.size(); ++i) {
        double const middle = inside(planes[i].z);
        auto& plane = part.planes.emplace_back(drawn(slice_at(spline, middle).value()));
        plane.raise = raise[i];
        if (std::abs(raise[i]) > least_raise)
            plane.raised = std::make_unique<inspect::NominalPlane>(drawn(slice_at(spline, middle + raise[i]).value()));
    }
}

/// The flexspline before assembly: its neutral layer is a circle, its teeth are the same in each plane.
void add_flexspline_planes(NominalPart& part, Scene const& scene, std::size_t planes)
{
    Faults faults;
    profile::Profile const tooth = drive::given_tooth(scene, faults);
    part.seat = drive::ring_geometry(scene, tooth).r_m;
    part.frame.origin.y() = part.seat + tooth.pitch_line;
    for (std::size_t i = 0; i < planes; ++i)
        part.planes.push_back(inspect::plane_of_profile(tooth, part.seat));
}

/// The same of a flexspline whose tooth is solved for.
void add_flexspline_planes(NominalPart& part, Solution const& solution, std::size_t planes)
{
    part.seat = solution.geometry.r_m + solution.geometry.pitch_line;
    part.frame.origin.y() = part.seat;
    for (std::size_t i = 0; i < planes; ++i)
        part.planes.push_back(inspect::plane_of_outline(solution.flexspline_outline, solution.flexspline_pieces,
                                                        part.seat, false, solution.error.point));
}

/// The scene with outlines so fine that a curve through their points misses them by less than 1e-9 mm where they are
/// smooth. A tilted ring has one at either end, as it is cut.
Scene finely_drawn(Scene scene)
{
    constexpr double finer = 16;
    constexpr int ends = 2;
    scene.solver.tolerance = std::max(scene.solver.tolerance / finer, scene::bounds::least_tolerance);
    if (scene.tilt && scene.circular_spline.width) {
        if (!scene.slices)
            scene.slices.emplace();
        scene.slices->count = std::max(ends, scene.slices->count);
    }
    return scene;
}

/// Whether all points of the layer that write_dxf() draws the assembled tooth on stand outside the round one.
bool is_assembled_tooth(Inspection const& found, PointFile const& measured)
{
    return measured.layers == std::vector<std::string>{inspect::flexspline_layer} &&
           std::ranges::all_of(found.points, [](PointDeviation const& point) {
               return point.fate != PointFate::used || point.deviation > inspect::plane_thickness;
           });
}

void require_finite(Faults& faults, char const* option, std::optional<double> given)
{
    if (given && !std::isfinite(*given))
        faults.push_back({option, 0, short_number(*given), "is no finite number", "write a length in mm"});
}

}  // namespace

Inspection inspect_points(Scene const& scene, PointFile const& given, InspectOptions const& options,
                          StageObserver const& on_stage)
{
    throw_if_any(scene::value_faults(scene));
    Faults faults = check_scene(scene);
    require_finite(faults, "--probe", options.probe);
    require_finite(faults, "--plane", options.plane);
    throw_if_any(faults);
    PointFile const measured = inspect::of_own_layer(given, options.part);
    std::vector<MeasuredPlane> const planes = inspect::planes_of(measured, options);
    inspect::refuse_planes_outside(planes, scene, measured, options);
    NominalPart part;
    part.space = options.part == InspectedPart::circular_spline;
    part.teeth = part.space ? scene.drive.circular_spline_teeth : scene.drive.flexspline_teeth;
    inspect::refuse_numbers(measured, part);
    PairGeometry geometry;
    if (part.space || scene.is_reverse()) {
        Solution const solution = solve(finely_drawn(scene), on_stage);
        geometry = solution.geometry;
        part.space ? add_spline_planes(part, solution, planes, measured)
                   : add_flexspline_planes(part, solution, planes.size());
    } else {
        add_flexspline_planes(part, scene, planes.size());
    }
    part.scale = part.planes.front().reference_radius;
    Inspection result = inspect::evaluated(scene, part, planes, measured, options);
    result.geometry = geometry;
    if (given.layers.size() > measured.layers.size())
        result.notes.push_back(fmt::format("of the {} layers of the drawing {} is read alone", given.layers.size(),
                                           measured.layers.front()));
    if (is_assembled_tooth(result, measured))
        result.notes.push_back(fmt::format(
            "on the layer {} `solve --dxf` draws the assembled tooth at the major axis, further out by the radial "
            "deformation; here the flexspline is round",
            inspect::flexspline_layer));
    return result;
}

}  // namespace hdconj
