// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The instants at which the set of contacts on a piece changes: a contact crosses an end, or two merge.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "hdconj/envelope/branch.hpp"
#include "hdconj/envelope/double_roots.hpp"
#include "hdconj/numeric/all_roots.hpp"
#include "hdconj/profile/profile.hpp"

namespace hdconj {

/// Something happens to the contacts of a piece at u, at local parameter t.
struct CriticalAngle
{
    double u = 0;
    double t = 0;        ///< 0, 1: a contact crosses that end; else two contacts merge here
    bool merge = false;
};

/// Instants in (a, b) at which a contact crosses an end of @p shape: all roots in u of f(t_end, u) = n_end . v(x_end, u).
/// A near-double root is a contact that touches the end and turns back within roundoff: nothing changes there.
template<RelativeMotion Motion>
void end_crossings(PieceShape const& shape, Motion const& motion, double a, double b, std::vector<CriticalAngle>& out,
                   TraceRecord& record)
{
    auto const crossings = [&](PieceEnd const& end, double t) {
        // on a corner or arc the centre moves, not the point: the same value, since the arc turns about its centre
        auto const f = [&](double u) { return end.normal.dot(motion.rates(u).twist(end.point)); };
        double scale = 0;
        constexpr int probes = 8;
        for (int i = 0; i <= probes; ++i)
        {
            scale = std::max(scale, motion.rates(a + (b - a) * i / probes).velocity_size(end.point));
        }
        RootSet const roots = all_roots(f, a, b, scale);
        record.evaluations += roots.evaluations;
        record.certified = record.certified && roots.certified;
        if (roots.vanishes)
            record.doubts.push_back("the meshing condition vanishes at a profile joint over an interval");
        for (IsolatedRoot const& root : roots.roots)
        {
            ++record.roots;
            if (!root.near_double && root.x > a && root.x < b)
                out.push_back({root.x, t, false});
        }
    };
    crossings(start_of(shape), 0);
    crossings(end_of(shape), 1);
}

/// All critical angles of a piece in (a, b), increasing.
template<RelativeMotion Motion>
[[nodiscard]] std::vector<CriticalAngle> critical_angles(PieceShape const& shape, Motion const& motion, double a, double b,
                                                         TraceRecord& record)
{
    std::vector<CriticalAngle> found;
    end_crossings(shape, motion, a, b, found, record);
    if (auto const* curve = std::get_if<CurvePiece>(&shape))
    {
        DoubleRoots const merges = DoubleRootSearch<Motion>(*curve, motion, a, b)();
        record.certified = record.certified && merges.certified;
        if (!merges.certified)
            record.doubts.push_back("double roots on a curve were not all isolated");
        for (DoubleRoot const& root : merges.roots)
            found.push_back({root.u, root.t, true});
        record.roots += merges.roots.size();
    }
    std::sort(found.begin(), found.end(), [](CriticalAngle const& x, CriticalAngle const& y) { return x.u < y.u; });
    return found;
}

}  // namespace hdconj
