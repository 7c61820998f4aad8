// SPDX-License-Identifier: GPL-3.0-or-later
// The motion models by a path of their own, in any number type: vectors in place of angles; private to src/accuracy.
#pragma once

#include <utility>

#include "reference_integral.hpp"
#include "reference_neutral_curve.hpp"

namespace hdconj::accuracy {

/// Where a frame is in another one, and how fast it moves, per unit of the motion's parameter.
template <class T>
struct MovingFrame
{
    Pair<T> origin, along, outward;
    Pair<T> origin_rate, along_rate, outward_rate;

    Pair<T> point(Pair<T> const& x) const { return origin + x.x * along + x.y * outward; }
    Pair<T> velocity(Pair<T> const& x) const { return origin_rate + x.x * along_rate + x.y * outward_rate; }
    Pair<T> turned(Pair<T> const& n) const { return n.x * along + n.y * outward; }
};

/// Tooth frame on the deformed ring, in the circular spline's frame.
///
/// Not the program's path: everything is made in the frame of the held wave generator, by the product rule on vectors,
/// and then turned against the circular spline; the program uses formulas for theta' and q. "exact": the frame is built
/// of P'/|P'| and P'', no angle of it is ever taken, and the undeformed angle is the speed integrated by
/// ReferenceIntegral. "material": the same of P = (r_m + w) e_r + v e_t by phi, v' = -(w - its mean), v(0) = 0.
/// "first-order": P = (r_m + w)(sin, cos)(phi + v/r_m), the frame turned clockwise by phi + (v - w')/r_m (thesis
/// (2-16), (2-19)). The parameter is u, with the other two models phi. Accuracy: some roundings of T.
template <class T>
class ReferenceMotion
{
  public:
    explicit ReferenceMotion(ReferenceNumbers const& given)
        : curve_(given),
          model_(given.model),
          r_m_(T(given.r_m)),
          ratio_(T(given.z_f) / T(given.z_c)),
          pitch_(T(2) * half_turn<T>() / T(given.z_c))
    {
        if (model_ == Kinematics::exact)
            sum_ = ReferenceIntegral<T>([this](T const& u) { return length(curve_.at(u).p1); }, given.waves,
                                        curve_.breaks());
        else
            sum_ = ReferenceIntegral<T>([this](T const& u) { return curve_.displacement(u).w; }, given.waves,
                                        curve_.breaks(), r_m_);
    }

    [[nodiscard]] T pitch() const { return pitch_; }
    [[nodiscard]] ReferenceNeutralCurve<T> const& curve() const { return curve_; }

    /// Undeformed angle at @p u.
    [[nodiscard]] T phi(T const& u) const { return model_ == Kinematics::exact ? T(sum_(u) / r_m_) : u; }

    [[nodiscard]] MovingFrame<T> at(T const& u) const
    {
        switch (model_) {
            case Kinematics::first_order:
                return first_order(u);
            case Kinematics::material:
                return on_curve(displaced(u), u, T(1));
            case Kinematics::exact:
                break;
        }
        ReferenceJet<T> const c = curve_.at(u);
        return on_curve(c, phi(u), length(c.p1) / r_m_);
    }

  private:
    /// v and its derivatives: v' = -(w - mean).
    [[nodiscard]] WaveJet<T> tangential(WaveJet<T> const& w, T const& phi) const
    {
        return {sum_.mean() * phi - sum_(phi), sum_.mean() - w.w, -w.w1};
    }

    [[nodiscard]] ReferenceJet<T> displaced(T const& phi) const
    {
        WaveJet<T> const w = curve_.displacement(phi), v = tangential(w, phi);
        ReferenceJet<T> const out = polar(WaveJet<T>{r_m_ + w.w, w.w1, w.w2}, phi), on = polar(v, phi);
        auto const right = [](Pair<T> const& a) -> Pair<T> { return {a.y, -a.x}; };  // e_t is e_r turned
        return {out.p + right(on.p), out.p1 + right(on.p1), out.p2 + right(on.p2)};
    }

    /// The frame on a curve's normal, where the circular spline has turned by ratio @p phi.
    [[nodiscard]] MovingFrame<T> on_curve(ReferenceJet<T> const& c, T const& phi, T const& phi_rate) const
    {
        T const speed = length(c.p1);
        Pair<T> const tangent = (T(1) / speed) * c.p1;
        Pair<T> const bend = (T(1) / speed) * (c.p2 - inner(tangent, c.p2) * tangent);
        return against_spline({c.p, tangent, to_left(tangent), c.p1, bend, to_left(bend)}, phi, phi_rate);
    }

