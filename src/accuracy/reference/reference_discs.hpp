// SPDX-License-Identifier: GPL-3.0-or-later
// Neutral curve on eccentric discs by a path of its own, in any number type; private to src/accuracy.
#pragma once

#include <limits>
#include <vector>

#include "hdconj/error.hpp"
#include "reference_wave.hpp"

namespace hdconj::accuracy {

/// Ring that lies on a disc over the polar angle beta on either side of each lobe and is free between discs, 2 pi r_m
/// long.
///
/// Not the program's path: a point of the disc is found by its angle about the disc's centre, and the stretch on the
/// disc is as long as that angle says; the radius at the joint comes from vectors.
/// @throws NumericalError where no disc closes the curve
template <class T>
class ReferenceDiscs
{
  public:
    ReferenceDiscs() = default;
    ReferenceDiscs(T const& w0, T const& beta, int waves, T const& r_m)
        : half_(half_turn<T>() / T(waves)), beta_(beta), top_(r_m + w0)
    {
        T const eps = std::numeric_limits<T>::epsilon();
        T a = r_m, fa = too_long(a, r_m), b = r_m - w0;
        constexpr int budget = 60;
        for (int i = 0; i < budget; ++i) {
            T const fb = too_long(b, r_m);
            if (fb == fa || abs(b - a) <= T(4) * eps * r_m)
                return;
            T const next = b - fb * (b - a) / (fb - fa);
            a = b;
            fa = fb;
            b = next;
        }
        throw NumericalError(ErrorCode::no_solution, "reference", "neutral curve",
                             "no disc makes it as long as the ring");
    }

    [[nodiscard]] std::vector<T> breaks() const { return {-beta_, beta_}; }

    [[nodiscard]] ReferenceJet<T> at(T const& u) const
    {
        T const v = within_period(u, half_), rest = u - v;
        ReferenceJet<T> c = abs(v) < beta_ ? on_disc(v) : polar(between_.at(v > T(0) ? T(v - half_) : T(v + half_)), v);
        if (!(rest == T(0))) {
            T const k = cos(rest), s = sin(rest);
            c = {turned(c.p, k, s), turned(c.p1, k, s), turned(c.p2, k, s)};
        }
        return c;
    }

  private:
    /// Angle about the disc's centre: the sines of a triangle.
    [[nodiscard]] T about_centre(T const& u) const { return u + asin((top_ - disc_) * sin(u) / disc_); }

    [[nodiscard]] ReferenceJet<T> on_disc(T const& u) const
    {
        T const a = about_centre(u), s = disc_ * sin(a), k = disc_ * cos(a);
        return by_polar_angle(ReferenceJet<T>{{s, top_ - disc_ + k}, {k, -s}, {-s, -k}});
    }

    /// Length of half a wave less that of the ring, for discs of this radius.
    [[nodiscard]] T too_long(T const& disc, T const& r_m)
    {
        disc_ = disc;
        WaveJet<T> const joint = radius_of(on_disc(beta_));
        auto const found = solution_of<T, 3>(FreeRing<T>::terms(beta_ - half_), {joint.w, joint.w1, joint.w2});
        between_ = {found[0], found[1], found[2]};
        // the free stretch from -y to y as one period of its own
        T const y = half_ - beta_;
        ReferenceIntegral<T> const free(
            [&](T const& x) {
                T const at = (x - half_turn<T>()) * y / half_turn<T>();
                WaveJet<T> const rho = between_.at(at);
                return sqrt(rho.w * rho.w + rho.w1 * rho.w1);
            },
            1, {T(0)});
        return disc * about_centre(beta_) + free.mean() * y - r_m * half_;
    }

    T half_{}, beta_{}, top_{};
    T disc_{};
    FreeRing<T> between_;
};

}  // namespace hdconj::accuracy
