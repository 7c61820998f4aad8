// SPDX-License-Identifier: GPL-3.0-or-later
// All real roots of a Bernstein polynomial whose coefficients are known to a stated error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/numeric/bernstein.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/numeric/root_clusters.hpp"

namespace hdconj::numeric {

/// Roots of a Bernstein polynomial on [0, 1], increasing.
struct BernsteinRoots
{
    std::array<double, bernstein_max_degree + 1> t{};
    std::array<double, bernstein_max_degree + 1>
        width{};  ///< 0: simple; else near-double: every root there lies within t +- width/2
    int count = 0;
    bool complete = true;  ///< false: more near-double places than the degree allows roots
};

/// What the coefficients of one piece prove, given that each is right to +-noise.
struct CoefficientProof
{
    int left = 0;  ///< certain sign at the ends, or 0
    int right = 0;
    bool one_sign = false;  ///< no root
    bool crossing = false;  ///< exactly one root, between certain signs, of every polynomial within the noise
    int direction = 0;      ///< +-1: monotone
    double slope = 0;       ///< then: smallest |derivative|, parameter 0 ... 1 along the piece
    double largest = 0;
};

/// @param slope_noise  further error of the derivative, beyond what the coefficients' noise makes of it
[[nodiscard]] CoefficientProof prove_signs(std::span<double const> c, double noise, double slope_noise);

/// Feeds @p clusters with the stretches of one polynomial on x in [a, b].
///
/// A piece is cut until its coefficients prove it free of roots, crossed once or monotone, or its largest coefficient
/// is 4 noise. Cuts at 1/2 add at most degree * roundoff * largest coefficient to the noise of each half, which is
/// carried along.
/// @param c            Bernstein coefficients, each right to +-@p noise; overwritten
/// @param slope_noise  further error of the derivative with respect to x * 1/(b - a), for functions that are no
///                     polynomials
template <class Sink>
void bernstein_isolate(std::span<double> c, double a, double b, double noise, double slope_noise,
                       RootClusters<Sink>& clusters)
{
    CoefficientProof const proof = prove_signs(c, noise, slope_noise);
    if (proof.one_sign)
        return clusters.one_sign(a, proof.left);
    if (proof.crossing)
        return clusters.crossing(a, b, proof.left, proof.right);
    if (proof.direction != 0) {
        double const reach = 2 * noise / proof.slope * (b - a);
        return clusters.monotone(a, b, proof.left, proof.right, proof.direction, reach);
    }
    constexpr double indistinct = 4;
    double const middle = 0.5 * (a + b);
    double const smallest = 4 * unit_roundoff * std::max(std::abs(a), std::abs(b));
    if (proof.largest <= indistinct * noise || b - a <= smallest)
        return clusters.undecided(a, b, proof.largest + noise);
    BernsteinWork high{};
    constexpr double cut = 0.5;
    bernstein_split(c, {high.data(), c.size()}, cut);
    double const rounded = noise + static_cast<double>(c.size() - 1) * unit_roundoff * proof.largest;
    bernstein_isolate(c, a, middle, rounded, 0.5 * slope_noise, clusters);
    bernstein_isolate(std::span<double>(high.data(), c.size()), middle, b, rounded, 0.5 * slope_noise, clusters);
}

/// The root of @p f in a cluster that holds one simple root. Where roundoff hides the change of sign, at an end of the
/// axis or on a cut, the end of the cluster with the smaller |f|.
template <class F>
[[nodiscard]] double root_in(RootCluster const& cluster, F&& f)
{
    double const f_lo = f(cluster.lo);
    double const f_hi = f(cluster.hi);
    BracketedRoot const root = bracketed_root(f, cluster.lo, cluster.hi, f_lo, f_hi);
    if (root.found)
        return root.x;
    return std::abs(f_lo) <= std::abs(f_hi) ? cluster.lo : cluster.hi;
}

/// All roots in [0, 1] of every polynomial whose Bernstein coefficients differ from @p c by at most @p noise.
///
/// Theorem. Let p be such a polynomial. Outside the intervals t +- width/2 of the near-double roots, p has exactly the
/// simple roots listed. Away from all of them p exceeds the noise. A root within roundoff of 0 or 1 is listed and may
/// lie just outside. Within an interval of a near-double root |c(t)| stays within a few noises: p may have no root
/// there, one or more.
///
/// Proof. Variation diminishing: a polynomial has at most as many roots as its coefficients have changes of sign, and
/// as many but for an even number. A coefficient counts as certain only beyond the noise, and an uncertain one is tried
/// with both signs. Where all differences of coefficients exceed twice the noise, p is monotone. The noise of each
/// piece includes the rounding of all cuts before it.
///
/// Accuracy: simple roots to noise / |slope|. Two roots at distance D with curvature k are told apart where k D^2 / 8
/// exceeds some noises, about D > 1e-7 where noise is roundoff. Else one near-double root of width about sqrt(32 noise
/// / k) holds both.
[[nodiscard]] BernsteinRoots bernstein_roots(std::span<double const> c, double noise);

}  // namespace hdconj::numeric
