// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The swept region by uniting tooth polygons with Clipper: another way to the tooth space that
/// knows nothing of envelopes.
///
/// Every polygon is the tooth at its position and every added triangle part of what the tooth
/// sweeps, both up to the chord error below, so that the union is nowhere larger than the swept
/// region by more than this chord. A point of the true boundary is missed by no more than
///
///   chord     sagitta of the polygon's arcs, chosen; convex arcs lose it, concave arcs gain it
///   step      acceleration step^2 / 8: between two positions a touching tooth moves off a point by
///             at most half the second derivative of its distance times (step/2)^2. The derivative is
///             bounded by |point acceleration| + |velocity|^2 / (smallest radius of the profile)
///   corner    the same sagitta for a tip corner's path: without help the union would have notches
///             there that are linear in the step, so the triangle (corner now, corner next, middle of
///             the tooth) is added
///   grid      rounding to Clipper's integers
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <polyclipping/clipper.hpp>
#include <stdexcept>
#include <vector>

#include "motion.hpp"
#include "tooth.hpp"

namespace oracle {

struct SweptBoundary
{
    std::vector<std::vector<Point<double>>> loops;  ///< outer loops, closed
    double error = 0;                               ///< stated [mm]
    std::size_t positions = 0;                      ///< over one lobe
    std::size_t polygons = 0;                       ///< that came near the window
};

/// Unites @p positions tooth positions over a lobe, with the neighbours that reach the pitch window
/// of the tooth space on the y axis.
/// @param tip_circle  what stays below it is of no interest
/// @param chord       sagitta of polygon sides [mm]
inline SweptBoundary swept_boundary(hdconj::Scene const& scene, double tip_circle, std::size_t positions, double chord)
{
    namespace clip = ClipperLib;
    double const unit = 1e-8;
    Tooth<double> const tooth(scene);
    Motion<double> const motion(scene);

    // The tooth as a polygon, right flank from the root up, mirrored on the left.
    std::vector<Point<double>> shape;
    double sharpest = 1e300;
    for (auto const& piece : tooth.flank) {
        int parts = 1;
        if (piece.arc) {
            sharpest = std::min(sharpest, piece.radius);
            parts = std::max(1, static_cast<int>(std::ceil(piece.arc_length() / piece.radius /
                                                           std::sqrt(8 * chord / piece.radius))));
        }
        for (int i = 0; i < parts; ++i)
            shape.push_back(piece.at(static_cast<double>(i) / parts));
    }
    std::size_t const right = shape.size();
    for (std::size_t i = right; i-- > 0;)
        shape.push_back({-shape[i].x, shape[i].y});
    for (auto& p : shape)
        p.y += tooth.pitch_line;
    Point<double> const corner{tooth.tip_corner().x, tooth.top};
    Point<double> const middle{0, tooth.pitch_line};

    double const half = motion.half_lobe(), step = 2 * half / static_cast<double>(positions);
    int const reach = std::abs(motion.pitches_per_turn) / motion.waves + 2;
    double const window = 0.75 * motion.pitch();
    double const widest = std::atan2(1.3 * tooth.half_width, tip_circle);
    auto const to_grid = [&](Point<double> const& p) {
        return clip::IntPoint(std::llround(p.x / unit), std::llround((p.y - tip_circle) / unit));
    };
    auto const unite = [](clip::Paths const& paths) {
        clip::Clipper clipper;
        clipper.AddPaths(paths, clip::ptSubject, true);
        clip::Paths united;
        if (!clipper.Execute(clip::ctUnion, united, clip::pftNonZero, clip::pftNonZero))
            throw std::runtime_error("oracle: Clipper failed");
        return united;
    };
    auto const oriented = [&](std::vector<Point<double>> const& points) {
        clip::Path path;
        for (auto const& p : points)
            path.push_back(to_grid(p));
        if (!clip::Orientation(path))
            clip::ReversePath(path);
        return path;
    };

    SweptBoundary result;
    result.positions = positions;
    double fastest = 0, acceleration = 0;
    // Binary counter of unions: level k holds the union of 2^k batches.
    std::vector<clip::Paths> level;
    auto const add = [&](clip::Paths paths) {
        paths = unite(paths);
        for (std::size_t k = 0;; ++k) {
            if (k == level.size())
                level.emplace_back();
            if (level[k].empty()) {
                level[k] = std::move(paths);
                return;
            }
            level[k].insert(level[k].end(), paths.begin(), paths.end());
            paths = unite(level[k]);
            level[k].clear();
        }
    };

    for (int copy = -reach; copy <= reach; ++copy) {
        clip::Paths batch;
        for (std::size_t i = 0; i < positions; ++i) {
            double const s = -half + step * static_cast<double>(i);
            auto const turned = [&](double at) {
                Pose<double> pose = motion.pose(at);
                double const angle = copy * motion.pitch();
                return Pose<double>{turned_clockwise(pose.origin, angle), turned_clockwise(pose.along, angle),
                                    turned_clockwise(pose.outward, angle)};
            };
            Pose<double> const pose = turned(s);
            if (length(pose.origin) + std::hypot(tooth.top, tooth.half_width) < tip_circle ||
                std::abs(std::atan2(pose.origin.x, pose.origin.y)) > window + widest)
                continue;
            ++result.polygons;
            std::vector<Point<double>> points;
            for (auto const& p : shape)
                points.push_back(pose.to_circular_spline(p));
            batch.push_back(oriented(points));
            Pose<double> const next = turned(s + step), before = turned(s - step);
            for (double const side : {-1.0, 1.0}) {
                Point<double> const c{side * corner.x, corner.y};
                Point<double> const now = pose.to_circular_spline(c), then = next.to_circular_spline(c);
                batch.push_back(oriented({now, then, pose.to_circular_spline(middle)}));
                fastest = std::max(fastest, length(then - now) / step);
                Point<double> const bend = then + before.to_circular_spline(c) - 2.0 * now;
                acceleration = std::max(acceleration, length(bend) / (step * step));
            }
            for (Point<double> const& p : {points.front(), points.back()}) {
                Point<double> const local = pose.to_tooth(p);
                fastest = std::max(fastest, length(next.to_circular_spline(local) - p) / step);
            }
            if (batch.size() >= 24) {
                add(std::move(batch));
                batch.clear();
            }
        }
        if (!batch.empty())
            add(std::move(batch));
    }
    clip::Paths all;
    for (auto const& paths : level)
        all.insert(all.end(), paths.begin(), paths.end());
    for (auto const& path : unite(all)) {
        if (!clip::Orientation(path))
            continue;  // a hole: a piece of material that would hang in the air
        auto& loop = result.loops.emplace_back();
        for (auto const& p : path)
            loop.push_back({static_cast<double>(p.X) * unit, static_cast<double>(p.Y) * unit + tip_circle});
    }
    double const second = 2 * acceleration + 2 * fastest * fastest / sharpest;
    result.error = chord + second * step * step / 8 + 2 * unit;
    return result;
}

}  // namespace oracle
