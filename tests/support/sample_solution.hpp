// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A solution to write, made without the solver: the type-50 tooth moved along a plausible path, its swept boundary
/// read off the tooth family. Right shape and size for files and pictures, not a reference for numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hdconj/solution.hpp"

namespace hdconj::sample {

inline constexpr double radius = 24.347;     // r_m
inline constexpr double deformation = 0.25;  // w0
inline constexpr double pitch_line = 0.653;
inline constexpr double addendum = 0.225;
inline constexpr double dedendum = 0.303;
inline constexpr double tip_radius = 25.025;
inline constexpr double flexspline_teeth = 200;
inline constexpr double circular_spline_teeth = 202;

struct Arc
{
    std::string name;
    Vec2 centre;
    double radius = 0;
    double from = 0, to = 0;  // of the normal's angle, from the tooth outwards
    bool concave = false;
};

/// The arcs of the right flank.
inline std::vector<Arc> arcs()
{
    Vec2 const convex(-0.0982, 0), concave(std::sqrt(0.7846 * 0.7846 - 0.0671 * 0.0671) - 0.0982, 0.0671);
    double const joint = std::atan2(concave.y(), concave.x() - convex.x());
    return {{"convex arc right", convex, 0.2701, joint, std::asin(0.19 / 0.2701), false},
            {"concave arc right", concave, 0.5145, joint, std::asin((dedendum + 0.0671) / 0.5145), true}};
}

/// Right flank from the tip down, y from the pitch line.
inline std::vector<Vec2> right_flank()
{
    constexpr int steps = 24;
    auto const both = arcs();
    std::vector<Vec2> flank = {{0.0592, addendum}};
    for (int i = 0; i <= steps; ++i) {
        auto const& arc = both[0];
        flank.push_back(arc.centre + arc.radius * direction(arc.to + (arc.from - arc.to) * i / steps));
    }
    for (int i = 1; i <= steps; ++i) {
        auto const& arc = both[1];
        flank.push_back(arc.centre - arc.radius * direction(arc.from + (arc.to - arc.from) * i / steps));
    }
    return flank;
}

/// Tooth frame in the circular-spline frame.
struct Pose
{
    double theta = 0;
    Vec2 origin = Vec2::Zero();
    [[nodiscard]] Vec2 turned(Vec2 const& a) const
    {
        return {a.x() * std::cos(theta) + a.y() * std::sin(theta), -a.x() * std::sin(theta) + a.y() * std::cos(theta)};
    }
    [[nodiscard]] Vec2 operator()(Vec2 const& from_pitch_line) const
    {
        return origin + turned(from_pitch_line + Vec2(0, pitch_line));
    }
};

inline double undeformed_angle(double u)
{
    return u + deformation / (2 * radius) * std::sin(2 * u);
}

inline Pose pose_at(double u)
{
    double const rho = radius + deformation * std::cos(2 * u);
    double const gamma = u - flexspline_teeth / circular_spline_teeth * undeformed_angle(u);
    double const theta = gamma - std::atan(-2 * deformation * std::sin(2 * u) / rho);
    return {theta, rho * Vec2(std::sin(gamma), std::cos(gamma))};
}

/// Where the right flank touches its envelope: the contact normal is across the velocity of the arc's centre.
inline std::vector<BranchRecord> branches()
{
    constexpr int steps = 900;
    constexpr double last = std::numbers::pi / 2, delta = 1e-5;
    std::vector<BranchRecord> found;
    auto const both = arcs();
    for (int segment = 0; segment < 2; ++segment) {
        auto const& arc = both[static_cast<std::size_t>(segment)];
        for (int side : {1, -1}) {
            BranchRecord record;
            for (int i = 0; i <= steps; ++i) {
                double const u = last * i / steps;
                Vec2 const velocity = pose_at(u + delta)(arc.centre) - pose_at(u - delta)(arc.centre);
                Vec2 const normal = side * left_of(velocity).normalized();
                double const angle = std::atan2(normal.y(), normal.x()) + pose_at(u).theta;
                double const t = (angle - arc.from) / (arc.to - arc.from);
                bool const inside = t >= 0 && t <= 1;
                if (inside) {
                    record.u.push_back(u);
                    record.phi.push_back(undeformed_angle(u));
                    record.t.push_back(t);
                    record.point.push_back(pose_at(u)(arc.centre) + (arc.concave ? -1 : 1) * arc.radius * normal);
                }
                if ((!inside || i == steps) && record.u.size() > 1) {
                    record.kind = "regular";
                    record.segment = segment;
                    record.segment_name = arc.name;
                    record.begins = "segment end";
                    record.ends = inside ? "range end" : "segment end";
                    record.on_boundary = arc.concave == false && record.u.front() < 0.1;
                    found.push_back(record);
                }
                if (!inside) {
                    record = {};
                }
            }
        }
    }
    return found;
}

inline std::vector<Vec2> mirrored(std::vector<Vec2> right)
{
    std::vector<Vec2> all;
    for (auto const& point : right)
        all.emplace_back(-point.x(), point.y());
    std::reverse(all.begin(), all.end());
    all.insert(all.end(), right.begin(), right.end());
    return all;
}

inline std::vector<std::vector<Vec2>> tooth_family(int positions)
{
    std::vector<std::vector<Vec2>> family;
    auto const tooth = mirrored(right_flank());
    for (int i = 0; i < positions; ++i) {
        Pose const pose = pose_at(std::numbers::pi * ((i + 0.5) / positions - 0.5));
        family.emplace_back();
        for (auto const& point : tooth)
            family.back().push_back(pose(point));
    }
    return family;
}

/// One pitch of the boundary: at each height the widest tooth of the family.
inline std::vector<Vec2> outline(int levels)
{
    auto const family = tooth_family(400);
    double const top = radius + deformation + pitch_line + addendum;
    double const half_pitch = std::numbers::pi / circular_spline_teeth;
    double const low = std::sqrt(tip_radius * tip_radius - 0.3 * 0.3);
    std::vector<Vec2> right;
    for (int i = 0; i <= levels; ++i) {
        double const y = top + (low - top) * i / levels;
        double widest = 0.0592;
        for (auto const& tooth : family) {
            for (std::size_t k = tooth.size() / 2; k + 1 < tooth.size(); ++k) {
                double const a = tooth[k].y() - y, b = tooth[k + 1].y() - y;
                if (a >= 0 && b < 0)
                    widest = std::max(widest, tooth[k].x() + (tooth[k + 1].x() - tooth[k].x()) * a / (a - b));
            }
        }
        right.emplace_back(widest, y);
    }
    right.emplace_back(tip_radius * std::sin(half_pitch), tip_radius * std::cos(half_pitch));
    return mirrored(right);
}

inline Solution solution()
{
    Solution result;
    result.scene.drive = {"type-50", 0.25, 200, 202};
    result.scene.circular_spline.width = 7;
    result.scene.text = "# sample\n[drive]\nname = \"type-50\"\n";
    result.plan = {{{Stage::profile, "always"}, {Stage::neutral_curve, "always"}, {Stage::envelope, "always"}},
                   {{"coning", "write [coning]"}}};
    double const space_depth = radius + deformation + pitch_line + addendum - tip_radius;
    result.geometry = {radius, radius - 2.567e-3, deformation, pitch_line,  addendum, dedendum,
                       23.997, tip_radius,        2.5e-3,      space_depth, -100};
    result.segment_names = {"convex arc right", "concave arc right"};
    result.flexspline_outline = mirrored(right_flank());
    for (int i = 0; i < 720; ++i) {
        double const u = std::numbers::pi * i / 360;
        result.neutral_curve.emplace_back((radius + deformation * std::cos(2 * u)) * Vec2(std::sin(u), std::cos(u)));
    }
    result.branches = branches();
    for (std::size_t i = 0; i < result.branches.size(); ++i) {
        auto const& branch = result.branches[i];
        result.zones.push_back({branch.segment, branch.segment_name, branch.kind, i, branch.u.front(), branch.u.back(),
                                branch.phi.front(), branch.phi.back(), branch.t.front(), branch.t.back(), 3e-13, 5e-14,
                                branch.on_boundary, branch.on_boundary});
    }
    result.certificate.undecided = {
        {"convex arc right", 0.25, 0.5, 3e-7, 2e-17, "a contact touches the end of a profile piece"}};
    auto const boundary = outline(120);
    int const last = static_cast<int>(boundary.size()) - 1;
    result.circular_spline = {{0.0},
                              {boundary},
                              {0, 1, last / 2, last - 1, last},
                              {{"land", "", 0, 1},
                               {"flank", "convex arc right", 1, boundary.size() - 2},
                               {"land", "", boundary.size() - 2, boundary.size() - 1}}};
    result.tooth_family = tooth_family(40);
    result.check = PairCheck{-3e-8, boundary[30], 0.1, boundary.size(), 2000};
    result.error = {3.1e-7, 2e-15, 1e-15, 2.4e-14, 3.2e-7, 4e-12, 1.3e-12};
    result.work = {12345, 67, 890};
    result.threads = 2;
    result.timing = {{"profile", 1e-5}, {"neutral_curve", 2e-4}, {"envelope", 1.5e-3}, {"region", 12e-3}};
    return result;
}

}  // namespace hdconj::sample
