// SPDX-License-Identifier: GPL-3.0-or-later
// The meshing condition of a curve over a box of (t, u) as a tensor-product Bernstein polynomial with a stated error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "hdconj/motion/rates_model.hpp"
#include "hdconj/numeric/bernstein.hpp"
#include "hdconj/profile/pieces.hpp"

namespace hdconj::envelope {

/// Smallest and largest value, widened by the noise.
struct Range
{
    double low = 0;
    double high = 0;
    double noise = 0;

    [[nodiscard]] bool holds_zero() const { return low <= 0 && high >= 0; }
    [[nodiscard]] double middle() const { return 0.5 * (low + high); }
    [[nodiscard]] double radius() const { return 0.5 * (high - low); }
    [[nodiscard]] double largest() const { return std::max(-low, high); }
    [[nodiscard]] double beyond_noise() const { return std::max(0.0, largest() - 2 * noise); }
};

/// f(t, u) = sum_ij c_ij B_i(s) B_j(r) with s, r from 0 to 1 over the box. f is known to +-noise, and so are the
/// coefficients of f(., u) in t. All derivatives are with respect to s and r.
class MeshingPatch
{
  public:
    double t0 = 0, t1 = 1, u0 = 0, u1 = 1;
    double noise = 0;
    double slope_noise = 0;  ///< further error of df/dr

    MeshingPatch(profile::CurvePiece const& curve, motion::RatesPanel const& panel)
        : u0(panel.u0), u1(panel.u1), rows_(curve.a().size())
    {
        double a = 0, b = 0, size = 0;
        double const omega = panel.omega.cwiseAbs().maxCoeff();
        double const q = panel.q_x.cwiseAbs().maxCoeff() + panel.q_y.cwiseAbs().maxCoeff();
        for (std::size_t i = 0; i < rows_; ++i) {
            row(i) = curve.a()[i] * panel.omega + curve.b()[i] * panel.q_x + curve.c()[i] * panel.q_y;
            a = std::max(a, std::abs(curve.a()[i]));
            b = std::max(b, std::abs(curve.b()[i]) + std::abs(curve.c()[i]));
        }
        size = a * omega + b * q;
        noise = panel.omega_error * a + panel.q_error * b + omega * curve.a_error() + q * curve.b_error() +
                4 * unit_roundoff * size;
        slope_noise = panel.omega_slope * a + panel.q_slope * b;
    }

    [[nodiscard]] double degree_t() const { return static_cast<double>(rows_ - 1); }

    [[nodiscard]] Range value() const
    {
        return widened(span([&](std::size_t i) { return row(i); }, rows_), noise);
    }
    [[nodiscard]] Range by_t() const
    {
        double const m = degree_t();
        return widened(span([&](std::size_t i) -> motion::RatesVector { return m * (row(i + 1) - row(i)); }, rows_ - 1),
                       2 * m * noise);
    }
    [[nodiscard]] Range by_u() const
    {
        constexpr double d = motion::rates_degree;
        return widened(span([&](std::size_t i) { return differences(row(i)); }, rows_), 2 * d * noise + slope_noise);
    }
    [[nodiscard]] Range by_tt() const
    {
        double const k = degree_t() * (degree_t() - 1);
        if (rows_ < 3)
            return {};
        return widened(
            span([&](std::size_t i) -> motion::RatesVector { return k * (row(i + 2) - 2 * row(i + 1) + row(i)); },
                 rows_ - 2),
            4 * k * noise);
    }
    [[nodiscard]] Range by_tu() const
    {
        constexpr double d = motion::rates_degree;
        double const m = degree_t();
        return widened(span([&](std::size_t i) { return differences(m * (row(i + 1) - row(i))); }, rows_ - 1),
                       2 * m * (2 * d * noise + slope_noise));
    }

