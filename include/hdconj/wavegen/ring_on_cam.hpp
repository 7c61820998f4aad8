// SPDX-License-Identifier: GPL-3.0-or-later
// Wave generator "ring-on-cosine-cam": a ring of some thickness on a cosine cam.
#pragma once

#include "hdconj/wavegen/build.hpp"
#include "hdconj/wavegen/radial_displacement.hpp"

namespace hdconj::wavegen {

/// The cam's surface is r(a) = R_c + w0 cos(n a). The neutral curve is its parallel curve at the distance t, which is
/// bearing and half the wall. Let chi = atan(r'/r) be the angle between the cam's normal and its radius. The neutral
/// point over the cam angle a is
///   rho = |r + t exp(-i chi)|,  u = a - atan2(t sin chi, r + t cos chi).
/// Both curves share their normals, so the angle between normal and radius on the neutral curve is chi + u - a. A
/// parallel curve is longer than the cam by 2 pi t: R_c is the closed mean radius of a cosine cam of length 2 pi (r_m -
/// t). The displacement is measured from R_c + t: w(0) = w0, w(pi/n) = -w0. Domain: 0 <= t < r_m, and a cam without a
/// hollow sharper than t. t -> 0 gives "cosine". Accuracy: a few roundings of r_m (the cam angle is solved for by
/// Newton's method at each u).
class RingOnCam
{
  public:
    RingOnCam() = default;
    RingOnCam(double w0, int n, double t, double r_m);

    [[nodiscard]] int waves() const { return n_; }
    [[nodiscard]] double amplitude() const { return w0_; }
    [[nodiscard]] bool even() const { return true; }
    [[nodiscard]] std::span<double const> breaks() const { return {}; }
    [[nodiscard]] double cam_radius() const { return cam_; }  ///< R_c

    [[nodiscard]] RadialDisplacement operator()(double u) const;

    [[nodiscard]] static scene::FamilyDescription describe()
    {
        return {"ring-on-cosine-cam",
                "neutral curve parallel to a cosine cam",
                {radial_deformation_key(),
                 {"ring_thickness", scene::Quantity::positive_length,
                  "distance from the cam's surface to the neutral curve, t (bearing and half the wall)"}}};
    }

    [[nodiscard]] static RingOnCam build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place,
                                         Faults& faults);

  private:
    double w0_ = 0;
    int n_ = 2;
    double t_ = 0;
    double cam_ = 1;
};

}  // namespace hdconj::wavegen
