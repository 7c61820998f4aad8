// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measured points of a ring whose errors are known, from the formulas of the built-in drive's double circular arc.
#pragma once

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "hdconj/base/rigid_motion.hpp"
#include "hdconj/inspect.hpp"
#include "hdconj/read_scene.hpp"
#include "support/draws.hpp"

namespace hdconj::test {

/// The right flank of the type-50 tooth by arc length from its root, y from the pitch line.
class FormulaFlank
{
  public:
    struct Point
    {
        Vec2 where, normal;
    };

    [[nodiscard]] double length() const { return root_length + convex_length + line_length; }
    [[nodiscard]] Point at(double s) const
    {
        if (s < root_length) {
            Vec2 const n = direction(root - s / concave);
            return {Vec2(concave_at - concave * n), n};
        }
        s -= root_length;
        if (s < convex_length) {
            Vec2 const n = direction(joint + s / convex);
            return {Vec2(convex_at + convex * n), n};
        }
        Vec2 const n = direction(tip);
        return {Vec2(convex_at + convex * n + (s - convex_length) * left_of(n)), n};
    }

  private:
    double h_a = 0.2250, h_f = 0.3030, convex = 0.2701, l_a = 0.0982, concave = 0.5145, b_f = 0.0671, h_t = 0.1900;
    Vec2 convex_at{-l_a, 0};
    Vec2 concave_at{std::sqrt((convex + concave) * (convex + concave) - b_f * b_f) - l_a, b_f};
    double joint = std::atan2(b_f, concave_at.x() + l_a);
    double tip = std::asin(h_t / convex);
    double root = std::asin((b_f + h_f) / concave);
    double root_length = concave * (root - joint);
    double convex_length = convex * (tip - joint);
    double line_length = (h_a - h_t) / std::cos(tip);
};

/// Errors of one flank [mm], along the normal; the turn is an arc at the reference circle, clockwise.
struct FlankErrors
{
    double position = 0, slope = 0, crowning = 0;
    double form = 0;                   ///< amplitude of a wave from which constant, slope and parabola are taken out
    double form_range = 0, total = 0;  ///< largest less smallest, found while the points are made
};

/// A ring, what is wrong with it, and how it is measured.
struct MeasuredRing
{
    int teeth = 200;                       ///< on the whole ring; its module is 0.25 mm
    std::vector<int> measured;             ///< teeth, from 0; empty: all
    std::vector<FlankErrors> left, right;  ///< of each measured tooth
    int points = 25;                       ///< on each flank
    double missing = 0;                    ///< share of points that are left out
    bool shuffled = false;
    double probe = 0;
    double noise = 0;  ///< standard deviation
    double turn = 0;   ///< of the part, clockwise [rad]
    Vec2 shift = Vec2::Zero();
    int strays = 0;  ///< points that stand 30 ... 80 um off