    /// Part between @p from and @p to of the range of t (or of u); these may lie a little outside of 0 ... 1.
    [[nodiscard]] MeshingPatch part_in_t(double from, double to) const
    {
        MeshingPatch part = *this;
        for (Eigen::Index j = 0; j < motion::rates_coefficients; ++j) {
            numeric::BernsteinWork line{};
            for (std::size_t i = 0; i < rows_; ++i)
                line[i] = row(i)[j];
            between(std::span<double>(line.data(), rows_), from, to);
            for (std::size_t i = 0; i < rows_; ++i)
                part.row(i)[j] = line[i];
        }
        part.t0 = t0 + from * (t1 - t0);
        part.t1 = t0 + to * (t1 - t0);
        part.noise += rounding(degree_t(), to - from);
        return part;
    }
    [[nodiscard]] MeshingPatch part_in_u(double from, double to) const
    {
        MeshingPatch part = *this;
        for (std::size_t i = 0; i < rows_; ++i)
            between(std::span<double>(part.row(i).data(), motion::rates_coefficients), from, to);
        part.u0 = u0 + from * (u1 - u0);
        part.u1 = u0 + to * (u1 - u0);
        part.noise += rounding(motion::rates_degree, to - from);
        part.slope_noise *= to - from;
        return part;
    }

    /// f, f_s, f_r, f_ss, f_sr at (s, r).
    struct Jet
    {
        double f, s, r, ss, sr;
    };
    [[nodiscard]] Jet jet(double s, double r) const
    {
        numeric::BernsteinWork value{};
        numeric::BernsteinWork slope{};
        for (std::size_t i = 0; i < rows_; ++i) {
            motion::RatesVector w = row(i);
            for (Eigen::Index k = motion::rates_degree; k > 1; --k)
                w.head(k) += (r * (w.segment(1, k) - w.head(k))).eval();
            slope[i] = motion::rates_degree * (w[1] - w[0]);
            value[i] = w[0] + r * (w[1] - w[0]);
        }
        Jet out{};
        auto const along_t = [&](numeric::BernsteinWork& w, double& first, double& second) {
            double const m = degree_t();
            for (std::size_t k = rows_ - 1; k > 0; --k) {
                if (k == 2)
                    second = m * (m - 1) * (w[2] - 2 * w[1] + w[0]);
                if (k == 1)
                    first = m * (w[1] - w[0]);
                for (std::size_t i = 0; i < k; ++i)
                    w[i] += s * (w[i + 1] - w[i]);
            }
            return w[0];
        };
        double unused = 0;
        out.f = along_t(value, out.s, out.ss);
        out.r = along_t(slope, out.sr, unused);
        return out;
    }

  private:
    [[nodiscard]] motion::RatesVector& row(std::size_t i) { return rows_of_[i]; }
    [[nodiscard]] motion::RatesVector const& row(std::size_t i) const { return rows_of_[i]; }

    [[nodiscard]] static Eigen::Matrix<double, motion::rates_degree, 1> differences(motion::RatesVector const& c)
    {
        return motion::rates_degree * (c.tail<motion::rates_degree>() - c.head<motion::rates_degree>());
    }

    [[nodiscard]] double size() const
    {
        double largest = 0;
        for (std::size_t i = 0; i < rows_; ++i)
            largest = std::max(largest, row(i).cwiseAbs().maxCoeff());
        return largest;
    }

    /// Of the coefficients of a part that is @p share as wide; beyond the ends of the patch every step may magnify it.
    [[nodiscard]] double rounding(double degree, double share) const
    {
        return 2 * degree * unit_roundoff * size() * std::pow(std::max(1.0, share), degree);
    }

    template <class Row>
    [[nodiscard]] static Range span(Row&& row, std::size_t count)
    {
        Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0};
        for (std::size_t i = 0; i < count; ++i) {
            auto const r = row(i);
            range.low = std::min(range.low, r.minCoeff());
            range.high = std::max(range.high, r.maxCoeff());
        }
        return range;
    }
    [[nodiscard]] static Range widened(Range range, double by) { return {range.low - by, range.high + by, by}; }

    static void between(std::span<double> c, double from, double to)
    {
        numeric::BernsteinWork other{};
        std::span<double> const high(other.data(), c.size());
        if (to != 1)
            numeric::bernstein_split(c, high, to);
        if (from == 0)
            return;
        numeric::bernstein_split(c, high, from / to);
        std::copy(high.begin(), high.end(), c.begin());
    }

    std::size_t rows_;
    std::array<motion::RatesVector, numeric::bernstein_max_degree + 1> rows_of_;
};

}  // namespace hdconj::envelope
