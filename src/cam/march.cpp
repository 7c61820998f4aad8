// SPDX-License-Identifier: GPL-3.0-or-later
#include "march.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <functional>
#include <limits>

#include "hdconj/base/stop.hpp"

namespace hdconj::cam {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double first_step = 0x1p-10;     // rad
constexpr double same_place = 0x1p-10;     // of a flank: tangencies this near are one
constexpr double shortest_step = 0x1p-40;  // rad, of the place where flanks part
constexpr double finest_step = 0x1p-17;    // rad, for the sake of the error

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
        double const same = same_place * pair_.inner().length();
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

    [[nodiscard]] MeshPoint point(double x, CurveState const& state) const
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

/// Steps of a length that holds the local error. It is estimated by two steps of half the length: the embedded estimate
/// of Fehlberg's pair vanishes where the rate depends on the angle alone, and does not see the breaks of a cam.
class Stepper
{
  public:
    Stepper(ContactFollower const& follower, double tolerance) : follower_(follower), tolerance_(tolerance) {}

    /// The curve one step farther than @p from, and not beyond @p limit. @throws Parted where the flanks part before
    [[nodiscard]] MeshPoint next(MeshPoint const& from, double limit)
    {
        constexpr double order = 8, safety = 0.9, least = 0.2, most = 4;
        for (;;) {
            end_if_stopped();
            double const rest = limit - from.x;
            double const step = std::min(step_, rest);
            try {
                CurveState const whole = after(from.state, from.x, step);
                CurveState const state = after(after(from.state, from.x, step / 2), from.x + step / 2, step / 2);
                MeshPoint const reached = follower_.point(step == rest ? limit : from.x + step, state);
                double const miss = std::max(std::abs(state[0] - whole[0]), std::abs(state[1] - whole[1]));
                double const factor = std::clamp(safety * std::pow(tolerance_ / miss, 1 / order), least, most);
                // a step that is cut at the limit says nothing of longer ones
                step_ = miss > tolerance_ ? step * factor : std::max(step == rest ? step_ : 0.0, step * factor);
                // below that length the estimate is rounding
                if (!(miss > tolerance_) || step <= finest_step)
                    return reached;
            } catch (Parted const&) {
                step_ = step / 2;
            }
            if (step_ < shortest_step)
                throw Parted();
        }
    }

  private:
    [[nodiscard]] CurveState after(CurveState const& state, double x, double step)
    {
        CurveState result;
        rule_.do_step(std::cref(follower_), state, x, result, step);
        return result;
    }

    ContactFollower const& follower_;
    double tolerance_;
    double step_ = first_step;
    odeint::runge_kutta_fehlberg78<CurveState> rule_;
};

}  // namespace

MarchedCurve march(FlankPair const& pair, CurveRule const& rule, MeshPoint const& begin,
                   std::vector<double> const& angles, double tolerance)
{
    ContactFollower follower(pair, rule);
    Stepper stepper(follower, tolerance);
    MarchedCurve result;
    try {
        follower.look_again(begin.x, begin.state, begin.contact.theta);
        result.last = follower.point(begin.x, begin.state);
        for (double const angle : angles) {
            while (result.last.x < angle) {
                result.last = stepper.next(result.last, angle);
                follower.look_again(result.last.x, result.last.state, result.last.contact.theta);
            }
            result.points.push_back(result.last);
        }
    } catch (Parted const&) {
        result.lost = true;
        result.end_error = 2 * shortest_step;
    }
    return result;
}

}  // namespace hdconj::cam
