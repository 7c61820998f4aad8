// SPDX-License-Identifier: GPL-3.0-or-later
// Neutral curves by a path of their own, in any number type; private to src/accuracy.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/scene.hpp"
#include "reference_discs.hpp"
#include "reference_pair.hpp"
#include "reference_wave.hpp"

namespace hdconj::accuracy {

/// Families of wave generators; the last three are analytic between breaks only.
enum class ReferenceShape
{
    cosine,
    ellipse,
    ring_on_cosine_cam,
    four_roller,
    two_disc,
    table
};

/// The numbers that a motion is given by, as the program rounds them: what comes of them is computed anew.
struct ReferenceNumbers
{
    ReferenceShape shape = ReferenceShape::cosine;
    double w0 = 0;
    int waves = 2;
    double r_m = 0;
    double thickness = 0;                     ///< of the ring on a cosine cam, t
    double angle_deg = 0;                     ///< of rollers, or over which the ring lies on a disc, beta
    std::vector<std::array<double, 2>> rows;  ///< of a table: angle [deg], value
    int z_f = 0;
    int z_c = 0;
    Kinematics model = Kinematics::exact;
};

/// Inextensible neutral curve of length 2 pi r_m.
///
/// Not the program's path: "cosine" is closed by the trapezoidal and the secant rule; "ellipse" is traced by its
/// eccentric angle and closed likewise, without an elliptic integral; "ring-on-cosine-cam" is cam plus t times its
/// normal as vectors, by the cam's angle, where the program differentiates angles. Those with breaks: ReferenceRollers,
/// ReferenceDiscs, ReferenceTable, closed by ReferenceIntegral. Accuracy: some roundings of T; the trapezoidal rule
/// converges geometrically, and its points are doubled until it has.
/// @throws NumericalError where a length or the angle on the cam does not converge
template <class T>
class ReferenceNeutralCurve
{
  public:
    explicit ReferenceNeutralCurve(ReferenceNumbers const& given)
        : shape_(given.shape),
          waves_(T(given.waves)),
          w0_(T(given.w0)),
          r_m_(T(given.r_m)),
          thickness_(T(given.thickness))
    {
        T const beta = T(given.angle_deg) * half_turn<T>() / T(180);
        auto const close_cam = [this](T const& length_around) {
            closed_ = closed(length_around, length_around, [this](T const& r) {
                return mean_of([&](T const& x) { return length(cam(r, x / waves_).p1); });
            });
        };
        auto const close_wave = [&](auto const& wave) {
            closed_ = closed(r_m_, r_m_, [&](T const& r) {
                auto const speed = [&](T const& u) { return length(wave_on(r, wave.at(u), u).p1); };
                return ReferenceIntegral<T>(speed, given.waves, wave.breaks()).mean();
            });
        };
        switch (shape_) {
            case ReferenceShape::cosine:
                close_cam(r_m_);
                break;
            // x is the eccentric angle from the minor axis on, whose semi-axis is sought
            case ReferenceShape::ellipse:
                closed_ = closed(r_m_, r_m_ - w0_, [this](T const& b) {
                    return mean_of([&](T const& x) { return length(eccentric(b, x).p1); });
                });
                break;
            case ReferenceShape::ring_on_cosine_cam:
                close_cam(r_m_ - thickness_);
                break;  // a parallel curve is 2 pi t longer
            case ReferenceShape::four_roller:
                rollers_ = ReferenceRollers<T>(w0_, beta, given.waves);
                close_wave(rollers_);
                break;
            case ReferenceShape::two_disc:
                discs_ = ReferenceDiscs<T>(w0_, beta, given.waves, r_m_);
                break;
            case ReferenceShape::table:
                table_ = ReferenceTable<T>(given.rows, given.waves);
                close_wave(table_);
                break;
        }
    }

    /// What the program calls r_0: the radius that the displacement w is counted from.
    [[nodiscard]] T mean_radius() const
    {
        if (shape_ == ReferenceShape::ellipse || shape_ == ReferenceShape::two_disc)
            return r_m_;
        return shape_ == ReferenceShape::ring_on_cosine_cam ? T(closed_ + thickness_) : closed_;
    }

    /// Angles within a wave at which the third derivative jumps, increasing.
    [[nodiscard]] std::vector<T> breaks() const
    {
        return shape_ == ReferenceShape::four_roller ? rollers_.breaks()
               : shape_ == ReferenceShape::two_disc  ? discs_.breaks()
               : shape_ == ReferenceShape::table     ? table_.breaks()
                                                     : std::vector<T>{};
    }

    [[nodiscard]] ReferenceJet<T> at(T const& u) const
    {
        switch (shape_) {
            case ReferenceShape::cosine:
                break;
            case ReferenceShape::ellipse:
                return by_polar_angle(eccentric(closed_, atan2((r_m_ + w0_) * sin(u), closed_ * cos(u))));
            case ReferenceShape::ring_on_cosine_cam:
                return by_polar_angle(ring(angle_on_cam(u)));
            case ReferenceShape::four_roller:
                return wave_on(closed_, rollers_.at(u), u);
            case ReferenceShape::two_disc:
                return discs_.at(u);
            case ReferenceShape::table:
                return wave_on(closed_, table_.at(u), u);
        }
        return cam(closed_, u);
    }

