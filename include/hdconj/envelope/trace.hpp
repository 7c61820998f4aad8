// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds every contact arc of a profile: where it begins, where it ends and why.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/envelope/critical_angles.hpp"
#include "hdconj/envelope/envelope.hpp"
#include "hdconj/envelope/smooth_ranges.hpp"
#include "hdconj/numeric/error.hpp"
#include "hdconj/numeric/parallel.hpp"

namespace hdconj {

/// Contact arcs of one piece over the lobe [-pi/n, pi/n], before they are cut at cusps.
///
/// Between two critical angles the number of contacts is constant and each is a smooth function of u; so the contacts
/// at the middle of each interval stand for all, and no arc is lost for being shorter than some step. Where the motion has
/// breaks, the ranges between them are traced one by one and their arcs joined.
template<RelativeMotion Motion>
class PieceTracer
{
  public:
    PieceTracer(Envelope<Motion> const& envelope, int piece) : envelope_(envelope), piece_(piece) {}

    [[nodiscard]] std::vector<ContactArc> operator()(TraceRecord& record)
    {
        for (SmoothRange const& range : smooth_ranges(envelope_.motion()))
        {
            range_ = range;
            critical_ = critical_angles(shape(), envelope_.motion(), range.a, range.b, record);
            cuts_.assign(1, range.a);
            for (CriticalAngle const& c : critical_)
                cuts_.push_back(c.u);
            cuts_.push_back(range.b);
            if (auto const* curve = std::get_if<CurvePiece>(&shape()))
                trace_curve(*curve);
            else
                trace_closed_form();
        }
        join_continuing();
        return std::move(arcs_);
    }

  private:
    [[nodiscard]] PieceShape const& shape() const { return envelope_.profile().pieces[static_cast<std::size_t>(piece_)].shape; }

    /// Lines have one candidate, arcs two opposite normals; membership is constant between cuts.
    void trace_closed_form()
    {
        bool const circle = std::holds_alternative<ArcPiece>(shape());
        std::vector<int> const candidates = circle ? std::vector<int>{-1, 1} : std::vector<int>{0};
        for (int candidate : candidates)
        {
            ContactArc arc;
            arc.piece = piece_;
            arc.candidate = candidate;
            bool open = false;
            for (std::size_t i = 0; i + 1 < cuts_.size(); ++i)
            {
                if (!(cuts_[i + 1] > cuts_[i]))
                    continue;
                double const t = envelope_.contact(arc, 0.5 * (cuts_[i] + cuts_[i + 1])).t;
                bool const inside = t >= 0 && t <= 1;
                if (inside && !open)
                    arc.u_begin = cuts_[i];
                if (inside)
                    arc.u_end = cuts_[i + 1];
                if (open && !inside)
                    close(arc);
                open = inside;
            }
            if (open)
                close(arc);
        }
    }

    void close(ContactArc arc)
    {
        arc.begins = arc.u_begin == cuts_.front() ? at_range_begin() : BranchEnd::segment_end;
        arc.ends = arc.u_end == cuts_.back() ? at_range_end() : BranchEnd::segment_end;
        auto const settled = [&](double u, BranchEnd why) {
            double const t = envelope_.contact(arc, u).t;
            return why == BranchEnd::segment_end ? (t < 0.5 ? 0.0 : 1.0) : t;
        };
        arc.t_begin = settled(arc.u_begin, arc.begins);
        arc.t_end = settled(arc.u_end, arc.ends);
        arc.resting = rests(arc);
        arcs_.push_back(arc);
    }

    /// Whether the arc's centre moves less than coordinates are rounded by while the contact runs along the arc.
    [[nodiscard]] bool rests(ContactArc const& arc) const
    {
        auto const* circle = std::get_if<ArcPiece>(&shape());
        if (circle == nullptr || arc.candidate == 0 || arc.t_begin == arc.t_end)
            return false;
        auto const centre = [&](double u) { return envelope_.motion().pose(u)(circle->centre); };
        Vec2 const begin = centre(arc.u_begin);
        constexpr double roundings = 8;
        double const rounding = roundings * unit_roundoff * begin.norm();
        return (centre(arc.u_end) - begin).norm() <= rounding && (centre(0.5 * (arc.u_begin + arc.u_end)) - begin).norm() <= rounding;
    }

