// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth periodic function as a Fourier series, and its integral.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "hdconj/base/tolerance.hpp"

namespace hdconj::numeric {

/// sum_k a_k cos(k w u) + b_k sin(k w u), k = 0 ... ; w = 2 pi / period.
class FourierSeries
{
  public:
    /// Samples @p f at 2^m points of one period, m raised until the last quarter of the coefficients is roundoff,
    /// of the sums or of f itself.
    /// Converges geometrically for analytic f. `resolved()` says whether the limit of 4096 points was enough.
    template <class F>
    FourierSeries(F&& f, double period) : frequency_(2 * std::numbers::pi / period)
    {
        double before = std::numeric_limits<double>::infinity();
        for (std::size_t points = smallest; points <= largest && !resolved_; points *= 2) {
            fit(f, points);
            // a tail that no longer falls is the rounding error of f itself
            resolved_ = resolved_ || (relative_error_ > before / 4 && relative_error_ <= noisiest);
            before = relative_error_;
        }
    }

    [[nodiscard]] double mean() const { return a_[0]; }
    [[nodiscard]] bool resolved() const { return resolved_; }
    [[nodiscard]] std::size_t terms() const { return a_.size(); }
    /// a_k, and b_k; 0 from k = terms() on.
    [[nodiscard]] double cosine(std::size_t k) const { return k < a_.size() ? a_[k] : 0; }
    [[nodiscard]] double sine(std::size_t k) const { return k < b_.size() ? b_[k] : 0; }
    /// Coefficients up to this size are rounding, of the sums or of f.
    [[nodiscard]] double noise() const { return std::max(8 * unit_roundoff, 2 * relative_error_) * size_; }
    /// Largest neglected coefficient against the largest of all.
    [[nodiscard]] double relative_error() const { return relative_error_; }

    /// Integral from 0 to @p u, given the sine and cosine of w u (often at hand already).
    [[nodiscard]] double integral(double u, double sine, double cosine) const
    {
        if (even_) {
            double s1 = 0, s2 = 0;
            for (std::size_t k = a_.size() - 1; k >= 1; --k) {
                double const s0 = ai_[k] + 2 * cosine * s1 - s2;
                s2 = s1;
                s1 = s0;
            }
            return a_[0] * u + s1 * sine;
        }
        // Clenshaw for sum (a_k sin(k x) + b_k (1 - cos(k x))) / (k w), evaluated as two series in one pass
        double s1 = 0, s2 = 0, c1 = 0, c2 = 0;
        for (std::size_t k = a_.size() - 1; k >= 1; --k) {
            double const s0 = ai_[k] + 2 * cosine * s1 - s2;
            s2 = s1;
            s1 = s0;
            double const c0 = bi_[k] + 2 * cosine * c1 - c2;
            c2 = c1;
            c1 = c0;
        }
        double const sines = s1 * sine;
        double const cosines = c1 * cosine - c2;
        return a_[0] * u + sines + (bi_sum_ - cosines);
    }

    [[nodiscard]] double integral(double u) const
    {
        return integral(u, std::sin(frequency_ * u), std::cos(frequency_ * u));
    }

  private:
    static constexpr std::size_t smallest = 16;
    static constexpr std::size_t largest = 4096;
    static constexpr double noisiest = 0x1p-30;

    template <class F>
    void fit(F& f, std::size_t points)
    {
        std::vector<double> values(points), cosine(points), sine(points);
        double const step = 2 * std::numbers::pi / static_cast<double>(points);
        for (std::size_t j = 0; j < points; ++j) {
            double const x = step * static_cast<double>(j);
            values[j] = f(x / frequency_);
            cosine[j] = std::cos(x);
            sine[j] = std::sin(x);
        }
        std::size_t const terms = points / 2;
        a_.assign(terms, 0);
        b_.assign(terms, 0);
        double const weight = 2 / static_cast<double>(points);
        for (std::size_t k = 0; k < terms; ++k) {
            for (std::size_t j = 0; j < points; ++j) {
                std::size_t const m = (k * j) % points;
                a_[k] += weight * values[j] * cosine[m];
                b_[k] += weight * values[j] * sine[m];
            }
        }
        a_[0] /= 2;
        double tail = 0;
        size_ = std::abs(a_[0]);
        for (std::size_t k = 1; k < terms; ++k) {
            double const size = std::hypot(a_[k], b_[k]);
            size_ = std::max(size_, size);
            if (k >= terms - terms / 4)
                tail = std::max(tail, size);
        }
        relative_error_ = size_ > 0 ? tail / size_ : 0;
        constexpr double roundoff_of_the_sums = 8 * unit_roundoff;
        resolved_ = relative_error_ <= roundoff_of_the_sums;
        trim();
    }

    /// Drops coefficients that are roundoff and prepares the integrated series.
    void trim()
    {
        constexpr double negligible = unit_roundoff / 16;
        std::size_t used = a_.size();
        // an even function has no sines; what the sums leave of them is rounding and would spoil exact symmetry
        double const odd =
            *std::max_element(b_.begin(), b_.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
        even_ = std::abs(odd) <= 8 * unit_roundoff * size_;
        if (even_)
            std::fill(b_.begin(), b_.end(), 0.0);
        while (used > 1 && std::hypot(a_[used - 1], b_[used - 1]) <= negligible * size_)
            --used;
        a_.resize(used);
        b_.resize(used);
        ai_.assign(used, 0);
        bi_.assign(used, 0);
        bi_sum_ = 0;
        for (std::size_t k = 1; k < used; ++k) {
            double const kw = static_cast<double>(k) * frequency_;
            ai_[k] = a_[k] / kw;
            bi_[k] = b_[k] / kw;
            bi_sum_ += bi_[k];
        }
    }

    double frequency_;
    std::vector<double> a_, b_, ai_, bi_;
    double bi_sum_ = 0;
    double size_ = 0;  ///< largest coefficient
    double relative_error_ = 1;
    bool resolved_ = false;
    bool even_ = false;  ///< no sines
};

}  // namespace hdconj::numeric
