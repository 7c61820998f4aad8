// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "checks.hpp"
#include "limits.hpp"

namespace hdconj::judgement {
namespace {

/// Length of the tooth's flat tip, 0 where it is pointed [mm]; nothing where it is round.
std::optional<double> flat_tip(profile::Profile const& tooth)
{
    double length = 0;
    bool any = false;
    for (std::size_t i = 0; i < tooth.pieces.size(); ++i) {
        if (!profile::is_tip(tooth, static_cast<int>(i)))
            continue;
        any = true;
        profile::PieceShape const& shape = tooth.pieces[i].shape;
        length += (profile::end_of(shape).point - profile::start_of(shape).point).norm();
    }
    return any ? std::optional(length) : std::nullopt;
}

/// The height above the pitch line up to which @p tooth is at least @p width thick, from its right flank [mm]; nothing
/// where it nowhere is, or already at its tip.
std::optional<double> height_of_width(profile::Profile const& tooth, double width)
{
    std::vector<Vec2> const polygon = profile::polygon_of(tooth, (tooth.addendum + tooth.dedendum) * 0x1p-10);
    for (std::size_t i = 1; i < polygon.size(); ++i) {
        Vec2 const &before = polygon[i - 1], after = polygon[i];
        if (before.x() >= width / 2 || after.x() < width / 2)
            continue;
        double const share = (width / 2 - before.x()) / (after.x() - before.x());
        return before.y() + share * (after.y() - before.y()) - tooth.pitch_line;
    }
    return std::nullopt;
}

/// The smallest radius at which the circular spline's tooth of @p solution is @p width thick [mm]; nothing where it
/// nowhere is.
std::optional<double> radius_of_land(Solution const& solution, double width)
{
    double const half_pitch = std::numbers::pi / solution.scene.drive.circular_spline_teeth;
    CircularSplineOutline const& spline = solution.circular_spline;
    std::vector<Vec2> const& points = spline.outline.front();
    for (auto i = static_cast<std::size_t>(spline.landmarks.front()); i < points.size() && points[i].x() < 0; ++i) {
        double const radius = points[i].norm();
        if (2 * radius * (half_pitch + std::atan2(points[i].x(), points[i].y())) >= width)
            return radius;
    }
    return std::nullopt;
}

std::string modules(double share)
{
    return short_number(share, 2) + " modules";
}

/// What is wrong with a land of @p note.
std::string thin(Note const& note, char const* member)
{
    return std::string("the tip land of the ") + member + " is " + modules(note.figure) + " wide, and " +
           modules(note.limit) + " is " + (note.severity == Severity::warning ? "accepted" : "usual");
}

/// Lands are advised this much wider than the limit that they miss.
constexpr double margin = 1.05;

}  // namespace

std::optional<Note> tip_land(UnsolvedPair const& pair)
{
    double const module = pair.scene.drive.module;
    auto const width = pair.scene.is_reverse() ? std::nullopt : flat_tip(pair.tooth);
    auto note = width ? note_on(NoteCode::tip_land, *width / module) : std::nullopt;
    if (!note)
        return note;
    note->place = "flexspline.profile";
    note->cause = thin(*note, "flexspline");
    note->advice = "write a smaller addendum or a thicker tooth";
    auto const height = height_of_width(pair.tooth, margin * limit_of(note->code).usual.low * module);
    if (height && *height > 0 && pair.scene.given_profile().has("addendum")) {
        std::string const addendum = short_number(*height, 3);
        note->advice = "write flexspline.profile.addendum = " + addendum + ", or a thicker tooth";
        note->set = {"flexspline.profile.addendum=" + addendum};
    }
    return note;
}

std::optional<Note> land(Solution const& solution)
{
    PairGeometry const& g = solution.geometry;
    double const module = solution.scene.drive.module;
    auto note = note_on(NoteCode::land, 2 * g.land_half_angle * g.circular_spline_inner_radius / module);
    if (!note)
        return note;
    note->place = "circular_spline.inner_radius";
    note->cause = thin(*note, "circular spline");
    note->advice = "write a larger circular_spline.inner_radius";
    auto const radius = radius_of_land(solution, margin * limit_of(note->code).usual.low * module);
    if (solution.scene.is_reverse()) {
        note->advice = "write a smaller addendum of its tooth";
    } else if (radius) {
        std::string const value = short_number(*radius, 6);
        note->advice = "write circular_spline.inner_radius = " + value + ", or a thinner flexspline tooth";
        note->set = {"circular_spline.inner_radius=" + value};
    }
    return note;
}

}  // namespace hdconj::judgement
