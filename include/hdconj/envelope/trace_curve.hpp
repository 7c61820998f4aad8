// SPDX-License-Identifier: GPL-3.0-or-later
// Contact arcs of a polynomial curve: its roots in t, counted across critical angles and followed between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hdconj/envelope/critical_angles.hpp"
#include "hdconj/envelope/envelope.hpp"
#include "hdconj/error.hpp"

namespace hdconj::envelope {

/// Contact arcs of a curve on one smooth range.
/// @throws NumericalError where the counts of contacts contradict each other
template <motion::RelativeMotion Motion>
class CurveTracer
{
  public:
    CurveTracer(Envelope<Motion> const& envelope, profile::CurvePiece const& curve, int piece, CutRange const& range)
        : envelope_(envelope), curve_(curve), piece_(piece), range_(range)
    {
    }

    /// Contacts of a curve keep their order between critical angles, and each of these adds or removes known ones.
    void operator()(std::vector<ContactArc>& out)
    {
        count_contacts();
        Motion const& motion = envelope_.motion();
        std::size_t const last = range_.cuts.size() - 1;
        std::vector<std::vector<double>> at_cut(range_.cuts.size());
        std::vector<std::size_t> first_changed(range_.cuts.size(), 0);
        for (std::size_t i = 0; i <= last; ++i) {
            bool const inner = i > 0 && i < last;
            int const before = i > 0 ? counts_[i - 1] : counts_[i];
            int const after = i < last ? counts_[i] : counts_[i - 1];
            // at an end of the range what rounding adds or hides lies next to an end of the curve
            double const where = inner ? range_.critical[i - 1].t : 0;
            at_cut[i] = parameters(curve_, motion.rates(range_.cuts[i]).twist,
                                   static_cast<std::size_t>(std::min(before, after)), where);
            if (inner)
                first_changed[i] = static_cast<std::size_t>(
                    std::upper_bound(at_cut[i].begin(), at_cut[i].end(), where) - at_cut[i].begin());
            if (inner && !range_.critical[i - 1].merge)
                first_changed[i] = where == 0 ? 0 : at_cut[i].size();
        }
        for (std::size_t i = 0; i < last; ++i) {
            if (!(range_.cuts[i + 1] > range_.cuts[i]))
                continue;
            for (int k = 0; k < counts_[i]; ++k) {
                ContactArc arc;
                arc.piece = piece_;
                arc.candidate = k;
                arc.roots = counts_[i];
                arc.u_begin = range_.cuts[i];
                arc.u_end = range_.cuts[i + 1];
                auto const limit = [&](std::size_t cut) -> std::pair<double, BranchEnd> {
                    auto index = static_cast<std::size_t>(k);
                    if (cut == 0)
                        return {at_cut[cut][index], range_.at_begin()};
                    if (cut == last)
                        return {at_cut[cut][index], range_.at_end()};
                    std::size_t const changed = static_cast<std::size_t>(counts_[i]) - at_cut[cut].size();
                    if (index >= first_changed[cut] && index < first_changed[cut] + changed)
                        return {range_.critical[cut - 1].t,
                                range_.critical[cut - 1].merge ? BranchEnd::double_root : BranchEnd::segment_end};
                    if (index >= first_changed[cut])
                        index -= changed;
                    return {at_cut[cut][index], BranchEnd::continues};
                };
                std::tie(arc.t_begin, arc.begins) = limit(i);
                std::tie(arc.t_end, arc.ends) = limit(i + 1);
                out.push_back(arc);
            }
        }
    }

  private:
    /// Number of contacts between cuts. It is counted in the middle of the longest interval whose roots are all simple.
    /// From there on each critical angle changes it by a known number. All other such intervals check the result.
    void count_contacts()
    {
        std::size_t const intervals = range_.cuts.size() - 1;
        std::vector<int> seen(intervals, -1);
        std::size_t anchor = intervals;
        auto const length = [&](std::size_t i) { return range_.cuts[i + 1] - range_.cuts[i]; };
        for (std::size_t i = 0; i < intervals; ++i) {
            numeric::BernsteinRoots const roots =
                curve_contacts(curve_, envelope_.motion().rates(range_.cuts[i] + 0.5 * length(i)).twist);
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
            throw NumericalError(ErrorCode::no_solution, "envelope", place(),
                                 "its contacts are not distinct at any instant: the meshing condition vanishes");
        counts_.assign(intervals, 0);
        counts_[anchor] = seen[anchor];
        auto const change = [&](std::size_t event, std::size_t from, std::size_t to) {
            if (range_.critical[event].change == 0)
                return seen[to] < 0 ? 0 : seen[to] - counts_[from];
            return to > from ? range_.critical[event].change : -range_.critical[event].change;
        };
        for (std::size_t i = anchor + 1; i < intervals; ++i)
            counts_[i] = counts_[i - 1] + change(i - 1, i - 1, i);
        for (std::size_t i = anchor; i-- > 0;)
            counts_[i] = counts_[i + 1] + change(i, i + 1, i);
        for (std::size_t i = 0; i < intervals; ++i)
            if (counts_[i] < 0 || (seen[i] >= 0 && seen[i] != counts_[i]))
                throw NumericalError(ErrorCode::not_converged, "envelope", place(),
                                     "contacts on both sides of a critical angle do not match");
    }

    /// The @p wanted contacts at one instant; where rounding adds or hides some they are those nearest to @p where.
    [[nodiscard]] static std::vector<double> parameters(profile::CurvePiece const& curve, PlanarVelocity const& twist,
                                                        std::size_t wanted, double where)
    {
        numeric::BernsteinRoots const roots = curve_contacts(curve, twist);
        std::vector<double> t(roots.t.begin(), roots.t.begin() + roots.count);
        auto const nearest = [&] {
            return std::min_element(t.begin(), t.end(),
                                    [&](double x, double y) { return std::abs(x - where) < std::abs(y - where); });
        };
        while (t.size() > wanted)
            t.erase(nearest());
        while (t.size() < wanted)
            t.insert(std::upper_bound(t.begin(), t.end(), where), where);
        return t;
    }

    Envelope<Motion> const& envelope_;
    profile::CurvePiece const& curve_;
    int piece_;
    CutRange const& range_;
    std::vector<int> counts_;  ///< contacts between cuts
};

}  // namespace hdconj::envelope
