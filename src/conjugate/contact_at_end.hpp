// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where the contact goes on from one piece of a boundary to the next.
#pragma once

#include <cstdlib>

#include "hdconj/envelope/smooth_ranges.hpp"

namespace hdconj::conjugate {

/// An end of a boundary piece: which profile piece touches there, of which tooth, and when.
struct ContactAtEnd
{
    int piece = 0;
    int copy = 0;
    double u = 0;
};

/// Whether the contact goes on over two neighbours of a boundary: through a joint inside a segment, or a break of the
/// motion. Where two branches cross it does not, although neighbouring profile pieces may have made them.
[[nodiscard]] inline bool contact_goes_on(ContactAtEnd const& before, ContactAtEnd const& after, bool corner)
{
    if (before.copy != after.copy)
        return false;
    int const step = std::abs(after.piece - before.piece);
    return (step == 0 && envelope::same_instant(before.u, after.u)) ||
           (step == 1 && !corner && envelope::same_at_joint(before.u, after.u));
}

}  // namespace hdconj::conjugate
