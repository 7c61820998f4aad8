// SPDX-License-Identifier: GPL-3.0-or-later
// Contact arcs of a drive, and the pieces of them that bound the member that is solved for.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "drive/drive.hpp"
#include "hdconj/distance/any_full_turn.hpp"
#include "hdconj/envelope/find_branches.hpp"
#include "hdconj/envelope/sample.hpp"
#include "hdconj/error.hpp"
#include "study_drive.hpp"

namespace hdconj::accuracy {
namespace {

/// Adds the contact arcs of tooth @p which.
void add_arcs(StudyDrive& drive, std::size_t which)
{
    envelope::BranchSet const set =
        envelope::find_branches(envelope::AnyEnvelope(drive.tooth, drive.motions[which], drive.offset), 1);
    drive.branches += set.branches.size();
    for (envelope::Branch const& branch : set.branches)
        drive.arcs.insert(drive.arcs.end(), branch.arcs.begin(), branch.arcs.end());
}

/// Has the pieces of the boundary found by polygons of ever smaller chords, until no tooth enters them over a full
/// turn: coarse polygons pass over stretches that stand out by less than their chord.
/// @throws NumericalError where they never do
template <class Clearance, class Find>
void until_clear(StudyDrive const& drive, Clearance const& clearance, Find const& find)
{
    double chord = drive.height() * 0x1p-16;
    double const sampled = drive.height() * 0x1p-22, allowed = drive.height() * 0x1p-34;
    constexpr int attempts = 4;
    for (int attempt = 0; attempt < attempts; ++attempt, chord /= 64) {
        find(chord);
        double least = std::numeric_limits<double>::infinity();
        for (conjugate::BoundaryPiece const& piece : drive.pieces) {
            if (piece.arc < 0)
                continue;
            std::vector<Vec2> points;
            for (envelope::EnvelopePoint const& e :
                 envelope::sample_arc(drive.envelope(piece), drive.arc(piece), piece.begin, piece.end, sampled, 1)
                     .points)
                points.push_back(drive.reverse() ? e.p : drive.placed(piece, e.p));
            std::vector<distance::TurnMinimum> minima(points.size());
            clearance(points, nullptr, minima);
            for (distance::TurnMinimum const& each : minima)
                least = std::min(least, each.distance);
        }
        if (least >= drive.offset - allowed)
            return;
    }
    throw NumericalError(ErrorCode::interference, "reference", "boundary",
                         "teeth interfere with it however finely it is computed");
}

void find_tooth_space(StudyDrive& drive)
{
    add_arcs(drive, 0);
    double const scale = drive.geometry.r_m + drive.geometry.w0 + drive.tooth.pitch_line + drive.tooth.addendum;
    Tolerance const tolerance{scale * 0x1p-44, scale};
    envelope::AnyEnvelope const envelope(drive.tooth, drive.motion(), drive.offset);
    distance::FullTurnClearance<motion::AnyMotion> const clearance(drive.tooth, drive.motion(), drive.pitch,
                                                                   drive::pitches_per_lobe(drive.scene));
    until_clear(drive, clearance, [&](double chord) {
        drive.pieces = conjugate::ToothSpaceFinder<motion::AnyMotion>(
                           envelope, drive.arcs, drive.geometry.circular_spline_inner_radius,
                           drive.scene.drive.circular_spline_teeth, tolerance, chord)()
                           .pieces;
    });
}

/// The flexspline tooth that they leave.
void find_tooth_body(StudyDrive& drive)
{
    std::vector<conjugate::SweptTooth<motion::AnyMotion>> teeth;
    std::vector<int> first_arc;
    for (std::size_t j = 0; j < drive.motions.size(); ++j) {
        std::size_t const before = drive.arcs.size();
        first_arc.push_back(static_cast<int>(before));
        add_arcs(drive, j);
        teeth.push_back({envelope::AnyEnvelope(drive.tooth, drive.motions[j], drive.offset),
                         std::vector<envelope::ContactArc>(drive.arcs.begin() + static_cast<std::ptrdiff_t>(before),
                                                           drive.arcs.end())});
    }
    Tolerance const tolerance{drive.seat_radius * 0x1p-44, drive.seat_radius};
    auto const numbered = [&](conjugate::BoundaryPiece piece) {
        piece.arc += first_arc[static_cast<std::size_t>(piece.copy)];
        return piece;
    };
    distance::ReverseFullTurnClearance<motion::AnyMotion> const clearance(
        drive.tooth, drive.flexspline.front(), drive.pitch, drive.seat_radius, drive::pitches_per_lobe(drive.scene));
    until_clear(drive, clearance, [&](double chord) {
        conjugate::ToothBody const body =
            conjugate::ToothBodyFinder<motion::AnyMotion>(teeth, drive.limits, tolerance, chord)();
        drive.pieces.assign(1, {});
        for (auto piece = body.left.rbegin(); piece != body.left.rend(); ++piece) {
            drive.pieces.push_back(numbered(*piece));
            std::swap(drive.pieces.back().begin, drive.pieces.back().end);
        }
        drive.pieces.emplace_back();
        for (conjugate::BoundaryPiece const& piece : body.right)
            drive.pieces.push_back(numbered(piece));
        drive.pieces.emplace_back();
    });
}

}  // namespace

void find_boundary(StudyDrive& drive)
{
    if (drive.reverse())
        find_tooth_body(drive);
    else
        find_tooth_space(drive);
}

}  // namespace hdconj::accuracy
