// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts contact arcs where their envelope has a cusp, marks the outer parts, and finds where conjugate zones end.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "hdconj/envelope/envelope.hpp"
#include "hdconj/numeric/all_roots.hpp"

namespace hdconj::envelope {

/// Roots in (0, 1) of a function of the arc's smooth parameter, `value` and `size` being members of Contact.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::vector<double> roots_along(Envelope<Motion> const& envelope, ContactArc const& arc,
                                              double Contact::*value, double Contact::*size, TraceRecord& record)
{
    auto const f = [&](double s) { return envelope.contact(arc, arc_parameter_to_u(arc, s)).*value; };
    double scale = 0;
    constexpr int probes = 8;
    for (int i = 0; i <= probes; ++i)
        scale = std::max(scale, envelope.contact(arc, arc_parameter_to_u(arc, static_cast<double>(i) / probes)).*size);
    numeric::RootSet const found = numeric::all_roots(f, 0.0, 1.0, scale);
    record.evaluations += found.evaluations;
    record.roots += found.roots.size();
    if (!found.certified)
        record.doubts.push_back({arc.piece, 0.5, 0.5 * (arc.u_begin + arc.u_end), arc.u_end - arc.u_begin,
                                 std::numeric_limits<double>::infinity(), "cusps or reversals were not all isolated"});
    std::vector<double> s;
    for (numeric::IsolatedRoot const& root : found.roots)
        if (root.x > 0 && root.x < 1)
            s.push_back(root.x);
    return s;
}

/// Cuts @p whole at the cusps of its envelope. Each part is wholly outer or wholly inner (the thesis' two envelopes);
/// the zones of a part, between its `reversals`, are monotone in t.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::vector<ContactArc> cut_at_cusps(Envelope<Motion> const& envelope, ContactArc const& whole,
                                                   TraceRecord& record)
{
    std::vector<double> const cusps = roots_along(envelope, whole, &Contact::bound, &Contact::bound_size, record);
    std::vector<double> const turns = roots_along(envelope, whole, &Contact::turning, &Contact::turning_size, record);
    std::vector<ContactArc> parts;
    for (std::size_t i = 0; i <= cusps.size(); ++i) {
        double const from = i == 0 ? 0.0 : cusps[i - 1];
        double const to = i == cusps.size() ? 1.0 : cusps[i];
        ContactArc part = whole;
        part.u_begin = arc_parameter_to_u(whole, from);
        part.u_end = arc_parameter_to_u(whole, to);
        if (!(part.u_end > part.u_begin))
            continue;
        if (i > 0) {
            part.begins = BranchEnd::cusp;
            part.t_begin = envelope.contact(whole, part.u_begin).t;
        }
        if (i < cusps.size()) {
            part.ends = BranchEnd::cusp;
            part.t_end = envelope.contact(whole, part.u_end).t;
        }
        part.bounding = envelope.contact(whole, arc_parameter_to_u(whole, 0.5 * (from + to))).bound > 0;
        for (double s : turns)
            if (s > from && s < to)
                part.reversals.push_back(arc_parameter_to_u(whole, s));
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace hdconj::envelope
