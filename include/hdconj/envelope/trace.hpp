// SPDX-License-Identifier: GPL-3.0-or-later
// Finds every contact arc of a profile: where it begins, where it ends and why.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "hdconj/envelope/trace_closed_form.hpp"
#include "hdconj/envelope/trace_curve.hpp"

namespace hdconj::envelope {

/// A contact may reach an end of the piece at the very instant of a break; it then has no partner there.
inline void leave_at_end(double& t, BranchEnd& why, int piece)
{
    constexpr double reach = 0x1p-16;
    double const end = t < 0.5 ? 0.0 : 1.0;
    if (!(std::abs(t - end) <= reach))
        throw NumericalError(ErrorCode::not_converged, "envelope", "profile piece " + std::to_string(piece),
                             "contacts on both sides of a critical angle do not match");
    t = end;
    why = BranchEnd::segment_end;
}

/// Contacts that a cut, or a break of the motion, does not concern are one arc on both sides.
inline void join_continuing(std::vector<ContactArc>& arcs, int piece)
{
    std::vector<bool> joined(arcs.size(), false);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (arcs[i].ends != BranchEnd::continues)
            continue;
        std::size_t partner = arcs.size();
        double best = 1;
        for (std::size_t j = 0; j < arcs.size(); ++j) {
            double const gap = std::abs(arcs[j].t_begin - arcs[i].t_end);
            if (arcs[j].begins == BranchEnd::continues && !joined[j] && same_instant(arcs[i].u_end, arcs[j].u_begin) &&
                gap < best) {
                best = gap;
                partner = j;
            }
        }
        constexpr double same = 0x1p-20;
        if (partner == arcs.size() || best > same) {
            leave_at_end(arcs[i].t_end, arcs[i].ends, piece);
            continue;
        }
        // kept as two arcs (the index of the root may differ), marked as one branch by their common end
        arcs[partner].t_begin = arcs[i].t_end;
        joined[partner] = true;
    }
    for (std::size_t j = 0; j < arcs.size(); ++j)
        if (arcs[j].begins == BranchEnd::continues && !joined[j])
            leave_at_end(arcs[j].t_begin, arcs[j].begins, piece);
}

/// Contact arcs of piece @p piece over the wave [-pi/n, pi/n], before they are cut at cusps.
///
/// Between two critical angles the number of contacts is constant, and each is a smooth function of u. The contacts at
/// the middle of each interval therefore stand for all, and no arc is lost for being short. Where the motion has
/// breaks, the ranges between them are traced one by one and their arcs joined.
/// @param rates  models of the motion on its smooth ranges, in order
template <motion::RelativeMotion Motion>
[[nodiscard]] std::vector<ContactArc> trace_piece(Envelope<Motion> const& envelope,
                                                  std::vector<motion::RatesModel> const& rates, int piece,
                                                  TraceRecord& record)
{
    profile::PieceShape const& shape = envelope.profile().pieces[static_cast<std::size_t>(piece)].shape;
    std::vector<SmoothRange> const ranges = smooth_ranges(envelope.motion());
    std::vector<ContactArc> arcs;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        SmoothRange const& r = ranges[i];
        CutRange const range(r, critical_angles(shape, piece, envelope.motion(), rates[i], r.a, r.b, record));
        if (auto const* curve = std::get_if<profile::CurvePiece>(&shape))
            CurveTracer<Motion>(envelope, *curve, piece, range)(arcs);
        else
            ClosedFormTracer<Motion>(envelope, piece, range)(arcs);
    }
    join_continuing(arcs, piece);
    return arcs;
}

}  // namespace hdconj::envelope
