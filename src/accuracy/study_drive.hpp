// SPDX-License-Identifier: GPL-3.0-or-later
// A drive taken apart, for methods that are parts of `solve` or stand in for one; private to src/accuracy.
#pragma once

#include <algorithm>
#include <vector>

#include "accuracy/reference/reference_curve.hpp"
#include "accuracy/reference/reference_motion.hpp"
#include "hdconj/conjugate/tooth_body.hpp"
#include "hdconj/conjugate/tooth_space.hpp"
#include "hdconj/envelope/any_envelope.hpp"
#include "hdconj/profile/profile.hpp"
#include "hdconj/solution.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::accuracy {

/// Tooth, motion, contact arcs and the pieces of the boundary that is solved for, each with exact ends.
///
/// Forward problem: the boundary is one pitch of the circular spline, mid-land to mid-land, and `copy` of a piece
/// counts pitches. Reverse problem: it is the flexspline tooth from root to root, pieces without an arc are its walls
/// and its tip land, and `copy` is the index of the circular-spline tooth that sweeps the piece.
struct StudyDrive
{
    Scene scene;
    PairGeometry geometry;
    profile::Profile tooth;  ///< the given one
    wavegen::AnyWaveShape shape;
    std::vector<motion::AnyMotion> motions;     ///< of the given tooth; reverse problem: of each circular-spline tooth
    std::vector<int> numbers;                   ///< of these teeth
    std::vector<motion::AnyMotion> flexspline;  ///< reverse problem: the motion that these are seen from; else empty
    std::vector<envelope::ContactArc> arcs;     ///< of all of them
    std::vector<conjugate::BoundaryPiece> pieces;
    double pitch = 0;
    double offset = 0;
    double seat_radius = 0;        ///< of the frame of a given circular-spline tooth
    conjugate::BodyLimits limits;  ///< of the flexspline tooth that is solved for
    std::size_t branches = 0;

    [[nodiscard]] bool reverse() const { return scene.is_reverse(); }
    [[nodiscard]] std::size_t tooth_of(conjugate::BoundaryPiece const& piece) const
    {
        return reverse() ? static_cast<std::size_t>(piece.copy) : 0;
    }
    [[nodiscard]] motion::AnyMotion const& motion() const { return motions.front(); }
    [[nodiscard]] motion::AnyMotion const& motion(conjugate::BoundaryPiece const& piece) const
    {
        return motions[tooth_of(piece)];
    }
    [[nodiscard]] envelope::AnyEnvelope envelope(conjugate::BoundaryPiece const& piece) const
    {
        return {tooth, motion(piece), offset};
    }
    [[nodiscard]] envelope::ContactArc const& arc(conjugate::BoundaryPiece const& piece) const
    {
        return arcs[static_cast<std::size_t>(piece.arc)];
    }
    /// Of the profile piece that makes @p piece.
    [[nodiscard]] profile::PieceShape const& shape_of(conjugate::BoundaryPiece const& piece) const
    {
        return tooth.pieces[static_cast<std::size_t>(arc(piece).piece)].shape;
    }
    /// A point of the envelope of the tooth that makes @p piece, where the outline has it.
    [[nodiscard]] Vec2 placed(conjugate::BoundaryPiece const& piece, Vec2 const& p) const;
    [[nodiscard]] ReferenceNumbers given() const;
    /// Index into `motions` of the tooth @p number of a branch.
    [[nodiscard]] std::size_t index_of(int number) const
    {
        return reverse() ? static_cast<std::size_t>(std::ranges::find(numbers, number) - numbers.begin()) : 0;
    }
    /// The given tooth by the reference's path, for each of `motions`.
    template <class T>
    [[nodiscard]] std::vector<ReferenceView<T>> views() const
    {
        ReferenceMotion<T> const held(given());
        std::vector<ReferenceView<T>> all;
        for (std::size_t j = 0; j < motions.size(); ++j)
            all.push_back(reverse() ? ReferenceView<T>(held, numbers[j], T(seat_radius)) : ReferenceView<T>(held));
        return all;
    }
    /// One of them.
    template <class T>
    [[nodiscard]] ReferenceView<T> view(std::size_t which = 0) const
    {
        return views<T>()[which];
    }
    /// Largest tooth height, a length to measure by [mm].
    [[nodiscard]] double height() const { return tooth.addendum + tooth.dedendum; }
    /// Whether a piece is traced by the flank (not a corner, not the tip).
    [[nodiscard]] bool is_flank(conjugate::BoundaryPiece const& piece) const;
};

/// The outline that @p solution was asked for.
[[nodiscard]] inline std::vector<Vec2> const& outline_of(Solution const& solution)
{
    return solution.scene.is_reverse() ? solution.flexspline_outline : solution.circular_spline.outline.front();
}

/// Tooth and motions, without arcs and pieces.
/// @throws NumericalError as `solve` does
[[nodiscard]] StudyDrive drive_parts(Scene const& scene);

/// Adds arcs and pieces to @p drive, which has tooth and motions.
/// @throws NumericalError where a tooth enters the boundary however finely its pieces are searched
void find_boundary(StudyDrive& drive);

/// All of it. @throws NumericalError as `solve` does, and where the boundary's pieces cannot be put together to
/// rounding
[[nodiscard]] StudyDrive study_drive(Scene const& scene);

/// Where two contacts of a flank made of @p pieces merge.
[[nodiscard]] std::vector<double> fold_angles(motion::AnyMotion const& motion,
                                              std::vector<profile::CurvePiece> const& pieces);

/// The boundary in 50 digits, in the frame of the outline. Which stretch follows which is taken from @p drive, where a
/// full turn has shown that no tooth enters it, and confirmed by entry_of(); every number is computed anew from the
/// numbers that the scene gives: positions, contacts, corners.
/// @throws NumericalError where a corner does not converge
[[nodiscard]] ReferenceCurve reference_of(StudyDrive const& drive);

/// One stretch of the boundary alone.
[[nodiscard]] ReferenceCurve reference_of(StudyDrive const& drive, conjugate::BoundaryPiece const& piece);

/// Brute force on the reference itself: @p samples of its points against teeth at @p positions over a lobe, neighbours
/// included.
/// @returns how deep the deepest tooth enters [mm]; a point off the lands must also be touched: its distance from the
/// nearest tooth counts as well
[[nodiscard]] double entry_of(StudyDrive const& drive, ReferenceCurve const& reference, int samples, int positions);

/// Largest |n.v| over at most @p samples contacts of a solution's regular branches, in long double [mm/rad].
[[nodiscard]] double residual_of(StudyDrive const& drive, Solution const& solution, std::size_t samples);

}  // namespace hdconj::accuracy
