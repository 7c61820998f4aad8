// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Contact arcs of one piece, joined where a cut or a break of the motion does not concern them.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/envelope/smooth_ranges.hpp"
#include "hdconj/error.hpp"

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

}  // namespace hdconj::envelope
