// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include "base/text.hpp"
#include "checks.hpp"
#include "hdconj/units.hpp"
#include "limits.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

/// How far the tips stand outside the tip circle at the share @p s of a lobe's half [mm].
double overlap(UnsolvedPair const& pair, double s)
{
    PairGeometry const& g = pair.geometry;
    double const u = std::numbers::pi / pair.shape.waves() * s;
    return g.r_m + pair.shape(u).w + g.pitch_line + g.addendum - g.circular_spline_inner_radius;
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
    // where they would leave it within the usual range
    double const wanted = std::max(g.circular_spline_inner_radius + overlap(pair, limit_of(note->code).usual.high),
                                   scene::usual_tip_radius(pair.scene, g.w0).value_or(0));
    std::string const radius = short_number(wanted + 0.01 * pair.scene.drive.module, 6);
    if (pair.scene.is_reverse()) {
        note->advice = "write a smaller flexspline.addendum";
        return note;
    }
    note->advice = "write circular_spline.inner_radius = " + radius + ", or a smaller addendum";
    note->set = {"circular_spline.inner_radius=" + radius};
    return note;
}

}  // namespace hdconj::judgement
