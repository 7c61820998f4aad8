// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Right flanks of the curve families by the oracle's own formulas: an involute as the end of a string, cycloids as
/// points of rolling circles, an S-tooth as its locus, splines by the second derivatives at their knots. Nothing of the
/// library but the scene's data.
#pragma once

#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "flank_curve.hpp"
#include "hdconj/scene.hpp"
#include "number.hpp"

namespace oracle {

template <class T>
using Curves = std::vector<std::shared_ptr<FlankCurve<T> const>>;

/// The parameter in [a, b] at which an increasing or decreasing function is 0.
template <class T, class F>
T bisected(F const& f, T a, T b)
{
    bool const rising = f(b) > f(a);
    for (int step = 0; step < 8 * std::numeric_limits<T>::digits / 4; ++step) {
        T const c = (a + b) / T(2);
        if ((f(c) < T(0)) == rising)
            a = c;
        else
            b = c;
    }
    return (a + b) / T(2);
}

/// The curve u -> point, slope from @p lower (s = 0) to @p upper (s = 1).
template <class T, class F>
std::shared_ptr<FlankCurve<T> const> stretch(F formula, T lower, T upper, int intervals = 96)
{
    return std::make_shared<FlankCurve<T> const>(
        [formula, lower, upper](T const& s) {
            OnCurve<T> on = formula(lower + s * (upper - lower));
            on.slope = (upper - lower) * on.slope;
            return on;
        },
        intervals);
}

/// Unit vector at @p angle clockwise from y, and its derivative.
template <class T>
inline Point<T> clockwise(T const& angle)
{
    using std::cos;
    using std::sin;
    return {sin(angle), cos(angle)};
}
template <class T>
inline Point<T> across(T const& angle)
{
    using std::cos;
    using std::sin;
    return {cos(angle), -sin(angle)};
}

/// The end of a string that unwinds from the base circle: r_b (d(b) + t d'(b)), b = s/(2 r) - alpha + tan(alpha) - t.
template <class T>
struct StringEnd
{
    T r, base, offset;  ///< b = offset - t

    StringEnd(T const& pitch_radius, T const& alpha, T const& thickness) : r(pitch_radius)
    {
        using std::cos;
        using std::tan;
        base = r * cos(alpha);
        offset = thickness / (T(2) * r) - alpha + tan(alpha);
    }
    OnCurve<T> operator()(T const& t) const
    {
        T const b = offset - t;
        Point<T> const p = base * clockwise(b) + (base * t) * across(b);
        // dP/dt = -r_b d' + r_b d' - r_b t d''(b), and d'' = -d
        return {{p.x, p.y - r}, (base * t) * clockwise(b)};
    }
};

/// A point of a circle that rolls on the pitch circle: outside towards the left, or inside towards the right.
template <class T>
struct RollingPoint
{
    T r, rho, start;
    bool outside;

    OnCurve<T> operator()(T const& t) const
    {
        T const step = rho / r * t;
        T const centre = outside ? start - step : start + step;
        T const reach = outside ? r + rho : r - rho, arm = outside ? -rho : rho;
        T const turn = centre - t, rate = outside ? -rho / r : rho / r;
        Point<T> const p = reach * clockwise(centre) + arm * clockwise(turn);
        return {{p.x, p.y - r}, (reach * rate) * across(centre) + (arm * (rate - T(1))) * across(turn)};
    }
};

/// Half the locus, from its datum point: M + (L(eta_M) - L(eta))/2.
template <class T>
struct HalfLocus
{
    T size, waves, kappa, eta_datum;
    Point<T> datum;

    Point<T> locus(T const& eta) const
    {
        using std::cos;
        using std::sin;
        return {size / waves * (eta - kappa * sin(eta)), size * kappa * cos(eta)};
    }
    OnCurve<T> operator()(T const& eta) const
    {
        using std::cos;
        using std::sin;
        T const half = T(1) / T(2);
        Point<T> const slope{size / waves * (T(1) - kappa * cos(eta)), -size * kappa * sin(eta)};
        return {datum + half * (locus(eta_datum) - locus(eta)), -half * slope};
    }
};

/// Bezier curve by de Casteljau's scheme.
template <class T>
struct BezierCurve
{
    std::vector<Point<T>> control;