    /// The displacement w from the mean radius, by the angle that at() takes.
    [[nodiscard]] WaveJet<T> displacement(T const& u) const
    {
        WaveJet<T> w = radius_of(at(u));
        w.w -= mean_radius();
        return w;
    }

  private:
    [[nodiscard]] static ReferenceJet<T> wave_on(T const& r, WaveJet<T> const& w, T const& u)
    {
        return polar(WaveJet<T>{r + w.w, w.w1, w.w2}, u);
    }

    /// rho = r + w0 cos(n a), by a.
    [[nodiscard]] ReferenceJet<T> cam(T const& r, T const& a) const
    {
        T const cn = cos(waves_ * a), sn = sin(waves_ * a);
        return polar(WaveJet<T>{r + w0_ * cn, -waves_ * w0_ * sn, -waves_ * waves_ * w0_ * cn}, a);
    }

    /// Third derivative of cam() by a.
    [[nodiscard]] Pair<T> cam_third(T const& r, T const& a) const
    {
        T const cn = cos(waves_ * a), sn = sin(waves_ * a), n2 = waves_ * waves_;
        T const rho = r + w0_ * cn, rho1 = -waves_ * w0_ * sn, rho2 = -n2 * w0_ * cn, rho3 = n2 * waves_ * w0_ * sn;
        Pair<T> const out{sin(a), cos(a)}, on{cos(a), -sin(a)};
        return (rho3 - T(3) * rho1) * out + (T(3) * rho2 - rho) * on;
    }

    /// Ellipse with semi-axes r_m + w0 along u = 0 and @p b across, by its eccentric angle.
    [[nodiscard]] ReferenceJet<T> eccentric(T const& b, T const& e) const
    {
        T const a = r_m_ + w0_;
        return {{b * sin(e), a * cos(e)}, {b * cos(e), -a * sin(e)}, {-b * sin(e), -a * cos(e)}};
    }

    /// c + t n with the cam c, its tangent d = c'/s and n = d turned left; s d' + s' d = c'', once more differentiated
    /// for d''.
    [[nodiscard]] ReferenceJet<T> ring(T const& a) const
    {
        ReferenceJet<T> const c = cam(closed_, a);
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
        constexpr int budget = 60;
        T a = u, before(1);
        for (int i = 0; i < budget; ++i) {
            ReferenceJet<T> const c = ring(a);
            T const beyond = atan2(c.p.x * cos(u) - c.p.y * sin(u), c.p.x * sin(u) + c.p.y * cos(u));
            T const step = beyond * inner(c.p, c.p) / turning(c);
            a -= step;
            // Newton's method squares a small step: what follows half the digits is rounding
            if (abs(step) <= T(4) * std::numeric_limits<T>::epsilon() ||
                (abs(step) >= before && before * before < std::numeric_limits<T>::epsilon()))
                return a;
            before = abs(step);
        }
        throw NumericalError(ErrorCode::not_converged, "reference", "neutral curve",
                             "its angle on the cam is not found");
    }

    /// Mean of @p speed over a period of 2 pi, by as many equal steps as it takes.
    template <class Speed>
    [[nodiscard]] T mean_of(Speed const& speed) const
    {
        T const eps = std::numeric_limits<T>::epsilon();
        constexpr int fewest = 16, most = 1 << 12;
        T before(0);
        for (int points = fewest; points <= most; points *= 2) {
            T sum(0);
            for (int i = 0; i < points; ++i)
                sum += speed(T(2) * half_turn<T>() * T(i) / T(points));
            T const now = sum / T(points);
            if (abs(now - before) <= T(16) * eps * r_m_)
                return now;
            before = now;
        }
        throw NumericalError(ErrorCode::not_converged, "reference", "neutral curve", "its length is not resolved");
    }

    /// The radius with which @p mean_speed is @p mean, from @p guess on.
    template <class MeanSpeed>
    [[nodiscard]] static T closed(T const& mean, T const& guess, MeanSpeed const& mean_speed)
    {
        T const eps = std::numeric_limits<T>::epsilon();
        T a = guess, fa = mean_speed(a) - mean, found = a - fa;
        constexpr int budget = 60;
        for (int i = 0; i < budget; ++i) {
            T const b = found, fb = mean_speed(b) - mean;
            if (fb == fa || abs(b - a) <= eps * mean)
                break;
            found = b - fb * (b - a) / (fb - fa);
            a = b;
            fa = fb;
        }
        return found;
    }

    ReferenceShape shape_;
    T waves_, w0_, r_m_, thickness_;
    T closed_{};  ///< mean radius of the curve or cam, or semi-axis across
    ReferenceRollers<T> rollers_;
    ReferenceDiscs<T> discs_;
    ReferenceTable<T> table_;
};

}  // namespace hdconj::accuracy
