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

#include "families.hpp"
#include "hdconj/scene.hpp"
#include "number.hpp"

namespace oracle {

/// A number of the scene, read from its data without help from the library.
inline bool given(hdconj::scene::FamilyChoice const& choice, std::string const& key)
{
    return choice.given.count(key) == 1;
}

inline double number_of(hdconj::scene::FamilyChoice const& choice, std::string const& key)
{
    auto const found = choice.given.find(key);
    if (found == choice.given.end())
        throw std::invalid_argument("oracle: no " + key);
    return std::get<double>(found->second.value);
}

inline double number_of(hdconj::scene::FamilyChoice const& choice, std::string const& key, double otherwise)
{
    return given(choice, key) ? number_of(choice, key) : otherwise;
}

/// Depth of the root below the pitch line, whatever key says it.
inline double dedendum_of(hdconj::Scene const& scene)
{
    auto const& profile = scene.flexspline.profile;
    if (given(profile, "dedendum"))
        return number_of(profile, "dedendum");
    auto const points = points_of(scene);
    return -std::min(points.front().y, points.back().y);
}

inline double addendum_of(hdconj::Scene const& scene)
{
    auto const& profile = scene.flexspline.profile;
    if (given(profile, "addendum"))
        return number_of(profile, "addendum");
    auto const points = points_of(scene);
    return std::max(points.front().y, points.back().y);
}

/// A piece of the right flank, or the right half of the flat tip.
template <class T>
struct Piece
{
    std::string name;  ///< "concave", "line", "convex", "tip line", "tip"
    bool arc = false;
    Point<T> lower, upper;                         ///< ends; for the tip: corner, then the middle
    Point<T> centre;                               ///< of an arc
    T radius{};                                    ///< of an arc
    int side = 1;                                  ///< arc: +1 body inside the circle (convex), -1 outside
    std::shared_ptr<FlankCurve<T> const> curve{};  ///< neither line nor arc

    /// Point at @p s, 0 at lower, 1 at upper, proportional to arc length.
    Point<T> at(T const& s) const
    {
        if (curve)
            return (*curve)(s).point;
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
            Point<T> const d = curve ? (*curve)(s).slope : upper - lower;
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
        if (curve)
            return curve->distance(p);
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
        addendum = T(addendum_of(scene));
        dedendum = T(dedendum_of(scene));
        if (profile.family == "double-circular-arc")
            double_arc(profile);
        else if (profile.family == "straight")
            straight(profile);
        else
            curves(scene);
        pitch_line = T(scene.flexspline.wall) / T(2) + dedendum + T(scene.flexspline.neutral_offset);
        top = pitch_line + addendum;
        half_width = T(0);
        for (auto const& piece : flank) {
            half_width = std::max(half_width, std::max(piece.lower.x, piece.upper.x));
            if (piece.curve)
                half_width = std::max(half_width, piece.curve->widest());
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
            if (piece.curve && piece.curve->is_beyond(p, best))
                continue;
            T const d = piece.distance(p);
            if (d < best)
                best = d;
        }
        return p.y < addendum && inside(p) ? -best : best;
    }

    /// The same with @p p in the tooth frame, whose origin is on the neutral curve.
    T distance(Point<T> const& p) const { return distance_from_pitch_line({p.x, p.y - pitch_line}); }

    /// p.x < X(p.y) for a point below the tip, X found only where it matters.
    bool inside(Point<T> const& p) const
    {
        if (p.y > root().y)
            for (auto const& piece : flank)
                if (piece.curve && p.y <= piece.upper.y && p.y >= piece.lower.y)
                    return piece.curve->is_left(p);
        return p.x < half_thickness(p.y);
    }

