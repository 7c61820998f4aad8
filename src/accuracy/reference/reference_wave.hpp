// SPDX-License-Identifier: GPL-3.0-or-later
// Radial displacements that are analytic only between breaks, by paths of their own, in any number type; private to
// src/accuracy.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "reference_integral.hpp"
#include "reference_pair.hpp"

namespace hdconj::accuracy {

/// Solution of n linear equations by elimination with row pivots.
template <class T, std::size_t n>
[[nodiscard]] std::array<T, n> solution_of(std::array<std::array<T, n>, n> a, std::array<T, n> b)
{
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (abs(a[i][k]) > abs(a[pivot][k]))
                pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            T const factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j)
                a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
    return b;
}

/// C + a cos y + d y sin y: a stretch of ring without load, even about its middle.
template <class T>
struct FreeRing
{
    T c{}, a{}, d{};

    [[nodiscard]] WaveJet<T> at(T const& y) const
    {
        auto const rows = terms(y);
        return {c + a * rows[0][1] + d * rows[0][2], a * rows[1][1] + d * rows[1][2], a * rows[2][1] + d * rows[2][2]};
    }
    /// What C, a and d count in value, slope and second derivative.
    [[nodiscard]] static std::array<std::array<T, 3>, 3> terms(T const& y)
    {
        T const s = sin(y), k = cos(y);
        return {{{T(1), k, y * s}, {T(0), -s, s + y * k}, {T(0), -k, T(2) * k - y * s}}};
    }
    /// In the integral from 0 to y.
    [[nodiscard]] static std::array<T, 3> integral(T const& y) { return {y, sin(y), sin(y) - y * cos(y)}; }
};

/// Angle within half a period of 0.
template <class T>
[[nodiscard]] T within_period(T const& u, T const& half)
{
    return u - T(2) * half * floor((u + half) / (T(2) * half));
}

/// Ring under equal forces at +-beta about each lobe.
///
/// Not the program's path, which sums two rings under one force each in closed form: here each stretch between forces
/// has its three constants, and they are those with which w, w', w'' go on across a force, w(0) = w0 and the mean of w
/// is 0.
template <class T>
class ReferenceRollers
{
  public:
    ReferenceRollers() = default;
    ReferenceRollers(T const& w0, T const& beta, int waves) : half_(half_turn<T>() / T(waves)), beta_(beta)
    {
        if (beta == T(0)) {
            auto const middle = FreeRing<T>::terms(-half_);
            auto const whole = FreeRing<T>::integral(half_);
            auto const found = solution_of<T, 3>({{middle[0], middle[1], whole}}, {w0, T(0), T(0)});
            between_ = {found[0], found[1], found[2]};
            return;
        }
        T const y = beta - half_;
        auto const in = FreeRing<T>::terms(beta), out = FreeRing<T>::terms(y);
        auto const upto = FreeRing<T>::integral(beta), beyond = FreeRing<T>::integral(-y);
        // C, a and d inside, a and d between
        std::array<std::array<T, 5>, 5> rows{};
        rows[0] = {T(1), T(1), T(0), T(0), T(0)};
        for (std::size_t i = 0; i < 3; ++i)
            rows[i + 1] = {T(0), in[i][1], in[i][2], -out[i][1], -out[i][2]};
        rows[4] = {half_, upto[1], upto[2], beyond[1], beyond[2]};
        auto const found = solution_of<T, 5>(rows, {w0, T(0), T(0), T(0), T(0)});
        inside_ = {found[0], found[1], found[2]};
        between_ = {found[0], found[3], found[4]};
    }

    [[nodiscard]] std::vector<T> breaks() const
    {
        return beta_ == T(0) ? std::vector<T>{T(0)} : std::vector<T>{-beta_, beta_};
    }

    [[nodiscard]] WaveJet<T> at(T const& u) const
    {
        T const v = within_period(u, half_);
        if (abs(v) < beta_)
            return inside_.at(v);
        return between_.at(v > T(0) ? T(v - half_) : T(v + half_));
    }

  private:
    T half_{}, beta_{};
    FreeRing<T> inside_, between_;
};

