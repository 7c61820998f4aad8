// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The wave generators by the oracle's own derivation: radial displacement and its slope against the polar angle.
///
///   cosine               w0 cos(n u)
///   ellipse              1/rho^2 = sin^2/b^2 + cos^2/a^2; b by bisection on the perimeter in the eccentric anomaly
///   four-roller          classical solution of the ring under a force: cos y + y sin y and its rigid and constant
///   parts, y
///                        from the middle between two forces, the constants from w'(force) = 0 and no mean
///   two-disc             circle, and between the discs the same three functions, joined with their curvature; the
///                        disc's radius by bisection on the length
///   ring-on-cosine-cam   foot of the normal by bisection on the polar angle, height by adding t along the normal
///   table                natural equations of a periodic cubic spline in its slopes, by dense elimination
#pragma once

#include <Eigen/LU>
#include <array>
#include <cstddef>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hdconj/scene.hpp"
#include "quadrature.hpp"
#include "tooth.hpp"

namespace oracle {

/// w and dw/du at one angle.
template <class T>
struct Radial
{
    T w{}, slope{};
};

template <class T>
class Cam
{
  public:
    Cam() = default;
    /// @param r_m  radius of the undeformed neutral curve
    Cam(hdconj::Scene const& scene, T const& r_m)
        : waves_(scene.wave_generator.waves), r_m_(r_m), half_(pi<T>() / T(waves_))
    {
        auto const& shape = scene.wave_generator.shape;
        T const degree = pi<T>() / T(180);
        if (shape.family != "table")
            w0 = T(number_of(shape, "radial_deformation"));
        if (shape.family == "cosine") {
            int const n = waves_;
            T const lift = w0;
            at_ = [n, lift](T const& u) -> Radial<T> {
                using std::cos;
                using std::sin;
                return {lift * cos(T(n) * u), -T(n) * lift * sin(T(n) * u)};
            };
        } else if (shape.family == "ellipse")
            ellipse();
        else if (shape.family == "four-roller")
            rollers(T(number_of(shape, "roller_angle_deg")) * degree);
        else if (shape.family == "two-disc")
            discs(T(number_of(shape, "wrap_angle_deg")) * degree);
        else if (shape.family == "ring-on-cosine-cam")
            ring(T(number_of(shape, "ring_thickness")));
        else if (shape.family == "table")
            table(scene.folder.string() + "/" + std::get<std::string>(shape.given.at("file").value));
        else
            throw std::invalid_argument("oracle: no wave generator " + shape.family);
    }

    /// u of any turn.
    Radial<T> operator()(T const& u) const
    {
        using std::floor;
        T const period = T(2) * half_;
        return at_(u - period * floor(u / period + T(1) / T(2)));
    }

    std::vector<T> breaks;  ///< in [-pi/n, pi/n]
    T w0{};                 ///< largest

  private:
    /// w from the constants C, A, D of the free ring: C + A cos y + D y sin y.
    static Radial<T> free_ring(std::array<T, 3> const& k, T const& y)
    {
        using std::cos;
        using std::sin;
        T const c = cos(y), s = sin(y);
        return {k[0] + k[1] * c + k[2] * y * s, -k[1] * s + k[2] * (s + y * c)};
    }

    void ellipse()
    {
        using std::cos;
        using std::sin;
        using std::sqrt;
        T const a = r_m_ + w0;
        auto const perimeter = [&](T const& b) {
            int const points = 512;
            T sum(0);
            for (int i = 0; i < points; ++i) {
                T const e = T(2) * pi<T>() * T(i) / T(points);
                T const x = b * cos(e), y = a * sin(e);
                sum += sqrt(x * x + y * y);
            }
            return T(2) * pi<T>() * sum / T(points);
        };
        T low = r_m_ - T(2) * w0, high = r_m_;
        for (int i = 0; i < 200 && high - low > std::numeric_limits<T>::epsilon() * r_m_; ++i) {
            T const b = (low + high) / T(2);
            (perimeter(b) < T(2) * pi<T>() * r_m_ ? low : high) = b;
        }
        T const b = (low + high) / T(2), r_m = r_m_;
        at_ = [a, b, r_m](T const& u) -> Radial<T> {
            using std::cos;
            using std::sin;
            using std::sqrt;
            T const s = sin(u), c = cos(u);
            T const rho = T(1) / sqrt(s * s / (b * b) + c * c / (a * a));
            return {rho - r_m, -rho * rho * rho * s * c * (T(1) / (b * b) - T(1) / (a * a))};
        };
    }

