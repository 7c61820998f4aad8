// SPDX-License-Identifier: GPL-3.0-or-later
#include "sliding.hpp"

#include <cmath>
#include <numbers>

#include "hdconj/base/rigid_motion.hpp"
#include "load/study/loaded_shape.hpp"

namespace hdconj::running {
namespace {

/// Whether @p places holds the pose of @p tooth.
bool holds(contact::ToothPoses const& places, int tooth)
{
    return tooth >= places.first && static_cast<std::size_t>(tooth - places.first) * places.slices < places.pose.size();
}

}  // namespace

std::vector<SlidingContact> sliding_contacts(load::LoadProblem const& problem, load::LoadedDrive const& loaded)
{
    load::ElasticDrive const& drive = problem.drive;
    Drive const& pair = problem.context.scene.drive;
    constexpr double step = 0.01;  // of a pitch, to either side
    double const h = step * 2 * std::numbers::pi / pair.flexspline_teeth;
    double const space_pitch = 2 * std::numbers::pi / pair.circular_spline_teeth;
    contact::ToothPoses const before = load::tooth_poses(problem.context, drive, loaded.shape.series, drive.phase - h),
                              after = load::tooth_poses(problem.context, drive, loaded.shape.series, drive.phase + h);
    contact::GapField const field = load::gap_field(problem, loaded.shape, problem.edges);
    std::vector<SlidingContact> result;
    for (std::size_t i = 0; i < loaded.contacts.size(); ++i) {
        load::FlankContact const& c = loaded.contacts[i];
        double const force = loaded.state.flank[i];
        if (!(force > 0) || !holds(before, c.tooth) || !holds(after, c.tooth))
            continue;
        double const angle = (field.space_number(c.space) - c.tooth) * space_pitch - loaded.state.turn;
        Vec2 const q = turned_clockwise(c.point, angle), normal = turned_clockwise(c.normal, angle);
        Vec2 const velocity =
            (after.at(c.tooth, c.slice).inverse(q) - before.at(c.tooth, c.slice).inverse(q)) / (2 * h);
        Vec2 const outward = loaded.shape.places.at(c.tooth, c.slice).rotate_back(normal);
        double const phi = 2 * std::numbers::pi * c.tooth / pair.flexspline_teeth + drive.phase;
        double const axial = load::series_at(drive, loaded.shape.series[drive.stations.axial(c.slice)], phi).slope;
        result.push_back(
            {force * drive.response->sectors(), std::hypot(cross(outward, velocity), axial), outward.dot(velocity)});
    }
    return result;
}

}  // namespace hdconj::running
