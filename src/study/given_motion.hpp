// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The exact motion by a path of its own, in any number type: vectors in place of angles; private to src/study.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "hdconj/numeric/error.hpp"

namespace hdconj::detail {

/// A point or a vector in a number type of any width.
template<class T>
struct Pair
{
    T x{};
    T y{};

    friend Pair operator+(Pair const& a, Pair const& b) { return {a.x + b.x, a.y + b.y}; }
    friend Pair operator-(Pair const& a, Pair const& b) { return {a.x - b.x, a.y - b.y}; }
    friend Pair operator*(T const& s, Pair const& a) { return {s * a.x, s * a.y}; }
};

template<class T>
T inner(Pair<T> const& a, Pair<T> const& b)
{
    return a.x * b.x + a.y * b.y;
}

template<class T>
T length(Pair<T> const& a)
{
    using std::sqrt;
    return sqrt(a.x * a.x + a.y * a.y);
}

/// +90 degrees.
template<class T>
Pair<T> to_left(Pair<T> const& a)
{
    return {-a.y, a.x};
}

/// The numbers that a motion is given by, as the program rounds them: what comes of them is computed anew.
struct GivenNumbers
{
    double w0 = 0;
    int waves = 2;
    double r_m = 0;
    int z_f = 0;
    int z_c = 0;
};

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

/// Inextensible neutral curve rho = r_0 + w0 cos(n u).
///
/// Not the program's path: the frame is built of P'/|P'| and P'', no angle of it is ever taken; r_0 by the trapezoidal rule and the
/// secant rule, the undeformed angle by the integrated cosine sums of the speed at equal steps. The program uses angles, a formula for theta' and q in
/// which arc length cancels, and Newton's method on another series.
/// Accuracy: some roundings of T; the trapezoidal rule converges geometrically, and its points are doubled until it has.
template<class T>
class GivenMotion
{
  public:
    explicit GivenMotion(GivenNumbers const& given)
        : waves_(given.waves), w0_(T(given.w0)), r_m_(T(given.r_m)), ratio_(T(given.z_f) / T(given.z_c)), pitch_(T(2) * pi() / T(given.z_c))
    {
        close();
        expand();
    }

    [[nodiscard]] static T pi()
    {
        using std::acos;
        static T const value = acos(T(-1));
        return value;
    }
    [[nodiscard]] T pitch() const { return pitch_; }
    [[nodiscard]] T r_0() const { return r_0_; }

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
        T const n = T(waves_);
        T const cn = cos(n * u), sn = sin(n * u), c = cos(u), s = sin(u);
        T const rho = r_0_ + w0_ * cn, rho1 = -n * w0_ * sn, rho2 = -n * n * w0_ * cn;
        Pair<T> const out{s, c}, on{c, -s};
        Pair<T> const p = rho * out;
        Pair<T> const p1 = rho1 * out + rho * on;
        Pair<T> const p2 = (rho2 - rho) * out + (T(2) * rho1) * on;
        T const speed = length(p1);
        Pair<T> const tangent = (T(1) / speed) * p1;
        Pair<T> const bend = (T(1) / speed) * (p2 - inner(tangent, p2) * tangent);
        // into the circular spline's frame, which has turned clockwise by ratio phi
        T const angle = -ratio_ * phi(u), rate = -ratio_ * speed / r_m_;
        T const ca = cos(angle), sa = sin(angle);
        auto const turn = [&](Pair<T> const& a) -> Pair<T> { return {a.x * ca + a.y * sa, a.y * ca - a.x * sa}; };
        auto const turning = [&](Pair<T> const& turned) -> Pair<T> { return {rate * turned.y, -rate * turned.x}; };
        Place<T> place;
        place.origin = turn(p);
        place.along = turn(tangent);
        place.outward = to_left(place.along);
        place.origin_rate = turn(p1) + turning(place.origin);
        place.along_rate = turn(bend) + turning(place.along);
        place.outward_rate = to_left(place.along_rate);
        return place;
    }

  private:
    [[nodiscard]] T speed(T const& r_0, T const& u) const
    {
        using std::cos;
        using std::sin;
        using std::sqrt;
        T const n = T(waves_);
        T const rho = r_0 + w0_ * cos(n * u), slope = n * w0_ * sin(n * u);
        return sqrt(rho * rho + slope * slope);
    }

    [[nodiscard]] T mean_speed(T const& r_0, int points) const
    {
        T sum(0);
        for (int i = 0; i < points; ++i)
            sum += speed(r_0, T(2) * pi() * T(i) / (T(waves_) * T(points)));
        return sum / T(points);
    }

    void close()
    {
        using std::abs;
        T const eps = std::numeric_limits<T>::epsilon();
        points_ = 16;
        constexpr int most = 1 << 12;
        for (T before(0);; points_ *= 2)
        {
            T const now = mean_speed(r_m_, points_);
            if (abs(now - before) <= T(16) * eps * r_m_)
                break;
            if (points_ >= most)
                throw NumericalError("reference", "neutral curve", "its length is not resolved");
            before = now;
        }
        T a = r_m_, fa = mean_speed(a, points_) - r_m_;
        r_0_ = r_m_ - fa;
        constexpr int budget = 60;
        for (int i = 0; i < budget; ++i)
        {
            T const b = r_0_, fb = mean_speed(b, points_) - r_m_;
            if (fb == fa || abs(b - a) <= eps * r_m_)
                break;
            r_0_ = b - fb * (b - a) / (fb - fa);
            a = b;
            fa = fb;
        }
    }

    void expand()
    {
        using std::abs;
        using std::cos;
        auto const n = static_cast<std::size_t>(points_);
        std::vector<T> values(n), cosines(n);
        drift_ = T(0);
        for (std::size_t i = 0; i < n; ++i)
        {
            T const angle = T(2) * pi() * T(static_cast<int>(i)) / T(points_);
            values[i] = speed(r_0_, angle / T(waves_));
            cosines[i] = cos(angle);
            drift_ += values[i];
        }
        drift_ = drift_ / (T(points_) * r_m_);
        for (std::size_t k = 1; k < n / 2; ++k)
        {
            T sum(0);
            for (std::size_t i = 0; i < n; ++i)
                sum += values[i] * cosines[(k * i) % n];
            sines_.push_back(T(2) * sum / (T(points_) * r_m_ * T(static_cast<int>(k)) * T(waves_)));
        }
        while (!sines_.empty() && abs(sines_.back()) < std::numeric_limits<T>::epsilon() / T(16))
            sines_.pop_back();
    }

    int waves_;
    T w0_, r_m_, ratio_, pitch_;
    T r_0_{};
    T drift_{};
    int points_ = 0;
    std::vector<T> sines_;
};

}  // namespace hdconj::detail
