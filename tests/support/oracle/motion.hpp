// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The relative motion of a flexspline tooth and the circular spline by the oracle's own path.
///
/// Exact: the neutral curve rho(u) = r_0 + w0 cos(n u) does not stretch. The frame is built from
/// the tangent vector dP/du, not from angles; r_0 by the trapezoidal rule over a period (converges
/// exponentially for a periodic analytic integrand); the undeformed angle from the Fourier series
/// of the speed, and a second time by Gauss-Legendre quadrature.
///
/// First order: thesis (2-16), (2-17), (2-19) for n waves, explicit in the undeformed angle phi:
///   rho = r_m + w0 cos(n phi), phi_1 = phi - w0 sin(n phi) / (n r_m),
///   mu = w0 (n - 1/n) sin(n phi) / r_m, turned by phi + mu - phi_2.
///
/// Material: the point of the undeformed circle at phi goes to (r_m + w(phi)) e_r + v(phi) e_t with the cam's w at phi
/// and v = -integral of (w - mean); its frame from the tangent vector dP/dphi.
///
/// The parameter `s` of a position is u (exact) or phi (first order, material).
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "cam.hpp"
#include "hdconj/scene.hpp"
#include "number.hpp"
#include "quadrature.hpp"
#include "tooth.hpp"

namespace oracle {

/// Where a tooth is in the circular-spline frame: origin and axes of the tooth frame.
template <class T>
struct Pose
{
    Point<T> origin, along, outward;

    Point<T> to_circular_spline(Point<T> const& in_tooth) const
    {
        return origin + in_tooth.x * along + in_tooth.y * outward;
    }
    Point<T> to_tooth(Point<T> const& in_circular_spline) const
    {
        Point<T> const d = in_circular_spline - origin;
        return {dot(d, along), dot(d, outward)};
    }
};

template <class T>
class Motion
{
  public:
    /// @param closed  false leaves r_0 = r_m, as the thesis prints it: the curve is then too long by
    ///                about 2 pi w0^2 / r_m. Only to compare with numbers computed that way.
    explicit Motion(hdconj::Scene const& scene, bool closed = true)
    {
        auto const& flexspline = scene.flexspline;
        T const inner = flexspline.inner_radius ? T(*flexspline.inner_radius)
                                                : T(scene.drive.module) * T(scene.drive.flexspline_teeth) / T(2) -
                                                      T(dedendum_of(scene)) - T(flexspline.wall);
        r_m = inner + T(flexspline.wall) / T(2) - T(flexspline.neutral_offset);
        waves = scene.wave_generator.waves;
        cam_ = Cam<T>(scene, r_m);
        w0 = cam_.w0;
        cosine_ = scene.wave_generator.shape.family == "cosine";
        circular_spline_teeth = scene.drive.circular_spline_teeth;
        pitches_per_turn = scene.drive.circular_spline_teeth - scene.drive.flexspline_teeth;
        turn_ratio = T(scene.drive.flexspline_teeth) / T(scene.drive.circular_spline_teeth);
        exact = scene.solver.kinematics == hdconj::Kinematics::exact;
        material_ = scene.solver.kinematics == hdconj::Kinematics::material;
        r_0 = r_m;
        if (exact) {
            if (cosine_) {
                close(closed);
                expand();
            } else {
                close_any();
            }
        } else if (!cosine_) {
            w_ = RunningIntegral<T>([cam = cam_](T const& u) { return cam(u).w; }, T(2) * half_lobe(), cam_.breaks);
            mean_ = w_.total() / (T(2) * half_lobe());
        }
    }

    /// Undeformed angle of the tooth at @p s.
    T phi(T const& s) const
    {
        using std::cos;
        using std::sin;
        if (!exact)
            return s;
        if (!cosine_)
            return length_(s) / r_m;
        // sum of c_k sin(k x) by Clenshaw's recurrence
        T const x = T(waves) * s, twice_cos = T(2) * cos(x);
        T b1(0), b2(0);
        for (std::size_t k = sine_.size(); k-- > 0;) {
            T const b = sine_[k] + twice_cos * b1 - b2;
            b2 = b1;
            b1 = b;
        }
        return drift_ * s + b1 * sin(x);
    }

