// SPDX-License-Identifier: GPL-3.0-or-later
// The instants at which the set of contacts on a piece changes: a contact crosses an end, or two merge.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/envelope/contact.hpp"
#include "hdconj/envelope/double_roots.hpp"
#include "hdconj/envelope/smooth_ranges.hpp"
#include "hdconj/motion/rates_model.hpp"
#include "hdconj/numeric/bernstein_roots.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj::envelope {

/// Something happens to the contacts of a piece at u, at local parameter t.
struct CriticalAngle
{
    double u = 0;
    double t = 0;  ///< 0, 1: a contact crosses that end; else two contacts merge here
    bool merge = false;
    int change = 0;    ///< contacts after u less those before: +-1 at an end, +-2 at a merge; 0: not known
    double doubt = 0;  ///< how far from u a merge may be
};

/// Sign of df/dt at an end of a piece, 0 where rounding hides it; known for curves only.
[[nodiscard]] inline int slope_at_end(profile::PieceShape const& shape, PlanarVelocity const& twist, double t)
{
    auto const* curve = std::get_if<profile::CurvePiece>(&shape);
    if (curve == nullptr)
        return 0;
    numeric::BernsteinWork f{};
    std::size_t const size = curve->a().size();
    double const noise = meshing_polynomial(*curve, twist, {f.data(), size});
    std::size_t const inner = t == 0 ? 1 : size - 2;
    std::size_t const end = t == 0 ? 0 : size - 1;
    double const rise = (f[inner] - f[end]) * (t == 0 ? 1 : -1);
    return rise > 2 * noise ? 1 : rise < -2 * noise ? -1 : 0;
}

/// Instants in (a, b) at which a contact crosses an end of @p shape: all roots in u of f(t_end, u) = n_end . v(x_end,
/// u).
///
/// On each panel of @p rates this is a Bernstein polynomial with a stated error. Its roots are isolated as in
/// bernstein_roots, across panels, and refined on the motion itself. At a near-double root a contact touches the end
/// and turns back, or crosses it for a time that rounding hides. Such a place is recorded as undecided.
/// @param piece  number of the piece, for the record
template <motion::RelativeMotion Motion>
void end_crossings(profile::PieceShape const& shape, int piece, Motion const& motion, motion::RatesModel const& rates,
                   double a, double b, std::vector<CriticalAngle>& out, TraceRecord& record)
{
    auto const crossings = [&](profile::PieceEnd const& end, double t) {
        // on a corner or arc the centre moves, not the point: the same value, since the arc turns about its centre
        auto const f = [&](double u) {
            ++record.evaluations;
            return end.normal.dot(motion.rates(u).twist(end.point));
        };
        auto const take = [&](numeric::RootCluster const& cluster) {
            ++record.roots;
            double u = 0.5 * (cluster.lo + cluster.hi);
            if (cluster.near_double) {
                double const width = cluster.hi - cluster.lo;
                record.doubts.push_back(
                    {piece, t, u, width, cluster.size * width, "a contact touches the end of a profile piece"});
                if (cluster.left == cluster.right || cluster.left == 0 || cluster.right == 0)
                    return;
            } else {
                u = numeric::root_in(cluster, f);
            }
            if (!(u > a && u < b))
                return;
            int const slope = slope_at_end(shape, motion.rates(u).twist, t);
            int const after = cluster.right != 0 ? cluster.right : -cluster.left;
            out.push_back({u, t, false, t == 0 ? -after * slope : after * slope});
        };
        numeric::RootClusters<decltype(take)> clusters(take);
        double const along = cross(end.point, end.normal);  // n_x y - n_y x with the sign of theta'
        double const across = std::abs(end.normal.x()) + std::abs(end.normal.y());
        for (motion::RatesPanel const& panel : rates.panels) {
            if (!(panel.u1 > a && panel.u0 < b))
                continue;
            motion::RatesVector c = -along * panel.omega + end.normal.x() * panel.q_x + end.normal.y() * panel.q_y;
            double const size = end.point.norm() * panel.omega.cwiseAbs().maxCoeff() + panel.q_x.cwiseAbs().maxCoeff() +
                                panel.q_y.cwiseAbs().maxCoeff();
            double const noise =
                std::abs(along) * panel.omega_error + across * panel.q_error + 4 * unit_roundoff * size;
            double const slope_noise = std::abs(along) * panel.omega_slope + across * panel.q_slope;
            numeric::bernstein_isolate(std::span<double>(c.data(), motion::rates_coefficients), panel.u0, panel.u1,
                                       noise, slope_noise, clusters);
        }
        clusters.finish();
    };
    crossings(profile::start_of(shape), 0);
    crossings(profile::end_of(shape), 1);
}

