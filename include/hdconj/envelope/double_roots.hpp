// SPDX-License-Identifier: GPL-3.0-or-later
// Double roots of the meshing condition on a curve: f = df/dt = 0, solved in (t, u).
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "hdconj/envelope/meshing_patch.hpp"

namespace hdconj::envelope {

/// Two contacts merge at (t, u); or a box in which that was not decided.
struct DoubleRoot
{
    double t = 0;
    double u = 0;
    double t_width = 0;  ///< the point lies within t +- t_width/2 and u +- u_width/2, whatever the rounding
    double u_width = 0;
    int change = 0;   ///< +2: two contacts appear as u grows, -2: they vanish; 0: not known
    double size = 0;  ///< not separated: largest |f| in the box
    bool separated =
        true;  ///< false: no point, one or several (three contacts merging, a merge that parts again at once)
};

/// Double roots of a curve, and what the search took.
struct DoubleRoots
{
    std::vector<DoubleRoot> roots;
    std::vector<DoubleRoot> at_ends;  ///< no farther from an end of the curve than their width: inside or beyond it
    std::size_t boxes = 0;

    [[nodiscard]] bool certified() const
    {
        return std::all_of(roots.begin(), roots.end(), [](DoubleRoot const& root) { return root.separated; });
    }
};

/// All (t, u) in [0, 1] x [a, b] with f = f_t = 0. Geometrically these are the instants at which the instantaneous
/// centre of rotation crosses the evolute of the curve.
///
/// F = (f, f_t) is a tensor-product Bernstein polynomial to a stated error e. A box is empty if the coefficients of f,
/// or of f_t, widened by the error, do not contain zero. Let J be the Jacobian of F, X' the box X widened by an eighth,
/// and Y the inverse of the middle of J over X'. The ranges of the coefficients give E >= |1 - Y J| on X'; its row sums
/// must be below q < 1. By the mean value theorem every zero x in X of any function within e satisfies, for any z in
/// X',
///   |x - z| <= (1 - E)^-1 |Y| (|F(z)| + e)                                    (1)
/// So X' holds at most one zero; z is what Newton's method gives. Where the box (1) about z lies inside X' the zero
/// exists (Brouwer). Where it misses X, X is empty. Otherwise X is cut across the direction in which F varies more.
///
/// A box in which F stays within five times its error, or varies by less than it, is not cut further. It and its
/// neighbours are reported as one root that is not separated. At most `budget` boxes are examined; what is left then is
/// reported in the same way. Merges within rounding of an end of the curve are a list of their own: there one contact
/// crosses the end, and that is solved for. Accuracy: (1), stated with each root. Domain: the errors are those of the
/// RatesModel.
class DoubleRootSearch
{
  public:
    DoubleRootSearch(profile::CurvePiece const& curve, motion::RatesModel const& rates, double a, double b)
        : curve_(curve), rates_(rates), a_(a), b_(b)
    {
    }

    [[nodiscard]] DoubleRoots operator()()
    {
        for (motion::RatesPanel const& panel : rates_.panels)
            if (panel.u1 > a_ && panel.u0 < b_)
                visit(MeshingPatch(curve_, panel));
        std::sort(found_.roots.begin(), found_.roots.end(),
                  [](DoubleRoot const& x, DoubleRoot const& y) { return x.u < y.u; });
        return std::move(found_);
    }

  private:
    static constexpr std::size_t budget = 4096;
    static constexpr double indistinct = 4;

    void visit(MeshingPatch const& box)
    {
        ++found_.boxes;
        Range const f = box.value();
        if (!f.holds_zero())
            return;
        Range const f_t = box.by_t();
        if (!f_t.holds_zero())
            return;
        Range const f_u = box.by_u();
        Range const f_tt = box.by_tt();
        Range const f_tu = box.by_tu();
        if (settled(box, f_t, f_u, f_tt, f_tu))
            return;
        bool const in_noise =
            f.largest() <= (indistinct + 1) * f.noise && f_t.largest() <= (indistinct + 1) * f_t.noise;
        double const smallest = 4 * unit_roundoff;
        bool const wide_t = box.t1 - box.t0 > smallest;
        bool const wide_u = box.u1 - box.u0 > smallest * std::max(std::abs(a_), std::abs(b_));
        // how much each of the two conditions varies, in units of its error
        double const along_t = std::max(f_t.beyond_noise() / f.noise, f_tt.beyond_noise() / f_t.noise);
        double const along_u = std::max(f_u.beyond_noise() / f.noise, f_tu.beyond_noise() / f_t.noise);
        // cutting helps only while F varies by more than its error
        if (in_noise || std::max(along_t, along_u) < 1 || found_.boxes >= budget || !(wide_t || wide_u))
            return not_separated(box);
        constexpr double half = 0.5;
        if (wide_t && (along_t >= along_u || !wide_u)) {
            visit(box.part_in_t(0, half));
            visit(box.part_in_t(half, 1));
        } else {
            visit(box.part_in_u(0, half));
            visit(box.part_in_u(half, 1));
        }
    }

    /// |1 - Y J| bounded entry by entry over a box, with Y the inverse of the middle of J.
    struct Contraction
    {
        Eigen::Matrix2d inverse = Eigen::Matrix2d::Zero();
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();

