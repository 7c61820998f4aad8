// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/profile/builder.hpp"
#include "base/text.hpp"

#include <cmath>
#include <numbers>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::profile {
namespace {

/// Mirror image about the y axis, traversed the other way, so that the body stays on the same side.
PieceShape mirrored(PieceShape const& shape)
{
    auto const flip = [](Vec2 const& p) { return Vec2(-p.x(), p.y()); };
    if (auto const* line = std::get_if<LinePiece>(&shape))
        return LinePiece{flip(line->b), flip(line->a)};
    if (auto const* arc = std::get_if<ArcPiece>(&shape))
        return ArcPiece{flip(arc->centre), arc->radius, std::numbers::pi - arc->to, std::numbers::pi - arc->from};
    auto const& curve = std::get<CurvePiece>(shape);
    std::vector<double> x(curve.x().rbegin(), curve.x().rend());
    for (double& value : x)
        value = -value;
    return CurvePiece(std::move(x), {curve.y().rbegin(), curve.y().rend()});
}

FlankSegment mirrored(FlankSegment const& segment)
{
    FlankSegment image{segment.name, {}};
    for (auto piece = segment.pieces.rbegin(); piece != segment.pieces.rend(); ++piece)
        image.pieces.push_back(mirrored(*piece));
    return image;
}

/// The convex corner between two pieces, or nothing where they share a tangent or make a concave angle.
void append_corner(Profile& profile, PieceShape const& before, PieceShape const& after)
{
    PieceEnd const in = end_of(before);
    PieceEnd const out = start_of(after);
    // the turn of a joint that was computed as tangent is roundoff; it sweeps less than roundoff of the tooth
    constexpr double tangent = 1024 * unit_roundoff;
    double const turn = std::atan2(cross(in.normal, out.normal), in.normal.dot(out.normal));
    if (turn >= -tangent)
        return;
    double const from = std::atan2(in.normal.y(), in.normal.x());
    ProfilePiece corner{ArcPiece{in.point, 0, from, from + turn}, profile.pieces.back().segment, 0, 1, true};
    profile.pieces.push_back(std::move(corner));
}

}  // namespace

Profile whole_tooth(std::vector<FlankSegment> const& segments, ToothPlace const& place, double addendum,
                    double dedendum, bool mirror_symmetric)
{
    Profile profile;
    profile.mirror_symmetric = mirror_symmetric;
    profile.addendum = addendum;
    profile.dedendum = dedendum;
    profile.pitch_line = place.wall / 2 + dedendum + place.neutral_offset;
    for (FlankSegment const& segment : segments) {
        int const index = static_cast<int>(profile.segment_names.size());
        profile.segment_names.push_back(segment.name);
        double const count = static_cast<double>(segment.pieces.size());
        for (std::size_t i = 0; i < segment.pieces.size(); ++i) {
            PieceShape shape = moved_up(segment.pieces[i], profile.pitch_line);
            // inside a segment pieces join smoothly by construction
            if (i == 0 && !profile.pieces.empty())
                append_corner(profile, profile.pieces.back().shape, shape);
            double const k = static_cast<double>(i);
            profile.pieces.push_back({std::move(shape), index, k / count, (k + 1) / count, false});
        }
    }
    for (Vec2 const& p : polygon_of(profile, (addendum + dedendum) / 1024))
        profile.root_half_width = std::max(profile.root_half_width, std::abs(p.x()));
    return profile;
}

FlankSegment curve_segment(std::string name, std::vector<CurvePiece> pieces)
{
    FlankSegment segment{std::move(name), {}};
    for (CurvePiece& piece : pieces)
        segment.pieces.emplace_back(std::move(piece));
    return segment;
}

Profile symmetric_tooth(std::vector<FlankSegment> const& right_flank, ToothPlace const& place, double addendum,
                        double dedendum)
{
    std::vector<FlankSegment> segments;
    for (auto segment = right_flank.rbegin(); segment != right_flank.rend(); ++segment) {
        segments.push_back(mirrored(*segment));
        segments.back().name = "left " + segment->name;
    }
    Vec2 const tip = start_of(right_flank.front().pieces.front()).point;
    // a land shorter than roundoff has no direction: the tooth is pointed
    if (tip.x() > unit_roundoff * (addendum + dedendum))
        segments.push_back({"tip land", {LinePiece{{-tip.x(), tip.y()}, tip}}});
    for (FlankSegment segment : right_flank) {
        segment.name = "right " + segment.name;
        segments.push_back(std::move(segment));
    }
    return whole_tooth(segments, place, addendum, dedendum, true);
}

double thickness_at_pitch(scene::FamilyChoice const& choice, ToothPlace const& place, Faults& faults)
{
    double const pitch = std::numbers::pi * place.module;
    double const s = choice.number_or("thickness", pitch / 2);
    if (!(s < pitch))
        faults.push_back(scene::parameter_fault(
            choice, "thickness", "leaves no space between the teeth: the pitch is " + short_number(pitch),
            "write about half the pitch, " + short_number(pitch / 2)));
    return s;
}

void refuse_crossing(scene::ParameterFaults const& refuse, double pointed, std::string const& otherwise)
{
    std::string const lower =
        pointed > 0 ? "write an addendum of at most " + at_most_text(pointed) + ", or " : "write ";
    refuse("addendum",
           "the two flanks cross below the tip: the tooth becomes pointed at height " + short_number(pointed),
           lower + otherwise);
}

}  // namespace hdconj::profile
