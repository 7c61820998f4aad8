// SPDX-License-Identifier: GPL-3.0-or-later
// The displacement of the neutral curve as functions of the undeformed angle.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hdconj::wavegen {

/// Coefficients [mm] of one harmonic of w and v.
struct DisplacementHarmonic
{
    double w_cosine = 0;
    double w_sine = 0;
    double v_cosine = 0;
    double v_sine = 0;
};

/// Displacement of a ring by its undeformed angle. The point that stood at phi on the circle of radius r_m now stands
/// at (r_m + w) e_r + v e_t. Here e_r = (sin phi, cos phi) and e_t = (cos phi, -sin phi), and
///
///   w(phi) = sum_k w_cosine[k] cos(k n phi) + w_sine[k] sin(k n phi), v(phi) the same.
///
/// A shell or finite-element model of the cup gives its displacements in this form, slice by slice. v_cosine of k = 0
/// turns the ring as a whole.
struct MaterialDisplacement
{
    int waves = 2;                                ///< n >= 1
    std::vector<DisplacementHarmonic> harmonics;  ///< k = 0, 1, ...; none: the undeformed circle
};

/// w and v of one point and their derivatives: w[j] = d^j w/dphi^j [mm].
struct PointDisplacement
{
    std::array<double, 4> w{};
    std::array<double, 4> v{};
};

/// Displacement of the point at @p phi.
/// One sine and cosine; those of the multiples follow by adding angles, with an error of k roundings of the k-th term.
[[nodiscard]] inline PointDisplacement displacement_at(MaterialDisplacement const& displacement, double phi)
{
    double const n = displacement.waves;
    double const sine = std::sin(n * phi);
    double const cosine = std::cos(n * phi);
    double s = 0;
    double c = 1;
    double order = 0;
    PointDisplacement at;
    auto const add = [&](std::array<double, 4>& sum, double on_cosine, double on_sine) {
        double const term = on_cosine * c + on_sine * s;
        double const slope = (on_sine * c - on_cosine * s) * order;
        sum[0] += term;
        sum[1] += slope;
        sum[2] -= order * order * term;
        sum[3] -= order * order * slope;
    };
    for (DisplacementHarmonic const& h : displacement.harmonics) {
        add(at.w, h.w_cosine, h.w_sine);
        add(at.v, h.v_cosine, h.v_sine);
        double const next = s * cosine + c * sine;
        c = c * cosine - s * sine;
        s = next;
        order += n;
    }
    return at;
}

/// The same, bit for bit, of a displacement that is_symmetric(), where w has cosines and v has sines alone: in half the
/// time.
[[nodiscard]] inline PointDisplacement symmetric_displacement_at(MaterialDisplacement const& displacement, double phi)
{
    using Pair = Eigen::Array2d;  // of w and of v
    double const n = displacement.waves;
    double const sine = std::sin(n * phi);
    double const cosine = std::cos(n * phi);
    Pair on(1, 0), slope_on(-0.0, 1);  // cosine and sine of k n phi, and their derivatives by k n phi
    Pair order(0, 0), turn(n, n);
    std::array<Pair, 4> sum{Pair::Zero(), Pair::Zero(), Pair::Zero(), Pair::Zero()};
    for (DisplacementHarmonic const& h : displacement.harmonics) {
        // Loads of two numbers: w has no sines and v no cosines. Stores of single numbers would delay the next load.
        Pair const amplitude = Pair::Map(&h.w_cosine) + Pair::Map(&h.v_cosine);
        Pair const term = amplitude * on, slope = amplitude * slope_on * order, square = order * order;
        sum[0] += term;
        sum[1] += slope;
        sum[2] -= square * term;
        sum[3] -= square * slope;
        Pair const next = on * cosine + slope_on * sine;
        slope_on = slope_on * cosine - on * sine;
        on = next;
        order += turn;
    }
    PointDisplacement at;
    for (std::size_t j = 0; j < sum.size(); ++j) {
        at.w[j] = sum[j][0];
        at.v[j] = sum[j][1];
    }
    return at;
}

/// Sums of the moduli of the terms of w and v and of their derivatives: bounds at every phi.
[[nodiscard]] inline PointDisplacement displacement_bounds(MaterialDisplacement const& displacement)
{
    PointDisplacement bound;
    double order = 0;
    for (DisplacementHarmonic const& h : displacement.harmonics) {
        double w = std::hypot(h.w_cosine, h.w_sine);
        double v = std::hypot(h.v_cosine, h.v_sine);
        for (std::size_t j = 0; j < bound.w.size(); ++j) {
            bound.w[j] += w;
            bound.v[j] += v;
            w *= order;
            v *= order;
        }
        order += displacement.waves;
    }
    return bound;
}

/// Drops harmonics at the end of which nothing is left.
inline void drop_empty_tail(MaterialDisplacement& displacement)
{
    auto& all = displacement.harmonics;
    auto const is_empty = [](DisplacementHarmonic const& h) {
        return h.w_cosine == 0 && h.w_sine == 0 && h.v_cosine == 0 && h.v_sine == 0;
    };
    while (!all.empty() && is_empty(all.back()))
        all.pop_back();
}

/// Whether the point at -phi goes where the mirror image of that at phi goes: w even, v odd.
[[nodiscard]] inline bool is_symmetric(MaterialDisplacement const& displacement)
{
    return std::all_of(displacement.harmonics.begin(), displacement.harmonics.end(),
                       [](DisplacementHarmonic const& h) { return h.w_sine == 0 && h.v_cosine == 0; });
}

}  // namespace hdconj::wavegen