/// Periodic cubic spline through a table, its mean taken away.
///
/// Not the program's path, which asks a library for second derivatives: here the unknowns are the slopes at the rows,
/// and what closes the ring of equations is split off as a correction of rank one.
template <class T>
class ReferenceTable
{
  public:
    ReferenceTable() = default;
    /// @param rows  angle [deg] and value of one wave, increasing, without a closing row
    ReferenceTable(std::vector<std::array<double, 2>> const& rows, int waves)
        : period_(T(2) * half_turn<T>() / T(waves))
    {
        std::vector<std::pair<T, T>> sorted;
        for (auto const& row : rows)
            sorted.emplace_back(within_period(T(T(row[0]) * half_turn<T>() / T(180)), T(period_ / T(2))), T(row[1]));
        std::sort(sorted.begin(), sorted.end());
        for (auto const& each : sorted) {
            x_.push_back(each.first);
            y_.push_back(each.second);
        }
        solve_slopes();
        T sum(0);
        for (std::size_t i = 0; i < x_.size(); ++i) {
            std::size_t const j = (i + 1) % x_.size();
            T const h = length(i);
            sum += h * ((y_[i] + y_[j]) / T(2) + h * (slope_[i] - slope_[j]) / T(12));
        }
        for (T& y : y_)
            y -= sum / period_;
    }

    [[nodiscard]] std::vector<T> breaks() const { return x_; }

    [[nodiscard]] WaveJet<T> at(T const& u) const
    {
        T const v = u - period_ * floor((u - x_.front()) / period_);
        auto const after = std::upper_bound(x_.begin(), x_.end(), v);
        std::size_t const i = after == x_.begin() ? 0 : static_cast<std::size_t>(after - x_.begin()) - 1,
                          j = (i + 1) % x_.size();
        T const h = length(i), s = (v - x_[i]) / h, r = T(1) - s;
        T const a = y_[i], b = y_[j], p = h * slope_[i], q = h * slope_[j];
        return {r * r * ((T(1) + T(2) * s) * a + s * p) + s * s * ((T(1) + T(2) * r) * b - r * q),
                (T(6) * s * r * (b - a) + r * (T(1) - T(3) * s) * p + s * (T(3) * s - T(2)) * q) / h,
                (T(6) * (T(1) - T(2) * s) * (b - a) + (T(6) * s - T(4)) * p + (T(6) * s - T(2)) * q) / (h * h)};
    }

  private:
    /// From row i to the next.
    [[nodiscard]] T length(std::size_t i) const
    {
        return i + 1 < x_.size() ? T(x_[i + 1] - x_[i]) : T(x_.front() + period_ - x_.back());
    }

    void solve_slopes()
    {
        std::size_t const n = x_.size();
        std::vector<T> diagonal(n), next(n), right(n), correction(n, T(0));
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t const before = (i + n - 1) % n, after = (i + 1) % n;
            T const l = T(1) / length(before), r = T(1) / length(i);
            diagonal[i] = T(2) * (l + r);
            next[i] = r;
            right[i] = T(3) * ((y_[i] - y_[before]) * l * l + (y_[after] - y_[i]) * r * r);
        }
        // (A + g e e^T) m = right, e_0 = 1 and e_{n-1} = corner/g, A tridiagonal
        T const corner = next[n - 1], g = -diagonal[0], share = corner / g;
        diagonal[0] -= g;
        diagonal[n - 1] -= corner * share;
        correction[0] = g;
        correction[n - 1] = corner;
        for (std::size_t i = 1; i < n; ++i) {
            T const factor = next[i - 1] / diagonal[i - 1];
            diagonal[i] -= factor * next[i - 1];
            right[i] -= factor * right[i - 1];
            correction[i] -= factor * correction[i - 1];
        }
        for (std::size_t i = n; i-- > 0;) {
            for (std::vector<T>* b : {&right, &correction})
                (*b)[i] = ((*b)[i] - (i + 1 < n ? T(next[i] * (*b)[i + 1]) : T(0))) / diagonal[i];
        }
        T const part = (right[0] + share * right[n - 1]) / (T(1) + correction[0] + share * correction[n - 1]);
        for (std::size_t i = 0; i < n; ++i)
            slope_.push_back(right[i] - part * correction[i]);
    }

    T period_{};
    std::vector<T> x_, y_, slope_;
};

}  // namespace hdconj::accuracy
