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

namespace {

/// The least width of the space that @p outline bounds, between its mouth at the point @p corner of the land and the
/// slot of @p slot at its root [mm].
double narrowest_of(std::vector<Vec2> const& outline, int corner, double slot)
{
    double const root = std::ranges::max(outline, {}, [](Vec2 const& p) { return p.norm(); }).norm();
    double narrowest = 2 * std::abs(outline[static_cast<std::size_t>(corner)].x());
    for (Vec2 const& p : outline)
        if (p.norm() <= root - slot / 2)
            narrowest = std::min(narrowest, 2 * std::abs(p.x()));
    return narrowest;
}

}  // namespace

std::optional<Note> narrow_space(Scene const& scene, Solution const& solution)
{
    if (scene.is_reverse())
        return std::nullopt;
    WireRequest const wire = wire_of(scene);
    double const slot = wire.wire_diameter + 2 * wire.spark_gap;
    auto const& [z, outlines, landmarks, pieces] = solution.circular_spline;
    double narrowest = std::numeric_limits<double>::infinity(), where = 0;
    for (std::size_t k = 0; k < z.size(); ++k)
        if (double const width = narrowest_of(outlines[k], landmarks.front(), slot); width < narrowest) {
            narrowest = width;
            where = z[k];
        }
    auto note = note_on(NoteCode::narrow_space, narrowest / slot);
    if (!note)
        return note;
    note->place = "tooth space" + (z.size() > 1 ? " at z = " + short_number(where) + " mm" : std::string());
    note->cause = wire_name(scene) + " cuts a slot of " + short_number(slot) + " mm, and the space is " +
                  short_number(narrowest, 3) + " mm wide";
    note->advice = "take a thinner wire, or a wider tip of the flexspline's tooth";
    return note;
}

}  // namespace hdconj::judgement