    /// The same by Gauss-Legendre quadrature of the arc length: sums @p panels panels.
    T phi_by_quadrature(T const& s, GaussLegendre<T> const& rule, int panels = 4) const
    {
        if (!exact)
            return s;
        T const half = s / T(2 * panels);
        T sum(0);
        for (int panel = 0; panel < panels; ++panel)
            for (std::size_t i = 0; i < rule.node.size(); ++i)
                sum += rule.weight[i] * speed(half * (T(2 * panel + 1) + rule.node[i]));
        return half * sum / r_m;
    }

    /// Polar angle on the neutral curve at @p s.
    T u(T const& s) const
    {
        using std::sin;
        if (exact)
            return s;
        if (material_) {
            using std::atan2;
            return s + atan2(v(s), r_m + cam_(s).w);
        }
        return cosine_ ? s - w0 * sin(T(waves) * s) / (T(waves) * r_m) : s - (w_(s) - mean_ * s) / r_m;
    }

    Pose<T> pose(T const& s) const { return pose(s, phi(s)); }

    /// Pose at @p s with the undeformed angle @p phi known.
    Pose<T> pose(T const& s, T const& phi) const
    {
        using std::cos;
        using std::sin;
        T const turned_back = turn_ratio * phi;
        if (material_)
            return turned(material_point(s), turned_back);
        if (!exact && !cosine_) {
            Radial<T> const r = cam_(s);
            T const rho = r_m + r.w, gamma = u(s) - turned_back, tilt = gamma - r.slope / r_m;
            T const c = cos(tilt), d = sin(tilt);
            return {{rho * sin(gamma), rho * cos(gamma)}, {c, -d}, {d, c}};
        }
        if (!exact) {
            T const n(waves);
            T const wave = sin(n * s);
            T const rho = r_m + w0 * cos(n * s);
            T const gamma = u(s) - turned_back;
            T const tilt = s + w0 * (n - T(1) / n) * wave / r_m - turned_back;
            T const c = cos(tilt), d = sin(tilt);
            return {{rho * sin(gamma), rho * cos(gamma)}, {c, -d}, {d, c}};
        }
        Radial<T> const radial = cam_(s);
        T const rho = r_0 + radial.w, slope = radial.slope;
        T const c = cos(s), d = sin(s);
        return turned({{rho * d, rho * c}, {slope * d + rho * c, slope * c - rho * d}}, turned_back);
    }

    /// d(pose)/ds by a central difference of order four of the pose itself.
    Pose<T> pose_rate(T const& s) const
    {
        using std::pow;
        T const h = pow(std::numeric_limits<T>::epsilon(), T(1) / T(5));
        Pose<T> const a = pose(s - T(2) * h), b = pose(s - h), c = pose(s + h), d = pose(s + T(2) * h);
        auto const rate = [&](Point<T> const& pa, Point<T> const& pb, Point<T> const& pc, Point<T> const& pd) {
            return (T(1) / (T(12) * h)) * ((pa - pd) + T(8) * (pc - pb));
        };
        return {rate(a.origin, b.origin, c.origin, d.origin), rate(a.along, b.along, c.along, d.along),
                rate(a.outward, b.outward, c.outward, d.outward)};
    }

    /// Half the range of s after which everything repeats, moved by whole pitches.
    T half_lobe() const { return pi<T>() / T(waves); }
    T pitch() const { return T(2) * pi<T>() / T(circular_spline_teeth); }

    T r_m{}, r_0{}, w0{}, turn_ratio{};
    int waves = 2, circular_spline_teeth = 0;
    int pitches_per_turn = 0;  ///< z_c - z_f
    bool exact = true;

  private:
    /// A point of the deformed curve in the fixed frame and its derivative with respect to the parameter.
    struct Moving
    {
        Point<T> point, velocity;
    };

    /// Tangential displacement, material.
    T v(T const& s) const
    {
        using std::sin;
        return cosine_ ? -w0 * sin(T(waves) * s) / T(waves) : mean_ * s - w_(s);
    }

    Moving material_point(T const& s) const
    {
        using std::cos;
        using std::sin;
        Radial<T> const radial = cam_(s);
        T const c = cos(s), d = sin(s), out = r_m + radial.w, along = v(s), stretch = mean_ - radial.w;
        Point<T> const e_r{d, c}, e_t{c, -d};
        return {out * e_r + along * e_t, (radial.slope - along) * e_r + (out + stretch) * e_t};
    }

