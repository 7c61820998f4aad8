// SPDX-License-Identifier: GPL-3.0-or-later
// Loops over lanes, compiled as those of tooth_lanes.cpp.
#include "lane_placement.hpp"

#include "base/loop_targets.hpp"

namespace hdconj::contact {

using distance::lanes;

HDCONJ_TARGETS
void place(distance::ToothDistance const& tooth, double cosine, double sine, Vec2 const& shift,
           LanePoints const& points, double more, PlacedLanes& placed)
{
    double const s_x = shift.x(), s_y = shift.y();
    for (std::size_t l = 0; l < lanes; ++l) {
        placed.x[l] = cosine * points.x[l] + sine * points.y[l] - s_x;
        placed.y[l] = -sine * points.x[l] + cosine * points.y[l] - s_y;
    }
    for (std::size_t l = 0; l < lanes; ++l)
        placed.asked[l] = tooth.lower_bound({placed.x[l], placed.y[l]}) < points.best[l] + more ? 1.0 : 0.0;
    double any = 0;
    for (std::size_t l = 0; l < lanes; ++l)
        any += placed.asked[l];
    placed.any = any != 0;
}

HDCONJ_TARGETS
void keep_nearer(distance::Lanes const& distance, LanePoints& points, PlacedLanes& placed)
{
    for (std::size_t l = 0; l < lanes; ++l) {
        int const nearer = int{placed.asked[l] != 0} & int{distance[l] < points.best[l]};
        points.best[l] = nearer != 0 ? distance[l] : points.best[l];
        placed.asked[l] = nearer != 0 ? 1.0 : 0.0;
    }
}

}  // namespace hdconj::contact
