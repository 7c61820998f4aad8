// SPDX-License-Identifier: GPL-3.0-or-later
#include "tangency.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::cam {
namespace {

constexpr int inner_steps = 192;
constexpr int outer_steps = 384;

/// Frame of the flexspline tooth from (0, r_m).
Pose pose_at(ToothOrigin const& origin, double theta)
{
    return {std::cos(theta), std::sin(theta), origin.point()};
}

}  // namespace

Pose right_wall(double angle, double r_m, double height)
{
    double const half = std::sin(angle / 2);
    double const radius = r_m + height;
    // y towards the axis: turned clockwise by the angle and pi
    return {-std::cos(angle), -std::sin(angle), {radius * std::sin(angle), height - 2 * radius * half * half}};
}

FlankPair::FlankPair(Flank inner, Flank outer, Pose const& seat, double offset)
    : inner_(std::move(inner)), outer_(std::move(outer)), seat_(seat), offset_(offset)
{
    for (FlankPlace const& place : inner_.places(inner_.length() / inner_steps)) {
        PointOnFlank const p = inner_.at(place);
        inner_samples_.push_back({place, p.point + offset_ * p.normal(), p.normal()});
    }
    for (FlankPlace const& place : outer_.places(outer_.length() / outer_steps)) {
        PointOnFlank const p = outer_.at(place);
        outer_samples_.push_back({place, seat_(p.point), seat_.rotate(p.normal())});
        if (std::size_t const n = outer_samples_.size(); n > 1)
            outer_spacing_ =
                std::max(outer_spacing_, (outer_samples_[n - 1].point - outer_samples_[n - 2].point).norm());
    }
}

FlankPair::Sample const& FlankPair::nearest(Vec2 const& p, Sample const& guess) const
{
    Sample const* best = &guess;
    double least = (p - guess.point).norm();
    for (std::size_t i = 0; i < outer_samples_.size();) {
        double const d = (p - outer_samples_[i].point).norm();
        if (d < least) {
            least = d;
            best = &outer_samples_[i];
        }
        i += 1 + static_cast<std::size_t>((d - least) / outer_spacing_);  // so far none can be nearer
    }
    return *best;
}

std::optional<Tangency> FlankPair::refined(Tangency const& seed, ToothOrigin const& origin) const
{
    constexpr int budget = 40;
    constexpr int settled = 2;  // steps of rounding size before the result is taken
    Tangency found = seed;
    double const step_limit = std::min(inner_.length(), outer_.length()) / 4;
    double const rounding = 64 * unit_roundoff * (inner_.length() + std::abs(origin.w));
    int small = 0, times_at_end = 0;
    for (int i = 0; i < budget; ++i) {
        PointOnFlank const a = inner_.at(found.inner);
        PointOnFlank const b = outer_.at(found.outer);
        Pose const pose = pose_at(origin, found.theta);
        Vec2 const shifted = a.point + offset_ * a.normal();
        // an offset changes the speed along the flank and its curvature, not its tangent
        double const stretch = 1 - offset_ * a.curvature;
        Vec2 const ta = pose.rotate(a.tangent), na = left_of(ta);
        Vec2 const tb = seat_.rotate(b.tangent), nb = left_of(tb);
        Vec2 const arm = pose.rotate(right_of(shifted));
        Vec2 const miss = pose(shifted) - seat_(b.point);
        Eigen::Matrix3d jacobian;
        jacobian << stretch * ta.x(), -tb.x(), arm.x(), stretch * ta.y(), -tb.y(), arm.y(), a.curvature * na.dot(nb),
            -b.curvature * ta.dot(tb), -na.dot(nb);
        Eigen::Vector3d const step = jacobian.fullPivLu().solve(Eigen::Vector3d(-miss.x(), -miss.y(), -ta.dot(nb)));
        if (!step.allFinite())
            return std::nullopt;
        double const longest = std::max(std::abs(step[0]), std::abs(step[1]));
        double const factor = longest > step_limit ? step_limit / longest : 1;
        bool const inside_inner = inner_.advance(found.inner, factor * step[0]);
        bool const inside_outer = outer_.advance(found.outer, factor * step[1]);
        found.theta += factor * step[2];
        times_at_end = inside_inner && inside_outer ? 0 : times_at_end + 1;
        if (times_at_end > settled + 1)
            return std::nullopt;
        found.lever = -arm.dot(nb);
        bool const done =
            times_at_end == 0 && std::abs(step[2]) * inner_.length() <= rounding && miss.norm() <= 4 * rounding;
        small = done ? small + 1 : 0;
        if (small == settled) {
            // opposite normals, a gap that grows to both sides, and a tooth that comes nearer as it turns
            bool const outside = na.dot(nb) < 0 && a.curvature / stretch + b.curvature < 0 && found.lever > 0;
            return outside ? std::optional(found) : std::nullopt;
        }
    }
    return std::nullopt;
}

std::vector<Tangency> FlankPair::tangencies(ToothOrigin const& origin, double theta) const
{
    Pose const pose = pose_at(origin, theta);
    std::vector<double> gaps;
    std::vector<FlankPlace> places;
    Sample const* best = &outer_samples_.front();
    for (Sample const& a : inner_samples_) {
        Vec2 const p = pose(a.point);
        best = &nearest(p, *best);
        gaps.push_back((p - best->point).dot(best->normal));
        places.push_back(best->place);
    }
    std::vector<Tangency> found;
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        bool const low = (i == 0 || gaps[i] <= gaps[i - 1]) && (i + 1 == gaps.size() || gaps[i] <= gaps[i + 1]);
        if (!low)
            continue;
        if (auto const tangency = refined({inner_samples_[i].place, places[i], theta, 0}, origin))
            found.push_back(*tangency);
    }
    std::sort(found.begin(), found.end(), [](Tangency const& a, Tangency const& b) { return a.theta < b.theta; });
    return found;
}

}  // namespace hdconj::cam
