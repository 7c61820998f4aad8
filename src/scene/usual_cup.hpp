// SPDX-License-Identifier: GPL-3.0-or-later
// What dimensions cup and bearing of a drive usually have, for remedies that say what to write.
#pragma once

#include <string>

#include "hdconj/scene.hpp"

namespace hdconj::scene {

/// Dimensions of a cup and its bearing that fit each other and the rest of a scene: the shares that type-50 has of the
/// pitch diameter, of the wall under the teeth and of the face width. What the scene gives stays. [mm]
struct UsualCup
{
    explicit UsualCup(Scene const& scene);

    double spline_width = 0;  ///< face width of the circular spline
    Cup cup;
    double bearing_width = 0, ring_thickness = 0;
    double bottom_to_middle = 0;  ///< of the teeth, and of the bearing
    double outer_radius = 0;      ///< of the circular spline's body

    /// "write the line [flexspline.cup] and below it length = 15.0, ..."
    [[nodiscard]] std::string advice_on_cup() const;
    /// "write the line [bearing] and below it type = "elastic", ..."
    [[nodiscard]] std::string advice_on_bearing() const;
};

/// A length to three digits, with a decimal point: "15.0".
[[nodiscard]] std::string length_text(double length);

}  // namespace hdconj::scene
