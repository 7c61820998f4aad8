// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Neutral curves of the smooth wave generators by a path of their own, in any number type; private to src/study.
#pragma once

#include <cmath>
#include <limits>

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

/// Families that are analytic all around; the others have breaks, which series in 50 digits do not follow.
enum class GivenShape { cosine, ellipse, ring_on_cosine_cam };

/// The numbers that a motion is given by, as the program rounds them: what comes of them is computed anew.
struct GivenNumbers
{
    GivenShape shape = GivenShape::cosine;
    double w0 = 0;
    int waves = 2;
    double r_m = 0;
    double thickness = 0;   ///< of the ring on a cosine cam, t
    int z_f = 0;
    int z_c = 0;
};

/// Point of the neutral curve at the polar angle u and its derivatives by u.
template<class T>
struct CurveJet
{
    Pair<T> p, p1, p2;
};

template<class T>
[[nodiscard]] T half_turn()
{
    using std::acos;
    static T const value = acos(T(-1));
    return value;
}

/// Inextensible neutral curve of length 2 pi r_m.
///
/// Not the program's path: "cosine" is closed by the trapezoidal and the secant rule; "ellipse" is traced by its eccentric angle and closed likewise, without an elliptic integral;
/// "ring-on-cosine-cam" is cam plus t times its normal as vectors, by the cam's angle, where the program differentiates angles.
/// Accuracy: some roundings of T; the trapezoidal rule converges geometrically, and its points are doubled until it has.
/// @throws NumericalError where a length or the angle on the cam does not converge
template<class T>
class GivenCurve
{
  public:
    explicit GivenCurve(GivenNumbers const& given)
        : shape_(given.shape), waves_(T(given.waves)), w0_(T(given.w0)), r_m_(T(given.r_m)), thickness_(T(given.thickness))
    {
        switch (shape_)
        {
        case GivenShape::cosine: closed_ = closed(r_m_, r_m_, [this](T const& r, T const& x) { return length(cam(r, x / waves_).p1); }); break;
        // x is the eccentric angle from the minor axis on, whose semi-axis is sought
        case GivenShape::ellipse: closed_ = closed(r_m_, r_m_ - w0_, [this](T const& b, T const& x) { return length(eccentric(b, x).p1); }); break;
        case GivenShape::ring_on_cosine_cam:
        {
            T const inside = r_m_ - thickness_;   // a parallel curve is 2 pi t longer
            closed_ = closed(inside, inside, [this](T const& r, T const& x) { return length(cam(r, x / waves_).p1); });
            break;
        }
        }
    }

    /// What the program calls r_0: the radius that the displacement w is counted from.
    [[nodiscard]] T mean_radius() const
    {
        switch (shape_)
        {
        case GivenShape::ellipse: return r_m_;
        case GivenShape::ring_on_cosine_cam: return closed_ + thickness_;
        case GivenShape::cosine: break;
        }
        return closed_;
    }

    [[nodiscard]] CurveJet<T> at(T const& u) const
    {
        using std::atan2;
        using std::cos;
        using std::sin;
        switch (shape_)
        {
        case GivenShape::cosine: break;
        case GivenShape::ellipse: return by_polar_angle(eccentric(closed_, atan2((r_m_ + w0_) * sin(u), closed_ * cos(u))));
        case GivenShape::ring_on_cosine_cam: return by_polar_angle(ring(angle_on_cam(u)));
        }
        return cam(closed_, u);
    }

  private:
    /// rho = r + w0 cos(n a), by a.
    [[nodiscard]] CurveJet<T> cam(T const& r, T const& a) const
    {
        using std::cos;
        using std::sin;
        T const cn = cos(waves_ * a), sn = sin(waves_ * a);
        T const rho = r + w0_ * cn, rho1 = -waves_ * w0_ * sn, rho2 = -waves_ * waves_ * w0_ * cn;
        Pair<T> const out{sin(a), cos(a)}, on{cos(a), -sin(a)};
        return {rho * out, rho1 * out + rho * on, (rho2 - rho) * out + (T(2) * rho1) * on};
    }

    /// Third derivative of cam() by a.
    [[nodiscard]] Pair<T> cam_third(T const& r, T const& a) const
    {
        using std::cos;
        using std::sin;
        T const cn = cos(waves_ * a), sn = sin(waves_ * a), n2 = waves_ * waves_;
        T const rho = r + w0_ * cn, rho1 = -waves_ * w0_ * sn, rho2 = -n2 * w0_ * cn, rho3 = n2 * waves_ * w0_ * sn;
        Pair<T> const out{sin(a), cos(a)}, on{cos(a), -sin(a)};
        return (rho3 - T(3) * rho1) * out + (T(3) * rho2 - rho) * on;
    }

