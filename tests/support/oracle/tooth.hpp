// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The flexspline tooth by the oracle's own derivation, as a body with a signed distance.
///
/// The right flank is x = X(y), one value per height, from the root end up to the tip:
///
///   concave arc   centre F, the body outside of the circle
///   line          the crossed tangent of both circles (absent when they touch)
///   convex arc    centre A, the body inside of the circle
///   tip line      tangent to the convex arc where it starts (absent without tip_line_from)
///   tip           flat, at the addendum
///
/// With n the outward normal of the crossed tangent, both A + r_a n and F - r_f n lie on it, so
/// n.(F - A) = r_a + r_f: n is F - A turned counter-clockwise by acos((r_a + r_f) / |F - A|),
/// counter-clockwise because the flank runs down from A's side to F's side.
///
/// The body is |x| <= X(y), y <= addendum, with X continued downwards as a constant below the root
/// end. Only points above the tip circle of the circular spline may be asked, where this
/// continuation is never the nearest part.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "hdconj/scene/scene.hpp"
#include "support/oracle/number.hpp"

namespace oracle {

/// A number of the scene, read from its data without help from the library.
inline bool given(hdconj::FamilyChoice const& choice, std::string const& key)
{
    return choice.given.count(key) == 1;
}

inline double number_of(hdconj::FamilyChoice const& choice, std::string const& key)
{
    auto const found = choice.given.find(key);
    if (found == choice.given.end())
        throw std::invalid_argument("oracle: no " + key);
    return std::get<double>(found->second.value);
}

inline double number_of(hdconj::FamilyChoice const& choice, std::string const& key, double otherwise)
{
    return given(choice, key) ? number_of(choice, key) : otherwise;
}

/// A piece of the right flank, or the right half of the flat tip.
template <class T>
struct Piece
{
    std::string name;  ///< "concave", "line", "convex", "tip line", "tip"
    bool arc = false;
    Point<T> lower, upper;  ///< ends; for the tip: corner, then the middle
    Point<T> centre;        ///< of an arc
    T radius{};             ///< of an arc
    int side = 1;           ///< arc: +1 body inside the circle (convex), -1 outside

    /// Point at @p s, 0 at lower, 1 at upper, proportional to arc length.
    Point<T> at(T const& s) const
    {
        if (!arc)
            return lower + s * (upper - lower);
        return centre + T(side) * radius * normal(s);
    }

    /// Outward unit normal at @p s.
    Point<T> normal(T const& s) const
    {
        using std::atan2;
        using std::cos;
        using std::sin;
        if (!arc) {
            Point<T> const d = upper - lower;
            T const l = length(d);
            return {d.y / l, -d.x / l};
        }
        Point<T> const a = lower - centre, b = upper - centre;
        T const from = atan2(T(side) * a.y, T(side) * a.x), to = atan2(T(side) * b.y, T(side) * b.x);
        T const angle = from + s * (to - from);
        return {cos(angle), sin(angle)};
    }

    T arc_length() const
    {
        using std::acos;
        using std::asin;
        T const chord = length(upper - lower);
        return arc ? T(2) * radius * asin(chord / (T(2) * radius)) : chord;
    }

    /// Distance of @p p from this piece.
    T distance(Point<T> const& p) const
    {
        using std::abs;
        if (arc) {
            Point<T> const from_centre = p - centre;
            T const l = length(from_centre);
            if (l == T(0))
                return radius;
            // Along the right flank the height grows from lower to upper, so that the foot
            // of the perpendicular is on the arc when its height and its side are right.
            T const foot_y = centre.y + radius * from_centre.y / l;
            if (T(side) * from_centre.x > T(0) && foot_y >= lower.y && foot_y <= upper.y)
                return abs(l - radius);
        } else {
            Point<T> const d = upper - lower, q = p - lower;
            T const along = dot(d, q), whole = dot(d, d);
            if (along >= T(0) && along <= whole)
                return abs(d.x * q.y - d.y * q.x) / length(d);
        }
        T const to_lower = length(p - lower), to_upper = length(p - upper);
        return to_lower < to_upper ? to_lower : to_upper;
    }
};

template <class T>
class Tooth
{
  public:
    explicit Tooth(hdconj::Scene const& scene)
    {
        auto const& profile = scene.flexspline.profile;
        addendum = T(number_of(profile, "addendum"));
        dedendum = T(number_of(profile, "dedendum"));
        if (profile.family == "double-circular-arc")
            double_arc(profile);
        else
            straight(profile);
        pitch_line = T(scene.flexspline.wall) / T(2) + dedendum + T(scene.flexspline.neutral_offset);
        top = pitch_line + addendum;
        half_width = T(0);
        for (auto const& piece : flank) {
            half_width = std::max(half_width, std::max(piece.lower.x, piece.upper.x));
            // An undercut convex arc is widest at the height of its centre.
            if (piece.arc && piece.side > 0 && piece.lower.y < piece.centre.y && piece.upper.y > piece.centre.y)
                half_width = std::max(half_width, piece.centre.x + piece.radius);
        }
    }

    /// Signed distance of @p p (height from the pitch line) to the body, negative inside.
    T distance_from_pitch_line(Point<T> p) const
    {
        using std::abs;
        p.x = abs(p.x);
        T best = abs(p.x - root().x);
        if (p.y > root().y)
            best = length(p - root());
        for (auto const& piece : flank) {
            T const d = piece.distance(p);
            if (d < best)
                best = d;
        }
        return p.y < addendum && p.x < half_thickness(p.y) ? -best : best;
    }

