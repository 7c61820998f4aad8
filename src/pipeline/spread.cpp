// SPDX-License-Identifier: GPL-3.0-or-later
#include "spread.hpp"

#include <cmath>
#include <numbers>

#include "contact_case.hpp"
#include "drive.hpp"
#include "hdconj/axial/cone.hpp"
#include "hdconj/axial/slice_places.hpp"
#include "hdconj/numeric/parallel.hpp"
#include "hdconj/pipeline/contact.hpp"
#include "hdconj/profile/builder.hpp"
#include "moved_outline.hpp"
#include "outline_records.hpp"
#include "spline_surface.hpp"

namespace hdconj::detail {
namespace {

/// Every slice is the outline at z = 0, perhaps moved along its radii.
void repeat_outline(Solution& out, std::vector<double> const& z, double tilt)
{
    CircularSplineOutline& spline = out.circular_spline;
    std::vector<Vec2> const middle = spline.outline.front();
    spline.z = z;
    spline.outline.assign(z.size(), middle);
    if (tilt == 0)
        return;
    double const chord = out.error.chord;
    for (std::size_t k = 0; k < z.size(); ++k)
    {
        double const distance = z[k] * std::tan(tilt);
        if (distance != 0)
            out.error.chord = std::max(out.error.chord, chord_moved_radially(middle, chord, distance));
        for (Vec2& p : spline.outline[k])
            p = moved_radially(p, distance);
    }
}

void take(Solution& out, MatchedOutline const& outline, Profile const& tooth, std::vector<double> const& z)
{
    Outline common;
    common.stretches = outline.stretches;
    out.circular_spline.z = z;
    out.circular_spline.outline = outline.points;
    out.circular_spline.pieces = piece_records(common, tooth);
    out.circular_spline.landmarks.assign(outline.landmarks.begin(), outline.landmarks.end());
    take_errors(out, outline, out.scene.slices->surface);
}

/// Tip circle and land of the slice in the middle.
void take_tip(Solution& out, MatchedOutline const& outline, double tip, std::string const& why)
{
    if (tip == out.geometry.circular_spline_inner_radius)
        return;
    out.notes.push_back("tip circle widened from " + short_number(out.geometry.circular_spline_inner_radius) + " to " + short_number(tip) + " mm: " + why);
    auto const& middle = outline.points[outline.points.size() / 2];
    out.geometry.space_depth += out.geometry.circular_spline_inner_radius - tip;
    out.geometry.circular_spline_inner_radius = tip;
    double const pitch = 2 * std::numbers::pi / out.scene.drive.circular_spline_teeth;
    out.geometry.land_half_angle = land_half_angle(middle[outline.landmarks[0]], middle[outline.landmarks[4]], pitch);
}

}  // namespace

void take_errors(Solution& out, MatchedOutline const& outline, std::string const& surface)
{
    out.error.chord = std::max(out.error.chord, outline.chord);
    if (surface == "ruled" && out.scene.coning && outline.points.size() > 2)
        out.error.point = std::max(out.error.point, outline.chord);
}

void spread_over_width(Solution& out, Profile const& tooth, AnyWaveShape const& shape, StageClock& clock)
{
    Scene const& scene = out.scene;
    std::vector<double> const z = slice_places(scene.slices->count, scene.circular_spline.width.value_or(0));
    double const tilt = scene.tilt ? scene.tilt->angle : 0;
    bool const draft = scene.tilt && scene.tilt->kind == "draft" && tilt != 0;
    bool const follows = scene.coning && scene.slices->surface != "tilted";
    if (!follows && !draft)
    {
        clock.run(Stage::surface, [&] { repeat_outline(out, z, 0); });
        clock.run(Stage::tilt, [&] { repeat_outline(out, z, tilt); });
        return;
    }
    Solution const base = out;
    SurfaceMaker maker(base, tooth, shape, z, out.threads);
    clock.run(Stage::coning, [&] { maker.find_motions(z.size()); });
    MatchedOutline outline;
    SurfaceChoice const flat{scene.slices->surface, "radial", 0};
    SurfaceChoice const choice{scene.slices->surface, draft ? "draft" : "radial", tilt};
    double const tip = maker.own_tip(choice);
    std::string const why = maker.why_widened();
    clock.run(Stage::surface, [&] {
        if (!draft)
            outline = maker(flat, tip, scene.solver.tolerance, 0);
    });
    clock.run(Stage::tilt, [&] {
        if (draft)
            outline = maker(choice, tip, scene.solver.tolerance, 0);
        else
            move_radially(outline, z, tilt);
    });
    take(out, outline, tooth, z);
    if (std::string const note = maker.note_on_sections(); !note.empty())
        out.notes.push_back(note);
    take_tip(out, outline, tip, why);
}

Solution solve_with_automatic_backlash(Scene const& scene, StageObserver const& on_stage)
{
    Scene given = scene;
    given.circular_spline.automatic_backlash = false;
    given.circular_spline.backlash_offset = 0;
    std::string note = "side clearance \"auto\": none is needed";
    double error = 0;
    bool const moves = scene.slices && scene.slices->count > 1 && (scene.coning || scene.tilt);
    if (moves)
    {
        if (on_stage)
            on_stage(Stage::clearance);
        ClearingNeed const need = clearing_need(scene);
        given.circular_spline.backlash_offset = need.offset;
        bool const wider = need.tip > need.own_tip;
        if (wider)
            given.circular_spline.inner_radius = need.tip;
        error = need.error;
        note = "side clearance \"auto\": " + short_number(need.offset) + (error > 0 ? " +- " + short_number(error) : "") + " mm" + (wider ? ", with a tip circle of " + short_number(need.tip) + " in place of "
                                                                                        + short_number(need.own_tip) + " mm" : "");
    }
    Solution out = solve(given, on_stage);
    out.scene.text = scene.text;
    out.scene.circular_spline.automatic_backlash = true;
    out.notes.insert(out.notes.begin(), note);
    // both flanks move with it, each as far as it does but where it meets the tip circle aslant
    out.error.side_clearance = error;
    out.error.clearance += error;
    out.error.land += 2 * error;
    return out;
}

}  // namespace hdconj::detail
