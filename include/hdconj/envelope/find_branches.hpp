// SPDX-License-Identifier: GPL-3.0-or-later
// All branches of a tooth's meshing condition over one lobe of the wave generator.
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <variant>
#include <vector>

#include "hdconj/base/parallel.hpp"
#include "hdconj/envelope/contact_batch.hpp"
#include "hdconj/envelope/cusps.hpp"
#include "hdconj/envelope/trace.hpp"

namespace hdconj::envelope {

/// Branches in the order of the profile, and what it took.
struct BranchSet
{
    std::vector<Branch> branches;
    TraceRecord record;
};

/// Whether arc @p b goes on where @p a stops: across a critical angle or a joint of pieces inside one segment.
[[nodiscard]] inline bool goes_on(ContactArc const& a, ContactArc const& b)
{
    if (!same_instant(a.u_end, b.u_begin) && (a.piece == b.piece || !same_at_joint(a.u_end, b.u_begin)))
        return false;
    if (a.piece == b.piece)
        return a.ends == BranchEnd::continues && b.begins == BranchEnd::continues && a.t_end == b.t_begin;
    bool const forward = b.piece == a.piece + 1 && a.t_end == 1 && b.t_begin == 0;
    bool const backward = b.piece == a.piece - 1 && a.t_end == 0 && b.t_begin == 1;
    return a.ends == BranchEnd::segment_end && b.begins == BranchEnd::segment_end && (forward || backward);
}

/// Fewest pieces that are worth a thread. @param long_job  as for find_branches()
template <motion::RelativeMotion Motion>
[[nodiscard]] std::size_t pieces_worth_a_thread(Envelope<Motion> const& envelope, bool long_job)
{
    // microseconds, about
    constexpr double line_or_arc = 20, curve = 200, other_motion = 500;
    double const enough = long_job ? 80 : 640;
    auto const& pieces = envelope.profile().pieces;
    bool const batch = motion::cosine_form(envelope.motion()).has_value();
    double total = 0;
    for (profile::ProfilePiece const& piece : pieces)
        total += !batch ? other_motion : std::holds_alternative<profile::CurvePiece>(piece.shape) ? curve : line_or_arc;
    return static_cast<std::size_t>(std::ceil(enough * static_cast<double>(pieces.size()) / total));
}

/// Links the arcs of one segment, which come in the order of its pieces, into branches, in order of their first arc.
[[nodiscard]] inline std::vector<Branch> link(std::vector<ContactArc> const& arcs, int segment, bool corner)
{
    std::size_t const none = arcs.size();
    std::vector<std::size_t> next(arcs.size(), none);
    std::vector<bool> continued(arcs.size(), false);
    std::size_t first = 0;  // of the pieces that touch that of arc i
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        while (arcs[first].piece + 1 < arcs[i].piece)
            ++first;
        for (std::size_t j = first; j < arcs.size() && arcs[j].piece <= arcs[i].piece + 1; ++j) {
            if (i == j || continued[j] || !goes_on(arcs[i], arcs[j]))
                continue;
            next[i] = j;
            continued[j] = true;
            break;
        }
    }
    std::vector<Branch> branches;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        if (continued[i])
            continue;
        Branch branch{segment, corner, {}};
        for (std::size_t k = i; k != none; k = next[k]) {
            branch.arcs.push_back(arcs[k]);
            if (next[k] != none)
                branch.arcs.back().ends = BranchEnd::continues;
            if (k != i)
                branch.arcs.back().begins = BranchEnd::continues;
        }
        branches.push_back(std::move(branch));
    }
    return branches;
}

/// Every branch of {f = 0} for u over the lobe [-pi/n, pi/n]: regular ones on lines, arcs and curves, corner paths on
/// convex corners. Pieces are traced in parallel; the result does not depend on the number of threads.
/// @param long_job  what follows keeps all threads busy, so that they may as well be woken for this
/// @throws NumericalError naming the piece and the place
template <motion::RelativeMotion Motion>
[[nodiscard]] BranchSet find_branches(Envelope<Motion> const& envelope, int threads, bool long_job = false)
{
    auto const& pieces = envelope.profile().pieces;
    std::vector<std::vector<ContactArc>> arcs(pieces.size());
    std::vector<TraceRecord> records(pieces.size());
    std::vector<motion::RatesModel> rates;
    for (SmoothRange const& range : smooth_ranges(envelope.motion()))
        rates.push_back(motion::rates_model(envelope.motion(), range.a, range.b));
    parallel_for(pieces.size(), threads, pieces_worth_a_thread(envelope, long_job), [&](std::size_t i) {
        for (ContactArc const& arc : trace_piece(envelope, rates, static_cast<int>(i), records[i]))
            for (ContactArc& part : cut_at_cusps(envelope, arc, records[i]))
                arcs[i].push_back(std::move(part));
    });

    BranchSet set;
    for (motion::RatesModel const& model : rates) {
        if (!model.resolved)
            set.record.doubts.push_back({-1, 0, 0.5 * (model.panels.front().u0 + model.panels.back().u1),
                                         model.panels.back().u1 - model.panels.front().u0,
                                         std::numeric_limits<double>::infinity(),
                                         "the motion is not smooth between its breaks"});
    }
    for (TraceRecord& record : records) {
        set.record.evaluations += record.evaluations;
        set.record.roots += record.roots;
        std::move(record.doubts.begin(), record.doubts.end(), std::back_inserter(set.record.doubts));
    }
    for (std::size_t i = 0; i < pieces.size();) {
        std::vector<ContactArc> together = std::move(arcs[i]);
        std::size_t j = i + 1;
        while (j < pieces.size() && pieces[j].segment == pieces[i].segment && !pieces[j].corner && !pieces[i].corner) {
            std::move(arcs[j].begin(), arcs[j].end(), std::back_inserter(together));
            ++j;
        }
        for (Branch& branch : link(together, pieces[i].segment, pieces[i].corner))
            set.branches.push_back(std::move(branch));
        i = j;
    }
    return set;
}

}  // namespace hdconj::envelope
