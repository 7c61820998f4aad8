// SPDX-License-Identifier: GPL-3.0-or-later
// What a boundary must pass: no branch lost, no stretch lost by an offset, no tooth inside over a full turn.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "conjugate/outline.hpp"
#include "hdconj/base/parallel.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/distance/any_full_turn.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/error.hpp"
#include "hdconj/solution.hpp"

namespace hdconj::conjugate {

/// @throws NumericalError where a branch could be missing that stands out of the known ones by more than @p tolerance
/// [mm]
inline void refuse_lost_branches(envelope::TraceRecord const& record, double tolerance)
{
    for (envelope::RootDoubt const& doubt : record.doubts)
        if (!(doubt.reach <= tolerance))
            throw NumericalError(ErrorCode::not_converged, "envelope",
                                 "profile piece " + std::to_string(doubt.piece) + " at u = " + std::to_string(doubt.u),
                                 doubt.what + ": its roots could not all be told apart in double precision");
}

/// The doubts that pass, as the result states them.
inline void record_doubts(envelope::TraceRecord const& record, profile::Profile const& profile,
                          RootCertificate& certificate)
{
    for (envelope::RootDoubt const& doubt : record.doubts) {
        profile::ProfilePiece const& piece = profile.pieces[static_cast<std::size_t>(doubt.piece)];
        certificate.undecided.push_back({profile.segment_names[static_cast<std::size_t>(piece.segment)],
                                         piece.t_begin + doubt.t * (piece.t_end - piece.t_begin), doubt.u, doubt.width,
                                         doubt.reach, doubt.what});
    }
}

/// Polygons decide which branch is outside; where they misjudge two that lie closer than their own error, the full-turn
/// check sees it and they are made finer.
/// @param chord     chord error of the first polygons [mm]
/// @param assemble  puts the boundary together from polygons of a chord error, and checks it into out.check
/// @param wanted    smallest clearance that will do, asked for after each check [mm]
/// @param frame     of the place in the message
/// @throws NumericalError when the finest polygons leave a tooth inside
template <class Assemble, class Wanted>
void assemble_until_clear(Solution const& out, double chord, Assemble&& assemble, Wanted&& wanted,
                          std::string const& frame)
{
    constexpr int attempts = 5;
    for (int attempt = 1; attempt <= attempts; ++attempt, chord /= 64) {
        assemble(chord);
        if (!out.check || out.check->smallest_clearance >= wanted())
            return;
    }
    throw NumericalError(
        ErrorCode::interference, "interference", near_text(out.check->where) + frame,
        "a tooth interferes with the outline by " + std::to_string(wanted() - out.check->smallest_clearance) + " mm");
}

/// Length and middle of a run of boundary pieces.
struct RunMeasure
{
    double length = 0;
    Vec2 middle = Vec2::Zero();
};
template <class PointAt>
[[nodiscard]] RunMeasure measure_of(std::span<BoundaryPiece const> run, PointAt const& point)
{
    constexpr int steps = 16;
    std::vector<Vec2> points;
    std::vector<double> lengths;
    RunMeasure measure;
    for (BoundaryPiece const& piece : run)
        for (int i = 0; i <= steps; ++i) {
            points.push_back(point(piece, piece.begin + (piece.end - piece.begin) * i / steps));
            measure.length += i > 0 ? (points.back() - points[points.size() - 2]).norm() : 0;
            lengths.push_back(measure.length);
        }
    auto const half = std::ranges::lower_bound(lengths, measure.length / 2);
    measure.middle = points[static_cast<std::size_t>(half - lengths.begin())];
    return measure;
}

/// Requires that no stretch of a boundary longer than the tolerance vanishes at the offset, where the neighbours'
/// offsets meet in front of it. A stretch that is only shortened is trimmed exactly and kept, even where whole pieces
/// of a spline go with what is trimmed.
/// @param goes_on  whether two neighbouring pieces are of one stretch
/// @param kept     whether a piece is there after the offset
/// @param point    point of a piece at u, before the offset
/// @throws NumericalError with place and size of the largest stretch lost
template <class GoesOn, class Kept, class PointAt>
void require_same_topology(std::vector<BoundaryPiece> const& before, GoesOn const& goes_on, Kept const& kept,
                           PointAt const& point, double offset, double tolerance)
{
    RunMeasure largest;
    for (auto first = before.begin(); first != before.end();) {
        auto last = first + 1;
        while (last != before.end() && first->arc >= 0 && last->arc >= 0 && goes_on(*(last - 1), *last))
            ++last;
        if (first->arc >= 0 && std::none_of(first, last, kept)) {
            RunMeasure const lost = measure_of(std::span(first, last), point);
            largest = lost.length > largest.length ? lost : largest;
        }
        first = last;
    }
    if (largest.length > tolerance)
        throw NumericalError(ErrorCode::no_outline, "side clearance", near_text(largest.middle),
                             "a side clearance of " + short_number(offset) + " mm would remove a part of the flank " +
                                 short_number(largest.length) + " mm long",
                             "write a smaller circular_spline.backlash_offset");
}

/// Whether @p pieces, on @p arcs, have one on the contact that @p arc follows, of the tooth @p copy.
[[nodiscard]] inline bool has_contact(std::vector<BoundaryPiece> const& pieces,
                                      std::vector<envelope::ContactArc> const& arcs, envelope::ContactArc const& arc,
                                      int copy)
{
    return std::any_of(pieces.begin(), pieces.end(), [&](BoundaryPiece const& other) {
        if (other.arc < 0 || other.copy != copy)
            return false;
        envelope::ContactArc const& there = arcs[static_cast<std::size_t>(other.arc)];
        return there.piece == arc.piece && there.candidate == arc.candidate;
    });
}

/// The same for a tooth space, whose pieces are arcs of one tooth turned by whole pitches.
inline void require_same_topology(envelope::AnyEnvelope const& base, std::vector<envelope::ContactArc> const& base_arcs,
                                  ToothSpace const& before, std::vector<envelope::ContactArc> const& offset_arcs,
                                  ToothSpace const& after, double pitch, double offset, double tolerance)
{
    auto const arc_of = [&](BoundaryPiece const& piece) -> envelope::ContactArc const& {
        return base_arcs[static_cast<std::size_t>(piece.arc)];
    };
    auto const goes_on = [&](BoundaryPiece const& a, BoundaryPiece const& b) {
        return outline_goes_on(base.profile(), a, arc_of(a), b, arc_of(b));
    };
    auto const kept = [&](BoundaryPiece const& piece) {
        return has_contact(after.pieces, offset_arcs, arc_of(piece), piece.copy);
    };
    auto const point = [&](BoundaryPiece const& piece, double u) {
        return TurnedArc<motion::AnyMotion>{base, arc_of(piece), piece.copy * pitch}.point(u).p;
    };
    require_same_topology(before.pieces, goes_on, kept, point, offset, tolerance);
}

/// Outline points for the check from index @p first on: all of them; of a very fine outline every k-th beside the ends
/// of its stretches, since what the check looks for (a branch that was taken for the outer one) is a stretch, not a
/// point.
[[nodiscard]] inline std::vector<std::size_t> points_to_check(Outline const& outline, std::size_t first)
{
    constexpr std::size_t enough = 4096;
    std::size_t const count = outline.points.size() - first;
    std::size_t const stride = (count + enough - 1) / enough;
    std::vector<std::size_t> chosen;
    for (OutlineStretch const& stretch : outline.stretches)
        for (std::size_t i = std::max(first, stretch.first); i < stretch.last; i += stride)
            chosen.push_back(i);
    chosen.push_back(outline.points.size() - 1);
    return chosen;
}

/// Smallest clearance of the points @p chosen by the law @p clearance (FullTurnClearance or its reverse).
template <class Clearance>
[[nodiscard]] PairCheck check_turn(Clearance const& clearance, motion::AnyMotion const& motion,
                                   std::vector<Vec2> const& points, std::vector<std::size_t> const& chosen, int threads)
{
    std::vector<distance::TurnMinimum> minima(chosen.size());
    // blocks of fixed size, whatever the number of threads: inside one, each point starts from its neighbour's result
    constexpr std::size_t most = 64;
    std::size_t const block = std::min(most, clearance.block());
    std::size_t const blocks_worth_a_thread = block < most ? 3 : motion::cosine_form(motion) ? 4 : 2;
    parallel_for((chosen.size() + block - 1) / block, threads, blocks_worth_a_thread, [&](std::size_t b) {
        std::size_t const first = b * block;
        std::size_t const count = std::min(block, chosen.size() - first);
        std::array<Vec2, most> at;
        for (std::size_t i = 0; i < count; ++i)
            at[i] = points[chosen[first + i]];
        clearance(std::span(at).first(count), nullptr, std::span(minima).subspan(first, count));
    });
    auto const worst = std::ranges::min_element(
        minima, [](distance::TurnMinimum const& a, distance::TurnMinimum const& b) { return a.distance < b.distance; });
    return {worst->distance, points[chosen[static_cast<std::size_t>(worst - minima.begin())]],
            motion.angles(worst->u).phi, minima.size(), clearance.positions()};
}

}  // namespace hdconj::conjugate