    [[nodiscard]] double pitch_radius() const { return 0.125 * teeth; }
    /// Radius of the circle through the middles of the flanks.
    [[nodiscard]] double reference_radius() const
    {
        FormulaFlank const flank;
        return (flank.at(flank.length() / 2).where + Vec2(0, pitch_radius())).norm();
    }
};

/// A number of the normal distribution (Box and Muller).
inline double normal(designs::Draws& draws)
{
    double const radius = std::sqrt(-2 * std::log(1 - draws.between(0, 1)));
    return radius * std::cos(2 * std::numbers::pi * draws.between(0, 1));
}

/// A wave over xi without constant, slope and parabola, of amplitude 1 before these are taken out.
inline Eigen::VectorXd pure_form(std::vector<double> const& xi, double phase)
{
    auto const n = static_cast<Eigen::Index>(xi.size());
    Eigen::MatrixX3d basis(n, 3);
    Eigen::VectorXd wave(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        double const x = xi[static_cast<std::size_t>(i)];
        basis.row(i) << 1, x, x * x;
        wave[i] = std::sin(5 * x + phase);
    }
    return wave - basis * basis.colPivHouseholderQr().solve(wave);
}

/// Adds the points of one flank. @param errors  their ranges are entered
inline void add_flank(MeasuredRing const& ring, int tooth, bool is_right, FlankErrors& errors, designs::Draws& draws,
                      std::vector<PartPoint>& points)
{
    FormulaFlank const flank;
    std::vector<double> s, xi;
    for (int i = 0; i < ring.points; ++i) {
        bool const kept = draws.between(0, 1) >= ring.missing || i == 0 || i + 1 == ring.points;
        double const share = 0.06 + 0.88 * (i + draws.between(-0.3, 0.3)) / (ring.points - 1);
        if (!kept)
            continue;
        s.push_back(flank.length() * std::clamp(share, 0.04, 0.96));
        xi.push_back(2 * s.back() / flank.length() - 1);
    }
    Eigen::VectorXd const form = errors.form * pure_form(xi, draws.between(0, 6));
    std::vector<double> smooth;
    double const pitch = 2 * std::numbers::pi / ring.teeth;
    double const angle = tooth * pitch + errors.position / ring.reference_radius();
    for (std::size_t i = 0; i < s.size(); ++i) {
        auto const [where, normal_there] = flank.at(s[i]);
        smooth.push_back(errors.slope / 2 * xi[i] - errors.crowning * xi[i] * xi[i] +
                         form[static_cast<Eigen::Index>(i)]);
        Vec2 p = where + (smooth[i] + ring.probe + ring.noise * normal(draws)) * normal_there;
        p.x() *= is_right ? 1 : -1;
        p = turned_clockwise(p + Vec2(0, ring.pitch_radius()), angle);
        points.push_back({turned_clockwise(p, ring.turn) + ring.shift, 0, 0, std::nullopt, 0});
    }
    auto const [low, high] = std::minmax_element(smooth.begin(), smooth.end());
    errors.total = *high - *low;
    errors.form_range = form.size() > 0 ? form.maxCoeff() - form.minCoeff() : 0;
}

/// The file of the ring's points; enters the ranges of its flanks into @p ring.
inline PointFile points_of(MeasuredRing& ring, designs::Draws& draws)
{
    if (ring.measured.empty()) {
        ring.measured.resize(static_cast<std::size_t>(ring.teeth));
        std::iota(ring.measured.begin(), ring.measured.end(), 0);
    }
    ring.left.resize(ring.measured.size());
    ring.right.resize(ring.measured.size());
    PointFile file{"ring", {}, false};
    for (std::size_t k = 0; k < ring.measured.size(); ++k) {
        add_flank(ring, ring.measured[k], false, ring.left[k], draws, file.points);
        add_flank(ring, ring.measured[k], true, ring.right[k], draws, file.points);
    }
    for (int i = 0; i < ring.strays; ++i) {
        auto const which = static_cast<std::size_t>(draws.whole(0, static_cast<int>(file.points.size()) - 1));
        Vec2& where = file.points[which].where;
        where += draws.sign() * draws.between(0.03, 0.08) * right_of(where.normalized());
    }
    if (ring.shuffled)
        for (std::size_t i = file.points.size(); i > 1; --i)
            std::swap(file.points[i - 1],
                      file.points[static_cast<std::size_t>(draws.whole(0, static_cast<int>(i) - 1))]);
    for (std::size_t i = 0; i < file.points.size(); ++i)
        file.points[i].line = static_cast<int>(i) + 2;
    return file;
}

/// What a figure of a ring without noise may be off by [mm].
inline constexpr double exact = 1e-9;

/// A drive with the flexspline of @p ring.
inline Scene scene_of(MeasuredRing const& ring)
{
    return builtin_scene({"drive.flexspline_teeth=" + std::to_string(ring.teeth),
                          "drive.circular_spline_teeth=" + std::to_string(ring.teeth + 2),
                          "circular_spline.inner_radius=" + std::to_string(ring.pitch_radius() + 0.025),
                          "solver.threads=1"});
}

/// The points of @p ring on its nominal part.
inline Inspection inspected(MeasuredRing& ring, designs::Draws& draws, Registration registration)
{
    PointFile const file = points_of(ring, draws);
    return inspect_points(scene_of(ring), file, {InspectedPart::flexspline, std::nullopt, ring.probe, registration});
}

}  // namespace hdconj::test