        [[nodiscard]] double factor() const { return excess.rowwise().sum().maxCoeff(); }
    };
    [[nodiscard]] static std::optional<Contraction> contraction(Range const& f_t, Range const& f_u, Range const& f_tt,
                                                                Range const& f_tu)
    {
        Eigen::Matrix2d middle, radius;
        middle << f_t.middle(), f_u.middle(), f_tt.middle(), f_tu.middle();
        radius << f_t.radius(), f_u.radius(), f_tt.radius(), f_tu.radius();
        Contraction c;
        bool invertible = false;
        middle.computeInverseWithCheck(c.inverse, invertible, 0.0);
        if (!invertible || !c.inverse.allFinite())
            return std::nullopt;
        // the inverse itself is rounded
        Eigen::Matrix2d const rounding = (Eigen::Matrix2d::Identity() - c.inverse * middle).cwiseAbs();
        c.excess = c.inverse.cwiseAbs() * radius + rounding;
        return c;
    }

    /// Whether (1) proves the box empty or finds its only zero.
    bool settled(MeshingPatch const& box, Range const& f_t, Range const& f_u, Range const& f_tt, Range const& f_tu)
    {
        constexpr double worth_trying = 0.5;
        constexpr double enough = 0.75;
        std::optional<Contraction> c = contraction(f_t, f_u, f_tt, f_tu);
        if (!c || c->factor() > worth_trying)
            return false;
        constexpr double margin = 0.125;
        MeshingPatch const wide = box.part_in_t(-margin, 1 + margin).part_in_u(-margin, 1 + margin);
        c = contraction(wide.by_t(), wide.by_u(), wide.by_tt(), wide.by_tu());
        if (!c || c->factor() > enough)
            return false;
        // Newton's method in the coordinates of `wide`, in which the box is the part between rim and 1 - rim
        constexpr double rim = margin / (1 + 2 * margin);
        Eigen::Vector2d const error(wide.noise, 2 * wide.degree_t() * wide.noise);
        Eigen::Matrix2d const spread = (Eigen::Matrix2d::Identity() - c->excess).inverse();
        Eigen::Vector2d z(0.5, 0.5);
        Eigen::Vector2d reach(1, 1);
        constexpr int steps = 40;
        for (int k = 0; k < steps; ++k) {
            MeshingPatch::Jet const j = wide.jet(z.x(), z.y());
            Eigen::Vector2d const value(j.f, j.s);
            reach = spread * (c->inverse.cwiseAbs() * (value.cwiseAbs() + error));
            // every zero of the box lies within `reach` of z: the box may be empty already
            if (((z - reach).array() > 1 - rim).any() || ((z + reach).array() < rim).any())
                return true;
            Eigen::Vector2d const step = c->inverse * value;
            Eigen::Vector2d const next = (z - step).cwiseMax(0.0).cwiseMin(1.0);
            bool const stands = (next - z).cwiseAbs().maxCoeff() <= 2 * unit_roundoff;
            z = next;
            if (stands)
                break;
        }
        if (((z - reach).array() < 0).any() || ((z + reach).array() > 1).any())
            return false;
        // f = f_u du + f_tt dt^2/2: both factors are certain, since their product is the determinant of J there
        MeshingPatch::Jet const at = wide.jet(z.x(), z.y());
        bool const appears = (at.r > 0) != (at.ss > 0);
        double const wide_t = wide.t1 - wide.t0;
        double const wide_u = wide.u1 - wide.u0;
        record({wide.t0 + z.x() * wide_t, wide.u0 + z.y() * wide_u, 2 * reach.x() * wide_t, 2 * reach.y() * wide_u,
                appears ? 2 : -2, 0, true});
        return true;
    }

    void record(DoubleRoot const& root)
    {
        double const t = 0.5 * root.t_width;
        if (root.u <= a_ || root.u >= b_)
            return;
        std::vector<DoubleRoot>& roots = root.t <= t || root.t >= 1 - t ? found_.at_ends : found_.roots;
        // the neighbour of a box finds the same root on their common border
        for (DoubleRoot const& other : roots)
            if (other.separated && std::abs(other.t - root.t) <= t + 0.5 * other.t_width &&
                std::abs(other.u - root.u) <= 0.5 * (root.u_width + other.u_width))
                return;
        roots.push_back(root);
    }

    void not_separated(MeshingPatch const& box)
    {
        double t0 = box.t0, t1 = box.t1, u0 = std::max(a_, box.u0), u1 = std::min(b_, box.u1);
        if (!(u1 >= u0))
            return;
        double size = box.value().largest();
        // boxes that touch are one
        std::vector<DoubleRoot>& roots = found_.roots;
        for (std::size_t i = 0; i < roots.size();) {
            DoubleRoot const& other = roots[i];
            bool const apart = other.separated ||
                               std::abs(other.t - 0.5 * (t0 + t1)) > 0.5 * (other.t_width + t1 - t0) ||
                               std::abs(other.u - 0.5 * (u0 + u1)) > 0.5 * (other.u_width + u1 - u0);
            if (apart) {
                ++i;
                continue;
            }
            t0 = std::min(t0, other.t - 0.5 * other.t_width);
            t1 = std::max(t1, other.t + 0.5 * other.t_width);
            u0 = std::min(u0, other.u - 0.5 * other.u_width);
            u1 = std::max(u1, other.u + 0.5 * other.u_width);
            size = std::max(size, other.size);
            roots.erase(roots.begin() + static_cast<std::ptrdiff_t>(i));
            i = 0;
        }
        roots.push_back({0.5 * (t0 + t1), 0.5 * (u0 + u1), t1 - t0, u1 - u0, 0, size, false});
    }

    profile::CurvePiece const& curve_;
    motion::RatesModel const& rates_;
    double a_;
    double b_;
    DoubleRoots found_;
};

}  // namespace hdconj::envelope
