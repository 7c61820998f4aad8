// SPDX-License-Identifier: GPL-3.0-or-later
#include "sharp_corner.hpp"

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "hdconj/units.hpp"
#include "judgement/judgement.hpp"
#include "judgement/limits.hpp"
#include "judgement/wire.hpp"
#include "paired_path.hpp"
#include "pitch_pass.hpp"

namespace hdconj::wedm {
namespace {

/// @p scene with the wire that is judged, which cuts the circular spline.
Scene judged(Scene const& scene)
{
    Scene wired = scene;
    wired.wedm = judgement::wire_of(scene);
    wired.wedm->part = WirePart::circular_spline;
    if (thickness_of(wired) <= 0)
        wired.wedm->thickness = 1;  // both faces are the same: any will do
    return wired;
}

/// Part of the wire's tolerance that a contour may lose by having fewer points: what moves and arcs leave of it.
constexpr double share_of_contour = 1.0 / 32;

/// @p outline with fewer points. At both ends of the face width every point that is left out lies within
/// share_of_contour of @p tolerance [mm] of the straight line between its neighbours. Landmarks and ends of pieces
/// stay.
CircularSplineOutline with_fewer_points(CircularSplineOutline const& outline, double tolerance)
{
    std::vector<std::size_t> marked(outline.landmarks.begin(), outline.landmarks.end());
    for (OutlinePiece const& piece : outline.pieces)
        marked.insert(marked.end(), {piece.first, piece.last});
    std::ranges::sort(marked);
    std::vector<std::size_t> const kept =
        thinned({outline.outline.front(), outline.outline.back()}, share_of_contour * tolerance, marked);
    auto const number = [&](std::size_t point) {
        return static_cast<std::size_t>(std::ranges::lower_bound(kept, point) - kept.begin());
    };
    CircularSplineOutline few = outline;
    for (auto& points : few.outline) {
        std::vector<Vec2> taken;
        for (std::size_t const i : kept)
            taken.push_back(points[i]);
        points = std::move(taken);
    }
    for (int& mark : few.landmarks)
        mark = static_cast<int>(number(static_cast<std::size_t>(mark)));
    for (OutlinePiece& piece : few.pieces) {
        piece.first = number(piece.first);
        piece.last = number(piece.last);
    }
    return few;
}

std::optional<Note> sharp_corner(Scene const& scene, CircularSplineOutline const& outline)
{
    Scene const wired = judged(scene);
    WireRequest const& wire = *wired.wedm;
    if (wire.wire_diameter + 2 * wire.spark_gap >= std::numbers::pi * scene.drive.module)
        return std::nullopt;  // enters no space
    int const teeth = scene.drive.circular_spline_teeth;
    double const thickness = thickness_of(wired);
    WireJob const about(wired, wire_faces(with_fewer_points(outline, wire.tolerance), teeth, thickness));
    if (fits_well(about))
        return std::nullopt;
    WireJob const job(wired, wire_faces(outline, teeth, thickness));
    PitchPass const pass = pitch_pass(job, wire.wire_diameter, 0);
    Residual const* const worst = pass.uncut.highest();
    if (worst == nullptr)
        return std::nullopt;
    auto note =
        judgement::note_on(NoteCode::sharp_corner, (worst->height + job.residual_error()) / wire.residual_limit);
    if (!note)
        return note;
    note->place = std::string("tooth space near (") + short_number(worst->where.x(), 4) + ", " +
                  short_number(worst->where.y(), 6) + ") mm" +
                  (job.surface ? worst->upper ? " of the upper face" : " of the lower face" : "");
    note->cause = judgement::wire_name(scene) + " leaves " + short_number(worst->height * per_um, 3) + " +- " +
                  short_number(job.residual_error() * per_um, 2) + " um there, " +
                  (worst->meshing ? "on a flank" : "in the root") + ", which is too sharp for it";
    auto const thinner = fitting_wire(job);
    note->advice = (thinner ? "take a thinner wire, of at most " + short_number(*thinner) + " mm, or"
                            : std::string("no thinner wire that is sold leaves so little:")) +
                   " round the corner of the flexspline's tip that passes there; a larger "
                   "circular_spline.root_clearance moves the corner away from the teeth, but leaves it sharp";
    return note;
}

}  // namespace

void judge_sharp_corner(Notes& notes, Scene const& scene, CircularSplineOutline const& outline)
{
    judgement::replace_note(notes, NoteCode::sharp_corner,
                            scene.is_reverse() ? std::nullopt : sharp_corner(scene, outline));
}

}  // namespace hdconj::wedm
