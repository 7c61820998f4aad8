// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdconj/wavegen/ring_on_cam.hpp"

#include <numbers>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/error.hpp"
#include "hdconj/wavegen/cosine_cam.hpp"
#include "hdconj/wavegen/neutral_curve.hpp"

namespace hdconj::wavegen {

RingOnCam::RingOnCam(double w0, int n, double t, double r_m)
    : w0_(w0), n_(n), t_(t), cam_(NeutralCurve<CosineCam>(CosineCam{w0, n}, r_m - t).r_0())
{
    // the parallel curve has a cusp where the cam is hollow with a radius of t
    constexpr int probes = 256;
    for (int i = 0; i <= probes; ++i) {
        double const x = std::numbers::pi * i / probes;
        double const r = cam_ + w0 * std::cos(x);
        double const r1 = -n * w0 * std::sin(x);
        double const r2 = -n * n * w0 * std::cos(x);
        double const s2 = r * r + r1 * r1;
        double const bend = (s2 + r1 * r1 - r * r2) / (s2 * std::sqrt(s2));
        if (!(1 + t * bend > 0))
            throw NumericalError(ErrorCode::no_solution, "wave generator", "ring on a cosine cam",
                                 "the cam is hollow with a smaller radius than the ring is thick");
    }
}

RadialDisplacement RingOnCam::operator()(double u) const
{
    // cam angle a over which the neutral point stands at u: Newton from the first-order guess
    double const k = n_;
    double a = u - t_ * k * w0_ * std::sin(k * u) / (cam_ * (cam_ + t_));
    constexpr int budget = 50;
    double last = 1;
    double r = 0, r1 = 0, r2 = 0, r3 = 0, s2 = 0, s = 0, x = 0, y = 0, turn = 0;
    for (int i = 0; i < budget; ++i) {
        double const sine = std::sin(k * a);
        double const cosine = std::cos(k * a);
        r = cam_ + w0_ * cosine;
        r1 = -k * w0_ * sine;
        r2 = -k * k * w0_ * cosine;
        r3 = k * k * k * w0_ * sine;
        s2 = r * r + r1 * r1;
        s = std::sqrt(s2);
        // r + t exp(-i chi), chi = atan(r'/r)
        x = r + t_ * r / s;
        y = t_ * r1 / s;
        turn = (r * r2 - r1 * r1) / s2;  // chi'
        double const speed = s + t_ * (1 - turn);
        double const rho2 = x * x + y * y;
        // tangent's share across the radius: du/da = speed cos(chi + u - a)/rho, cos of the angle of (r + i r')(x - i
        // y)
        double const across = (r * x + r1 * y) / s;
        double const slope = speed * across / rho2;
        double const miss = a - std::atan2(y, x) - u;
        double const step = miss / slope;
        if (std::abs(step) <= 2 * unit_roundoff || (i > 3 && std::abs(step) >= last))
            break;
        last = std::abs(step);
        a -= step;
    }
    double const rho = std::hypot(x, y);
    double const psi = std::atan2(r1, r) - std::atan2(y, x);  // angle between normal and radius of the neutral curve
    double const c = std::cos(psi);
    double const tangent = std::tan(psi);
    double const speed = s + t_ * (1 - turn);
    double const s1 = r1 * (r + r2) / s;
    double const turn1 = (r * r3 - r1 * r2) / s2 - 2 * turn * s1 / s;  // chi''
    double const speed1 = s1 - t_ * turn1;
    double const a1 = rho / (speed * c);  // da/du
    double const psi1 = 1 - (1 - turn) * a1;
    double const rho1 = rho * tangent;
    double const rho2 = rho1 * tangent + rho * psi1 / (c * c);
    double const a2 = a1 * (rho1 / rho - speed1 * a1 / speed + tangent * psi1);
    double const psi2 = turn1 * a1 * a1 - (1 - turn) * a2;
    double const rho3 = rho2 * tangent + (2 * rho1 * psi1 + rho * psi2 + 2 * rho * psi1 * psi1 * tangent) / (c * c);
    return {rho - (cam_ + t_), rho1, rho2, rho3, std::sin(k * u), std::cos(k * u)};
}

RingOnCam RingOnCam::build(scene::FamilyChoice const& choice, WaveGeneratorPlace const& place, Faults& faults)
{
    double const w0 = choice.number_or(radial_deformation, 0);
    double const t = choice.number_or("ring_thickness", 0);
    if (!(place.r_m > 0))
        return {};
    if (!(t + w0 < place.r_m)) {
        faults.push_back(scene::parameter_fault(
            choice, "ring_thickness",
            "leaves no cam inside a neutral curve of radius " + std::to_string(place.r_m) + " mm",
            "write a smaller number"));
        return {};
    }
    try {
        return {w0, place.waves, t, place.r_m};
    } catch (NumericalError const& error) {
        faults.push_back(scene::parameter_fault(choice, radial_deformation, error.what(), "write about one module"));
        return {};
    }
}

}  // namespace hdconj::wavegen