/// The instant of @p merge where one of its contacts crosses an end of the curve beside it: not before that contact has
/// come in, nor after it has left, which rounding may say where both are as good as one. Nothing where none does.
[[nodiscard]] inline std::optional<double> instant_beside_end(DoubleRoot const& merge,
                                                              std::vector<CriticalAngle> const& crossings)
{
    constexpr double beside = 0x1p-8;
    double const end = merge.t < 0.5 ? 0 : 1;
    if (!merge.separated || std::abs(merge.t - end) > beside)
        return std::nullopt;
    for (CriticalAngle const& crossing : crossings)
        if (!crossing.merge && crossing.t == end && crossing.change * merge.change < 0 &&
            std::abs(crossing.u - merge.u) <= 0.5 * merge.u_width)
            return merge.change < 0 ? std::max(merge.u, crossing.u) : std::min(merge.u, crossing.u);
    return std::nullopt;
}

/// All critical angles of a piece in (a, b), increasing. On curves those a rounding apart get the same u, in their
/// order.
template <motion::RelativeMotion Motion>
[[nodiscard]] std::vector<CriticalAngle> critical_angles(profile::PieceShape const& shape, int piece,
                                                         Motion const& motion, motion::RatesModel const& rates,
                                                         double a, double b, TraceRecord& record)
{
    std::vector<CriticalAngle> found;
    end_crossings(shape, piece, motion, rates, a, b, found, record);
    if (auto const* curve = std::get_if<profile::CurvePiece>(&shape)) {
        DoubleRoots const merges = DoubleRootSearch(*curve, rates, a, b)();
        for (DoubleRoot const& root : merges.at_ends)
            if (auto const u = instant_beside_end(root, found))
                found.push_back({*u, root.t, true, root.change, 0.5 * root.u_width});
        for (DoubleRoot const& root : merges.roots) {
            if (!root.separated)
                record.doubts.push_back({piece, root.t, root.u, root.u_width,
                                         root.size / curve->first(root.t).norm() * root.u_width,
                                         "contacts merge, or nearly merge, in more than one point"});
            found.push_back(
                {instant_beside_end(root, found).value_or(root.u), root.t, true, root.change, 0.5 * root.u_width});
        }
        record.roots += merges.roots.size();
    }
    // at the same instant contacts appear before others vanish
    std::stable_sort(found.begin(), found.end(), [](CriticalAngle const& x, CriticalAngle const& y) {
        return x.u != y.u ? x.u < y.u : x.change > y.change;
    });
    // no contact can be followed between instants that are a rounding apart; one on an arc that has just that time to
    // run from end to end is a matter of its own
    if (std::holds_alternative<profile::CurvePiece>(shape)) {
        for (std::size_t i = 1; i < found.size(); ++i)
            if (same_instant(found[i - 1].u, found[i].u))
                found[i].u = found[i - 1].u;
    }
    return found;
}

/// A smooth range of the motion, cut where the contacts of one piece change. Between two neighbouring cuts the number
/// of contacts is constant and each is a smooth function of u.
struct CutRange
{
    CutRange(SmoothRange const& whole, std::vector<CriticalAngle> events) : range(whole), critical(std::move(events))
    {
        cuts.push_back(range.a);
        for (CriticalAngle const& c : critical)
            cuts.push_back(c.u);
        cuts.push_back(range.b);
    }

    /// Why an arc begins, or ends, with the range.
    [[nodiscard]] BranchEnd at_begin() const { return range.from_break ? BranchEnd::continues : BranchEnd::range_end; }
    [[nodiscard]] BranchEnd at_end() const { return range.to_break ? BranchEnd::continues : BranchEnd::range_end; }

    SmoothRange range;
    std::vector<CriticalAngle> critical;  ///< in order; cuts[i + 1] is the angle of critical[i]
    std::vector<double> cuts;
};

}  // namespace hdconj::envelope
