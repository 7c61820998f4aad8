// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far rounding may have moved the ends of conjugate zones.
#pragma once

#include <algorithm>
#include <cmath>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/envelope/any_envelope.hpp"

namespace hdconj::conjugate {

/// What makes a zone end where it does.
enum class ZoneEnd
{
    contact,   ///< f = 0 at the end of the segment, or f = df/dt = 0 where contacts merge; either way u solves f = 0
               ///< with the point held
    cusp,      ///< Contact::bound = 0
    reversal,  ///< Contact::turning = 0
    exact      ///< the lobe's end
};

[[nodiscard]] inline ZoneEnd zone_end(envelope::BranchEnd end)
{
    switch (end) {
        case envelope::BranchEnd::cusp:
            return ZoneEnd::cusp;
        case envelope::BranchEnd::range_end:
            return ZoneEnd::exact;
        case envelope::BranchEnd::segment_end:
        case envelope::BranchEnd::double_root:
        case envelope::BranchEnd::continues:
            break;
    }
    return ZoneEnd::contact;
}

/// Error of the angle @p u at which a zone on @p arc ends: the rounding of the function that vanishes there over its
/// slope, and no more than the arc is long. For f at a point held on the profile the slope is df/du = Contact::turning;
/// the others' is taken by differences within the arc. Accuracy: first order in the rounding, sizes of terms as in
/// Contact; roundings are counted generously.
/// @returns [parameter of the motion]
[[nodiscard]] inline double zone_angle_error(envelope::AnyEnvelope const& envelope, envelope::ContactArc const& arc,
                                             double u, ZoneEnd end)
{
    constexpr double roundings = 16;
    double const length = arc.u_end - arc.u_begin;
    double const least = 2 * unit_roundoff * std::abs(u);
    double noise = 0, slope = 1;
    if (end == ZoneEnd::contact) {
        motion::MotionRates const rates = envelope.motion().rates(u);
        bool const at_begin = std::abs(u - arc.u_begin) < std::abs(u - arc.u_end);
        double const t = at_begin ? arc.t_begin : arc.t_end;
        profile::PieceShape const& shape = envelope.profile().pieces[static_cast<std::size_t>(arc.piece)].shape;
        Vec2 x, n;
        if (t == 0 || t == 1) {
            profile::PieceEnd const held = t == 0 ? profile::start_of(shape) : profile::end_of(shape);
            x = held.point;
            n = held.normal;
        } else {
            envelope::Contact const c = envelope.contact(arc, u);
            x = c.x - envelope.offset() * c.n;
            n = c.n;
        }
        noise = rates.velocity_size(x);
        slope = std::abs(n.dot(rates.change(x)));
    } else if (end == ZoneEnd::cusp || end == ZoneEnd::reversal) {
        auto const value = end == ZoneEnd::cusp ? &envelope::Contact::bound : &envelope::Contact::turning;
        auto const size = end == ZoneEnd::cusp ? &envelope::Contact::bound_size : &envelope::Contact::turning_size;
        double const h = length * 0x1p-12;
        double const low = std::max(arc.u_begin, u - h), high = std::min(arc.u_end, u + h);
        noise = envelope.contact(arc, u).*size;
        slope = std::abs(envelope.contact(arc, high).*value - envelope.contact(arc, low).*value) / (high - low);
    }
    double const error = roundings * unit_roundoff * noise / slope;
    return error < length ? error + least : length;
}

/// Error of the segment's parameter t of the contact on @p arc at @p u, which is uncertain by @p angle: rounding at a
/// given u, and how far t runs meanwhile. None where the zone ends with the segment.
[[nodiscard]] inline double zone_t_error(envelope::AnyEnvelope const& envelope, envelope::ContactArc const& arc,
                                         double u, double angle)
{
    double const known = u == arc.u_begin ? arc.t_begin : u == arc.u_end ? arc.t_end : -1;
    if (known == 0 || known == 1 || arc.resting)
        return 0;
    profile::PieceShape const& shape = envelope.profile().pieces[static_cast<std::size_t>(arc.piece)].shape;
    double const inward = u - arc.u_begin < arc.u_end - u ? 1 : -1;
    double const h = (arc.u_end - arc.u_begin) * 0x1p-12;
    envelope::Contact const here = envelope.contact(arc, u), there = envelope.contact(arc, u + inward * h);
    constexpr double roundings = 8;
    double along = 0;
    if (auto const* circle = std::get_if<profile::ArcPiece>(&shape)) {
        // corners too, whose cone of normals t counts
        motion::MotionRates const rates = envelope.motion().rates(u);
        along = rates.velocity_size(circle->centre) /
                (rates.twist(circle->centre).norm() * std::abs(circle->to - circle->from));
    } else {
        along = std::min(here.rounding, there.rounding) /
                (profile::start_of(shape).point - profile::end_of(shape).point).norm();
    }
    double const error = roundings * unit_roundoff * along + std::abs(there.t - here.t) / h * angle + unit_roundoff;
    return error < 1 ? error : 1;
}

}  // namespace hdconj::conjugate