    /// Ellipse with semi-axes r_m + w0 along u = 0 and @p b across, by its eccentric angle.
    [[nodiscard]] CurveJet<T> eccentric(T const& b, T const& e) const
    {
        using std::cos;
        using std::sin;
        T const a = r_m_ + w0_;
        return {{b * sin(e), a * cos(e)}, {b * cos(e), -a * sin(e)}, {-b * sin(e), -a * cos(e)}};
    }

    /// c + t n with the cam c, its tangent d = c'/s and n = d turned left; s d' + s' d = c'', once more differentiated for d''.
    [[nodiscard]] CurveJet<T> ring(T const& a) const
    {
        CurveJet<T> const c = cam(closed_, a);
        Pair<T> const c3 = cam_third(closed_, a);
        T const s = length(c.p1);
        Pair<T> const d = (T(1) / s) * c.p1;
        T const s1 = inner(d, c.p2);
        Pair<T> const d1 = (T(1) / s) * (c.p2 - s1 * d);
        T const s2 = inner(d1, c.p2) + inner(d, c3);
        Pair<T> const d2 = (T(1) / s) * (c3 - s2 * d - (T(2) * s1) * d1);
        return {c.p + thickness_ * to_left(d), c.p1 + thickness_ * to_left(d1), c.p2 + thickness_ * to_left(d2)};
    }

    /// Angle of the cam over which the ring's point stands at u.
    [[nodiscard]] T angle_on_cam(T const& u) const
    {
        using std::abs;
        using std::atan2;
        using std::cos;
        using std::sin;
        constexpr int budget = 60;
        T a = u, before(1);
        for (int i = 0; i < budget; ++i)
        {
            CurveJet<T> const c = ring(a);
            T const beyond = atan2(c.p.x * cos(u) - c.p.y * sin(u), c.p.x * sin(u) + c.p.y * cos(u));
            T const step = beyond * inner(c.p, c.p) / turning(c);
            a -= step;
            // Newton's method squares a small step: what follows half the digits is rounding
            if (abs(step) <= T(4) * std::numeric_limits<T>::epsilon() || (abs(step) >= before && before * before < std::numeric_limits<T>::epsilon()))
                return a;
            before = abs(step);
        }
        throw NumericalError("reference", "neutral curve", "its angle on the cam is not found");
    }

    /// rho^2 du/de
    [[nodiscard]] static T turning(CurveJet<T> const& c) { return c.p.y * c.p1.x - c.p.x * c.p1.y; }

    /// Derivatives by the polar angle u of a curve that is given with those by another parameter e.
    [[nodiscard]] static CurveJet<T> by_polar_angle(CurveJet<T> const& c)
    {
        T const square = inner(c.p, c.p), turn = turning(c);
        T const u1 = turn / square;
        T const u2 = (c.p.y * c.p2.x - c.p.x * c.p2.y) / square - T(2) * u1 * inner(c.p, c.p1) / square;
        T const e1 = T(1) / u1, e2 = -u2 * e1 * e1 * e1;
        return {c.p, e1 * c.p1, (e1 * e1) * c.p2 + e2 * c.p1};
    }

    /// The radius with which the mean of @p speed(radius, x) over a period of 2 pi in x is @p mean, from @p guess on.
    template<class Speed>
    [[nodiscard]] static T closed(T const& mean, T const& guess, Speed const& speed)
    {
        using std::abs;
        T const eps = std::numeric_limits<T>::epsilon();
        auto const mean_of = [&](T const& radius, int points) {
            T sum(0);
            for (int i = 0; i < points; ++i)
                sum += speed(radius, T(2) * half_turn<T>() * T(i) / T(points));
            return sum / T(points);
        };
        int points = 16;
        constexpr int most = 1 << 12;
        for (T before(0);; points *= 2)
        {
            T const now = mean_of(guess, points);
            if (abs(now - before) <= T(16) * eps * mean)
                break;
            if (points >= most)
                throw NumericalError("reference", "neutral curve", "its length is not resolved");
            before = now;
        }
        T a = guess, fa = mean_of(a, points) - mean, found = a - fa;
        constexpr int budget = 60;
        for (int i = 0; i < budget; ++i)
        {
            T const b = found, fb = mean_of(b, points) - mean;
            if (fb == fa || abs(b - a) <= eps * mean)
                break;
            found = b - fb * (b - a) / (fb - fa);
            a = b;
            fa = fb;
        }
        return found;
    }

    GivenShape shape_;
    T waves_, w0_, r_m_, thickness_;
    T closed_{};   ///< mean radius of the cosine curve or cam, or semi-axis across
};

}  // namespace hdconj::detail
