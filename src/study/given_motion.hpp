// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The exact motion by a path of its own, in any number type: vectors in place of angles; private to src/study.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "given_curve.hpp"
#include "hdconj/numeric/error.hpp"

namespace hdconj::detail {

/// Where the tooth frame is in the circular-spline frame, and how fast it moves, per radian of u.
template<class T>
struct Place
{
    Pair<T> origin, along, outward;
    Pair<T> origin_rate, along_rate, outward_rate;

    Pair<T> point(Pair<T> const& x) const { return origin + x.x * along + x.y * outward; }
    Pair<T> velocity(Pair<T> const& x) const { return origin_rate + x.x * along_rate + x.y * outward_rate; }
    Pair<T> turned(Pair<T> const& n) const { return n.x * along + n.y * outward; }
};

/// Tooth frame on a neutral curve, in the circular spline's frame.
///
/// Not the program's path: the frame is built of P'/|P'| and P'', no angle of it is ever taken; the undeformed angle is the integrated cosine sums of the
/// speed at equal steps. The program uses angles, a formula for theta' and q in which arc length cancels, and Newton's method on another series.
/// Accuracy: some roundings of T; the trapezoidal rule converges geometrically, and its points are doubled until it has.
template<class T>
class GivenMotion
{
  public:
    explicit GivenMotion(GivenNumbers const& given)
        : curve_(given), waves_(given.waves), r_m_(T(given.r_m)), ratio_(T(given.z_f) / T(given.z_c)), pitch_(T(2) * half_turn<T>() / T(given.z_c))
    {
        expand();
    }

    [[nodiscard]] T pitch() const { return pitch_; }

    /// Undeformed angle at u.
    [[nodiscard]] T phi(T const& u) const
    {
        using std::cos;
        using std::sin;
        T const x = T(waves_) * u;
        T const twice = T(2) * cos(x);
        T b1(0), b2(0);
        for (std::size_t k = sines_.size(); k-- > 0;)
        {
            T const b = sines_[k] + twice * b1 - b2;
            b2 = b1;
            b1 = b;
        }
        return drift_ * u + b1 * sin(x);
    }

    [[nodiscard]] Place<T> at(T const& u) const
    {
        using std::cos;
        using std::sin;
        CurveJet<T> const c = curve_.at(u);
        T const speed = length(c.p1);
        Pair<T> const tangent = (T(1) / speed) * c.p1;
        Pair<T> const bend = (T(1) / speed) * (c.p2 - inner(tangent, c.p2) * tangent);
        // into the circular spline's frame, which has turned clockwise by ratio phi
        T const angle = -ratio_ * phi(u), rate = -ratio_ * speed / r_m_;
        T const ca = cos(angle), sa = sin(angle);
        auto const turn = [&](Pair<T> const& a) -> Pair<T> { return {a.x * ca + a.y * sa, a.y * ca - a.x * sa}; };
        auto const turning = [&](Pair<T> const& turned) -> Pair<T> { return {rate * turned.y, -rate * turned.x}; };
        Place<T> place;
        place.origin = turn(c.p);
        place.along = turn(tangent);
        place.outward = to_left(place.along);
        place.origin_rate = turn(c.p1) + turning(place.origin);
        place.along_rate = turn(bend) + turning(place.along);
        place.outward_rate = to_left(place.along_rate);
        return place;
    }

  private:
    /// Speeds |P'| at equal steps over a wave, as many as their mean needs.
    [[nodiscard]] std::vector<T> speeds() const
    {
        using std::abs;
        T const eps = std::numeric_limits<T>::epsilon();
        constexpr std::size_t most = std::size_t{1} << 12;
        T before(0);
        for (std::size_t n = 16;; n *= 2)
        {
            std::vector<T> values(n);
            T sum(0);
            for (std::size_t i = 0; i < n; ++i)
            {
                values[i] = length(curve_.at(T(2) * half_turn<T>() * T(static_cast<int>(i)) / T(waves_ * static_cast<int>(n))).p1);
                sum += values[i];
            }
            T const mean = sum / T(static_cast<int>(n));
            if (abs(mean - before) <= T(16) * eps * r_m_)
                return values;
            if (n >= most)
                throw NumericalError("reference", "neutral curve", "its speed is not resolved");
            before = mean;
        }
    }

    void expand()
    {
        using std::abs;
        using std::cos;
        std::vector<T> const values = speeds();
        std::size_t const n = values.size();
        T const points = T(static_cast<int>(n));
        std::vector<T> cosines(n);
        drift_ = T(0);
        for (std::size_t i = 0; i < n; ++i)
        {
            cosines[i] = cos(T(2) * half_turn<T>() * T(static_cast<int>(i)) / points);
            drift_ += values[i];
        }
        drift_ = drift_ / (points * r_m_);
        for (std::size_t k = 1; k < n / 2; ++k)
        {
            T sum(0);
            for (std::size_t i = 0; i < n; ++i)
                sum += values[i] * cosines[(k * i) % n];
            sines_.push_back(T(2) * sum / (points * r_m_ * T(static_cast<int>(k)) * T(waves_)));
        }
        while (!sines_.empty() && abs(sines_.back()) < std::numeric_limits<T>::epsilon() / T(16))
            sines_.pop_back();
    }

    GivenCurve<T> curve_;
    int waves_;
    T r_m_, ratio_, pitch_;
    T drift_{};
    std::vector<T> sines_;
};

}  // namespace hdconj::detail
