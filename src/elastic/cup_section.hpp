// SPDX-License-Identifier: GPL-3.0-or-later
// The meridian section of a cup: its dimensions, and what they ask of each other.
#pragma once

#include <string>

#include "elasticity.hpp"
#include "hdconj/error.hpp"

namespace hdconj::elastic {

/// Meridian section of the cup, lengths in mm, z from the outer face of the bottom towards the open end.
///
///     z = length      _
///                    | |   front land, `wall`
///     ring_end        \ \  ramp on the outside, `front_ramp` long
///                    |   | tooth ring, `ring_wall` (to the root of the teeth)
///     ring_begin      / /  ramp on the outside, `rear_ramp` long
///                    | |   barrel, `wall`
///     corner_radius  / /   outer fillet of `corner_radius`; the wall changes evenly into the bottom
///     z = 0   =======      bottom, clamped at `clamp_radius`
///
/// The inner surface of barrel, ring and land is one cylinder of `inner_radius`. A fillet of radius R between the walls
/// t and T is an arc, tangent to the thinner wall, in place of the ramp; it spans sqrt((T - t)(2 R - T + t)). Defaults:
/// the case that docs/explanation/elastic-cup.md checks against CalculiX.
struct CupSection
{
    double inner_radius = 24;
    double length = 15;
    double wall = 0.4;
    double ring_wall = 0.7;
    double ring_begin = 5;
    double ring_end = 13;
    double rear_ramp = 0.4;
    double front_ramp = 0.4;
    double rear_fillet = 0;  ///< radius of the arc behind the ring; 0: a straight ramp
    double front_fillet = 0;
    double tooth_layer = 0;    ///< height of the teeth as a layer on the ring (tooth_stress_matrix()); 0: none
    double tooth_share = 0.5;  ///< of it that is steel
    double bottom = 0.5;
    double corner_radius = 2;
    double clamp_radius = 13;
    Elasticity material;
};

/// Parts of the section whose dimensions may contradict each other.
enum class SectionPart
{
    walls,
    fillet,  ///< at the tooth ring
    flange,
    corner,  ///< at the bottom
    ramps,
    rear_ramp,
    front_ramp,
    tooth_ring,
    tooth_layer
};

/// A section whose dimensions contradict each other.
class UnsoundSection : public NumericalError
{
  public:
    UnsoundSection(SectionPart part, std::string const& cause);

    [[nodiscard]] SectionPart part() const { return part_; }  ///< whose dimensions are wrong

  private:
    SectionPart part_;
};

/// Where the section changes [mm].
struct SectionPlaces
{
    double fillet;  ///< radius at which the bottom ends and the corner begins
    double rear;    ///< height at which the wall behind the tooth ring begins to change
    double front;   ///< height at which the wall in front of it has ended to change
};

/// The places that follow from the dimensions. @throws UnsoundSection where these contradict each other
[[nodiscard]] SectionPlaces section_places(CupSection const& cup);

}  // namespace hdconj::elastic
