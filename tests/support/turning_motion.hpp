// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A motion and a curve whose meshing condition is any polynomial that a test wants.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj::test {

/// A translation whose direction turns: f = x' dy - y' dx, on the curve below a polynomial of our choice.
struct Turning
{
    double rate = 1;    ///< of q_y
    double at = 0;      ///< instant at which q_y = 0
    double square = 0;  ///< of q_y in u

    Pose pose(double) const { return {}; }
    motion::MotionRates rates(double u) const
    {
        double const d = u - at;
        return {{0, {1, rate * d + square * d * d}}, {0, {0, rate + 2 * square * d}}, 1, 1, 1, 1};
    }
    motion::ToothAngles angles(double u) const { return {u, u}; }
    double half_lobe() const { return 1; }
    std::span<double const> breaks() const { return {}; }
    bool symmetric() const { return false; }
};

/// x = t, y' = p(t) given by its Bernstein coefficients: f = q_y - q_x p(t).
inline profile::CurvePiece with_slope(std::vector<double> const& p)
{
    std::vector<double> x, y{0.5};
    auto const n = static_cast<double>(p.size());
    for (std::size_t i = 0; i <= p.size(); ++i)
        x.push_back(static_cast<double>(i) / n);
    for (double slope : p)
        y.push_back(y.back() + slope / n);
    return {x, y};
}

}  // namespace hdconj::test
