// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What tracing leaves undecided: refused, or recorded in the result.
#pragma once

#include <string>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/error.hpp"
#include "hdconj/profile/profile.hpp"
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

}  // namespace hdconj::conjugate
