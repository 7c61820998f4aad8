// SPDX-License-Identifier: GPL-3.0-or-later
// Tooth family "double-circular-arc": convex arc, common tangent, concave arc.
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "families.hpp"

namespace hdconj::profile {
namespace {

/// Touching offset of the concave arc, or NaN where the arcs are too far apart in height.
double touching_offset(scene::FamilyChoice const& c)
{
    double const reach = c.number_or("convex_radius", 0) + c.number_or("concave_radius", 0);
    double const rise = c.number_or("concave_rise", 0) - c.number_or("convex_rise", 0);
    return std::sqrt(reach * reach - rise * rise) - c.number_or("convex_offset", 0);
}

/// The two arcs as a scene gives them: centres o1 and o2, radii r_a and r_f.
struct GivenArcs
{
    explicit GivenArcs(scene::FamilyChoice const& c)
        : h_a(c.number_or("addendum", 0)),
          h_f(c.number_or("dedendum", 0)),
          h_t(c.number_or("tip_line_from", h_a)),
          r_a(c.number_or("convex_radius", 0)),
          r_f(c.number_or("concave_radius", 0)),
          touching(touching_offset(c)),
          tangent(c.word("concave_offset").has_value()),
          o1(-c.number_or("convex_offset", 0), c.number_or("convex_rise", 0)),
          o2(tangent ? touching : c.number_or("concave_offset", 0), c.number_or("concave_rise", 0)),
          reach(r_a + r_f),
          distance(tangent ? reach : (o2 - o1).norm())
    {
    }

    [[nodiscard]] double sine_at_tip() const { return (h_t - o1.y()) / r_a; }
    [[nodiscard]] double sine_at_root() const { return (o2.y() + h_f) / r_f; }

