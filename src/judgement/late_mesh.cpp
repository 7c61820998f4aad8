// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
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

/// How far the tips stand outside the tip circle at the angle @p u, where that is smallest [mm].
double overlap(UnsolvedPair const& pair, double u)
{
    PairGeometry const& g = pair.geometry;
    return g.r_m + pair.shape(u).w + g.pitch_line + g.addendum - g.circular_spline_inner_radius +
           closer_by_tilt(pair.scene);
}

/// The lobe that reaches furthest out: its major axis, half-way between the minor axes on either side. [rad]
struct Lobe
{
    double major = 0, half = 0;

    explicit Lobe(wavegen::AnyWaveShape const& shape)
    {
        constexpr int steps = 256;  // a period; both axes of an even shape are among them
        double const step = 2 * std::numbers::pi / shape.waves() / steps;
        std::array<double, steps> w{};
        for (int i = 0; i < steps; ++i)
            w[static_cast<std::size_t>(i)] = shape(i * step).w;
        auto const [low, high] = std::ranges::minmax_element(w);
        int const top = static_cast<int>(high - w.begin());
        // a rise by half of the whole ends a lobe; waviness and the hollow between two rollers do not
        double const rise = (*high - *low) / 2;
        auto const minor = [&, highest = *high](int direction) {
            double lowest = highest;
            int where = 0;
            for (int i = 1; i < steps; ++i) {
                double const here = w[static_cast<std::size_t>((top + direction * i + steps) % steps)];
                if (here > lowest + rise)
                    break;
                if (here < lowest) {
                    lowest = here;
                    where = i;
                }
            }
            return (top + direction * where) * step;
        };
        double const before = minor(-1), after = minor(1);
        major = (before + after) / 2;
        half = (after - before) / 2;
    }
};

/// How far the tips stand outside the tip circle at the share @p s of the way to a minor axis, on the side where that
/// is more [mm].
double overlap(UnsolvedPair const& pair, Lobe const& lobe, double s)
{
    return std::max(overlap(pair, lobe.major - s * lobe.half), overlap(pair, lobe.major + s * lobe.half));
}

/// The largest share of the way to a minor axis at which the tips stand outside the tip circle.
double leaving_share(UnsolvedPair const& pair, Lobe const& lobe)
{
    constexpr int steps = 256;
    double after = overlap(pair, lobe, 1);
    if (after > 0)
        return 1;
    for (int i = steps - 1; i >= 0; --i) {
        double const share = static_cast<double>(i) / steps, here = overlap(pair, lobe, share);
        if (here > 0)
            return share + here / (here - after) / steps;
        after = here;
    }
    return 0;
}

/// What the tip circle has to grow by for the tips to leave it at the share @p s and stay inside from there on [mm].
double growth_to_leave(UnsolvedPair const& pair, Lobe const& lobe, double s)
{
    constexpr int steps = 32;
    double growth = overlap(pair, lobe, 1);
    for (int i = 0; i < steps; ++i)
        growth = std::max(growth, overlap(pair, lobe, s + (1 - s) * i / steps));
    return growth;
}

}  // namespace

std::optional<Note> late_mesh(UnsolvedPair const& pair)
{
    Lobe const lobe(pair.shape);
    double const share = leaving_share(pair, lobe);
    auto note = note_on(NoteCode::late_mesh, share);
    if (!note)
        return note;
    PairGeometry const& g = pair.geometry;
    note->place = "circular_spline.inner_radius";
    note->cause = share < 1
                      ? "the tips leave the tip circle at " + short_number(share * to_deg(lobe.half), 3) +
                            " degrees from the major axis, of " + short_number(to_deg(lobe.half)) + " to the minor axis"
                      : "the tips never leave the tip circle: at the minor axis they overlap by " +
                            short_number(overlap(pair, lobe, 1), 3) + " mm";
    double const closer = closer_by_tilt(pair.scene);
    if (closer > 0)
        note->cause += "; the tilt makes the tip circle of one end " + short_number(closer, 3) + " mm smaller";
    // where they would leave it within the usual range
    double const growth = growth_to_leave(pair, lobe, limit_of(note->code).usual.high),
                 margin = 0.01 * pair.scene.drive.module;
    if (pair.scene.is_reverse()) {
        double const wanted =
            std::min(g.addendum - growth, scene::usual_addendum(pair.scene, g.w0).value_or(g.addendum) - closer) -
            margin;
        std::string const other = "a smaller circular_spline.profile.addendum or a larger radial deformation";
        note->advice = "write " + other;
        if (wanted > 0) {
            std::string const addendum = at_most_text(wanted);
            note->advice = "write flexspline.addendum = " + addendum + ", " + other;
            note->set = {"flexspline.addendum=" + addendum};
        }
        return note;
    }
    double const wanted = std::max(g.circular_spline_inner_radius + growth,
                                   scene::usual_tip_radius(pair.scene, g.w0).value_or(0) + closer);
    std::string const radius = short_number(wanted + margin, 6);
    note->advice =
        "write circular_spline.inner_radius = " + radius + ", or a smaller addendum" + (closer > 0 ? " or tilt" : "");
    note->set = {"circular_spline.inner_radius=" + radius};
    return note;
}

}  // namespace hdconj::judgement
