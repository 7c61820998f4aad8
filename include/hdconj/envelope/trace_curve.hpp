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
        find_contacts_at_cuts();
        for (std::size_t i = 0; i + 1 < range_.cuts.size(); ++i) {
            if (is_empty(i))
                continue;
            for (int k = 0; k < counts_[i]; ++k) {
                ContactArc arc;
                arc.piece = piece_;
                arc.candidate = k;
                arc.roots = counts_[i];
                arc.u_begin = range_.cuts[i];
                arc.u_end = range_.cuts[i + 1];
                std::tie(arc.t_begin, arc.begins) = limit(i, static_cast<std::size_t>(k), false);
                std::tie(arc.t_end, arc.ends) = limit(i, static_cast<std::size_t>(k), true);
                out.push_back(arc);
            }
        }
    }

  private:
    /// Whether the critical angles on both sides of interval @p i are a rounding apart.
    [[nodiscard]] bool is_empty(std::size_t i) const { return !(range_.cuts[i + 1] > range_.cuts[i]); }

    /// |f| at both ends of the curve at one instant, and what rounding makes of it.
    struct EndValues
    {
        double begin = 0;
        double end = 0;
        double noise = 0;

        /// No contact is so near to an end of the curve that rounding may add or hide it.
        [[nodiscard]] bool certain() const { return std::min(begin, end) > noise; }
        /// The end that is nearer to touching its envelope.
        [[nodiscard]] double nearer() const { return end < begin ? 1 : 0; }
    };
    [[nodiscard]] EndValues end_values(double u) const
    {
        constexpr double roundings = 16;
        motion::MotionRates const rates = envelope_.motion().rates(u);
        numeric::BernsteinWork f{};
        std::size_t const size = curve_.a().size();
        double const stored = meshing_polynomial(curve_, rates.twist, {f.data(), size});
        auto const moved = [&](double t) { return curve_.first(t).norm() * rates.velocity_size(curve_.point(t)); };
        return {std::abs(f[0]), std::abs(f[size - 1]),
                stored + roundings * unit_roundoff * std::max(moved(0), moved(1))};
    }

    /// The contacts at each cut that both its sides have, and before which of them others appear or vanish.
    void find_contacts_at_cuts()
    {
        std::size_t const last = range_.cuts.size() - 1;
        at_cut_.resize(range_.cuts.size());
        first_changed_.assign(range_.cuts.size(), 0);
        for (std::size_t i = 0; i <= last; ++i) {
            bool const inner = i > 0 && i < last;
            int const before = i > 0 ? counts_[i - 1] : counts_[i];
            int const after = i < last ? counts_[i] : counts_[i - 1];
            // at an end of the range what rounding adds or hides lies next to the end of the curve that touches there
            double const where = inner ? range_.critical[i - 1].t : end_values(range_.cuts[i]).nearer();
            at_cut_[i] = parameters(curve_, envelope_.motion().rates(range_.cuts[i]).twist,
                                    static_cast<std::size_t>(std::min(before, after)), where);
            if (inner)
                first_changed_[i] = static_cast<std::size_t>(
                    std::upper_bound(at_cut_[i].begin(), at_cut_[i].end(), where) - at_cut_[i].begin());
            if (inner && !range_.critical[i - 1].merge)
                first_changed_[i] = where == 0 ? 0 : at_cut_[i].size();
        }
    }

    /// Where contact @p index of interval @p i ends, or begins, and why. It is followed over intervals that are empty.
    /// If it merges there with one that comes in at an end of the curve at the same instant, it ends at that end, where
    /// the contact of the next piece ends too: to rounding, both merge in the joint.
    [[nodiscard]] std::pair<double, BranchEnd> limit(std::size_t i, std::size_t index, bool forward) const
    {
        for (;;) {
            std::size_t const cut = forward ? i + 1 : i;
            if (cut == 0)
                return {at_cut_[cut][index], range_.at_begin()};
            if (cut + 1 == range_.cuts.size())
                return {at_cut_[cut][index], range_.at_end()};
            CriticalAngle const& event = range_.critical[cut - 1];
            std::size_t const first = first_changed_[cut], kept = at_cut_[cut].size();
            std::size_t const changed = static_cast<std::size_t>(counts_[i]) - kept;
            if (index >= first && index < first + changed) {
                if (!event.merge)
                    return {event.t, BranchEnd::segment_end};
                std::size_t const partner = 2 * first + 1 - index;
                if (is_empty(i) && changed == 2)
                    if (auto const end = limit(i, partner, !forward); end.second == BranchEnd::segment_end)
                        return end;
                return {event.t, BranchEnd::double_root};
            }
            if (index >= first)
                index -= changed;
            i = forward ? cut : cut - 1;
            if (!is_empty(i))
                return {at_cut_[cut][index], BranchEnd::continues};
            if (index >= first)
                index += static_cast<std::size_t>(counts_[i]) - kept;
        }
    }

    /// How far the critical angles beside interval @p i may be from where they are said to be.
    [[nodiscard]] double doubt(std::size_t i) const
    {
        double const before = i > 0 ? range_.critical[i - 1].doubt : 0;
        return i < range_.critical.size() ? std::max(before, range_.critical[i].doubt) : before;
    }

    /// Number of contacts between cuts. It is counted in the middle of the longest interval whose roots are all simple
    /// and clear of the curve's ends. In a symmetric pair a contact passes a joint on the tooth's centre line at the
    /// very ends of the lobe, and rounding may put that instant just inside: such an interval is not counted. From
    /// there on each critical angle changes it by a known number. All other such intervals check the result.
    void count_contacts()
    {
        std::size_t const intervals = range_.cuts.size() - 1;
        std::vector<int> seen(intervals, -1);
        std::size_t anchor = intervals;
        auto const length = [&](std::size_t i) { return range_.cuts[i + 1] - range_.cuts[i]; };
        for (std::size_t i = 0; i < intervals; ++i) {
            double const middle = range_.cuts[i] + 0.5 * length(i);
            numeric::BernsteinRoots const roots = curve_contacts(curve_, envelope_.motion().rates(middle).twist);
            bool sure = length(i) > doubt(i) && roots.complete && end_values(middle).certain();
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
    std::vector<int> counts_;                  ///< contacts between cuts
    std::vector<std::vector<double>> at_cut_;  ///< parameters of the contacts that both sides of a cut have
    std::vector<std::size_t> first_changed_;   ///< index into these
};

}  // namespace hdconj::envelope
