// SPDX-License-Identifier: GPL-3.0-or-later
// The range of a drawing whose axes have the same scale.
#pragma once

#include <Eigen/Geometry>

#include "plot.hpp"

namespace hdconj::report {

/// Range in mm; empty until it takes a point.
class PlotWindow
{
  public:
    void take(Vec2 const& at) { box_.extend(at); }
    void take(std::vector<Vec2> const& points)
    {
        for (auto const& point : points)
            take(point);
    }
    void widen(double x, double y)
    {
        box_.min() -= Vec2(x, y);
        box_.max() += Vec2(x, y);
    }
    [[nodiscard]] double width() const { return box_.sizes().x(); }
    [[nodiscard]] double height() const { return box_.sizes().y(); }
    [[nodiscard]] Vec2 low() const { return box_.min(); }
    [[nodiscard]] Vec2 high() const { return box_.max(); }
    [[nodiscard]] Vec2 middle() const { return box_.center(); }

    /// Length of a pixel across the usual axes [mm].
    [[nodiscard]] double pixel() const
    {
        constexpr double axes_width = 875;  // right_edge - left_edge in common.gp
        return width() / axes_width;
    }
    void set_in(PlotData& data) const
    {
        data.set("x_low", low().x());
        data.set("x_high", high().x());
        data.set("y_low", low().y());
        data.set("y_high", high().y());
    }

  private:
    Eigen::AlignedBox2d box_;
};

}  // namespace hdconj::report
