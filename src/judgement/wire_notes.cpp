// SPDX-License-Identifier: GPL-3.0-or-later
// The wire that a design is judged for, and the space that it is to enter.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/text.hpp"
#include "checks.hpp"
#include "limits.hpp"
#include "scene/usual_wire.hpp"
#include "wire.hpp"

namespace hdconj::judgement {

WireRequest wire_of(Scene const& scene)
{
    if (scene.wedm)
        return *scene.wedm;
    WireRequest wire;
    wire.wire_diameter = std::stod(std::string(scene::usual_wire));
    wire.spark_gap = std::stod(std::string(scene::usual_spark_gap));
    return wire;
}

std::string wire_name(Scene const& scene)
{
    return scene.wedm ? "the wire of [wedm]" : "a wire of " + short_number(wire_of(scene).wire_diameter) + " mm";
}

std::optional<Note> narrow_space(Solution const& solution)
{
    if (solution.scene.is_reverse())
        return std::nullopt;
    WireRequest const wire = wire_of(solution.scene);
    PairGeometry const& g = solution.geometry;
    double const slot = wire.wire_diameter + 2 * wire.spark_gap;
    double const deepest = g.circular_spline_inner_radius + g.space_depth - slot / 2;
    double narrowest = std::numeric_limits<double>::infinity();
    for (Vec2 const& p : solution.circular_spline.outline.front())
        if (p.norm() <= deepest)
            narrowest = std::min(narrowest, 2 * std::abs(p.x()));
    auto note = note_on(NoteCode::narrow_space, narrowest / slot);
    if (!note)
        return note;
    note->place = "tooth space";
    note->cause = wire_name(solution.scene) + " cuts a slot of " + short_number(slot) + " mm, and the space is " +
                  short_number(narrowest, 3) + " mm wide";
    note->advice = "take a thinner wire, or a wider tip of the flexspline's tooth";
    return note;
}

}  // namespace hdconj::judgement
