// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Envelope points by brute force: for a given point of the tooth, all positions where its
/// velocity against the circular spline is perpendicular to its normal. A scan and a bisection on
/// n.v, with v from a difference quotient of the transform itself.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "motion.hpp"
#include "tooth.hpp"

namespace oracle {

/// n.v of the profile point (tooth frame) at position @p s. v is taken in the circular-spline
/// frame, n is turned into it.
template <class T>
T normal_velocity(Motion<T> const& motion, typename Tooth<T>::OnProfile const& on, T const& s)
{
    Pose<T> const pose = motion.pose(s), rate = motion.pose_rate(s);
    Point<T> const v = rate.origin + on.point.x * rate.along + on.point.y * rate.outward;
    Point<T> const n = on.normal.x * pose.along + on.normal.y * pose.outward;
    return dot(n, v);
}

/// Root of @p f in [a, b], where f(a) = fa and f(b) = fb have different signs: each step halves the
/// bracket and then tries to close it around the secant's guess.
template <class T, class F>
T bracketed(F const& f, T a, T fa, T b, T fb, T const& accuracy = std::numeric_limits<T>::epsilon())
{
    using std::abs;
    for (int step = 0; step < 2000; ++step) {
        if (fa == T(0))
            return a;
        if (fb == T(0))
            return b;
        T const width = b - a;
        T const smallest = accuracy * (abs(a) + abs(b));
        if (width <= smallest)
            break;
        // one halving, one secant step guarded by the bracket
        T const middle = a + width / T(2), fm = f(middle);
        if ((fm < T(0)) == (fa < T(0))) {
            a = middle;
            fa = fm;
        } else {
            b = middle;
            fb = fm;
        }
        T const guess = a - fa * (b - a) / (fb - fa);
        for (T const& c : {guess - smallest, guess + smallest}) {
            if (!(c > a && c < b))
                continue;
            T const fc = f(c);
            if ((fc < T(0)) == (fa < T(0))) {
                a = c;
                fa = fc;
            } else {
                b = c;
                fb = fc;
            }
        }
    }
    return a + (b - a) / T(2);
}

/// All positions in one lobe, (-pi/n, pi/n], where the profile point is in contact, found from sign
/// changes between @p scan positions; pairs of roots closer than a step are not promised.
template <class T>
std::vector<T> contact_positions(Motion<T> const& motion, typename Tooth<T>::OnProfile const& on, int scan = 2000)
{
    std::vector<T> found;
    T const half = motion.half_lobe();
    auto const f = [&](T const& s) { return normal_velocity(motion, on, s); };
    // The middle of the lobe is a position of symmetry: start off it.
    T before = -half + half / T(scan) / T(3), value = f(before);
    for (int i = 1; i <= scan; ++i) {
        T const now = -half + half / T(scan) / T(3) + T(2) * half * T(i) / T(scan), next = f(now);
        if ((value < T(0)) != (next < T(0)))
            found.push_back(bracketed(f, before, value, now, next));
        before = now;
        value = next;
    }
    return found;
}

/// One envelope point.
template <class T>
struct EnvelopePoint
{
    std::size_t segment = 0;  ///< in the order left root, tip, right root
    int step = 0;             ///< t = step / steps
    int root = 0;             ///< number of this position among those of the same profile point
    T t{}, u{}, phi{};
    Point<T> point;   ///< circular-spline frame
    Point<T> normal;  ///< of the tooth there, outward, circular-spline frame
};

/// All envelope points of the profile points t = 0, 1/steps, ... 1 of every piece of the whole tooth.
/// Positions are bracketed in double and found in T.
template <class T>
std::vector<EnvelopePoint<T>> envelope_points(hdconj::Scene const& scene, int steps)
{
    Tooth<double> const quick_tooth(scene);
    Motion<double> const quick(scene);
    Tooth<T> const tooth(scene);
    Motion<T> const motion(scene);
    std::vector<EnvelopePoint<T>> found;
    for (std::size_t segment = 0; segment < tooth.pieces_of_whole(); ++segment)
        for (int step = 0; step <= steps; ++step) {
            T const t = T(step) / T(steps);
            auto const on = tooth.on_whole(segment, t);
            auto const f = [&](T const& s) { return normal_velocity(motion, on, s); };
            int root = 0;
            for (double const near : contact_positions(quick, quick_tooth.on_whole(segment, static_cast<double>(t)))) {
                // Wide enough for the error of the double root, unless two roots nearly merge.
                T a, b, fa, fb;
                for (double width = 1e-9;; width *= 10) {
                    a = T(near - width);
                    b = T(near + width);
                    fa = f(a);
                    fb = f(b);
                    if ((fa < T(0)) != (fb < T(0)))
                        break;
                    if (width > 1e-3)
                        throw std::runtime_error("oracle: lost a root between number types");
                }
                using std::pow;
                T const s = bracketed(f, a, fa, b, fb, T(pow(std::numeric_limits<T>::epsilon(), T(3) / T(4))));
                auto const pose = motion.pose(s);
                found.push_back({segment, step, root++, t, motion.u(s), motion.phi(s),
                                 pose.to_circular_spline(on.point),
                                 on.normal.x * pose.along + on.normal.y * pose.outward});
            }
        }
    return found;
}

}  // namespace oracle
