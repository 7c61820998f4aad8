// SPDX-License-Identifier: GPL-3.0-or-later
// The union of N tooth positions: no envelope, no meshing condition, polygons only.
#include <algorithm>
#include <cmath>

#include "hdconj/conjugate/swept_polygons.hpp"
#include "hdconj/error.hpp"
#include "hdconj/region/outer_boundary.hpp"
#include "study_bench.hpp"

namespace hdconj::accuracy {
namespace {

/// Outer boundary of @p count positions of the tooth over a lobe, neighbours included, one pitch from mid-land to
/// mid-land.
std::vector<Vec2> united(StudyDrive const& drive, std::vector<Vec2> const& tooth, int count, std::size_t& segments)
{
    double const tip = drive.geometry.circular_spline_inner_radius, half = drive.motion().half_lobe();
    conjugate::SweptPolygons swept(drive.pitch);
    for (int i = 0; i <= count; ++i) {
        Pose const pose = drive.motion().pose(-half + 2 * half * i / count);
        conjugate::for_runs(
            tooth.size(), [&](std::size_t k) { return pose(tooth[k]).norm() > tip; },
            [&](std::size_t first, std::size_t end) {
                std::vector<Vec2> points;
                std::vector<double> numbers;
                for (std::size_t k = first; k < end; ++k) {
                    points.push_back(pose(tooth[k]));
                    numbers.push_back(static_cast<double>(k));
                }
                swept.add(i, points, numbers);
            });
    }
    int const floor = swept.add_floor(tip, drive.height() * 0x1p-20);
    region::OuterBoundary const boundary = region::outer_boundary(swept.polygons(), floor);
    segments = boundary.segments;
    std::vector<Vec2> outline;
    for (region::BoundaryRun const& run : boundary.runs) {
        std::vector<Vec2> const& polygon = swept.polygon(run.curve);
        auto const at = [&](double position) -> Vec2 {
            auto const k = std::min(static_cast<std::size_t>(position), polygon.size() - 2);
            return polygon[k] + (position - static_cast<double>(k)) * (polygon[k + 1] - polygon[k]);
        };
        bool const forward = run.end >= run.begin;
        outline.push_back(at(run.begin));
        double next = forward ? std::floor(run.begin) + 1 : std::ceil(run.begin) - 1;
        for (; forward ? next < run.end : next > run.end; next += forward ? 1 : -1)
            outline.push_back(at(next));
        outline.push_back(at(run.end));
    }
    auto const outside = [&](Vec2 const& p) { return std::abs(std::atan2(p.x(), p.y())) > drive.pitch / 2; };
    outline.erase(std::remove_if(outline.begin(), outline.end(), outside), outline.end());
    if (outline.size() < 2)
        throw NumericalError(ErrorCode::no_outline, "study union", "tip circle",
                             "the united teeth leave no boundary in the middle pitch");
    return outline;
}

}  // namespace

void study_union(StudyBench const& bench)
{
    StudyDrive const& drive = bench.drive;
    std::vector<Vec2> const tooth = profile::polygon_of(drive.tooth, drive.height() * 0x1p-17);
    constexpr int first = 16, last = 512, last_of_short = 32;
    for (int count = first; count <= bench.length(last, last_of_short, last_of_short); count *= 2) {
        std::size_t segments = 0;
        std::vector<Vec2> const outline = united(drive, tooth, count, segments);
        // the ends lie within one step of the floor of the middle of the lands
        CurveDifference const difference = bench.reference.inner().compare(outline, drive.height());
        StudyRecord record{"union", {}, "union of positions", "positions", static_cast<double>(count)};
        record.error = bench.reference.largest_distance(outline);
        record.hausdorff = std::max(record.error, bench.reference.inner().largest_gap(outline));
        record.missed = difference.missed;
        record.evaluations = static_cast<double>(segments);
        record.points = static_cast<double>(outline.size());
        StudyBench once = bench;
        once.repeats = std::min(bench.repeats, 3);
        once.measure(record, [&] { (void)united(drive, tooth, count, segments); });
    }
}

}  // namespace hdconj::accuracy
