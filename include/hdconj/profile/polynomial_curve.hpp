// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth curve given by a formula, as polynomial pieces that the envelope solver takes.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hdconj/error.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj::profile {

/// Degree of the pieces: the meshing condition then has degree 2 * 9 - 1 = 17 of the 23 that Bernstein work arrays
/// hold.
inline constexpr int polynomial_curve_degree = 9;

/// Point and derivative of a curve at one value of its parameter.
struct CurveJet
{
    Vec2 point;
    Vec2 slope;
};

inline constexpr int inner_nodes = polynomial_curve_degree - 3;

/// B_i^n(t) for all i.
[[nodiscard]] inline Eigen::Matrix<double, polynomial_curve_degree + 1, 1> bernstein_basis(double t)
{
    Eigen::Matrix<double, polynomial_curve_degree + 1, 1> b;
    b.setZero();
    b[0] = 1;
    for (int n = 1; n <= polynomial_curve_degree; ++n) {
        for (int i = n; i >= 1; --i)
            b[i] = (1 - t) * b[i] + t * b[i - 1];
        b[0] *= 1 - t;
    }
    return b;
}

/// Chebyshev points of (0, 1), increasing.
[[nodiscard]] inline double inner_node(int j)
{
    return 0.5 * (1 - std::cos(std::numbers::pi * (j + 1) / (inner_nodes + 1)));
}

/// The polynomial with the curve's end points and end derivatives that passes through the curve at the inner nodes.
template <class F>
[[nodiscard]] CurvePiece hermite_interpolant(F&& curve, double from, double to)
{
    using Square = Eigen::Matrix<double, inner_nodes, inner_nodes>;
    static Eigen::FullPivLU<Square> const solver = [] {
        Square m;
        for (int j = 0; j < inner_nodes; ++j)
            m.row(j) = bernstein_basis(inner_node(j)).template segment<inner_nodes>(2).transpose();
        return Eigen::FullPivLU<Square>(m);
    }();
    CurveJet const begin = curve(from);
    CurveJet const end = curve(to);
    double const third = (to - from) / polynomial_curve_degree;
    // measured from the first point: what is left is as small as the piece, and so is its rounding
    Eigen::Matrix<double, polynomial_curve_degree + 1, 2> c;
    c.setZero();
    c.row(1) = third * begin.slope.transpose();
    c.row(polynomial_curve_degree - 1) = (end.point - begin.point - third * end.slope).transpose();
    c.row(polynomial_curve_degree) = (end.point - begin.point).transpose();
    Eigen::Matrix<double, inner_nodes, 2> right;
    for (int j = 0; j < inner_nodes; ++j) {
        double const t = inner_node(j);
        Vec2 const wanted = curve(from + t * (to - from)).point - begin.point;
        right.row(j) = wanted.transpose() - bernstein_basis(t).transpose() * c;
    }
    c.template middleRows<inner_nodes>(2) = solver.solve(right);
    std::vector<double> x, y;
    for (int i = 0; i <= polynomial_curve_degree; ++i) {
        bool const last = i == polynomial_curve_degree;
        x.push_back(last ? end.point.x() : begin.point.x() + c(i, 0));
        y.push_back(last ? end.point.y() : begin.point.y() + c(i, 1));
    }
    return {std::move(x), std::move(y)};
}

/// Pieces of degree 9 for the curve s -> @p curve(s), s running from @p from to @p to (in either direction).
///
/// Each piece has the curve's points and derivatives at its ends, so joints are continuous to the last bit and share
/// their tangent to roundoff. Between the ends it passes through the curve at six Chebyshev points. Intervals are
/// halved until the piece is within @p accuracy [mm] of the curve, parameter for parameter, at 23 more points. Domain:
/// analytic curve with a derivative that does not vanish. The error falls with the tenth power of the interval.
/// @throws NumericalError when 12 halvings are not enough: the curve is not smooth, or @p accuracy is below its
/// rounding
template <class F>
[[nodiscard]] std::vector<CurvePiece> polynomial_curve(F&& curve, double from, double to, double accuracy,
                                                       int halvings = 12)
{
    CurvePiece piece = hermite_interpolant(curve, from, to);
    constexpr int probes = 23;
    double worst = 0;
    for (int i = 1; i <= probes; ++i) {
        double const t = static_cast<double>(i) / (probes + 1);
        worst = std::max(worst, (piece.point(t) - curve(from + t * (to - from)).point).norm());
    }
    if (worst <= accuracy)
        return {std::move(piece)};
    if (halvings == 0)
        throw NumericalError(ErrorCode::not_smooth, "profile", "polynomial pieces of a curve",
                             "the curve is not smooth enough for the accuracy asked for");
    double const middle = 0.5 * (from + to);
    std::vector<CurvePiece> pieces = polynomial_curve(curve, from, middle, accuracy, halvings - 1);
    for (CurvePiece& next : polynomial_curve(curve, middle, to, accuracy, halvings - 1))
        pieces.push_back(std::move(next));
    return pieces;
}

/// Accuracy of curve pieces as a fraction of the tooth's height.
inline constexpr double curve_accuracy = 0x1p-47;  // 7e-15: some tens of roundings of the height itself

}  // namespace hdconj::profile
