// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A drive taken apart, for methods that are parts of `solve` or stand in for one; private to src/study.
#pragma once

#include <optional>
#include <vector>

#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/envelope.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/pipeline/solution.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/study/reference_curve.hpp"
#include "hdconj/wavegen/registry.hpp"
#include "given_motion.hpp"

namespace hdconj::detail {

using StudyMotion = ExactMotion<AnyWaveShape>;

/// Tooth, motion, contact arcs and the pieces of one pitch of the boundary, each with exact ends.
struct StudyDrive
{
    Scene scene;
    PairGeometry geometry;
    Profile tooth;
    StudyMotion motion;
    std::vector<ContactArc> arcs;
    std::vector<BoundaryPiece> pieces;
    double pitch = 0;
    double offset = 0;
    std::size_t branches = 0;

    [[nodiscard]] Envelope<StudyMotion> envelope() const { return {tooth, motion, offset}; }
    [[nodiscard]] ContactArc const& arc(BoundaryPiece const& piece) const { return arcs[static_cast<std::size_t>(piece.arc)]; }
    [[nodiscard]] GivenNumbers numbers() const;
    /// Largest tooth height, a length to measure by [mm].
    [[nodiscard]] double height() const { return tooth.addendum + tooth.dedendum; }
    /// Whether a piece is traced by the flank (not a corner, not the tip).
    [[nodiscard]] bool is_flank(BoundaryPiece const& piece) const;
};

/// The wave generator of @p scene, where it has a reference in 50 digits.
[[nodiscard]] std::optional<GivenShape> given_shape(Scene const& scene);

/// @throws NumericalError as `solve` does
[[nodiscard]] StudyDrive study_drive(Scene const& scene);

/// Where two contacts of a flank made of @p pieces merge.
[[nodiscard]] std::vector<double> fold_angles(StudyMotion const& motion, std::vector<CurvePiece> const& pieces);

/// The boundary of one pitch in 50 digits, mid-land to mid-land. Which stretch follows which is taken from @p drive and confirmed by entry_of();
/// every number is computed anew from the numbers that the scene gives: positions, contacts, corners.
/// @throws NumericalError where a corner does not converge
[[nodiscard]] ReferenceCurve reference_of(StudyDrive const& drive);

/// One stretch of the boundary alone.
[[nodiscard]] ReferenceCurve reference_of(StudyDrive const& drive, BoundaryPiece const& piece);

/// Brute force on the reference itself: @p samples of its points against teeth at @p positions over a lobe, neighbours included.
/// @returns how deep the deepest tooth enters [mm]; a point off the lands must also be touched: its distance from the nearest tooth counts as well
[[nodiscard]] double entry_of(StudyDrive const& drive, ReferenceCurve const& reference, int samples, int positions);

/// Largest |n.v| over at most @p samples contacts of a solution's regular branches, in long double [mm/rad].
[[nodiscard]] double residual_of(StudyDrive const& drive, Solution const& solution, std::size_t samples);

}  // namespace hdconj::detail
