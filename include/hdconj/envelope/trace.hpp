// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds every contact arc of a profile: where it begins, where it ends and why.
#pragma once

#include <algorithm>
#include <cmath>
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
    /// @param rates  models of the motion on its smooth ranges, in order
    PieceTracer(Envelope<Motion> const& envelope, std::vector<RatesModel> const& rates, int piece) : envelope_(envelope), rates_(rates), piece_(piece)
    {
    }

    [[nodiscard]] std::vector<ContactArc> operator()(TraceRecord& record)
    {
        std::vector<SmoothRange> const ranges = smooth_ranges(envelope_.motion());
        for (std::size_t i = 0; i < ranges.size(); ++i)
        {
            range_ = ranges[i];
            critical_ = critical_angles(shape(), piece_, envelope_.motion(), rates_[i], range_.a, range_.b, record);
            cuts_.assign(1, range_.a);
            for (CriticalAngle const& c : critical_)
                cuts_.push_back(c.u);
            cuts_.push_back(range_.b);
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

    /// Contacts of a curve keep their order between critical angles, and each of these adds or removes known ones.
    void trace_curve(CurvePiece const& curve)
    {
        count_contacts(curve);
        Motion const& motion = envelope_.motion();
        std::size_t const last = cuts_.size() - 1;
        std::vector<std::vector<double>> at_cut(cuts_.size());
        std::vector<std::size_t> first_changed(cuts_.size(), 0);
        for (std::size_t i = 0; i <= last; ++i)
        {
            bool const inner = i > 0 && i < last;
            int const before = i > 0 ? counts_[i - 1] : counts_[i];
            int const after = i < last ? counts_[i] : counts_[i - 1];
            // at an end of the range what rounding adds or hides lies next to an end of the curve
            double const where = inner ? critical_[i - 1].t : 0;
            at_cut[i] = parameters(curve, motion.rates(cuts_[i]).twist, static_cast<std::size_t>(std::min(before, after)), where);
            if (inner)
                first_changed[i] = static_cast<std::size_t>(std::upper_bound(at_cut[i].begin(), at_cut[i].end(), where) - at_cut[i].begin());
            if (inner && !critical_[i - 1].merge)
                first_changed[i] = where == 0 ? 0 : at_cut[i].size();
        }
        for (std::size_t i = 0; i < last; ++i)
        {
            if (!(cuts_[i + 1] > cuts_[i]))
                continue;
            for (int k = 0; k < counts_[i]; ++k)
            {
                ContactArc arc;
                arc.piece = piece_;
                arc.candidate = k;
                arc.roots = counts_[i];
                arc.u_begin = cuts_[i];
                arc.u_end = cuts_[i + 1];
                auto const limit = [&](std::size_t cut) -> std::pair<double, BranchEnd> {
                    auto index = static_cast<std::size_t>(k);
                    if (cut == 0)
                        return {at_cut[cut][index], at_range_begin()};
                    if (cut == last)
                        return {at_cut[cut][index], at_range_end()};
                    std::size_t const changed = static_cast<std::size_t>(counts_[i]) - at_cut[cut].size();
                    if (index >= first_changed[cut] && index < first_changed[cut] + changed)
                        return {critical_[cut - 1].t, critical_[cut - 1].merge ? BranchEnd::double_root : BranchEnd::segment_end};
                    if (index >= first_changed[cut])
                        index -= changed;
                    return {at_cut[cut][index], BranchEnd::continues};
                };
                std::tie(arc.t_begin, arc.begins) = limit(i);
                std::tie(arc.t_end, arc.ends) = limit(i + 1);
                arcs_.push_back(arc);
            }
        }
    }

    /// Number of contacts between cuts: seen in the middle of the longest interval whose roots are all simple, and from there on by
    /// what each critical angle changes; compared with what is seen in all other such intervals.
    void count_contacts(CurvePiece const& curve)
    {
        std::size_t const intervals = cuts_.size() - 1;
        std::vector<int> seen(intervals, -1);
        std::size_t anchor = intervals;
        auto const length = [&](std::size_t i) { return cuts_[i + 1] - cuts_[i]; };
        for (std::size_t i = 0; i < intervals; ++i)
        {
            BernsteinRoots const roots = curve_contacts(curve, envelope_.motion().rates(cuts_[i] + 0.5 * length(i)).twist);
            bool sure = length(i) > 0 && roots.complete;
            for (int k = 0; k < roots.count; ++k)
                sure = sure && roots.width[static_cast<std::size_t>(k)] == 0;
            if (!sure)
                continue;
            seen[i] = roots.count;
            if (anchor == intervals || length(i) > length(anchor))
                anchor = i;
        }
        auto const place = [&] { return "profile piece " + std::to_string(piece_); };
        if (anchor == intervals)
            throw NumericalError("envelope", place(), "its contacts are not distinct at any instant: the meshing condition vanishes");
        counts_.assign(intervals, 0);
        counts_[anchor] = seen[anchor];
        auto const change = [&](std::size_t event, std::size_t from, std::size_t to) {
            if (critical_[event].change == 0)
                return seen[to] < 0 ? 0 : seen[to] - counts_[from];
            return to > from ? critical_[event].change : -critical_[event].change;
        };
        for (std::size_t i = anchor + 1; i < intervals; ++i)
            counts_[i] = counts_[i - 1] + change(i - 1, i - 1, i);
        for (std::size_t i = anchor; i-- > 0;)
            counts_[i] = counts_[i + 1] + change(i, i + 1, i);
        for (std::size_t i = 0; i < intervals; ++i)
            if (counts_[i] < 0 || (seen[i] >= 0 && seen[i] != counts_[i]))
                throw NumericalError("envelope", place(), "contacts on both sides of a critical angle do not match");
    }

    /// The @p wanted contacts at one instant; where rounding adds or hides some they are those nearest to @p where.
    [[nodiscard]] static std::vector<double> parameters(CurvePiece const& curve, Twist const& twist, std::size_t wanted, double where)
    {
        BernsteinRoots const roots = curve_contacts(curve, twist);
        std::vector<double> t(roots.t.begin(), roots.t.begin() + roots.count);
        auto const nearest = [&] {
            return std::min_element(t.begin(), t.end(), [&](double x, double y) { return std::abs(x - where) < std::abs(y - where); });
        };
        while (t.size() > wanted)
            t.erase(nearest());
        while (t.size() < wanted)
            t.insert(std::upper_bound(t.begin(), t.end(), where), where);
        return t;
    }

    [[nodiscard]] BranchEnd at_range_begin() const { return range_.from_break ? BranchEnd::continues : BranchEnd::range_end; }
    [[nodiscard]] BranchEnd at_range_end() const { return range_.to_break ? BranchEnd::continues : BranchEnd::range_end; }

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
    std::vector<RatesModel> const& rates_;
    int piece_;
    SmoothRange range_;
    std::vector<CriticalAngle> critical_;  ///< of the range being traced
    std::vector<double> cuts_;
    std::vector<int> counts_;              ///< curves: contacts between cuts
    std::vector<ContactArc> arcs_;
};

}  // namespace hdconj