    void rollers(T const& beta)
    {
        using std::cos;
        using std::sin;
        T const h = half_;
        // D = 1: w' = 0 at the force, y = h: A = 1 + h cot h; mean of A cos y + y sin y over -h ... h taken away
        T const a = T(1) + h * cos(h) / sin(h);
        T const mean = (a * sin(h) + sin(h) - h * cos(h)) / h;
        std::array<T, 3> const k{-mean, a, T(1)};
        auto const sum = [k, h, beta](T const& u) -> Radial<T> {
            using std::floor;
            T const period = T(2) * h;
            auto const middle = [&](T const& x) { return x - period * floor(x / period) - h; };
            Radial<T> const p = free_ring(k, middle(u - beta)), q = free_ring(k, middle(u + beta));
            return {p.w + q.w, p.slope + q.slope};
        };
        T const factor = w0 / sum(T(0)).w;
        at_ = [sum, factor](T const& u) -> Radial<T> {
            Radial<T> const r = sum(u);
            return {factor * r.w, factor * r.slope};
        };
        breaks = {-beta, beta};
    }

    void discs(T const& beta)
    {
        using std::abs;
        using std::cos;
        using std::sin;
        using std::sqrt;
        T const h = half_, r_m = r_m_, major = r_m_ + w0;
        breaks = {-beta, beta};
        auto const shape = [=](T const& radius) {
            T const e = major - radius;
            // on the disc, through the angle at its centre: the point sees the axis under asin(e sin u / R)
            auto const disc = [=](T const& u) -> Radial<T> {
                using std::asin;
                using std::cos;
                using std::sin;
                T const alpha = u + asin(e * sin(u) / radius);  // direction of the disc's radius
                T const x = radius * sin(alpha), y = e + radius * cos(alpha);
                T const rho = x * sin(u) + y * cos(u);
                // the curve's normal is the disc's radius: rho'/rho = -tan(alpha - u)
                return {rho - r_m, -rho * sin(alpha - u) / cos(alpha - u)};
            };
            // second derivative at the joint from the curvature 1/R
            Radial<T> const joint = disc(beta);
            T const rho = r_m + joint.w, s2 = rho * rho + joint.slope * joint.slope;
            T const second = (s2 + joint.slope * joint.slope - s2 * sqrt(s2) / radius) / rho;
            T const y = beta - h, c = cos(y), s = sin(y);
            // moment: w + w'' = C + 2 D cos y; slope: -A s + D (s + y c); value. Eliminate C by w'' - and A by the
            // slope
            T const det = (-s) * (T(2) * c - y * s) - (s + y * c) * (-c);
            T const a = (joint.slope * (T(2) * c - y * s) - second * (s + y * c)) / det;
            T const d = ((-s) * second + c * joint.slope) / det;
            std::array<T, 3> const k{joint.w - a * c - d * y * s, a, d};
            return [=](T const& u) -> Radial<T> {
                using std::abs;
                if (abs(u) <= beta)
                    return disc(u);
                return free_ring(k, u > T(0) ? u - h : u + h);
            };
        };
        auto const too_long = [&](T const& radius) {
            auto const at = shape(radius);
            RunningIntegral<T> const length(
                [at, r_m](T const& u) {
                    using std::sqrt;
                    Radial<T> const r = at(u);
                    return sqrt((r_m + r.w) * (r_m + r.w) + r.slope * r.slope);
                },
                T(2) * h, breaks);
            return length.total() > T(2) * h * r_m;
        };
        // the first change from the largest disc downwards
        T high = r_m, low = high;
        bool const at_high = too_long(high);
        do {
            high = low;
            low = low - w0 / T(4);
            if (low < r_m / T(2))
                throw std::invalid_argument("oracle: no disc radius");
        } while (too_long(low) == at_high);
        for (int i = 0; i < 200 && high - low > std::numeric_limits<T>::epsilon() * r_m; ++i) {
            T const middle = (low + high) / T(2);
            (too_long(middle) == at_high ? high : low) = middle;
        }
        at_ = shape((low + high) / T(2));
    }

    void ring(T const& t)
    {
        int const n = waves_;
        T const lift = w0, r_m = r_m_;
        auto const cam = [n, lift](T const& mean, T const& a) -> std::pair<Point<T>, Point<T>> {
            using std::cos;
            using std::sin;
            T const r = mean + lift * cos(T(n) * a), r1 = -T(n) * lift * sin(T(n) * a);
            T const s = sin(a), c = cos(a);
            return {{r * s, r * c}, {r1 * s + r * c, r1 * c - r * s}};
        };
        auto const neutral = [cam, t](T const& mean, T const& a) {
            auto const [p, d] = cam(mean, a);
            T const l = length(d);
            return std::pair<Point<T>, Point<T>>{p + (t / l) * Point<T>{-d.y, d.x}, (T(1) / l) * d};
        };
        // length of the cam: 2 pi (r_m - t)
        auto const too_long = [&](T const& mean) {
            int const points = 512;
            T sum(0);
            for (int i = 0; i < points; ++i)
                sum += length(cam(mean, T(2) * pi<T>() * T(i) / T(points)).second);
            return sum / T(points) > r_m - t;
        };
        T low = r_m - t - lift, high = r_m - t;
        for (int i = 0; i < 200 && high - low > std::numeric_limits<T>::epsilon() * r_m; ++i) {
            T const middle = (low + high) / T(2);
            (too_long(middle) ? high : low) = middle;
        }
        T const mean = (low + high) / T(2);
        at_ = [=](T const& u) -> Radial<T> {
            using std::abs;
            using std::atan2;
            // secant on the polar angle of the neutral point over the cam angle
            auto const miss = [&](T const& a) {
                auto const p = neutral(mean, a).first;
                return atan2(p.x, p.y) - u;
            };
            T a = u, fa = miss(a), b = u - fa;
            for (int i = 0; i < 60; ++i) {
                T const fb = miss(b);
                if (fb == fa || abs(b - a) <= std::numeric_limits<T>::epsilon())
                    break;
                T const next = b - fb * (b - a) / (fb - fa);
                a = b;
                fa = fb;
                b = next;
            }
            auto const [p, d] = neutral(mean, b);
            T const rho = length(p);
            // slope: rho' = rho (radial part)/(tangential part) of the tangent
            T const radial = dot(p, d) / rho, across = (p.y * d.x - p.x * d.y) / rho;
            return {rho - (mean + t), rho * radial / across};
        };
    }

