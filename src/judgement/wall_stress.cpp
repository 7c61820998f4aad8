// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "checks.hpp"
#include "limits.hpp"
#include "scene/usual_drive.hpp"

namespace hdconj::judgement {
namespace {

constexpr double steel = 206e3;  // [MPa] of 30CrMnSiA, where the scene has no cup

/// A wall that is @p factor times as thick, with its neutral layer and inner surface.
scene::Advice thinner_wall(Flexspline const& flexspline, double factor)
{
    constexpr int digits = 3;
    constexpr double inside = 0.99;  // so that rounding keeps the layer in the wall
    std::string const wall = short_number(factor * flexspline.wall, digits);
    scene::Advice advice;
    advice.add("flexspline.wall", wall);
    if (flexspline.neutral_offset != 0)
        advice.add("flexspline.neutral_offset", short_number(inside * factor * flexspline.neutral_offset, digits));
    if (flexspline.inner_radius)
        advice.add("flexspline.inner_radius",
                   short_number(*flexspline.inner_radius + flexspline.wall - std::stod(wall)));
    return advice;
}

}  // namespace

double stress_of_bending(Scene const& scene)
{
    Flexspline const& flexspline = scene.flexspline;
    double const modulus = flexspline.cup ? flexspline.cup->youngs_modulus : steel;
    double const depth = flexspline.wall / 2 + std::abs(flexspline.neutral_offset);
    return modulus * depth;
}

double bending_stress(Scene const& scene, PairGeometry const& g)
{
    double const waves = scene.wave_generator.waves;
    return stress_of_bending(scene) * g.w0 * (waves * waves - 1) / (g.r_m * g.r_m);
}

std::optional<Note> wall_stress(UnsolvedPair const& pair)
{
    Flexspline const& flexspline = pair.scene.flexspline;
    PairGeometry const& g = pair.geometry;
    double const stress = bending_stress(pair.scene, g);
    DesignLimit const limit = design_limits(pair.scene)[static_cast<std::size_t>(NoteCode::wall_stress)];
    auto note = note_on(limit, stress);
    if (!note)
        return note;
    note->place = "flexspline.wall";
    note->cause = "bending the ring stresses it by " + short_number(stress, 3) + " MPa, and " +
                  short_number(note->limit, 3) + " MPa are " +
                  (note->severity == Severity::warning ? "accepted" : "usual");
    double const usual = limit.usual.high;
    scene::Advice const other = scene::usual_pair(pair.scene, g.w0);
    Drive drive = pair.scene.drive;
    drive.circular_spline_teeth = drive.flexspline_teeth + pair.scene.wave_generator.waves;
    double const eased = other.set.empty() ? stress : stress * scene::usual_deformation(drive) / g.w0;
    if (eased < stress) {
        note->advice = "write " + other.words;
        note->set = other.set;
    }
    if (eased > usual || note->set.empty()) {
        scene::Advice const thinner = thinner_wall(flexspline, 0.95 * usual / std::min(stress, eased));
        note->advice += (note->advice.empty() ? "write " : " and ") + thinner.words;
        note->set.insert(note->set.end(), thinner.set.begin(), thinner.set.end());
    }
    note->advice += ", or more teeth";
    return note;
}

}  // namespace hdconj::judgement
