// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Double roots of the meshing condition on a curve: f = df/dt = 0, solved in (t, u).
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "hdconj/motion/relative_motion.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj {

/// Two contacts merge at (t, u).
struct DoubleRoot
{
    double t = 0;
    double u = 0;
};

/// Double roots found on a curve, and whether every box was decided.
struct DoubleRoots
{
    std::vector<DoubleRoot> roots;
    bool certified = true;
};

/// All (t, u) in [0,1] x [a,b] with f = f_t = 0.
///
/// Geometrically these are the instants at which the instantaneous centre of rotation crosses the evolute of the curve.
/// Boxes are discarded when the Bernstein coefficients of f or of f_t in t, widened by a Taylor bound in u, keep one sign;
/// small boxes are handed to Newton's method, which must converge near the box.
/// Accuracy: last bits of t and u where the double root is isolated.
template<RelativeMotion Motion>
class DoubleRootSearch
{
  public:
    DoubleRootSearch(CurvePiece const& curve, Motion const& motion, double a, double b)
        : curve_(curve), motion_(motion), a_(a), b_(b)
    {
    }

    [[nodiscard]] DoubleRoots operator()()
    {
        double const step = (b_ - a_) / u_pieces;
        for (int i = 0; i < u_pieces; ++i)
        {
            Box box{0, 1, a_ + i * step, a_ + (i + 1) * step, copy(curve_.a()), copy(curve_.b()), copy(curve_.c())};
            visit(box, 0);
        }
        return std::move(found_);
    }

  private:
    static constexpr int u_pieces = 16;
    static constexpr int deepest = 40;
    static constexpr int newton_from = 8;

    struct Box
    {
        double t0, t1, u0, u1;
        BernsteinWork a, b, c;
    };

    static BernsteinWork copy(std::span<double const> c)
    {
        BernsteinWork w{};
        std::copy(c.begin(), c.end(), w.begin());
        return w;
    }

    [[nodiscard]] std::size_t size() const { return curve_.a().size(); }

    void visit(Box const& box, int depth)
    {
        double const u = 0.5 * (box.u0 + box.u1);
        double const h = 0.5 * (box.u1 - box.u0);
        MotionRates const mid = motion_.rates(u);
        // Lagrange remainder of the linear expansion in u, from the change of the first derivative over the box
        Twist const low = motion_.rates(box.u0).change;
        Twist const high = motion_.rates(box.u1).change;
        double const bend_omega = std::max(std::abs(low.omega - mid.change.omega), std::abs(high.omega - mid.change.omega));
        double const bend_x = std::max(std::abs(low.q.x() - mid.change.q.x()), std::abs(high.q.x() - mid.change.q.x()));
        double const bend_y = std::max(std::abs(low.q.y() - mid.change.q.y()), std::abs(high.q.y() - mid.change.q.y()));
        double f_low = 0, f_high = 0, g_low = 0, g_high = 0;
        double before = 0;
        for (std::size_t i = 0; i < size(); ++i)
        {
            double const f = mid.twist.omega * box.a[i] + mid.twist.q.x() * box.b[i] + mid.twist.q.y() * box.c[i];
            double const slope = mid.change.omega * box.a[i] + mid.change.q.x() * box.b[i] + mid.change.q.y() * box.c[i];
            double const rest = bend_omega * std::abs(box.a[i]) + bend_x * std::abs(box.b[i]) + bend_y * std::abs(box.c[i]);
            double const room = h * (std::abs(slope) + rest);
            f_low = i == 0 ? f - room : std::min(f_low, f - room);
            f_high = i == 0 ? f + room : std::max(f_high, f + room);
            if (i > 0)
            {
                double const g = f - before;
                double const wide = difference_room(box, mid, bend_omega, bend_x, bend_y, i) * h;
                g_low = i == 1 ? g - wide : std::min(g_low, g - wide);
                g_high = i == 1 ? g + wide : std::max(g_high, g + wide);
            }
            before = f;
        }
        if (f_low > 0 || f_high < 0 || g_low > 0 || g_high < 0)
            return;
        if (depth >= newton_from && newton(box))
            return;
        if (depth >= deepest)
        {
            found_.certified = false;
            return;
        }
        split(box, depth);
    }

