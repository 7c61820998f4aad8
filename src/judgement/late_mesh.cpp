// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/units.hpp"
#include "limits.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

/// How far a tilt brings the tip circle towards the axis in one of the outer slices, below that of z = 0 [mm].
double closer_by_tilt(Scene const& scene)
{
    bool const tilts = scene.tilt && scene.slices && scene.slices->count > 1;
    return tilts ? std::abs(std::tan(scene.tilt->angle)) * scene.circular_spline.width.value_or(0) / 2 : 0;
}

/// How far the tips stand outside the tip circle, where that is smallest, at the share @p s of a lobe's half [mm].
double overlap(UnsolvedPair const& pair, double s)
{
    PairGeometry const& g = pair.geometry;
    double const u = std::numbers::pi / pair.shape.waves() * s;
    return g.r_m + pair.shape(u).w + g.pitch_line + g.addendum - g.circular_spline_inner_radius +
           closer_by_tilt(pair.scene);
}

/// The largest share of a lobe's half at which the tips stand outside the tip circle.
double leaving_share(UnsolvedPair const& pair)
{
    constexpr int steps = 256;
    double after = overlap(pair, 1);
    if (after > 0)
        return 1;
    for (int i = steps - 1; i >= 0; --i) {
        double const share = static_cast<double>(i) / steps, here = overlap(pair, share);
        if (here > 0)
            return share + here / (here - after) / steps;
        after = here;
    }
    return 0;
}

}  // namespace

std::optional<Note> late_mesh(UnsolvedPair const& pair)
{
    double const share = leaving_share(pair);
    auto note = note_on(NoteCode::late_mesh, share);
    if (!note)
        return note;
    PairGeometry const& g = pair.geometry;
    double const lobe = to_deg(std::numbers::pi / pair.shape.waves());
    note->place = "circular_spline.inner_radius";
    note->cause = share < 1 ? "the tips leave the tip circle at " + short_number(share * lobe, 3) +
                                  " degrees from the major axis, of " + short_number(lobe) + " to the minor axis"
                            : "the tips never leave the tip circle: at the minor axis they overlap by " +
                                  short_number(overlap(pair, 1), 3) + " mm";
    double const closer = closer_by_tilt(pair.scene);
    if (closer > 0)
        note->cause += "; the tilt makes the tip circle of one end " + short_number(closer, 3) + " mm smaller";
    // where they would leave it within the usual range
    double const wanted = std::max(g.circular_spline_inner_radius + overlap(pair, limit_of(note->code).usual.high),
                                   scene::usual_tip_radius(pair.scene, g.w0).value_or(0) + closer);
    std::string const radius = short_number(wanted + 0.01 * pair.scene.drive.module, 6);
    if (pair.scene.is_reverse()) {
        note->advice = "write a smaller flexspline.addendum";
        return note;
    }
    note->advice =
        "write circular_spline.inner_radius = " + radius + ", or a smaller addendum" + (closer > 0 ? " or tilt" : "");
    note->set = {"circular_spline.inner_radius=" + radius};
    return note;
}

}  // namespace hdconj::judgement
