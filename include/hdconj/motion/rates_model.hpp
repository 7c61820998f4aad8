// SPDX-License-Identifier: GPL-3.0-or-later
// The velocity of the tooth as piecewise polynomials of the motion's parameter, with stated errors.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "hdconj/base/tolerance.hpp"
#include "hdconj/motion/relative_motion.hpp"

namespace hdconj::motion {

/// Degree of the model in u: with it a lobe takes about ten panels.
inline constexpr int rates_degree = 12;
inline constexpr int rates_coefficients = rates_degree + 1;
using RatesVector = Eigen::Matrix<double, rates_coefficients, 1>;

/// theta', q_x, q_y on u0 <= u <= u1 as Bernstein polynomials of s = (u - u0)/(u1 - u0).
struct RatesPanel
{
    double u0 = 0;
    double u1 = 0;
    RatesVector omega, q_x, q_y;
    double omega_error = 0;  ///< |theta' - model|, rounding of the rates themselves included
    double q_error = 0;      ///< the same for q_x and for q_y [mm]
    double omega_slope = 0;  ///< |d/ds (theta' - model)|
    double q_slope = 0;
};

/// Panels in increasing order, without gaps.
struct RatesModel
{
    std::vector<RatesPanel> panels;
    bool resolved = true;  ///< false: on some panel the rates are not smooth enough for the errors to be known
};

/// Fixed matrices of the model: from values at the Chebyshev nodes to both kinds of coefficients, and from Bernstein
/// coefficients to values and slopes half-way between the nodes.
struct RatesTransform
{
    using Square = Eigen::Matrix<double, rates_coefficients, rates_coefficients>;
    using Check = Eigen::Matrix<double, rates_degree, rates_coefficients>;
    RatesVector node;  ///< in 0 ... 1, increasing
    Eigen::Matrix<double, rates_degree, 1> between;
    Square chebyshev;
    Square bernstein;  ///< from Chebyshev coefficients
    Check value, slope;

    [[nodiscard]] static RatesTransform const& get()
    {
        static RatesTransform const transform;
        return transform;
    }

  private:
    RatesTransform()
    {
        constexpr int n = rates_degree;
        auto const place = [](double j) { return 0.5 * (1 - std::cos(std::numbers::pi * j / n)); };
        auto const binomial = [](int m, int k) {
            double result = 1;
            for (double i = 0; i < k; ++i)
                result = result * (m - i) / (i + 1);
            return result;
        };
        for (int j = 0; j <= n; ++j)
            node[j] = place(j);
        for (int j = 0; j < n; ++j)
            between[j] = place(j + 0.5);
        for (int k = 0; k <= n; ++k) {
            for (int j = 0; j <= n; ++j) {
                double const half = (j == 0 || j == n ? 0.5 : 1.0) * (k == 0 || k == n ? 0.5 : 1.0);
                // nodes increase, so that T_k has the sign (-1)^k at the first
                chebyshev(k, j) = 2 * half / n * std::cos(std::numbers::pi * k * (n - j) / n);
            }
        }
        // T_k has the Bernstein coefficients (-1)^(k-i) C(2k, 2i)/C(k, i) at its own degree; raised to degree n
        for (int k = 0; k <= n; ++k) {
            for (int i = 0; i <= n; ++i) {
                double sum = 0;
                for (int l = std::max(0, i - (n - k)); l <= std::min(k, i); ++l)
                    sum += ((k - l) % 2 == 0 ? 1 : -1) * binomial(2 * k, 2 * l) * binomial(n - k, i - l);
                bernstein(i, k) = sum / binomial(n, i);
            }
        }
        auto const basis = [&](int m, int i, double s) {
            return i < 0 || i > m ? 0.0 : binomial(m, i) * std::pow(s, i) * std::pow(1 - s, m - i);
        };
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i <= n; ++i) {
                value(j, i) = basis(n, i, between[j]);
                slope(j, i) = n * (basis(n - 1, i - 1, between[j]) - basis(n - 1, i, between[j]));
            }
        }
    }
};

/// Builds panels by halving.
template <RelativeMotion Motion>
class RatesFit
{
  public:
    RatesFit(Motion const& motion, RatesModel& out) : motion_(motion), out_(out) {}

