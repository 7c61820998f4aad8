// SPDX-License-Identifier: GPL-3.0-or-later
// Every root of a smooth function on an interval, not only those that a scan happens to bracket.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/numeric/bracketed_root.hpp"
#include "hdconj/numeric/chebyshev.hpp"

namespace hdconj::numeric {

/// A root, or a place where two roots are too close to tell apart.
struct IsolatedRoot
{
    double x = 0;
    double width = 0;          ///< 0 for a simple root; else the roots, if any, lie within x +- width/2
    bool near_double = false;  ///< |f| and |f'| are both below what double precision can tell from 0
};

/// Roots in increasing order, and whether every piece of the interval was decided.
struct RootSet
{
    std::vector<IsolatedRoot> roots;
    bool certified = true;  ///< every piece shown empty, monotone with one root, or near-double: see all_roots()
    bool vanishes = false;  ///< f is zero to roundoff on a whole piece
    std::size_t evaluations = 0;
};

template <class F>
class RootIsolation
{
  public:
    RootIsolation(F& f, double scale, double smallest, RootSet& out)
        : f_(f), scale_(scale), smallest_(smallest), out_(out)
    {
    }

    /// @param tail_before  interpolation error on the interval that this one was cut from
    void operator()(double a, double b, double fa, double fb, double tail_before)
    {
        if (out_.evaluations > budget) {
            out_.certified = false;
            return;
        }
        double const middle = 0.5 * (a + b);
        double const half = 0.5 * (b - a);
        ChebyshevVector values;
        auto const& nodes = chebyshev_points();
        for (int j = 1; j < chebyshev_degree; ++j)
            values[j] = f_(middle + half * nodes[j]);
        values[0] = fb;
        values[chebyshev_degree] = fa;
        out_.evaluations += chebyshev_degree - 1;
        ChebyshevVector const c = chebyshev_coefficients(values);
        double const noise = 32 * unit_roundoff * scale_;
        double const tail = chebyshev_tail(c);
        double const doubt = noise + 4 * tail;
        if (values.cwiseAbs().maxCoeff() <= noise) {
            out_.vanishes = true;
            out_.roots.push_back({middle, b - a, true});
            return;
        }
        // a smooth function's tail falls by 2^-15 with each cut; one that stays is the rounding error of f itself
        bool const noise_reached = tail >= tail_before / 4 && tail <= noisiest * scale_;
        bool const resolved = tail <= resolution * scale_ || noise_reached;
        bool const empty = resolved && std::abs(c[0]) > chebyshev_spread(c) + doubt;
        ChebyshevVector const d = chebyshev_derivative(c);
        // Markov: an error e of a degree-N interpolant is at most N^2 e in its derivative
        double const slope_doubt = chebyshev_degree * chebyshev_degree * doubt;
        bool const rising_or_falling = resolved && !empty && std::abs(d[0]) > chebyshev_spread(d) + slope_doubt;
        if ((empty || rising_or_falling) && agrees(c, middle, half, doubt)) {
            if (rising_or_falling)
                monotone(a, b, fa, fb);
            return;
        }
        if (b - a <= smallest_)
            return undecided(a, b, fa, fb, values, noise, resolved);
        // off centre, so that the root of a symmetric function is not hit by the cut again and again
        double const cut = middle + split * half;
        double const f_cut = f_(cut);
        ++out_.evaluations;
        (*this)(a, cut, fa, f_cut, tail);
        (*this)(cut, b, f_cut, fb, tail);
    }

  private:
    /// Compares the interpolant with f at places that are nodes of no cut. A function that runs through many waves
    /// between the nodes can look smooth at all of them.
    [[nodiscard]] bool agrees(ChebyshevVector const& c, double middle, double half, double doubt)
    {
        constexpr std::array<double, 3> places{-0.7320508, 0.0954451, 0.6180339};
        out_.evaluations += places.size();
        return std::all_of(places.begin(), places.end(), [&](double x) {
            return std::abs(f_(middle + half * x) - chebyshev_value(c, x)) <= 2 * doubt;
        });
    }

    static constexpr double split = -0.0097;
    static constexpr double resolution = 4096 * unit_roundoff;
    static constexpr double noisiest = 0x1p-24;
    static constexpr std::size_t budget = std::size_t{1} << 18;

    void monotone(double a, double b, double fa, double fb)
    {
        // half-open convention: a zero at the cut belongs to the piece on whose other end f is negative
        if ((fa < 0) == (fb < 0))
            return;
        BracketedRoot const root = bracketed_root(f_, a, b, fa, fb);
        out_.evaluations += root.evaluations;
        out_.certified = out_.certified && root.found;
        out_.roots.push_back({root.x, 0, false});
    }

    void undecided(double a, double b, double fa, double fb, ChebyshevVector const& values, double noise, bool resolved)
    {
        out_.certified = out_.certified && resolved;
        if ((fa < 0) != (fb < 0))
            return monotone(a, b, fa, fb);
        Eigen::Index nearest = 0;
        if (values.cwiseAbs().minCoeff(&nearest) <= 16 * noise)
            out_.roots.push_back({0.5 * (a + b) + 0.5 * (b - a) * chebyshev_points()[nearest], b - a, true});
    }

    F& f_;
    double scale_;
    double smallest_;
    RootSet& out_;
};

/// All roots of @p f on [@p a, @p b].
///
/// A Chebyshev interpolant resolves f to roundoff. Its coefficients c_k decide, and the interval is bisected until each
/// piece is one of these:
/// (1) free of roots: |c_0| > sum |c_k|
/// (2) monotone: the same for the derivative. It has at most one root, decided by the signs at its ends and refined by
/// bracketing on f itself
/// (3) shorter than 2^-44 of the interval with |f| below roundoff: reported as a near-double root with its width
///
/// (1) and (2) are proofs under a premise. The interpolant must be within 4 times its last three coefficients (plus
/// roundoff) of f, and its derivative within 16^2 times that. The premise is tested at three further points of each
/// piece. It holds when the coefficients go on falling, as those of an analytic function do once they are small. A
/// feature that leaves no trace at the 20 points of a piece is not seen. Use it for functions that are analytic on [a,
/// b] and near it; for polynomials with stated errors use bernstein_isolate, which proves.
/// @param scale  size of the terms that f is summed from; sets what counts as roundoff of f
///
/// Domain: f smooth on [a, b] (kinks end as (3)). Degenerate: f = 0 on a piece is reported as `vanishes`. Not smooth,
/// or noisier than `scale` says: the work is bounded and `certified` is false. Accuracy: simple roots to the last bits
/// that f supports.
template <class F>
[[nodiscard]] RootSet all_roots(F&& f, double a, double b, double scale)
{
    RootSet found;
    if (!(b > a))
        return found;
    constexpr double smallest_share = 0x1p-44;
    RootIsolation<std::remove_reference_t<F>> isolate(f, scale, (b - a) * smallest_share, found);
    found.evaluations = 2;
    isolate(a, b, f(a), f(b), std::numeric_limits<double>::infinity());
    // two neighbouring undecided pieces are one near-double root
    std::vector<IsolatedRoot> merged;
    for (IsolatedRoot const& root : found.roots) {
        if (root.near_double && !merged.empty() && merged.back().near_double &&
            root.x - merged.back().x <= root.width + merged.back().width) {
            IsolatedRoot& last = merged.back();
            double const low = last.x - last.width / 2;
            double const high = root.x + root.width / 2;
            last = {0.5 * (low + high), high - low, true};
        } else {
            merged.push_back(root);
        }
    }
    found.roots = std::move(merged);
    return found;
}

}  // namespace hdconj::numeric
