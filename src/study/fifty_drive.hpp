// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Contacts of a drive in 50 digits; private to src/study.
#pragma once

#include <vector>

#include "fifty.hpp"
#include "given_contact.hpp"
#include "study_drive.hpp"

namespace hdconj::detail {

/// The contact arcs of a drive, which is referred to, at any u in 50 digits. Arcs say which contact is meant, and give a first guess of it; no digit of the result is theirs.
class FiftyDrive
{
  public:
    explicit FiftyDrive(StudyDrive const& drive);

    /// In the frame of the outline, turned by the pitches of @p piece.
    /// @throws NumericalError where an arc's centre is at rest
    [[nodiscard]] GivenContact<Fifty> contact(BoundaryPiece const& piece, Fifty const& u) const;
    [[nodiscard]] Pair<Fifty> point(BoundaryPiece const& piece, Fifty const& u) const { return contact(piece, u).point; }
    /// How far the contact's normal leans from the centre line of the tooth that makes @p piece.
    [[nodiscard]] Fifty lean(BoundaryPiece const& piece, Fifty const& u) const;
    /// The angle at which the contact of @p piece merges with another, where its arc says that it does near @p u; else @p u.
    [[nodiscard]] Fifty merged(BoundaryPiece const& piece, double u) const;
    /// Angles in a wave at which the speed of contacts jumps; none where the model is of series.
    [[nodiscard]] std::vector<Fifty> const& breaks() const { return breaks_; }
    [[nodiscard]] Fifty half_pitch() const { return views_.front().motion().pitch() / 2; }

  private:
    [[nodiscard]] GivenContact<Fifty> on_tooth(BoundaryPiece const& piece, Place<Fifty> const& place, Fifty const& u) const;

    StudyDrive const& drive_;
    std::vector<GivenView<Fifty>> views_;
    std::vector<Fifty> breaks_;
};

}  // namespace hdconj::detail
