// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of a given piece by a path of their own, in any number type; private to src/accuracy.
#pragma once

#include <limits>
#include <vector>

#include "hdconj/profile/profile.hpp"
#include "reference_motion.hpp"

namespace hdconj::accuracy {

template <class T>
Pair<T> pair_of(Vec2 const& a)
{
    return {T(a.x()), T(a.y())};
}

/// A contact in the circular-spline frame.
template <class T>
struct ReferenceContact
{
    Pair<T> point;
    Pair<T> normal;    ///< outward of the tooth
    Pair<T> velocity;  ///< of the profile point there
    T t{};             ///< local parameter of the piece
};

/// Value of a polynomial in Bernstein form by de Casteljau's rule.
template <class T>
T casteljau(std::vector<double> const& coefficients, T const& t)
{
    std::vector<T> b(coefficients.begin(), coefficients.end());
    for (std::size_t level = b.size(); level-- > 1;)
        for (std::size_t i = 0; i < level; ++i)
            b[i] = (T(1) - t) * b[i] + t * b[i + 1];
    return b[0];
}

/// The envelope of a circle is the parallel of its centre's path: the path's own normal in the fixed frame, either
/// side.
template <class T>
ReferenceContact<T> contact_at(profile::ArcPiece const& arc, int side, MovingFrame<T> const& place, T const& offset)
{
    Pair<T> const centre = pair_of<T>(arc.centre);
    Pair<T> const path = place.velocity(centre);
    Pair<T> const n = (T(side) / length(path)) * to_left(path);
    ReferenceContact<T> contact;
    contact.normal = n;
    contact.point = place.point(centre) + (T(arc.radius) + offset) * n;
    Pair<T> const in_tooth{inner(n, place.along), inner(n, place.outward)};
    contact.velocity = place.velocity(centre + (T(arc.radius) + offset) * in_tooth);
    Pair<T> const start{cos(T(arc.from)), sin(T(arc.from))};
    contact.t = atan2(start.x * in_tooth.y - start.y * in_tooth.x, inner(start, in_tooth)) / (T(arc.to) - T(arc.from));
    return contact;
}

/// The normal speeds of both ends of a line, and between them the place where it vanishes.
template <class T>
ReferenceContact<T> contact_at(profile::LinePiece const& line, int, MovingFrame<T> const& place, T const& offset)
{
    Pair<T> const a = pair_of<T>(line.a), b = pair_of<T>(line.b);
    Pair<T> const along = b - a;
    ReferenceContact<T> contact;
    Pair<T> const n = (T(1) / length(along)) * to_left(along);
    contact.normal = place.turned(n);
    T const at_a = inner(contact.normal, place.velocity(a)), at_b = inner(contact.normal, place.velocity(b));
    contact.t = at_a / (at_a - at_b);
    Pair<T> const x = a + contact.t * along + offset * n;
    contact.point = place.point(x);
    contact.velocity = place.velocity(x);
    return contact;
}

/// The secant rule from a guess on n.v along a polynomial.
template <class T>
ReferenceContact<T> contact_at(profile::CurvePiece const& curve, double guess, MovingFrame<T> const& place,
                               T const& offset)
{
    struct Seen
    {
        Pair<T> x, n;
        T f;
    };
    std::vector<double> const x1 = numeric::bernstein_derivative(curve.x()),
                              y1 = numeric::bernstein_derivative(curve.y());
    auto const look = [&](T const& t) -> Seen {
        Pair<T> const x{casteljau(curve.x(), t), casteljau(curve.y(), t)};
        Pair<T> const slope{casteljau(x1, t), casteljau(y1, t)};
        Pair<T> const n = (T(1) / length(slope)) * to_left(slope);
        return {x, n, inner(place.turned(n), place.velocity(x))};
    };
    T a(guess);
    T b = a + T(0x1p-40);  // closer than another root may be
    T fa = look(a).f;
    constexpr int budget = 40;
    for (int i = 0; i < budget; ++i) {
        T const fb = look(b).f;
        if (fb == fa)
            break;
        T const next = b - fb * (b - a) / (fb - fa);
        T const step = abs(next - b);
        a = b;
        fa = fb;
        b = next;
        if (step <= T(4) * std::numeric_limits<T>::epsilon())
            break;
    }
    Seen const seen = look(b);
    ReferenceContact<T> contact;
    contact.normal = place.turned(seen.n);
    Pair<T> const x = seen.x + offset * seen.n;
    contact.point = place.point(x);
    contact.velocity = place.velocity(x);
    contact.t = b;
    return contact;
}

}  // namespace hdconj::accuracy
