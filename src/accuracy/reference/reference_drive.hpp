// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a drive in 50 digits; private to src/accuracy.
#pragma once

#include <vector>

#include "accuracy/study_drive.hpp"
#include "fifty.hpp"
#include "reference_contact.hpp"

namespace hdconj::accuracy {

/// The contact arcs of a drive, which is referred to, at any u in 50 digits. Arcs say which contact is meant, and give
/// a first guess of it; no digit of the result is theirs.
class ReferenceDrive
{
  public:
    explicit ReferenceDrive(StudyDrive const& drive);

    /// In the frame of the outline, turned by the pitches of @p piece.
    /// @throws NumericalError where an arc's centre is at rest
    [[nodiscard]] ReferenceContact<Fifty> contact(conjugate::BoundaryPiece const& piece, Fifty const& u) const;
    [[nodiscard]] Pair<Fifty> point(conjugate::BoundaryPiece const& piece, Fifty const& u) const
    {
        return contact(piece, u).point;
    }
    /// How far the contact's normal leans from the centre line of the tooth that makes @p piece.
    [[nodiscard]] Fifty lean(conjugate::BoundaryPiece const& piece, Fifty const& u) const;
    /// The angle at which the contact of @p piece merges with another, where its arc says that it does near @p u; else
    /// @p u.
    [[nodiscard]] Fifty merged(conjugate::BoundaryPiece const& piece, double u) const;
    /// Angles in a wave at which the speed of contacts jumps; none where the model is of series.
    [[nodiscard]] std::vector<Fifty> const& breaks() const { return breaks_; }
    [[nodiscard]] Fifty half_pitch() const { return views_.front().motion().pitch() / 2; }

  private:
    [[nodiscard]] ReferenceContact<Fifty> on_tooth(conjugate::BoundaryPiece const& piece,
                                                   MovingFrame<Fifty> const& place, Fifty const& u) const;

    StudyDrive const& drive_;
    std::vector<ReferenceView<Fifty>> views_;
    std::vector<Fifty> breaks_;
};

}  // namespace hdconj::accuracy
