// SPDX-License-Identifier: GPL-3.0-or-later
// The found neutral curve as any drive has one: a closed curve by a table, and what it does with both teeth.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "curve_rule.hpp"
#include "hdconj/motion/exact_motion.hpp"
#include "hdconj/motion/first_order_motion.hpp"
#include "hdconj/wavegen/registry.hpp"

namespace hdconj::cam {

/// A closed neutral curve through rows of half a wave, mirrored: the family "table".
class ClosedCurve
{
  public:
    /// @param displacement  rho - r_m at equal steps from the major to the minor axis [mm]
    ClosedCurve(CurveRule const& rule, int waves, std::vector<double> const& displacement);

    /// State, slope and second derivative at @p x, as the motion models have them.
    struct Place
    {
        CurveState state{};
        double slope = 0, bend = 0;
    };
    [[nodiscard]] Place operator()(double x) const;
    [[nodiscard]] double curvature(double x) const;
    /// @p points points (n,2) at equal angles of a turn on the parallel curve that is @p inside of it [mm].
    [[nodiscard]] std::vector<Vec2> outline(int points, double inside) const;
    /// Base radius r_0 and amplitude w0 of the table.
    [[nodiscard]] double r_0() const { return r_0_; }
    [[nodiscard]] double amplitude() const { return shape_.amplitude(); }

  private:
    CurveRule rule_;
    wavegen::AnyWaveShape shape_;
    wavegen::NeutralCurve<wavegen::AnyWaveShape> curve_;
    motion::FirstOrderMotion<wavegen::AnyWaveShape> linear_;
    double r_0_;
};

/// Gap of the flanks at @p u, where the tooth stands at @p at [mm], negative: they overlap; none where they do not face
/// each other.
[[nodiscard]] std::optional<double> gap_at(FlankPair const& pair, CurveRule const& rule, double u,
                                           ClosedCurve::Place const& at);

/// Angles and displacements of a whole wave, from those of its half.
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>> whole_wave(std::vector<double> const& half,
                                                                             int waves);

}  // namespace hdconj::cam