    void operator()(double a, double b, int depth)
    {
        auto const& fixed = RatesTransform::get();
        Eigen::Matrix<double, rates_coefficients, 3> values;
        double omega_size = 0;
        double q_size = 0;
        for (int j = 0; j <= rates_degree; ++j) {
            MotionRates const r = motion_.rates(a + fixed.node[j] * (b - a));
            values.row(j) << r.twist.omega, r.twist.q.x(), r.twist.q.y();
            omega_size = std::max(omega_size, r.omega_size);
            q_size = std::max(q_size, r.q_size);
        }
        Eigen::Matrix<double, rates_coefficients, 3> c = fixed.chebyshev * values;
        // a smooth function's coefficients fall at least fourfold per degree once they are this small
        Eigen::Vector3d const tail = c.bottomRows<2>().cwiseAbs().colwise().sum();
        double const omega_rounding = roundings * unit_roundoff * omega_size;
        double const q_rounding = roundings * unit_roundoff * q_size;
        bool const fine = tail[0] <= omega_rounding && std::max(tail[1], tail[2]) <= q_rounding;
        if (!fine && depth < deepest) {
            double const middle = 0.5 * (a + b);
            (*this)(a, middle, depth + 1);
            (*this)(middle, b, depth + 1);
            return;
        }
        RatesPanel panel{a,
                         b,
                         fixed.bernstein * c.col(0),
                         fixed.bernstein * c.col(1),
                         fixed.bernstein * c.col(2),
                         omega_rounding + tail[0],
                         q_rounding + std::max(tail[1], tail[2]),
                         0,
                         0};
        // what the interpolant does not know of: rates and their derivatives between the nodes
        for (int j = 0; j < rates_degree; ++j) {
            MotionRates const r = motion_.rates(a + fixed.between[j] * (b - a));
            auto const off = [&](RatesVector const& model, double rate, double change) {
                return std::pair(std::abs(fixed.value.row(j).dot(model) - rate),
                                 std::abs(fixed.slope.row(j).dot(model) - change * (b - a)));
            };
            auto const [omega, omega_slope] = off(panel.omega, r.twist.omega, r.change.omega);
            auto const [x, x_slope] = off(panel.q_x, r.twist.q.x(), r.change.q.x());
            auto const [y, y_slope] = off(panel.q_y, r.twist.q.y(), r.change.q.y());
            panel.omega_error = std::max(panel.omega_error, safety * omega);
            panel.q_error = std::max(panel.q_error, safety * std::max(x, y));
            panel.omega_slope = std::max(panel.omega_slope, safety * omega_slope);
            panel.q_slope = std::max(panel.q_slope, safety * std::max(x_slope, y_slope));
        }
        // Markov: an error e of a polynomial of degree N is at most 2 N^2 e in its slope on 0 ... 1
        constexpr double markov = 2 * rates_degree * rates_degree;
        panel.omega_slope = std::max(panel.omega_slope, markov * omega_rounding);
        panel.q_slope = std::max(panel.q_slope, markov * q_rounding);
        out_.resolved = out_.resolved && fine && panel.omega_error <= unexpected * omega_rounding &&
                        panel.q_error <= unexpected * q_rounding;
        out_.panels.push_back(panel);
    }

  private:
    static constexpr double roundings = 16;  ///< of the sizes that the motion states, in a rate
    static constexpr double safety = 2;
    static constexpr double unexpected = 16;  ///< an error between the nodes that the coefficients did not announce
    static constexpr int deepest = 12;

    Motion const& motion_;
    RatesModel& out_;
};

/// Model of @p motion on [@p a, @p b].
///
/// Each panel has an interpolant at 13 Chebyshev nodes. Panels are halved until the last two coefficients are roundoff
/// of the rates. The stated error is 16 roundings of the sizes that the motion gives for its terms, plus these two
/// coefficients. If twice the largest difference at 12 further points is more, it is that. The derivative is treated
/// likewise, against the motion's own derivative.
///
/// Assumed, not proved: on a panel the rates are analytic, and all Chebyshev coefficients beyond the last sum to less
/// than it. That holds between the breaks that a motion declares. A kink that it does not declare ends as `resolved =
/// false`. For the cosine cam a test proves the error by Cauchy's bound in the complex plane.
template <RelativeMotion Motion>
[[nodiscard]] RatesModel rates_model(Motion const& motion, double a, double b)
{
    RatesModel model;
    if (b > a)
        RatesFit<Motion>(motion, model)(a, b, 0);
    return model;
}

}  // namespace hdconj::motion
