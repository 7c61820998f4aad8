// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces a tooth profile is made of. A tooth is traversed from its left root over the tip to its right root,
// so that the outward normal is the tangent turned by +90 degrees.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/base/vec2.hpp"
#include "hdconj/numeric/bernstein.hpp"

namespace hdconj::profile {

/// Straight piece from a to b.
struct LinePiece
{
    Vec2 a = Vec2::Zero();
    Vec2 b = Vec2::Zero();

    [[nodiscard]] double length() const { return (b - a).norm(); }
    [[nodiscard]] Vec2 tangent() const { return (b - a).normalized(); }
    [[nodiscard]] Vec2 normal() const { return left_of(tangent()); }
};

/// Circular arc: points centre + radius n, where the outward normal n turns from angle `from` to angle `to`. A radius >
/// 0 is convex (angles fall), a radius < 0 concave (angles rise). A radius of 0 is a convex corner with its cone of
/// normals.
struct ArcPiece
{
    Vec2 centre = Vec2::Zero();
    double radius = 0;
    double from = 0;  ///< [rad], counter-clockwise from +x
    double to = 0;

    [[nodiscard]] double length() const { return std::abs(radius) * std::abs(to - from); }
};

/// Polynomial curve x(t), t in [0, 1], in Bernstein form, with the three functions of t in its meshing condition:
///   f(t, u) = theta'(u) A(t) + q_x(u) B(t) + q_y(u) C(t)
/// Here (B, C) = N = x' turned by +90 degrees, and A = N_x y - N_y x = -x.x'.
class CurvePiece
{
  public:
    CurvePiece(std::vector<double> x, std::vector<double> y);

    [[nodiscard]] Vec2 point(double t) const
    {
        return {numeric::bernstein_value(x_, t), numeric::bernstein_value(y_, t)};
    }
    [[nodiscard]] Vec2 first(double t) const
    {
        return {numeric::bernstein_value(x1_, t), numeric::bernstein_value(y1_, t)};
    }
    [[nodiscard]] Vec2 second(double t) const
    {
        return {numeric::bernstein_value(x2_, t), numeric::bernstein_value(y2_, t)};
    }
    [[nodiscard]] std::span<double const> a() const { return a_; }
    [[nodiscard]] std::span<double const> b() const { return b_; }
    [[nodiscard]] std::span<double const> c() const { return c_; }
    /// Largest rounding error of a coefficient of A and of B and C, against the polynomials that x and y are exactly.
    [[nodiscard]] double a_error() const { return a_error_; }
    [[nodiscard]] double b_error() const { return b_error_; }
    [[nodiscard]] std::vector<double> const& x() const { return x_; }
    [[nodiscard]] std::vector<double> const& y() const { return y_; }

  private:
    std::vector<double> x_, y_, x1_, y1_, x2_, y2_, a_, b_, c_;
    double a_error_ = 0;
    double b_error_ = 0;
};

inline CurvePiece::CurvePiece(std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)),
      y_(std::move(y)),
      x1_(numeric::bernstein_derivative(x_)),
      y1_(numeric::bernstein_derivative(y_)),
      x2_(numeric::bernstein_derivative(x1_)),
      y2_(numeric::bernstein_derivative(y1_))
{
    std::vector<double> const xx = numeric::bernstein_product(x_, x1_);
    std::vector<double> const yy = numeric::bernstein_product(y_, y1_);
    std::size_t const degree = xx.size() - 1;
    a_.resize(xx.size());
    for (std::size_t i = 0; i < xx.size(); ++i)
        a_[i] = -xx[i] - yy[i];
    b_ = numeric::bernstein_raised(y1_, degree);
    for (double& value : b_)
        value = -value;
    c_ = numeric::bernstein_raised(x1_, degree);
    // each product is a convex sum of n terms whose factors are right to 3 roundings; raising rounds three times a
    // degree
    auto const largest = [](std::vector<double> const& v) {
        return std::abs(
            *std::max_element(v.begin(), v.end(), [](double p, double q) { return std::abs(p) < std::abs(q); }));
    };
    double const slope = largest(x1_) + largest(y1_);
    auto const n = static_cast<double>(x_.size());
    a_error_ = (3 * n + 8) * unit_roundoff * (largest(x_) * largest(x1_) + largest(y_) * largest(y1_));
    b_error_ = (3 * n + 3) * unit_roundoff * slope;
}

}  // namespace hdconj::profile
