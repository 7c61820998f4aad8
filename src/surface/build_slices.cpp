// SPDX-License-Identifier: GPL-3.0-or-later
#include "build_slices.hpp"

#include <numbers>

#include "base/text.hpp"
#include "conjugate/plane/outline_records.hpp"
#include "drive/drive.hpp"
#include "moved_outline.hpp"
#include "slice_places.hpp"
#include "tooth_surface.hpp"

namespace hdconj::surface {
namespace {

/// Every slice is the outline at z = 0, moved along its radii where the teeth are tilted.
void repeat_outline(Solution& out, std::vector<double> const& z, double tilt, drive::StageClock& clock)
{
    conjugate::MatchedOutline outline;
    clock.run(Stage::surface, [&] {
        outline.points.assign(z.size(), out.circular_spline.outline.front());
        outline.normals.resize(z.size());
        outline.chord = out.error.chord;
    });
    clock.run(Stage::tilt, [&] { move_radially(outline, z, tilt); });
    out.circular_spline.z = z;
    out.circular_spline.outline = std::move(outline.points);
    out.error.chord = outline.chord;
}

/// Tip circle and land of the slice in the middle.
void take_tip(Solution& out, conjugate::MatchedOutline const& outline, TipCircle const& widened)
{
    double const tip = widened.radius;
    if (tip == out.geometry.circular_spline_inner_radius)
        return;
    out.notes.push_back("tip circle enlarged from " + short_number(out.geometry.circular_spline_inner_radius) + " to " +
                        short_number(tip) + " mm: " + widened.why);
    auto const& middle = outline.points[outline.points.size() / 2];
    out.geometry.space_depth += out.geometry.circular_spline_inner_radius - tip;
    out.geometry.circular_spline_inner_radius = tip;
    double const pitch = 2 * std::numbers::pi / out.scene.drive.circular_spline_teeth;
    out.geometry.land_half_angle =
        conjugate::land_half_angle(middle[outline.landmarks[0]], middle[outline.landmarks[4]], pitch);
}

SurfaceSpec spec_of(Scene const& scene)
{
    SurfaceSpec spec{scene.slices->surface, TiltKind::radial, 0};
    if (scene.tilt && scene.tilt->angle != 0) {
        spec.kind = scene.tilt->kind;
        spec.tilt = scene.tilt->angle;
    }
    return spec;
}

/// Whether all slices are the outline at z = 0, moved along its radii at most.
bool repeats_outline(Scene const& scene, SurfaceSpec const& spec)
{
    bool const follows = scene.coning && spec.surface != ToothSurface::tilted;
    return !follows && !spec.is_drafted();
}

/// Such slices in other planes: every point moves along a straight line.
void move_points(CircularSplineOutline& spline, std::vector<double> const& z)
{
    std::vector<Vec2> const first = spline.outline.front(), last = spline.outline.back();
    double const begin = spline.z.front(), width = spline.z.back() - begin;
    spline.z = z;
    spline.outline.assign(z.size(), first);
    for (std::size_t k = 0; k < z.size(); ++k)
        for (std::size_t i = 0; i < first.size(); ++i)
            spline.outline[k][i] += (z[k] - begin) / width * (last[i] - first[i]);
}

}  // namespace

void write_outlines(Solution& out, conjugate::MatchedOutline const& outline, profile::Profile const& tooth,
                    std::vector<double> const& z, ToothSurface surface)
{
    conjugate::Outline common;
    common.stretches = outline.stretches;
    out.circular_spline.z = z;
    out.circular_spline.outline = outline.points;
    out.circular_spline.pieces = conjugate::piece_records(common, tooth);
    out.circular_spline.landmarks.assign(outline.landmarks.begin(), outline.landmarks.end());
    out.error.chord = std::max(out.error.chord, outline.chord);
    if (surface == ToothSurface::ruled && out.scene.coning && outline.points.size() > 2)
        out.error.point = std::max(out.error.point, outline.chord);
}

void build_slices(Solution& out, profile::Profile const& tooth, wavegen::AnyWaveShape const& shape,
                  drive::StageClock& clock)
{
    Scene const& scene = out.scene;
    std::vector<double> const z = slice_places(scene.slices->count, scene.circular_spline.width.value_or(0));
    SurfaceSpec const spec = spec_of(scene);
    if (repeats_outline(scene, spec))
        return repeat_outline(out, z, spec.tilt, clock);
    Solution const base = out;
    ToothSurfaceBuilder builder(base, tooth, shape, z, out.threads);
    NominalSurface const made = builder.nominal_surface(spec, {scene.solver.tolerance}, clock);
    // a draft is part of the surface, and a tilt of 0 moves nothing: the stage is planned all the same
    if (!spec.is_tilted_radially())
        clock.run(Stage::tilt, [] {});
    write_outlines(out, made.outline, tooth, z, spec.surface);
    if (!made.note.empty())
        out.notes.push_back(made.note);
    take_tip(out, made.outline, made.tip);
}

void move_slices(Solution& out, profile::Profile const& tooth, wavegen::AnyWaveShape const& shape,
                 std::vector<double> const& z)
{
    Scene const& scene = out.scene;
    SurfaceSpec const spec = spec_of(scene);
    if (repeats_outline(scene, spec))
        return move_points(out.circular_spline, z);
    Solution const base = out;
    ToothSurfaceBuilder builder(base, tooth, shape, z, out.threads);
    write_outlines(out, builder.outline(spec, base.geometry.circular_spline_inner_radius, {scene.solver.tolerance}),
                   tooth, z, spec.surface);
}

}  // namespace hdconj::surface
