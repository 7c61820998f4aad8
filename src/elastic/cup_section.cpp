// SPDX-License-Identifier: GPL-3.0-or-later
#include "cup_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hdconj::elastic {
namespace {

/// Length of a change of the wall: a ramp, or an arc of radius @p fillet.
double change_length(double ramp, double fillet, double thin, double thick)
{
    return fillet > 0 ? std::sqrt(std::max(0.0, (thick - thin) * (2 * fillet - thick + thin))) : ramp;
}

std::string name_of(SectionPart part)
{
    switch (part) {
        case SectionPart::walls:
            return "walls";
        case SectionPart::fillet:
            return "fillet at the tooth ring";
        case SectionPart::flange:
            return "flange";
        case SectionPart::corner:
            return "corner at the bottom";
        case SectionPart::ramps:
            return "ramps";
        case SectionPart::rear_ramp:
            return "rear ramp";
        case SectionPart::front_ramp:
            return "front ramp";
        case SectionPart::tooth_ring:
            return "tooth ring";
        case SectionPart::tooth_layer:
            return "layer of teeth";
    }
    return {};
}

/// @param cause  with a place for each of @p lengths
template <class... Lengths>
void require(bool good, SectionPart part, fmt::format_string<Lengths const&...> cause, Lengths const&... lengths)
{
    if (!good)
        throw UnsoundSection(part, fmt::format(cause, lengths...));
}

void require_sound_fillet(double radius, double step)
{
    using enum SectionPart;
    require(radius >= 0, fillet, "its radius must not be negative");
    require(radius == 0 || step >= 0, fillet, "the ring is thinner than the wall beside it: there is nothing to round");
    require(radius == 0 || radius >= step, fillet, "its radius {:g} mm is less than the wall grows by, {:g} mm", radius,
            step);
}

}  // namespace

UnsoundSection::UnsoundSection(SectionPart part, std::string const& cause)
    : NumericalError(ErrorCode::unsuitable_body, "elastic cup", name_of(part), cause), part_(part)
{
}

SectionPlaces section_places(CupSection const& cup)
{
    using enum SectionPart;
    double const behind = change_length(cup.rear_ramp, cup.rear_fillet, cup.wall, cup.ring_wall),
                 ahead = change_length(cup.front_ramp, cup.front_fillet, cup.wall, cup.ring_wall);
    SectionPlaces const at{cup.inner_radius + cup.wall - cup.corner_radius, cup.ring_begin - behind,
                           cup.ring_end + ahead};
    require_sound_fillet(cup.rear_fillet, cup.ring_wall - cup.wall);
    require_sound_fillet(cup.front_fillet, cup.ring_wall - cup.wall);
    require(cup.wall > 0 && cup.ring_wall > 0 && cup.bottom > 0, walls, "must be thicker than 0");
    require(cup.clamp_radius > 0, flange, "must have a radius above 0");
    require(cup.rear_ramp >= 0 && cup.front_ramp >= 0, ramps, "must not be negative");
    require(cup.corner_radius > std::max(cup.wall, cup.bottom), corner,
            "its outer radius {:g} mm must be larger than the walls that meet there, {:g} mm and {:g} mm",
            cup.corner_radius, cup.wall, cup.bottom);
    require(cup.clamp_radius < at.fillet, flange,
            "its radius {:g} mm reaches the corner fillet, which begins at {:g} mm", cup.clamp_radius, at.fillet);
    require(at.rear > cup.corner_radius, tooth_ring,
            "its rear ramp begins at {:g} mm, inside the corner fillet of {:g} mm", at.rear, cup.corner_radius);
    require(cup.tooth_layer >= 0 && std::isfinite(cup.tooth_layer), tooth_layer, "must not be of negative height");
    require(cup.tooth_share > 0 && cup.tooth_share <= 1, tooth_layer,
            "the fraction of it that is steel must be above 0 and at most 1");
    require(cup.ring_end > cup.ring_begin, tooth_ring, "must end in front of where it begins");
    require(cup.length >= cup.ring_end, tooth_ring, "ends at {:g} mm, beyond the cup's length of {:g} mm", cup.ring_end,
            cup.length);
    bool const has_step = cup.wall != cup.ring_wall, has_land = cup.length != cup.ring_end;
    require(!has_step || behind > 0, rear_ramp, "must be longer than 0 where the wall changes");
    require(!has_step || !has_land || ahead > 0, front_ramp, "must be longer than 0 where the wall changes");
    require(!has_land || cup.length >= at.front, front_ramp, "ends at {:g} mm, beyond the cup's length of {:g} mm",
            at.front, cup.length);
    return at;
}

}  // namespace hdconj::elastic