    [[nodiscard]] double difference_room(Box const& box, MotionRates const& mid, double bend_omega, double bend_x, double bend_y, std::size_t i) const
    {
        double const a = box.a[i] - box.a[i - 1];
        double const b = box.b[i] - box.b[i - 1];
        double const c = box.c[i] - box.c[i - 1];
        return std::abs(mid.change.omega * a + mid.change.q.x() * b + mid.change.q.y() * c)
               + bend_omega * std::abs(a) + bend_x * std::abs(b) + bend_y * std::abs(c);
    }

    void split(Box const& box, int depth)
    {
        if (depth % 2 == 0)
        {
            Box low = box;
            Box high = box;
            double const cut = 0.5;
            bernstein_split({low.a.data(), size()}, {high.a.data(), size()}, cut);
            bernstein_split({low.b.data(), size()}, {high.b.data(), size()}, cut);
            bernstein_split({low.c.data(), size()}, {high.c.data(), size()}, cut);
            low.t1 = high.t0 = 0.5 * (box.t0 + box.t1);
            visit(low, depth + 1);
            visit(high, depth + 1);
        }
        else
        {
            Box low = box;
            Box high = box;
            low.u1 = high.u0 = 0.5 * (box.u0 + box.u1);
            visit(low, depth + 1);
            visit(high, depth + 1);
        }
    }

    /// Newton from the box's centre; true when the box is settled (a root inside or next to it was recorded).
    bool newton(Box const& box)
    {
        double t = 0.5 * (box.t0 + box.t1);
        double u = 0.5 * (box.u0 + box.u1);
        double const reach_t = 2 * (box.t1 - box.t0);
        double const reach_u = 2 * (box.u1 - box.u0);
        double const t_start = t;
        double const u_start = u;
        constexpr int budget = 30;
        for (int k = 0; k < budget; ++k)
        {
            MotionRates const rates = motion_.rates(u);
            auto const combine = [](Twist const& w, double a, double b, double c) { return w.omega * a + w.q.x() * b + w.q.y() * c; };
            auto const [a, a1, a2] = jet(curve_.a(), t);
            auto const [b, b1, b2] = jet(curve_.b(), t);
            auto const [c, c1, c2] = jet(curve_.c(), t);
            Vec2 const residual{combine(rates.twist, a, b, c), combine(rates.twist, a1, b1, c1)};
            Eigen::Matrix2d slope;
            slope << residual.y(), combine(rates.change, a, b, c), combine(rates.twist, a2, b2, c2), combine(rates.change, a1, b1, c1);
            Vec2 const step = slope.fullPivLu().solve(residual);
            if (!step.allFinite())
                return false;
            t -= step.x();
            u -= step.y();
            if (std::abs(t - t_start) > reach_t || std::abs(u - u_start) > reach_u)
                return false;
            if (std::abs(step.x()) <= 16 * unit_roundoff && std::abs(step.y()) <= 16 * unit_roundoff * (b_ - a_))
                return record(t, u, box);
        }
        return false;
    }

    bool record(double t, double u, Box const& box)
    {
        // a root on a common border settles both boxes
        constexpr double border = 0x1p-20;
        double const dt = border * (box.t1 - box.t0);
        double const du = border * (box.u1 - box.u0);
        bool const inside = t >= box.t0 - dt && t <= box.t1 + dt && u >= box.u0 - du && u <= box.u1 + du;
        if (t < 0 || t > 1 || u < a_ || u > b_)
            return inside;
        constexpr double same = 0x1p-30;
        for (DoubleRoot const& root : found_.roots)
            if (std::abs(root.t - t) <= same && std::abs(root.u - u) <= same * (b_ - a_))
                return inside;
        if (inside)
            found_.roots.push_back({t, u});
        return inside;
    }

    struct Jet
    {
        double value, first, second;
    };
    static Jet jet(std::span<double const> c, double t)
    {
        // de Casteljau, stopping twice before the end for the derivatives
        BernsteinWork w{};
        std::copy(c.begin(), c.end(), w.begin());
        std::size_t const n = c.size() - 1;
        Jet j{0, 0, 0};
        for (std::size_t r = n; r > 0; --r)
        {
            if (r == 2)
                j.second = static_cast<double>(n * (n - 1)) * (w[2] - 2 * w[1] + w[0]);
            if (r == 1)
                j.first = static_cast<double>(n) * (w[1] - w[0]);
            for (std::size_t i = 0; i < r; ++i)
                w[i] += t * (w[i + 1] - w[i]);
        }
        j.value = w[0];
        return j;
    }

    CurvePiece const& curve_;
    Motion const& motion_;
    double a_;
    double b_;
    DoubleRoots found_;
};

}  // namespace hdconj