    /// The same with @p p in the tooth frame, whose origin is on the neutral curve.
    T distance(Point<T> const& p) const { return distance_from_pitch_line({p.x, p.y - pitch_line}); }

    /// X(y).
    T half_thickness(T const& y) const
    {
        using std::sqrt;
        if (y <= root().y)
            return root().x;
        for (auto const& piece : flank) {
            if (piece.name == "tip" || y > piece.upper.y)
                continue;
            if (!piece.arc)
                return piece.lower.x +
                       (y - piece.lower.y) / (piece.upper.y - piece.lower.y) * (piece.upper.x - piece.lower.x);
            T const rise = y - piece.centre.y;
            return piece.centre.x + T(piece.side) * sqrt(piece.radius * piece.radius - rise * rise);
        }
        return flank.back().lower.x;
    }

    Point<T> root() const { return flank.front().lower; }
    /// Corner between flank and flat tip.
    Point<T> tip_corner() const { return flank.back().lower; }

    /// Piece @p index of the whole tooth in the order left root, tip, right root, at @p t in 0 ... 1
    /// along it: point in the tooth frame and outward normal. The two halves of the flat tip are
    /// one piece.
    struct OnProfile
    {
        Point<T> point, normal;
    };
    std::size_t pieces_of_whole() const { return 2 * flank.size() - 1; }
    OnProfile on_whole(std::size_t index, T const& t) const
    {
        std::size_t const flat = flank.size() - 1;
        Point<T> p, n;
        if (index == flat) {
            p = {(T(2) * t - T(1)) * tip_corner().x, addendum};
            n = {T(0), T(1)};
        } else if (index < flat) {
            p = flank[index].at(t);
            n = flank[index].normal(t);
            p.x = -p.x;
            n.x = -n.x;
        } else {
            std::size_t const mirrored = 2 * flat - index;
            p = flank[mirrored].at(T(1) - t);
            n = flank[mirrored].normal(T(1) - t);
        }
        p.y += pitch_line;
        return {p, n};
    }
    std::string name_of_whole(std::size_t index) const
    {
        std::size_t const flat = flank.size() - 1;
        if (index == flat)
            return "tip";
        return (index < flat ? "left " : "right ") + flank[index < flat ? index : 2 * flat - index].name;
    }

    std::vector<Piece<T>> flank;  ///< from the root end up, last the right half of the tip
    T addendum{}, dedendum{};
    T pitch_line{};  ///< height of the pitch line above the neutral curve
    T top{};         ///< height of the tip above the neutral curve
    T half_width{};

  private:
    void add_line(char const* name, Point<T> const& lower, Point<T> const& upper)
    {
        flank.push_back({name, false, lower, upper, {}, T(0), 1});
    }
    void add_arc(char const* name, Point<T> const& lower, Point<T> const& upper, Point<T> const& centre,
                 T const& radius, int side)
    {
        flank.push_back({name, true, lower, upper, centre, radius, side});
    }

    void double_arc(hdconj::FamilyChoice const& profile)
    {
        using std::acos;
        using std::atan2;
        using std::cos;
        using std::sin;
        using std::sqrt;
        T const ra(number_of(profile, "convex_radius")), rf(number_of(profile, "concave_radius"));
        Point<T> const a{-T(number_of(profile, "convex_offset")), T(number_of(profile, "convex_rise", 0.0))};
        T const concave_rise(number_of(profile, "concave_rise"));
        T const sum = ra + rf, rise = concave_rise - a.y;
        bool const touching = std::holds_alternative<std::string>(profile.given.find("concave_offset")->second.value);
        Point<T> const f{touching ? sqrt(sum * sum - rise * rise) + a.x : T(number_of(profile, "concave_offset")),
                         concave_rise};
        T delta = atan2(f.y - a.y, f.x - a.x);
        if (!touching) {
            T const apart = length(f - a);
            if (apart < sum)
                throw std::invalid_argument("oracle: the arcs overlap");
            delta += acos(sum / apart);
        }
        Point<T> const n{cos(delta), sin(delta)};
        Point<T> const on_convex = a + ra * n, on_concave = f - rf * n;

        T const down = -dedendum - f.y;
        Point<T> const root{f.x - sqrt(rf * rf - down * down), -dedendum};
        add_arc("concave", root, on_concave, f, rf, -1);
        if (!touching)
            add_line("line", on_concave, on_convex);

        T const end = given(profile, "tip_line_from") ? T(number_of(profile, "tip_line_from")) : addendum;
        T const up = end - a.y;
        Point<T> const arc_end{a.x + sqrt(ra * ra - up * up), end};
        add_arc("convex", on_convex, arc_end, a, ra, 1);
        Point<T> corner = arc_end;
        if (given(profile, "tip_line_from")) {
            // The tangent at arc_end: its normal is (arc_end - a) / ra, so dx/dy = -n_y / n_x.
            corner = {arc_end.x - (addendum - end) * up / (arc_end.x - a.x), addendum};
            add_line("tip line", arc_end, corner);
        }
        add_line("tip", corner, {T(0), addendum});
    }

    void straight(hdconj::FamilyChoice const& profile)
    {
        using std::tan;
        T const slope = tan(T(number_of(profile, "pressure_angle_deg")) * pi<T>() / T(180));
        T const half = T(number_of(profile, "thickness")) / T(2);
        Point<T> const corner{half - addendum * slope, addendum};
        add_line("line", {half + dedendum * slope, -dedendum}, corner);
        add_line("tip", corner, {T(0), addendum});
    }
};

}  // namespace oracle