    OnCurve<T> operator()(T const& t) const
    {
        std::vector<Point<T>> w = control;
        Point<T> slope{};
        for (std::size_t r = w.size() - 1; r > 0; --r) {
            if (r == 1)
                slope = T(static_cast<int>(control.size()) - 1) * (w[1] - w[0]);
            for (std::size_t i = 0; i < r; ++i)
                w[i] = w[i] + t * (w[i + 1] - w[i]);
        }
        return {w[0], slope};
    }
};

/// Cubic spline with not-a-knot ends over chord length: second derivatives M at all points from
/// h_{i-1} M_{i-1} + 2 (h_{i-1} + h_i) M_i + h_i M_{i+1} = 6 (divided differences) and equal third derivatives at both
/// sides of the second and the last but one point.
template <class T>
class ChordSpline
{
  public:
    explicit ChordSpline(std::vector<Point<T>> points) : p_(std::move(points))
    {
        std::size_t const n = p_.size();
        for (std::size_t i = 0; i + 1 < n; ++i)
            h_.push_back(length(p_[i + 1] - p_[i]));
        std::vector<std::vector<T>> m(n, std::vector<T>(n, T(0)));
        std::vector<Point<T>> right(n);
        for (std::size_t i = 1; i + 1 < n; ++i) {
            m[i][i - 1] = h_[i - 1];
            m[i][i] = T(2) * (h_[i - 1] + h_[i]);
            m[i][i + 1] = h_[i];
            right[i] = T(6) * ((T(1) / h_[i]) * (p_[i + 1] - p_[i]) - (T(1) / h_[i - 1]) * (p_[i] - p_[i - 1]));
        }
        auto const same_third = [&](std::size_t row, std::size_t i) {
            m[row][i - 1] = -T(1) / h_[i - 1];
            m[row][i] = T(1) / h_[i - 1] + T(1) / h_[i];
            m[row][i + 1] = -T(1) / h_[i];
        };
        same_third(0, 1);
        same_third(n - 1, n - 2);
        solve(m, right);
        bend_ = right;
    }
    std::size_t intervals() const { return h_.size(); }
    /// Interval @p i at 0 ... 1.
    OnCurve<T> at(std::size_t i, T const& share) const
    {
        T const h = h_[i], b = share, a = T(1) - share;
        T const six = T(6);
        Point<T> const value =
            a * p_[i] + b * p_[i + 1] + (h * h / six) * ((a * a * a - a) * bend_[i] + (b * b * b - b) * bend_[i + 1]);
        Point<T> const slope = (p_[i + 1] - p_[i]) + (h * h / six) * ((T(1) - T(3) * a * a) * bend_[i] +
                                                                      (T(3) * b * b - T(1)) * bend_[i + 1]);
        return {value, slope};
    }

  private:
    static void solve(std::vector<std::vector<T>>& m, std::vector<Point<T>>& right)
    {
        using std::abs;
        std::size_t const n = m.size();
        for (std::size_t c = 0; c < n; ++c) {
            std::size_t pivot = c;
            for (std::size_t r = c + 1; r < n; ++r)
                if (abs(m[r][c]) > abs(m[pivot][c]))
                    pivot = r;
            std::swap(m[c], m[pivot]);
            std::swap(right[c], right[pivot]);
            for (std::size_t r = c + 1; r < n; ++r) {
                T const f = m[r][c] / m[c][c];
                if (f == T(0))
                    continue;
                for (std::size_t k = c; k < n; ++k)
                    m[r][k] -= f * m[c][k];
                right[r] = right[r] - f * right[c];
            }
        }
        for (std::size_t c = n; c-- > 0;) {
            for (std::size_t k = c + 1; k < n; ++k)
                right[c] = right[c] - m[c][k] * right[k];
            right[c] = (T(1) / m[c][c]) * right[c];
        }
    }

    std::vector<Point<T>> p_, bend_;
    std::vector<T> h_;
};

/// The spline's intervals from the root up; the points come from tip to root or the other way.
template <class T>
Curves<T> spline_curves(std::vector<Point<T>> points)
{
    if (points.front().y > points.back().y)
        std::reverse(points.begin(), points.end());
    auto const spline = std::make_shared<ChordSpline<T> const>(std::move(points));
    Curves<T> curves;
    for (std::size_t i = 0; i < spline->intervals(); ++i)
        curves.push_back(stretch<T>([spline, i](T const& s) { return spline->at(i, s); }, T(0), T(1), 24));
    return curves;
}

inline std::vector<Point<double>> rows_of(hdconj::scene::FamilyChoice const& choice, std::string const& key)
{
    std::vector<Point<double>> points;
    for (auto const& row : std::get<hdconj::scene::NumberRows>(choice.given.find(key)->second.value))
        points.push_back({row.at(0), row.at(1)});
    return points;
}

/// Points of the family's scene: rows of the scene, or a plain CSV file without comments.
inline std::vector<Point<double>> points_of(hdconj::Scene const& scene)
{
    auto const& choice = scene.flexspline.profile;
    if (choice.family != "points")
        return rows_of(choice, "points");
    std::ifstream file(scene.folder / std::get<std::string>(choice.given.find("file")->second.value));
    std::vector<Point<double>> points;
    for (std::string line; std::getline(file, line);) {
        std::size_t const comma = line.find(',');
        points.push_back({std::stod(line.substr(0, comma)), std::stod(line.substr(comma + 1))});
    }
    if (points.empty())
        throw std::invalid_argument("oracle: no points");
    return points;
}

}  // namespace oracle
