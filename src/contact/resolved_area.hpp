// SPDX-License-Identifier: GPL-3.0-or-later
// The contact area with its edge resolved finer than the map, and what its resolution leaves open.
#pragma once

#include <cstddef>
#include <vector>

#include "contact_area.hpp"

namespace hdconj::contact {

/// An area and what its resolution leaves open.
struct ResolvedArea
{
    ContactArea area;
    double along = 0;   ///< estimated error of so many points along the flank, as a share
    double across = 0;  ///< estimated error of so many slices, as a share
    double whole = 0;   ///< estimated error of the area of all flanks, of slices and chords [mm^2]
};

/// Area integral over the gaps of @p field at @p turn on the flanks @p flank of the spaces @p spaces of one lobe, which
/// stand for those of all; the others count with their area and without contact.
///
/// Wherever the gap may cross @p limit between two neighbouring points it is looked at in 16 steps between them (8 for
/// the half), on the exact flank and to the exact teeth; cells between slices as in contact_area(). So the error along
/// the flank is that of 16 times as many points, at the cost of the edge of the contact alone. `across`: D is what
/// every second slice in place of all changes and D' what every fourth in place of every second does. With q = D/D' all
/// that is left adds up to D q/(1 - q); q is taken from 1/2 to 2/3, and twice the sum is given, no less than D'/2,
/// since one difference may be small by chance. `along`: the same of the steps between points, 16, 8 and 4. Slices are
/// odd in number. Same bits for any number of threads.
/// @param errors  false: the area alone, the same bits, and no errors
[[nodiscard]] ResolvedArea resolved_area(GapField const& field, std::vector<std::size_t> const& spaces, double turn,
                                         int flank, double limit, double width, int threads, bool errors);

}  // namespace hdconj::contact
