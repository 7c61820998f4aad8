// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Number types of the oracle and the few things that every type needs.
///
/// The oracle shares nothing with the library but the scene's data: own tooth, own motion,
/// own quadrature. It is a template on the number type, so that the same text runs in double
/// (fast), long double (check) and 50 decimal digits (reference).
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

namespace oracle {

/// 50 decimal digits.
using Fifty = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class T>
T pi()
{
    using std::acos;
    static T const value = acos(T(-1));
    return value;
}

/// A point or a vector.
template <class T>
struct Point
{
    T x{};
    T y{};

    friend Point operator+(Point const& a, Point const& b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(Point const& a, Point const& b) { return {a.x - b.x, a.y - b.y}; }
    friend Point operator*(T const& s, Point const& a) { return {s * a.x, s * a.y}; }
};

template <class T>
inline T dot(Point<T> const& a, Point<T> const& b)
{
    return a.x * b.x + a.y * b.y;
}

template <class T>
inline T length(Point<T> const& a)
{
    using std::sqrt;
    return sqrt(a.x * a.x + a.y * a.y);
}

/// Turned clockwise by @p angle, the sense in which all polar angles are counted.
template <class T>
inline Point<T> turned_clockwise(Point<T> const& a, T const& angle)
{
    using std::cos;
    using std::sin;
    T const c = cos(angle), s = sin(angle);
    return {a.x * c + a.y * s, a.y * c - a.x * s};
}

/// @p a in another number type.
template <class To, class From>
Point<To> as(Point<From> const& a)
{
    return {static_cast<To>(a.x), static_cast<To>(a.y)};
}

}  // namespace oracle