    double h_a, h_f;
    double h_t;  ///< the straight tip line begins at this height
    double r_a, r_f;
    double touching;
    bool tangent;
    Vec2 o1, o2;
    double reach, distance;
};

/// A number typed with the digits of the touching offset may fall short of it by its own rounding.
constexpr double typed_offset = 1e-6;

/// Faults of arcs that do not reach each other, the tip or the root.
void validate_arcs(GivenArcs const& given, bool has_tip_line, scene::ParameterFaults const& refuse)
{
    auto const& [h_a, h_f, h_t, r_a, r_f, touching, tangent, o1, o2, reach, distance] = given;
    if (h_t > h_a)
        refuse("tip_line_from", "the straight tip line would start above the tip (addendum " + short_number(h_a) + ")",
               "write a height below the addendum, or leave the key out");
    if (!std::isfinite(touching))
        refuse("concave_rise",
               "the centres differ in height by more than the sum of the radii, so the arcs cannot meet",
               "write a concave_rise closer to convex_rise");
    if (std::isfinite(touching) && distance < reach * (1 - typed_offset))
        refuse("concave_offset",
               "the arcs do not meet: their centres are " + short_number(distance) + " apart, the radii add up to " +
                   short_number(reach),
               "write \"tangent\" (= " + short_number(touching) +
                   ") or a larger number, which leaves a straight line between the arcs");
    if (!(std::abs(given.sine_at_tip()) < 1))
        refuse(
            has_tip_line ? "tip_line_from" : "addendum",
            "the convex arc ends at height " + short_number(o1.y() + r_a) + " and does not reach " + short_number(h_t),
            "write a smaller height or a larger convex_radius");
    if (!(std::abs(given.sine_at_root()) < 1))
        refuse("dedendum",
               "the concave arc ends at height " + short_number(o2.y() - r_f) + " and does not reach the root at " +
                   short_number(-h_f),
               "write a smaller dedendum or a larger concave_radius");
}

/// Right flank, y from the pitch line (thesis (2-2), (2-3); Liu et al. 2025 with a convex centre off the pitch line):
///   convex arc   centre O1 = (-l_a, e_a), radius rho_a
///   straight     common inner tangent of the two circles, of length sqrt(|O1 O2|^2 - (rho_a + rho_f)^2)
///   concave arc  centre O2 = (l_f, b_f), radius rho_f, down to y = -h_f
/// and above y = h_t (if given) a straight line tangent to the convex arc up to y = h_a.
///
/// l_f = "tangent" makes the arcs touch: l_f = sqrt((rho_a + rho_f)^2 - (b_f - e_a)^2) - l_a.
/// Degenerate: arcs that do not meet are refused (the 0.0671 printed for l_f in the thesis is one of these).
Profile double_circular_arc_tooth(scene::FamilyChoice const& c, ToothPlace const& place, Faults& faults)
{
    scene::ParameterFaults const refuse(c, faults);
    GivenArcs const given(c);
    validate_arcs(given, c.has("tip_line_from"), refuse);
    if (refuse.any())
        return {};

    auto const& [h_a, h_f, h_t, r_a, r_f, touching, tangent, o1, o2, reach, distance] = given;
    double const gap = std::sqrt(std::max(0.0, distance * distance - reach * reach));
    bool const touch = tangent || gap <= reach * std::sqrt(2 * typed_offset);
    double const joint = std::atan2(o2.y() - o1.y(), o2.x() - o1.x()) + (touch ? 0.0 : std::atan2(gap, reach));
    double const tip = std::asin(given.sine_at_tip());
    double const root = std::asin(given.sine_at_root());
    if (!(tip > joint))
        refuse("convex_radius", "the convex arc ends below its joint with the concave arc, no convex flank is left",
               "write a larger addendum (or tip_line_from), or move the arcs");
    if (!(root > joint))
        refuse("concave_rise", "the concave arc ends above its joint with the convex arc, no concave flank is left",
               "write a larger dedendum, or move the arcs");
    Vec2 const n_tip = direction(tip);
    Vec2 const line_start = o1 + r_a * n_tip;
    double const rise_to_tip = h_a - h_t;
    Vec2 const tip_point = line_start - right_of(n_tip) * (rise_to_tip / n_tip.x());
    if (rise_to_tip >= 0 && !(tip_point.x() > -pointed_tip * h_a)) {
        refuse("addendum",
               "the two flanks cross below the tip: half the tip thickness would be " + short_number(tip_point.x()),
               "write a smaller addendum or move the convex arc outward (smaller convex_offset)");
    }
    if (refuse.any())
        return {};

    std::vector<FlankSegment> flank;
    if (rise_to_tip > 0)
        flank.push_back({"tip line", {LinePiece{tip_point, line_start}}});
    flank.push_back({"convex arc", {ArcPiece{o1, r_a, tip, joint}}});
    if (!touch)
        flank.push_back({"straight line", {LinePiece{o1 + r_a * direction(joint), o2 - r_f * direction(joint)}}});
    // "tangent" in typed digits: the concave arc starts where the convex one ended, so that the tooth is closed
    Vec2 const centre = touch ? Vec2(o1 + reach * direction(joint)) : o2;
    flank.push_back({"concave arc", {ArcPiece{centre, -r_f, joint, std::asin((centre.y() + h_f) / r_f)}}});
    return symmetric_tooth(flank, place, h_a, h_f);
}

}  // namespace

Family double_circular_arc()
{
    using enum scene::Quantity;
    return {{"double-circular-arc",
             "convex arc above, concave arc below, joined by their common tangent",
             {{"addendum", positive_length, "height of the tip above the pitch line, h_a"},
              {"dedendum", positive_length, "depth of the root below the pitch line, h_f"},
              {"convex_radius", positive_length, "radius of the convex arc, rho_a"},
              {"convex_offset", length, "its centre this far behind the tooth's centre line, l_a"},
              {"convex_rise", length, "its centre this far above the pitch line; default 0", false},
              {"concave_radius", positive_length, "radius of the concave arc, rho_f"},
              scene::with_words(
                  {"concave_offset", length_or_word, "its centre this far in front of the tooth's centre line, l_f"},
                  {"tangent"}),
              {"concave_rise", length, "its centre this far above the pitch line, b_f"},
              {"tip_line_from", length, "straight flank from this height to the tip, h_t; default: arc to the tip",
               false}}},
            double_circular_arc_tooth};
}

}  // namespace hdconj::profile