    void table(std::string const& file)
    {
        std::vector<T> x, y;
        std::ifstream in(file);
        for (std::string line; std::getline(in, line);) {
            for (char& c : line)
                if (c == ',')
                    c = ' ';
            std::istringstream row(line);
            double angle = 0, value = 0;
            if (!(row >> angle >> value))
                continue;
            T const degree = pi<T>() / T(180);
            if (!x.empty() && T(angle) * degree - x.front() >= T(2) * half_ * (T(1) - T(1) / T(1 << 20)))
                continue;
            x.push_back(T(angle) * degree);
            y.push_back(T(value));
        }
        std::size_t const n = x.size();
        if (n < 4)
            throw std::invalid_argument("oracle: cannot read " + file);
        auto const gap = [&](std::size_t i) { return i + 1 < n ? x[i + 1] - x[i] : x[0] + T(2) * half_ - x[n - 1]; };
        auto const next = [&](std::size_t i) { return (i + 1) % n; };
        // slopes s: s_(i-1)/h_(i-1) + 2 s_i (1/h_(i-1) + 1/h_i) + s_(i+1)/h_i = 3 (dy_(i-1)/h_(i-1)^2 + dy_i/h_i^2)
        using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;
        auto const size = static_cast<Eigen::Index>(n);
        Matrix m = Matrix::Constant(size, size, T(0));
        Matrix right = Matrix::Constant(size, 1, T(0));
        for (std::size_t i = 0; i < n; ++i) {
            std::size_t const before = (i + n - 1) % n;
            T const h0 = gap(before), h1 = gap(i);
            auto const row = static_cast<Eigen::Index>(i);
            m(row, static_cast<Eigen::Index>(before)) += T(1) / h0;
            m(row, row) += T(2) / h0 + T(2) / h1;
            m(row, static_cast<Eigen::Index>(next(i))) += T(1) / h1;
            right(row, 0) = T(3) * ((y[i] - y[before]) / (h0 * h0) + (y[next(i)] - y[i]) / (h1 * h1));
        }
        Matrix const solved = m.partialPivLu().solve(right);
        std::vector<T> const s(solved.data(), solved.data() + size);
        T const period = T(2) * half_;
        T mean(0);
        for (std::size_t i = 0; i < n; ++i)
            mean += gap(i) * ((y[i] + y[next(i)]) / T(2) + gap(i) * (s[i] - s[next(i)]) / T(12));
        mean = mean / period;
        at_ = [=](T const& u) -> Radial<T> {
            using std::floor;
            T const v = u - period * floor((u - x[0]) / period);
            std::size_t i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), v) - x.begin());
            i = i == 0 ? 0 : i - 1;
            std::size_t const j = (i + 1) % n;
            T const h = j == 0 ? x[0] + period - x[i] : x[j] - x[i];
            T const q = (v - x[i]) / h, p = T(1) - q;
            // Hermite's form
            T const w =
                y[i] * p * p * (T(1) + T(2) * q) + y[j] * q * q * (T(1) + T(2) * p) + h * p * q * (s[i] * p - s[j] * q);
            T const slope = T(6) * p * q * (y[j] - y[i]) / h + s[i] * p * (p - T(2) * q) + s[j] * q * (q - T(2) * p);
            return {w - mean, slope};
        };
        w0 = T(0);
        for (int i = 0; i < 20000; ++i)
            w0 = std::max(w0, (*this)(period * T(i) / T(20000)).w);
        using std::floor;
        for (T const& knot : x)
            breaks.push_back(knot - period * floor(knot / period + T(1) / T(2)));
    }

    int waves_ = 2;
    T r_m_{}, half_{};
    std::function<Radial<T>(T const&)> at_;
};

}  // namespace oracle
