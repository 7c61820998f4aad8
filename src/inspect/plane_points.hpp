// SPDX-License-Identifier: GPL-3.0-or-later
// The points that are evaluated, and whether they are of the part and of the teeth and flanks that they name.
#pragma once

#include <vector>

#include "hdconj/inspect.hpp"
#include "measured_planes.hpp"

namespace hdconj::inspect {

/// Layer of a drawing with points of the flexspline. write_dxf() draws the assembled tooth on it.
inline constexpr char const* flexspline_layer = "FLEXSPLINE_TOOTH";

/// The points of a drawing's layer that has the part, where it has several: the one that `solve --dxf` gives that name.
/// @throws InputError where there is none
[[nodiscard]] PointFile of_own_layer(PointFile const& measured, InspectedPart part);

/// @throws InputError where a point names a tooth that @p part has not
void refuse_numbers(PointFile const& measured, NominalPart const& part);

/// @throws InputError where most points that name a flank are clearly nearer to the other flank, wherever the part is
/// turned to
void refuse_exchanged_flanks(PlanePoints const& on, PointReader const& read, std::string const& file, int threads);

/// @throws InputError where most points stand on no flank: those of another part, of another unit or about another axis
void refuse_foreign_points(PlanePoints const& on, std::vector<PointView> const& views, NominalPart const& part,
                           std::string const& file);

/// @throws InputError where the points that name one tooth stand on several, two named teeth are one, or the numbers do
/// not count the teeth clockwise
void refuse_mixed_teeth(PlanePoints const& on, std::vector<PointView> const& views, PointFile const& measured,
                        NominalPart const& part);

}  // namespace hdconj::inspect
