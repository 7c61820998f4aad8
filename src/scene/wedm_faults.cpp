// SPDX-License-Identifier: GPL-3.0-or-later
// The wire of [wedm].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/text.hpp"
#include "usual_wire.hpp"
#include "validation.hpp"

namespace hdconj::scene {
namespace {

/// What the keys of [wedm] say to each other. What they say to the drive is checked where a wire is asked for
/// (check_wedm), so that a drive of another size can be solved without a word about its wire.
void check_wire(SceneReading const& reading, Faults& faults)
{
    WireRequest const& wedm = *reading.scene.wedm;
    constexpr double steps_per_mm = 1000;  // in which a hole is told
    bool const whole = knows(reading, {"wedm.wire_diameter", "wedm.spark_gap"});
    if (whole && wedm.spark_gap > wedm.wire_diameter)
        add_at(faults, "wedm.spark_gap", number_text(wedm.spark_gap), "a gap wider than the wire is no spark gap",
               "write the gap in mm, such as " + std::string(usual_spark_gap));
    std::string const rounding = rounding_fault(wedm.decimals, wedm.tolerance);
    if (knows(reading, {"wedm.tolerance", "wedm.decimals"}) && !rounding.empty()) {
        bool const told = reading.scene.given.contains("wedm.decimals");
        add_at(faults, told ? "wedm.decimals" : "wedm.tolerance",
               told ? std::to_string(wedm.decimals) : number_text(wedm.tolerance), rounding,
               "write more decimals or a larger tolerance");
    }
    double const reach = wedm.wire_diameter / 2 + wedm.spark_gap;
    if (whole && knows(reading, {"wedm.start_hole_radius"}) && wedm.start_hole_radius <= reach) {
        bool const told = reading.scene.given.contains("wedm.start_hole_radius");
        add_at(faults, told ? "wedm.start_hole_radius" : "wedm.wire_diameter",
               number_text(told ? wedm.start_hole_radius : wedm.wire_diameter),
               "wire and gap do not go through a start hole of radius " + number_text(wedm.start_hole_radius) + " mm",
               "write a start_hole_radius above " + short_number(reach));
    }
    double const stock = wedm.stock.empty() ? 0 : wedm.stock.front();
    double const least = wedm.start_hole_radius + reach + stock;
    if (whole && knows(reading, {"wedm.start_hole_radius", "wedm.lead_in"}) && wedm.lead_in <= least) {
        bool const told = reading.scene.given.contains("wedm.lead_in");
        // a lead-in that reaches beyond the axis of the bore is refused too
        bool const fits = wedm.part == WirePart::flexspline || !knows(reading, {"drive.module"}) ||
                          least < 0.5 * reading.scene.drive.module * reading.scene.drive.flexspline_teeth;
        std::string const hole = short_number(std::floor(steps_per_mm * (wedm.lead_in - reach - stock)) / steps_per_mm);
        add_at(faults, told ? "wedm.lead_in" : "wedm.start_hole_radius",
               number_text(told ? wedm.lead_in : wedm.start_hole_radius),
               "the start hole would reach into the cut along the part: its centre is " + number_text(wedm.lead_in) +
                   " mm from the tip land, its radius " + number_text(wedm.start_hole_radius) + " mm",
               fits ? "write a lead_in above " + short_number(least) + ", or a smaller hole"
                    : "write a start_hole_radius below " + hole);
    }
}

void check_passes(SceneReading const& reading, Faults& faults)
{
    auto const& stock = reading.scene.wedm->stock;
    if (!knows(reading, {"wedm.passes"}) || stock.empty())
        return;
    bool const falls = std::adjacent_find(stock.begin(), stock.end(), std::less_equal<>()) == stock.end();
    if (!falls || stock.back() != 0)
        add_at(faults, "wedm.passes", "",
               falls ? "the last pass leaves " + number_text(stock.back()) + " mm on the part"
                     : "a pass that leaves no less than the one before cuts nothing",
               "write decreasing lengths that end with 0, such as passes = [0.02, 0.005, 0]");
}

}  // namespace

std::string rounding_fault(int decimals, double tolerance)
{
    double const rounding = std::numbers::sqrt2 / 2 * std::pow(10.0, -decimals);
    return rounding <= tolerance
               ? ""
               : fmt::format(
                     "rounding to {} decimals moves a point by up to {:.6g} mm, more than the tolerance of {:.6g} mm",
                     decimals, rounding, tolerance);
}

void add_wedm_faults(SceneReading const& reading, Faults& faults)
{
    check_wire(reading, faults);
    check_passes(reading, faults);
}

}  // namespace hdconj::scene
