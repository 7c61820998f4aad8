// SPDX-License-Identifier: GPL-3.0-or-later
#include "march.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <limits>

namespace hdconj::cam {
namespace {

namespace odeint = boost::numeric::odeint;

/// The flanks do not touch where a step would go.
struct Parted
{
};

/// The tangencies that are followed, and the rate of the curve by the first of them.
class ContactFollower
{
  public:
    ContactFollower(FlankPair const& pair, CurveRule const& rule) : pair_(pair), rule_(rule) {}

    /// Looks for all tangencies at a point of the curve, beside those that are followed.
    void look_again(double x, CurveState const& state, double theta)
    {
        ToothOrigin const origin = rule_.origin(x, state);
        std::vector<Tangency> found = pair_.tangencies(origin, theta);
        for (Tangency const& known : followed_)
            if (auto const again = pair_.refined(known, origin))
                found.push_back(*again);
        double const same = 1e-3 * pair_.inner().length();
        followed_.clear();
        for (Tangency const& each : found) {
            bool const is_new = std::none_of(followed_.begin(), followed_.end(), [&](Tangency const& other) {
                return std::abs(pair_.inner().from_tip(other.inner) - pair_.inner().from_tip(each.inner)) < same;
            });
            if (is_new)
                followed_.push_back(each);
        }
    }

    /// The tangency that the tooth meets first. @throws Parted where there is none
    [[nodiscard]] Tangency first(ToothOrigin const& origin) const
    {
        Tangency best;
        best.theta = std::numeric_limits<double>::infinity();
        for (Tangency const& seed : followed_)
            if (auto const found = pair_.refined(seed, origin); found && found->theta < best.theta)
                best = *found;
        if (best.theta == std::numeric_limits<double>::infinity())
            throw Parted();
        return best;
    }

    void operator()(CurveState const& state, CurveState& rate, double x) const
    {
        ToothOrigin const origin = rule_.origin(x, state);
        double const slope = rule_.slope(origin, first(origin).theta);
        rate = {slope, rule_.tangential_rate(state[0], slope)};
    }

    [[nodiscard]] CurvePoint point(double x, CurveState const& state) const
    {
        ToothOrigin const origin = rule_.origin(x, state);
        Tangency const contact = first(origin);
        return {x, state, rule_.slope(origin, contact.theta), contact};
    }

  private:
    FlankPair const& pair_;
    CurveRule rule_;
    std::vector<Tangency> followed_;
};

}  // namespace

MarchedCurve march(FlankPair const& pair, CurveRule const& rule, CurvePoint const& begin,
                   std::vector<double> const& angles, double tolerance)
{
    constexpr double shortest = 0x1p-40;  // rad
    constexpr double first_step = 1e-3;   // rad
    auto stepper = odeint::make_controlled<odeint::runge_kutta_fehlberg78<CurveState>>(tolerance, 0.0);
    ContactFollower follower(pair, rule);
    MarchedCurve result;
    double x = begin.x, step = first_step;
    CurveState state = begin.state;
    try {
        follower.look_again(x, state, begin.contact.theta);
        result.last = follower.point(x, state);
        for (double const angle : angles) {
            while (x < angle) {
                double const rest = angle - x;
                double trial = std::min(step, rest);
                bool const whole = trial == rest;
                double const before = x;
                CurveState next = state;
                try {
                    auto const system = [&](CurveState const& y, CurveState& dydx, double at) {
                        follower(y, dydx, at);
                    };
                    if (stepper.try_step(system, next, x, trial) == odeint::fail) {
                        step = trial;
                        continue;
                    }
                    CurvePoint const reached = follower.point(whole ? angle : x, next);
                    x = reached.x;
                    state = next;
                    result.last = reached;
                    step = whole ? std::max(step, trial) : trial;
                    follower.look_again(x, state, reached.contact.theta);
                } catch (Parted const&) {
                    x = before;
                    step = std::min(step, rest) / 2;
                    if (step < shortest)
                        throw;
                }
            }
            result.points.push_back(follower.point(angle, state));
        }
    } catch (Parted const&) {
        result.lost = true;
        result.end_error = shortest * 2;
    }
    return result;
}

}  // namespace hdconj::cam