    /// X(y).
    T half_thickness(T const& y) const
    {
        using std::sqrt;
        if (y <= root().y)
            return root().x;
        for (auto const& piece : flank) {
            if (piece.name == "tip" || y > piece.upper.y)
                continue;
            if (piece.curve)
                return piece.curve->x_at(y);
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

    void double_arc(hdconj::scene::FamilyChoice const& profile)
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

    void add_curve(char const* name, std::shared_ptr<FlankCurve<T> const> curve)
    {
        flank.push_back({name, false, (*curve)(T(0)).point, (*curve)(T(1)).point, {}, T(0), 1, curve});
    }

    /// Height of a formula at a parameter, less @p y.
    template <class F>
    static auto above(F const& formula, T const& y)
    {
        return [formula, y](T const& u) { return formula(u).point.y - y; };
    }

    void curves(hdconj::Scene const& scene)
    {
        using std::tan;
        auto const& profile = scene.flexspline.profile;
        T const r = T(scene.drive.module) * T(scene.drive.flexspline_teeth) / T(2);
        T const half(number_of(profile, "thickness", pi<double>() * scene.drive.module / 2) / 2);
        T const degree = pi<T>() / T(180);
        if (profile.family == "involute") {
            T const alpha = T(number_of(profile, "pressure_angle_deg")) * degree;
            StringEnd<T> const end(r, alpha, T(2) * half);
            T lowest(0);
            if (end(T(0)).point.y > -dedendum) {
                Point<T> const base = end(T(0)).point, down = T(-1) * clockwise(end.offset);
                add_line("radial", base + ((base.y + dedendum) / -down.y) * down, base);
            } else
                lowest = bisected(above(end, -dedendum), T(0), tan(alpha));
            add_curve("involute",
                      stretch<T>(end, lowest, bisected(above(end, addendum), tan(alpha), tan(alpha) + T(1))));
        } else if (profile.family == "cycloid") {
            RollingPoint<T> const outside{r, T(number_of(profile, "addendum_rolling_radius")), half / r, true};
            RollingPoint<T> const inside{r, T(number_of(profile, "dedendum_rolling_radius")), half / r, false};
            add_curve("hypocycloid", stretch<T>(inside, bisected(above(inside, -dedendum), T(0), T(3)), T(0), 192));
            add_curve("epicycloid", stretch<T>(outside, T(0), bisected(above(outside, addendum), T(0), T(3)), 192));
        } else if (profile.family == "s-tooth") {
            T const kappa(number_of(profile, "deflection")), n(scene.wave_generator.waves);
            HalfLocus<T> locus{
                T(scene.drive.module) * T(scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth) / T(2),
                n,
                kappa,
                T(0),
                {}};
            using std::acos;
            T const steepest = kappa < T(1) ? acos(kappa) : acos(T(1) / kappa);
            auto const slope = [&](T const& eta) { return T(-1) * locus(eta).slope.x / locus(eta).slope.y; };
            bool const least = !given(profile, "pressure_angle_deg");
            T const tangent = least ? slope(steepest) : tan(T(number_of(profile, "pressure_angle_deg")) * degree);
            T const begin =
                least ? steepest
                      : bisected([&](T const& eta) { return slope(eta) - tangent; }, steepest + T(1e-9), T(3));
            locus.eta_datum = begin;
            T const rise(number_of(profile, "datum_rise", 0.0));
            if (rise < T(0))
                throw std::invalid_argument("oracle: datum point below the pitch line");
            locus.datum = {half - rise * tangent, rise};
            add_line("line", {half + dedendum * tangent, -dedendum}, locus.datum);
            add_curve("locus", stretch<T>(locus, begin, bisected(above(locus, addendum), begin, pi<T>())));
        } else if (profile.family == "arc-chain") {
            chain(profile);
        } else if (profile.family == "bezier") {
            auto const control = points_of(scene);
            std::size_t const degree_of =
                static_cast<std::size_t>(number_of(profile, "degree", static_cast<double>(control.size() - 1)));
            for (std::size_t last = control.size() - 1; last > 0; last -= degree_of) {
                BezierCurve<T> curve;
                for (std::size_t i = 0; i <= degree_of; ++i)
                    curve.control.push_back(as<T>(control[last - i]));
                add_curve("curve", stretch<T>(curve, T(0), T(1), 64));
            }
        } else if (profile.family == "b-spline" || profile.family == "points") {
            std::vector<Point<T>> points;
            for (auto const& p : points_of(scene))
                points.push_back(as<T>(p));
            for (auto const& curve : spline_curves(points))
                add_curve("spline", curve);
        } else
            throw std::invalid_argument("oracle: no family " + profile.family);
        add_line("tip", flank.back().upper, {T(0), addendum});
    }

    /// From the tip down, the heading turning by each sweep; the last piece ends where it comes to the root.
    void chain(hdconj::scene::FamilyChoice const& profile)
    {
        using std::asin;
        using std::cos;
        using std::sin;
        Point<T> at{T(number_of(profile, "tip_thickness")) / T(2), addendum};
        T normal = T(number_of(profile, "tip_angle_deg")) * pi<T>() / T(180);
        auto const& rows = std::get<hdconj::scene::NumberRows>(profile.given.find("pieces")->second.value);
        std::vector<Piece<T>> down;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            bool const last = i + 1 == rows.size();
            Point<T> const n{cos(normal), sin(normal)};
            if (rows[i].size() == 1) {
                T const full = T(rows[i][0]), to_root = (at.y + dedendum) / n.x;
                T const way = last ? std::min(full, to_root) : full;
                Point<T> const end = at + way * Point<T>{n.y, -n.x};
                down.push_back({"line", false, end, at, {}, T(0), 1});
                at = end;
                continue;
            }
            T const radius(rows[i][0]);
            Point<T> const centre = at - radius * n;
            T to = normal - (radius > T(0) ? T(1) : T(-1)) * T(rows[i][1]) * pi<T>() / T(180);
            if (last)
                to = asin((-dedendum - centre.y) / radius);
            Point<T> const end = centre + radius * Point<T>{cos(to), sin(to)};
            down.push_back({"arc", true, end, at, centre, radius < T(0) ? -radius : radius, radius > T(0) ? 1 : -1});
            at = end;
            normal = to;
        }
        flank.assign(down.rbegin(), down.rend());
    }

    void straight(hdconj::scene::FamilyChoice const& profile)
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