    /// Roots keep their order between cuts, so the k-th root of one interval is the k-th until a cut says otherwise.
    void trace_curve(CurvePiece const& curve)
    {
        Motion const& motion = envelope_.motion();
        for (std::size_t i = 0; i + 1 < cuts_.size(); ++i)
        {
            if (!(cuts_[i + 1] > cuts_[i]))
                continue;
            double const middle = 0.5 * (cuts_[i] + cuts_[i + 1]);
            BernsteinRoots const roots = curve_contacts(curve, motion.rates(middle).twist);
            for (int k = 0; k < roots.count; ++k)
            {
                ContactArc arc;
                arc.piece = piece_;
                arc.candidate = k;
                arc.roots = roots.count;
                arc.u_begin = cuts_[i];
                arc.u_end = cuts_[i + 1];
                double const t = roots.t[static_cast<std::size_t>(k)];
                std::tie(arc.t_begin, arc.begins) = limit(curve, arc, i, middle, t, cuts_[i]);
                std::tie(arc.t_end, arc.ends) = limit(curve, arc, i + 1, middle, t, cuts_[i + 1]);
                arcs_.push_back(arc);
            }
        }
    }

    [[nodiscard]] BranchEnd at_range_begin() const { return range_.from_break ? BranchEnd::continues : BranchEnd::range_end; }
    [[nodiscard]] BranchEnd at_range_end() const { return range_.to_break ? BranchEnd::continues : BranchEnd::range_end; }

    /// Where the k-th root goes as u tends to a cut: followed by halving steps towards it, then matched with what
    /// happens at the cut.
    [[nodiscard]] std::pair<double, BranchEnd> limit(CurvePiece const& curve, ContactArc const& arc, std::size_t cut, double from, double t,
                                                     double u_cut) const
    {
        Motion const& motion = envelope_.motion();
        constexpr int halvings = 40;
        double near = t;
        double u = from;
        for (int k = 0; k < halvings; ++k)
        {
            u = 0.5 * (u + u_cut);
            BernsteinRoots const roots = curve_contacts(curve, motion.rates(u).twist);
            if (roots.count != arc.roots)
                break;
            near = roots.t[static_cast<std::size_t>(arc.candidate)];
        }
        if (cut == 0)
            return {near, at_range_begin()};
        if (cut + 1 == cuts_.size())
            return {near, at_range_end()};
        // the steps stop within about 2^-40 of the cut, where a merging root is still sqrt of that away
        constexpr double reach = 0x1p-16;
        double best = reach;
        std::pair<double, BranchEnd> result{near, BranchEnd::segment_end};
        bool matched = false;
        for (CriticalAngle const& c : critical_)
        {
            if (c.u != u_cut || std::abs(c.t - near) > best)
                continue;
            best = std::abs(c.t - near);
            result = {c.t, c.merge ? BranchEnd::double_root : BranchEnd::segment_end};
            matched = true;
        }
        if (matched)
            return result;
        return {near, BranchEnd::continues};
    }

    /// Contacts that a cut, or a break of the motion, does not concern are one arc on both sides.
    void join_continuing()
    {
        std::vector<bool> joined(arcs_.size(), false);
        for (std::size_t i = 0; i < arcs_.size(); ++i)
        {
            if (arcs_[i].ends != BranchEnd::continues)
                continue;
            std::size_t partner = arcs_.size();
            double best = 1;
            for (std::size_t j = 0; j < arcs_.size(); ++j)
            {
                double const gap = std::abs(arcs_[j].t_begin - arcs_[i].t_end);
                if (arcs_[j].begins == BranchEnd::continues && !joined[j] && same_instant(arcs_[i].u_end, arcs_[j].u_begin) && gap < best)
                {
                    best = gap;
                    partner = j;
                }
            }
            constexpr double same = 0x1p-20;
            if (partner == arcs_.size() || best > same)
            {
                leave_at_end(arcs_[i].t_end, arcs_[i].ends);
                continue;
            }
            // kept as two arcs (the index of the root may differ), marked as one branch by their common end
            arcs_[partner].t_begin = arcs_[i].t_end;
            joined[partner] = true;
        }
        for (std::size_t j = 0; j < arcs_.size(); ++j)
            if (arcs_[j].begins == BranchEnd::continues && !joined[j])
                leave_at_end(arcs_[j].t_begin, arcs_[j].begins);
    }

    /// A contact may reach an end of the piece at the very instant of a break; it then has no partner there.
    void leave_at_end(double& t, BranchEnd& why) const
    {
        constexpr double reach = 0x1p-16;
        double const end = t < 0.5 ? 0.0 : 1.0;
        if (!(std::abs(t - end) <= reach))
            throw NumericalError("envelope", "profile piece " + std::to_string(piece_), "contacts on both sides of a critical angle do not match");
        t = end;
        why = BranchEnd::segment_end;
    }

    Envelope<Motion> const& envelope_;
    int piece_;
    SmoothRange range_;
    std::vector<CriticalAngle> critical_;  ///< of the range being traced
    std::vector<double> cuts_;
    std::vector<ContactArc> arcs_;
};

}  // namespace hdconj
