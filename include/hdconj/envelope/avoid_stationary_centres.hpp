// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs whose centre comes to rest: the one instant at which a whole arc touches its envelope.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "hdconj/envelope/smooth_ranges.hpp"
#include "hdconj/error.hpp"
#include "hdconj/numeric/all_roots.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::envelope {

/// An arc's centre at rest, to roundoff.
struct CentreAtRest
{
    double u = 0;
    double turning = 0;   ///< theta' there
    double rounding = 0;  ///< what the speed is uncertain by [mm per unit of the parameter]
};

/// Where the centre of @p arc has no speed that double precision could tell from 0: the minima of |V|, from V . V' = 0.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::optional<CentreAtRest> centre_at_rest(profile::ArcPiece const& arc, Motion const& motion)
{
    for (SmoothRange const& range : smooth_ranges(motion)) {
        double scale = 0;
        auto const approach = [&](double u) {
            motion::MotionRates const rates = motion.rates(u);
            scale = std::max(scale, rates.velocity_size(arc.centre) * rates.velocity_change_size(arc.centre));
            return rates.twist(arc.centre).dot(rates.change(arc.centre));
        };
        (void)approach(range.a);
        (void)approach(range.b);
        for (numeric::IsolatedRoot const& slowest : numeric::all_roots(approach, range.a, range.b, scale).roots) {
            motion::MotionRates const rates = motion.rates(slowest.x);
            constexpr double roundings = 16;
            double const rounding = roundings * unit_roundoff * rates.velocity_size(arc.centre);
            if (rates.twist(arc.centre).norm() <= rounding)
                return CentreAtRest{slowest.x, rates.twist.omega, rounding};
        }
    }
    return {};
}

/// @p tooth, shifted minimally so that no arc centre is stationary.
///
/// When V = 0, the meshing condition n.V = 0 of an arc holds for all of it at one instant, so the contact runs along
/// the arc in no time. The circular spline is the limit of teeth that are a little higher or lower, where it runs in a
/// short time. Such a tooth is solved: it is shifted by some roundings of r_m divided by theta', 4e-11 mm and less on
/// type-50. A tooth without such an arc is returned bit for bit.
/// @throws NumericalError where the tooth does not turn at that instant, so that a shift changes nothing
template <motion::RelativeMotion Motion>
[[nodiscard]] profile::Profile avoid_stationary_centres(profile::Profile tooth, Motion const& motion)
{
    constexpr int attempts = 8;
    profile::Profile raised = tooth;
    double rise = 0;
    for (int attempt = 0; attempt <= attempts; ++attempt) {
        std::optional<CentreAtRest> rest;
        std::size_t which = 0;
        // of a symmetric pair an arc rests where its image does
        std::size_t const enough =
            raised.mirror_symmetric && motion.symmetric() ? (raised.pieces.size() + 1) / 2 : raised.pieces.size();
        for (std::size_t i = 0; i < enough && !rest; ++i) {
            auto const* arc = std::get_if<profile::ArcPiece>(&raised.pieces[i].shape);
            if (arc != nullptr && !raised.pieces[i].corner)
                rest = centre_at_rest(*arc, motion);
            which = i;
        }
        if (!rest)
            return attempt == 0 ? std::move(tooth) : std::move(raised);
        constexpr double clear = 4;
        constexpr double negligible = 0x1p-26;
        rise += clear * rest->rounding / std::abs(rest->turning);
        if (attempt == attempts || !(rise <= negligible * (tooth.addendum + tooth.dedendum)))
            throw NumericalError(
                ErrorCode::no_solution, "envelope",
                "profile piece " + std::to_string(which) + " at " + std::to_string(rest->u) + " rad",
                "the arc's centre stands still while the tooth does not turn: the whole arc touches at once");
        raised = profile::moved_up(tooth, rise);
    }
    return raised;
}

}  // namespace hdconj::envelope
