// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and curves with derivatives in any number type; private to src/accuracy.
#pragma once

#include <cmath>

namespace hdconj::accuracy {

// those of the standard types; of others they are found beside the type
using std::abs, std::acos, std::asin, std::atan2, std::cos, std::floor, std::sin, std::sqrt;

/// A point or a vector in a number type of any width.
template <class T>
struct Pair
{
    T x{};
    T y{};

    friend Pair operator+(Pair const& a, Pair const& b) { return {a.x + b.x, a.y + b.y}; }
    friend Pair operator-(Pair const& a, Pair const& b) { return {a.x - b.x, a.y - b.y}; }
    friend Pair operator*(T const& s, Pair const& a) { return {s * a.x, s * a.y}; }
};

template <class T>
T inner(Pair<T> const& a, Pair<T> const& b)
{
    return a.x * b.x + a.y * b.y;
}

template <class T>
T length(Pair<T> const& a)
{
    return sqrt(a.x * a.x + a.y * a.y);
}

/// +90 degrees.
template <class T>
Pair<T> to_left(Pair<T> const& a)
{
    return {-a.y, a.x};
}

/// @p a turned clockwise by the angle whose cosine and sine are given.
template <class T>
Pair<T> turned(Pair<T> const& a, T const& cosine, T const& sine)
{
    return {a.x * cosine + a.y * sine, a.y * cosine - a.x * sine};
}

/// A function of the angle with its first two derivatives.
template <class T>
struct WaveJet
{
    T w{}, w1{}, w2{};
};

/// Point of a curve and its derivatives by a parameter.
template <class T>
struct ReferenceJet
{
    Pair<T> p, p1, p2;
};

/// The point w at the polar angle @p u, clockwise from y.
template <class T>
[[nodiscard]] ReferenceJet<T> polar(WaveJet<T> const& radius, T const& u)
{
    Pair<T> const out{sin(u), cos(u)}, on{cos(u), -sin(u)};
    return {radius.w * out, radius.w1 * out + radius.w * on, (radius.w2 - radius.w) * out + (T(2) * radius.w1) * on};
}

/// The radius of a curve that is given by its polar angle.
template <class T>
[[nodiscard]] WaveJet<T> radius_of(ReferenceJet<T> const& c)
{
    T const rho = length(c.p), rho1 = inner(c.p, c.p1) / rho;
    return {rho, rho1, (inner(c.p1, c.p1) + inner(c.p, c.p2) - rho1 * rho1) / rho};
}

/// rho^2 du/de of a curve that is given by another parameter e.
template <class T>
[[nodiscard]] T turning(ReferenceJet<T> const& c)
{
    return c.p.y * c.p1.x - c.p.x * c.p1.y;
}

/// Derivatives by the polar angle of a curve that is given with those by another parameter.
template <class T>
[[nodiscard]] ReferenceJet<T> by_polar_angle(ReferenceJet<T> const& c)
{
    T const square = inner(c.p, c.p), turn = turning(c);
    T const u1 = turn / square;
    T const u2 = (c.p.y * c.p2.x - c.p.x * c.p2.y) / square - T(2) * u1 * inner(c.p, c.p1) / square;
    T const e1 = T(1) / u1, e2 = -u2 * e1 * e1 * e1;
    return {c.p, e1 * c.p1, (e1 * e1) * c.p2 + e2 * c.p1};
}

}  // namespace hdconj::accuracy
