// SPDX-License-Identifier: GPL-3.0-or-later
#include "section_checks.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "hdconj/error.hpp"

namespace hdconj::elastic {

void require(bool good, std::string const& what, std::string const& cause)
{
    if (!good)
        throw NumericalError(ErrorCode::unsuitable_body, "elastic cup", what, cause);
}

std::string mm(double length)
{
    return short_number(length) + " mm";
}

void require_sound(Elasticity const& material)
{
    require(material.youngs_modulus > 0 && std::isfinite(material.youngs_modulus), "Young's modulus",
            "must be positive and finite");
    require(material.poissons_ratio >= 0 && material.poissons_ratio < 0.5, "Poisson's ratio",
            "must be from 0 to below 0.5: at 0.5 the material keeps its volume, which these elements cannot express");
}

void require_sound(MeshSize const& size)
{
    require(size.along > 0 && size.across > 0, "mesh", "element sizes must be positive");
}

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

}  // namespace

UnsoundSection::UnsoundSection(SectionPart part, std::string const& cause)
    : NumericalError(ErrorCode::unsuitable_body, "elastic cup", name_of(part), cause), part_(part)
{
}

double rear_length(CupSection const& cup)
{
    return change_length(cup.rear_ramp, cup.rear_fillet, cup.wall, cup.ring_wall);
}

double front_length(CupSection const& cup)
{
    return change_length(cup.front_ramp, cup.front_fillet, cup.wall, cup.ring_wall);
}

void require_sound(CupSection const& cup)
{
    using Part = SectionPart;
    auto const require = [](bool good, SectionPart part, std::string const& cause) {
        if (!good)
            throw UnsoundSection(part, cause);
    };
    for (double const fillet : {cup.rear_fillet, cup.front_fillet}) {
        require(fillet >= 0, Part::fillet, "its radius must not be negative");
        require(fillet == 0 || cup.ring_wall >= cup.wall, Part::fillet,
                "the ring is thinner than the wall beside it: there is nothing to round");
        require(fillet == 0 || fillet >= cup.ring_wall - cup.wall, Part::fillet,
                "its radius " + mm(fillet) + " is less than the wall grows by, " + mm(cup.ring_wall - cup.wall));
    }
    require(cup.wall > 0 && cup.ring_wall > 0 && cup.bottom > 0, Part::walls, "must be thicker than 0");
    require(cup.clamp_radius > 0, Part::flange, "must have a radius above 0");
    require(cup.rear_ramp >= 0 && cup.front_ramp >= 0, Part::ramps, "must not be negative");
    require(cup.corner_radius > std::max(cup.wall, cup.bottom), Part::corner,
            "its outer radius " + mm(cup.corner_radius) + " must be larger than the walls that meet there, " +
                mm(cup.wall) + " and " + mm(cup.bottom));
    double const fillet = cup.inner_radius + cup.wall - cup.corner_radius;
    require(cup.clamp_radius < fillet, Part::flange,
            "its radius " + mm(cup.clamp_radius) + " reaches the corner fillet, which begins at " + mm(fillet));
    require(cup.ring_begin - rear_length(cup) > cup.corner_radius, Part::tooth_ring,
            "its rear ramp begins at " + mm(cup.ring_begin - rear_length(cup)) + ", inside the corner fillet of " +
                mm(cup.corner_radius));
    require(cup.tooth_layer >= 0 && std::isfinite(cup.tooth_layer), Part::tooth_layer,
            "must not be of negative height");
    require(cup.tooth_share > 0 && cup.tooth_share <= 1, Part::tooth_layer,
            "the fraction of it that is steel must be above 0 and at most 1");
    require(cup.ring_end > cup.ring_begin, Part::tooth_ring, "must end in front of where it begins");
    require(cup.length >= cup.ring_end, Part::tooth_ring,
            "ends at " + mm(cup.ring_end) + ", beyond the cup's length of " + mm(cup.length));
    bool const has_step = cup.wall != cup.ring_wall;
    require(!has_step || rear_length(cup) > 0, Part::rear_ramp, "must be longer than 0 where the wall changes");
    require(!has_step || cup.length == cup.ring_end || front_length(cup) > 0, Part::front_ramp,
            "must be longer than 0 where the wall changes");
    require(cup.length == cup.ring_end || cup.length >= cup.ring_end + front_length(cup), Part::front_ramp,
            "ends at " + mm(cup.ring_end + front_length(cup)) + ", beyond the cup's length of " + mm(cup.length));
}

}  // namespace hdconj::elastic