    /// The frame on the curve there, from the fixed frame to the one that has turned clockwise by @p turned_back.
    static Pose<T> turned(Moving const& at, T const& turned_back)
    {
        using std::cos;
        using std::sin;
        T const back = -turned_back, cb = cos(back), sb = sin(back);
        auto const turn = [&](Point<T> const& a) -> Point<T> { return {a.x * cb + a.y * sb, a.y * cb - a.x * sb}; };
        Point<T> const along = turn((T(1) / length(at.velocity)) * at.velocity);
        return {turn(at.point), along, {-along.y, along.x}};
    }

    T speed(T const& u) const
    {
        using std::sqrt;
        Radial<T> const r = cam_(u);
        T const rho = r_0 + r.w, slope = r.slope;
        return sqrt(rho * rho + slope * slope);
    }

    /// Mean of the speed over one lobe by the trapezoidal rule.
    T mean_speed(int points) const
    {
        T sum(0);
        for (int i = 0; i < points; ++i)
            sum += speed(T(2) * pi<T>() * T(i) / (T(waves) * T(points)));
        return sum / T(points);
    }

    /// r_0 with 2 pi mean_speed = 2 pi r_m, by the secant rule.
    void close(bool closed)
    {
        using std::abs;
        points_ = 16;
        for (T before(0);; points_ *= 2) {
            T const now = mean_speed(points_);
            if (abs(now - before) <= T(64) * std::numeric_limits<T>::epsilon() * r_m)
                break;
            if (points_ > 1 << 14)
                throw std::runtime_error("oracle: the neutral curve is not smooth");
            before = now;
        }
        if (!closed)
            return;
        T a = r_m, fa = mean_speed(points_) - r_m;
        r_0 = r_m - fa;
        for (int step = 0; step < 60; ++step) {
            T const b = r_0, fb = mean_speed(points_) - r_m;
            if (fb == fa || abs(b - a) <= std::numeric_limits<T>::epsilon() * r_m)
                break;
            r_0 = b - fb * (b - a) / (fb - fa);
            a = b;
            fa = fb;
        }
    }

    /// The same for a wave generator with breaks, by quadrature between them; the arc length as a running integral.
    void close_any()
    {
        using std::abs;
        auto const mean_length = [&] {
            return RunningIntegral<T>([this](T const& u) { return speed(u); }, T(2) * half_lobe(), cam_.breaks)
                       .total() /
                   (T(2) * half_lobe());
        };
        T a = r_m, fa = mean_length() - r_m;
        r_0 = r_m - fa;
        for (int step = 0; step < 60; ++step) {
            T const b = r_0, fb = mean_length() - r_m;
            if (fb == fa || abs(b - a) <= std::numeric_limits<T>::epsilon() * r_m)
                break;
            r_0 = b - fb * (b - a) / (fb - fa);
            a = b;
            fa = fb;
        }
        length_ = RunningIntegral<T>(
            [cam = cam_, mean = r_0](T const& u) {
                using std::sqrt;
                Radial<T> const r = cam(u);
                return sqrt((mean + r.w) * (mean + r.w) + r.slope * r.slope);
            },
            T(2) * half_lobe(), cam_.breaks);
    }

    /// phi = slope u + sum c_k sin(k n u): the integrated Fourier series of the speed. The slope is 1
    /// when the curve is closed.
    void expand()
    {
        using std::abs;
        using std::cos;
        std::vector<T> values;
        for (int i = 0; i < points_; ++i)
            values.push_back(speed(T(2) * pi<T>() * T(i) / (T(waves) * T(points_))));
        for (int k = 1; k < points_ / 2; ++k) {
            T sum(0);
            for (int i = 0; i < points_; ++i)
                sum += values[static_cast<std::size_t>(i)] * cos(T(2) * pi<T>() * T((k * i) % points_) / T(points_));
            T const amplitude = T(2) * sum / (T(points_) * r_m);
            sine_.push_back(amplitude / T(k * waves));
        }
        drift_ = mean_speed(points_) / r_m;
        while (!sine_.empty() && abs(sine_.back()) < std::numeric_limits<T>::epsilon() / T(8))
            sine_.pop_back();
    }

    Cam<T> cam_;
    bool cosine_ = true;
    RunningIntegral<T> length_, w_;  ///< of wave generators other than cosine
    T mean_{};                       ///< of w, first order and material
    bool material_ = false;
    int points_ = 0;
    T drift_{1};
    std::vector<T> sine_;
};

}  // namespace oracle
