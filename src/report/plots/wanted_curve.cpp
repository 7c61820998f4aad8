// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "figures/number_text.hpp"
#include "hdconj/units.hpp"
#include "hdconj/wanted_curve.hpp"
#include "plot.hpp"
#include "plots.hpp"

namespace hdconj::report {
namespace {

constexpr double mm_per_m = 1000;

/// Angle in degrees, displacement in um, curvature per m, error in um.
PlotColumns curve_rows(WantedCurve const& found, bool touching)
{
    constexpr double not_drawn = std::numeric_limits<double>::quiet_NaN();
    PlotColumns columns;
    for (WantedCurveRow const& row : found.rows) {
        bool const shown = !touching || row.touching;
        columns.row(to_deg(row.u), shown ? row.displacement * per_um : not_drawn,
                    shown ? row.curvature * mm_per_m : not_drawn,
                    shown && row.error > 0 ? row.error * per_um : not_drawn);
    }
    return columns;
}

}  // namespace

std::string wanted_curve_script(WantedCurve const& found)
{
    PlotData data(found.scene.drive.name + ":  neutral curve on which both given teeth touch");
    data.set("curve", curve_rows(found, false));
    data.set("mesh", curve_rows(found, true));
    data.set("half_wave", 180.0 / found.scene.wave_generator.waves);
    data.set("touch_begin", to_deg(found.touch_begin));
    data.set("touch_end", to_deg(found.touch_end));
    data.set("ring", mm_per_m / found.geometry.r_m);
    data.set("words", fmt::format("flanks touch from {} to {} deg;  bending stress {} MPa",
                                  figures::fixed<2>(to_deg(found.touch_begin)),
                                  figures::fixed<2>(to_deg(found.touch_end)), figures::fixed<1>(found.bending_stress)));
    return plot_script("wanted_curve", data);
}

}  // namespace hdconj::report
