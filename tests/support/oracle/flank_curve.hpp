// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A stretch of flank given by any formula, for the oracle's tooth: nearest point by a table and root-finding in the
/// formula itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "number.hpp"

namespace oracle {

/// Point and derivative of a curve.
template <class T>
struct OnCurve
{
    Point<T> point, slope;
};

/// A curve that rises from s = 0 (its lower end) to s = 1 (its upper end).
template <class T>
class FlankCurve
{
  public:
    using Formula = std::function<OnCurve<T>(T const&)>;

    explicit FlankCurve(Formula formula, int intervals = 96) : formula_(std::move(formula))
    {
        for (int i = 0; i <= intervals; ++i) {
            table_.push_back(formula_(parameter(static_cast<std::size_t>(i), intervals)).point);
            Point<T> const& p = table_.back();
            least_ = i == 0 ? p : Point<T>{std::min(least_.x, p.x), std::min(least_.y, p.y)};
            most_ = i == 0 ? p : Point<T>{std::max(most_.x, p.x), std::max(most_.y, p.y)};
            widest_ = std::max(widest_, p.x);
            if (i > 0)
                spacing_ = std::max(spacing_, length(table_.back() - table_[table_.size() - 2]));
        }
    }

    OnCurve<T> operator()(T const& s) const { return formula_(s); }
    T widest() const { return widest_; }
    bool rises() const
    {
        for (std::size_t i = 1; i < table_.size(); ++i)
            if (!(table_[i].y > table_[i - 1].y))
                return false;
        return true;
    }

    /// Whether no point of the curve is nearer to @p p than @p distance: the box of the table is not.
    bool is_beyond(Point<T> const& p, T const& distance) const
    {
        T const reach = distance + spacing_;
        return p.x - most_.x > reach || least_.x - p.x > reach || p.y - most_.y > reach || least_.y - p.y > reach;
    }

    /// Smallest distance of @p p: each dip of the table that may hold it is followed to its foot.
    T distance(Point<T> const& p) const
    {
        using std::sqrt;
        std::size_t const n = table_.size();
        std::vector<T> apart(n);
        for (std::size_t i = 0; i < n; ++i) {
            Point<T> const d = p - table_[i];
            apart[i] = dot(d, d);
        }
        T const best = sqrt(*std::min_element(apart.begin(), apart.end()));
        // between two table points no curve point is nearer than the nearer of them less their spacing
        T const reach = best + spacing_;
        T result = best;
        for (std::size_t i = 0; i < n; ++i) {
            bool const dip = (i == 0 || apart[i] <= apart[i - 1]) && (i + 1 == n || apart[i] <= apart[i + 1]);
            if (dip && apart[i] <= reach * reach)
                result = std::min(result, foot(p, i));
        }
        return result;
    }

    /// Whether @p p (between the ends in height) lies left of the curve.
    bool is_left(Point<T> const& p) const
    {
        auto const above =
            std::upper_bound(table_.begin(), table_.end(), p.y, [](T const& y, Point<T> const& q) { return y < q.y; });
        std::size_t const i =
            std::clamp<std::size_t>(static_cast<std::size_t>(above - table_.begin()), 1, table_.size() - 1);
        T const low = std::min(table_[i - 1].x, table_[i].x) - spacing_,
                high = std::max(table_[i - 1].x, table_[i].x) + spacing_;
        if (p.x < low || p.x > high)
            return p.x < low;
        return p.x < x_at(p.y, i);
    }

    /// x at height @p y.
    T x_at(T const& y) const
    {
        std::size_t i = 1;
        while (i + 1 < table_.size() && table_[i].y < y)
            ++i;
        return x_at(y, i);
    }

  private:
    static T parameter(std::size_t i, std::size_t intervals)
    {
        return T(static_cast<int>(i)) / T(static_cast<int>(intervals));
    }
    static T parameter(std::size_t i, int intervals) { return parameter(i, static_cast<std::size_t>(intervals)); }

    T x_at(T const& y, std::size_t i) const
    {
        T const s = root([&](T const& at) { return formula_(at).point.y - y; }, parameter(i - 1, table_.size() - 1),
                         parameter(i, table_.size() - 1));
        return formula_(s).point.x;
    }

    T foot(Point<T> const& p, std::size_t i) const
    {
        std::size_t const last = table_.size() - 1;
        auto const along = [&](T const& s) {
            auto const on = formula_(s);
            return dot(on.point - p, on.slope);
        };
        T best = length(p - table_[i]);
        for (std::size_t k = i > 0 ? i - 1 : 0; k < std::min(i + 1, last); ++k) {
            T const a = parameter(k, last), b = parameter(k + 1, last);
            if (along(a) <= T(0) && along(b) >= T(0))
                best = std::min(best, length(p - formula_(root(along, a, b)).point));
        }
        return best;
    }

    /// Illinois rule; the sign changes between a and b, or one of them is returned.
    template <class F>
    static T root(F const& f, T a, T b)
    {
        using std::abs;
        T fa = f(a), fb = f(b);
        if ((fa < T(0)) == (fb < T(0)))
            return abs(fa) < abs(fb) ? a : b;
        for (int step = 0; step < 60; ++step) {
            T const c = (a * fb - b * fa) / (fb - fa), fc = f(c);
            if (fc == T(0) || !(abs(b - a) > T(4) * std::numeric_limits<T>::epsilon()))
                return c;
            if ((fc < T(0)) == (fb < T(0))) {
                b = c;
                fb = fc;
                fa /= T(2);
            } else {
                a = b;
                fa = fb;
                b = c;
                fb = fc;
            }
            if (abs(b - a) <= T(4) * std::numeric_limits<T>::epsilon())
                return b;
        }
        return abs(fa) < abs(fb) ? a : b;
    }

    Formula formula_;
    std::vector<Point<T>> table_;
    Point<T> least_{}, most_{};  ///< corners of the table's box
    T spacing_{}, widest_{};
};

}  // namespace oracle
