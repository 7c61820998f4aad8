// SPDX-License-Identifier: GPL-3.0-or-later
#include "placement.hpp"

#include <cmath>

#include "hdconj/base/parallel.hpp"
#include "hdconj/base/rigid_motion.hpp"

namespace hdconj::inspect {

PointReader::PointReader(NominalPart const& part, double probe) : part_(part), probe_(probe)
{
    for (int k = 0; k < part.teeth; ++k)
        turns_.emplace_back(std::cos(k * part.pitch()), std::sin(k * part.pitch()));
}

Vec2 PointReader::from_tooth(Vec2 const& v, int tooth) const
{
    Vec2 const& turn = turns_[static_cast<std::size_t>(tooth)];
    return Pose{turn.x(), turn.y()}.rotate(v);
}

Vec2 PointReader::to_tooth(Vec2 const& v, int tooth) const
{
    Vec2 const& turn = turns_[static_cast<std::size_t>(tooth)];
    return Pose{turn.x(), turn.y()}.rotate_back(v);
}

PointView PointReader::on_flank(PlanePoint const& point, Placement const& placement, int tooth, bool right) const
{
    PointView view;
    view.plane = point.plane;
    view.tooth = tooth;
    view.right = right;
    double const turn = placement.turn + (right ? placement.excess : -placement.excess);
    view.place = turned_clockwise(point.where - placement.shift, -turn);
    Vec2 const in_tooth = to_tooth(view.place, tooth) - Vec2(0, part_.seat);
    FlankFoot const foot = part_.planes[point.plane].foot(in_tooth, right, point.above);
    view.on = foot.on;
    view.deviation = foot.distance - probe_;
    view.foot = foot.point;
    view.normal = from_tooth(foot.normal, tooth);
    return view;
}

PointView PointReader::operator()(PlanePoint const& point, Placement const& placement) const
{
    Vec2 const place = turned_clockwise(point.where - placement.shift, -placement.turn);
    auto const nearest = static_cast<int>(std::lround(std::atan2(place.x(), place.y()) / part_.pitch()));
    int const tooth = (nearest + part_.teeth) % part_.teeth;
    if (point.right)
        return on_flank(point, placement, tooth, *point.right);
    PointView const left = on_flank(point, placement, tooth, false);
    PointView const right = on_flank(point, placement, tooth, true);
    // a point of the tip land may have its foot on the far flank; the end of the near one is nearer
    return std::abs(left.deviation) <= std::abs(right.deviation) ? left : right;
}

Vec2 by_shift(PointView const& view, Placement const& placement)
{
    return -turned_clockwise(view.normal, placement.turn);
}

std::vector<PointView> views_of(PointReader const& read, std::vector<PlanePoint> const& points,
                                Placement const& placement, int threads)
{
    constexpr std::size_t grain = 256;  // a point takes some microseconds
    std::vector<PointView> views(points.size());
    parallel_for(points.size(), threads, grain, [&](std::size_t i) { views[i] = read(points[i], placement); });
    return views;
}

}  // namespace hdconj::inspect