    [[nodiscard]] MovingFrame<T> first_order(T const& phi) const
    {
        WaveJet<T> const w = curve_.displacement(phi), v = tangential(w, phi);
        T const stands = phi + v.w / r_m_, stands_rate = T(1) + v.w1 / r_m_;
        T const leans = phi + (v.w - w.w1) / r_m_, leans_rate = T(1) + (v.w1 - w.w2) / r_m_;
        Pair<T> const radius{sin(stands), cos(stands)}, right{radius.y, -radius.x};
        Pair<T> const tangent{cos(leans), -sin(leans)};
        T const rho = r_m_ + w.w;
        Pair<T> const bend = (-leans_rate) * to_left(tangent);
        return against_spline(
            {rho * radius, tangent, to_left(tangent), w.w1 * radius + (rho * stands_rate) * right, bend, to_left(bend)},
            phi, T(1));
    }

    /// From the wave generator's frame into the circular spline's, which has turned clockwise by ratio @p phi.
    [[nodiscard]] MovingFrame<T> against_spline(MovingFrame<T> const& held, T const& phi, T const& phi_rate) const
    {
        T const angle = -ratio_ * phi, rate = -ratio_ * phi_rate;
        T const ca = cos(angle), sa = sin(angle);
        auto const turning = [&](Pair<T> const& a) -> Pair<T> { return {rate * a.y, -rate * a.x}; };
        MovingFrame<T> place;
        place.origin = turned(held.origin, ca, sa);
        place.along = turned(held.along, ca, sa);
        place.outward = to_left(place.along);
        place.origin_rate = turned(held.origin_rate, ca, sa) + turning(place.origin);
        place.along_rate = turned(held.along_rate, ca, sa) + turning(place.along);
        place.outward_rate = to_left(place.along_rate);
        return place;
    }

    ReferenceNeutralCurve<T> curve_;
    Kinematics model_;
    T r_m_, ratio_, pitch_;
    ReferenceIntegral<T> sum_;  ///< of the speed, with the other two models of w
};

/// A circular-spline tooth, or the flexspline tooth itself, as the other member sees it.
///
/// Not the program's path: coordinates of the resting tooth's vectors along those of the moving frame, by the product
/// rule; the program carries the velocity field over.
template <class T>
class ReferenceView
{
  public:
    /// The flexspline tooth in the circular spline's frame.
    explicit ReferenceView(ReferenceMotion<T> motion) : motion_(std::move(motion)) {}
    /// The circular-spline tooth whose centre line is (number - 1/2) pitches clockwise of y, the origin of its frame at
    /// @p radius and its y axis inward, in the flexspline tooth's frame.
    ReferenceView(ReferenceMotion<T> motion, int number, T const& radius) : motion_(std::move(motion)), reverse_(true)
    {
        T const angle = (T(2 * number - 1) / T(2)) * motion_.pitch();
        Pair<T> const out{sin(angle), cos(angle)};
        seat_ = radius * out;
        inward_ = T(-1) * out;
        across_ = {inward_.y, -inward_.x};
    }

    [[nodiscard]] ReferenceMotion<T> const& motion() const { return motion_; }

    [[nodiscard]] MovingFrame<T> at(T const& u) const
    {
        MovingFrame<T> const tooth = motion_.at(u);
        if (!reverse_)
            return tooth;
        auto const seen = [&](Pair<T> const& a) -> Pair<T> { return {inner(a, tooth.along), inner(a, tooth.outward)}; };
        auto const seen_rate = [&](Pair<T> const& a) -> Pair<T> {
            return {inner(a, tooth.along_rate), inner(a, tooth.outward_rate)};
        };
        Pair<T> const apart = seat_ - tooth.origin;
        return {seen(apart),        seen(across_),     seen(inward_), seen_rate(apart) - seen(tooth.origin_rate),
                seen_rate(across_), seen_rate(inward_)};
    }

  private:
    ReferenceMotion<T> motion_;
    bool reverse_ = false;
    Pair<T> seat_, across_, inward_;
};

}  // namespace hdconj::accuracy
