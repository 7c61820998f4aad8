// SPDX-License-Identifier: GPL-3.0-or-later
// Contact arcs of lines, arcs and corners, whose contacts are closed forms.
#pragma once

#include <variant>
#include <vector>

#include "hdconj/envelope/critical_angles.hpp"
#include "hdconj/envelope/envelope.hpp"

namespace hdconj::envelope {

/// Contact arcs of a line, arc or corner on one smooth range. Between cuts a candidate is a contact everywhere or
/// nowhere, so the middle of each interval stands for all of it.
template <motion::RelativeMotion Motion>
class ClosedFormTracer
{
  public:
    ClosedFormTracer(Envelope<Motion> const& envelope, int piece, CutRange const& range)
        : envelope_(envelope), piece_(piece), range_(range)
    {
    }

    /// Appends the arcs to @p out.
    void operator()(std::vector<ContactArc>& out)
    {
        bool const circle = std::holds_alternative<profile::ArcPiece>(shape());
        for (int candidate : circle ? std::vector<int>{-1, 1} : std::vector<int>{0})
            trace(candidate, out);
    }

  private:
    [[nodiscard]] profile::PieceShape const& shape() const
    {
        return envelope_.profile().pieces[static_cast<std::size_t>(piece_)].shape;
    }

    /// Lines have one candidate, arcs two opposite normals.
    void trace(int candidate, std::vector<ContactArc>& out)
    {
        std::vector<double> const& cuts = range_.cuts;
        ContactArc arc;
        arc.piece = piece_;
        arc.candidate = candidate;
        bool open = false;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (!(cuts[i + 1] > cuts[i]))
                continue;
            double const t = envelope_.contact(arc, 0.5 * (cuts[i] + cuts[i + 1])).t;
            bool const inside = t >= 0 && t <= 1;
            if (inside && !open)
                arc.u_begin = cuts[i];
            if (inside)
                arc.u_end = cuts[i + 1];
            if (open && !inside)
                out.push_back(closed(arc));
            open = inside;
        }
        if (open)
            out.push_back(closed(arc));
    }

    [[nodiscard]] ContactArc closed(ContactArc arc) const
    {
        arc.begins = arc.u_begin == range_.cuts.front() ? range_.at_begin() : BranchEnd::segment_end;
        arc.ends = arc.u_end == range_.cuts.back() ? range_.at_end() : BranchEnd::segment_end;
        auto const settled = [&](double u, BranchEnd why) {
            double const t = envelope_.contact(arc, u).t;
            return why == BranchEnd::segment_end ? (t < 0.5 ? 0.0 : 1.0) : t;
        };
        arc.t_begin = settled(arc.u_begin, arc.begins);
        arc.t_end = settled(arc.u_end, arc.ends);
        arc.resting = rests(arc);
        return arc;
    }

    /// Whether the arc's centre moves less than coordinates are rounded by while the contact runs along the arc.
    [[nodiscard]] bool rests(ContactArc const& arc) const
    {
        auto const* circle = std::get_if<profile::ArcPiece>(&shape());
        if (circle == nullptr || arc.candidate == 0 || arc.t_begin == arc.t_end)
            return false;
        auto const centre = [&](double u) { return envelope_.motion().pose(u)(circle->centre); };
        Vec2 const begin = centre(arc.u_begin);
        constexpr double roundings = 8;
        double const rounding = roundings * unit_roundoff * begin.norm();
        return (centre(arc.u_end) - begin).norm() <= rounding &&
               (centre(0.5 * (arc.u_begin + arc.u_end)) - begin).norm() <= rounding;
    }

    Envelope<Motion> const& envelope_;
    int piece_;
    CutRange const& range_;
};

}  // namespace hdconj::envelope
