// SPDX-License-Identifier: GPL-3.0-or-later
// Loops of plain arithmetic over the columns of a block. They are compiled with -fno-math-errno and -fno-trapping-math,
// which change no value, and -ffp-contract=off as everything else: each copy of a loop does the same operations in the
// same order.
#include "hdconj/envelope/contact_batch.hpp"

#include <algorithm>
#include <cmath>

#include "sine_cosine.hpp"

namespace hdconj::envelope {
namespace {

/// As many as fit, with all their columns, into the nearest cache.
constexpr std::size_t block = 256;

/// One column per number of an EnvelopePoint.
struct Columns
{
    alignas(64) double u[block];
    double t[block], x[block], y[block], n_x[block], n_y[block], error[block];
};

/// u - ratio phi, sines and cosines at one position, of which everything follows.
struct Wave
{
    double sine, cosine;  ///< of n u
    double phi;
};

/// Clenshaw's sum of the arc length, as FourierSeries::integral().
inline Wave wave_at(motion::CosineForm const& m, double u)
{
    auto const [sine, cosine] = sine_cosine(m.waves * u);
    double b1 = 0, b2 = 0;
    for (std::size_t k = motion::CosineForm::harmonics; k >= 1; --k) {
        double const b0 = m.sines[k - 1] + 2 * cosine * b1 - b2;
        b2 = b1;
        b1 = b0;
    }
    return {sine, cosine, (m.mean * u + b1 * sine) / m.r_m};
}

/// Pose and rates at one position: ExactMotion::state().
struct State
{
    double cosine, sine, p_x, p_y;  ///< of the pose
    double omega, q_x, q_y;
    double omega_size, q_size;
};

inline State state_at(motion::CosineForm const& m, double u)
{
    Wave const wave = wave_at(m, u);
    auto const [sg, cg] = sine_cosine(u - m.ratio * wave.phi);
    double const k = m.ratio / m.r_m;
    double const rho = m.r_0 + m.w0 * wave.cosine;
    double const rho1 = -m.waves * m.w0 * wave.sine;
    double const rho2 = -m.waves * m.waves * m.w0 * wave.cosine;
    double const s2 = rho * rho + rho1 * rho1;
    double const s = std::sqrt(s2);
    double const bend = rho * rho2 - rho1 * rho1;
    double const cos_tilt = rho / s, sin_tilt = rho1 / s;
    State r;
    r.cosine = cg * cos_tilt + sg * sin_tilt;
    r.sine = sg * cos_tilt - cg * sin_tilt;
    r.p_x = rho * sg;
    r.p_y = rho * cg;
    r.omega = 1 - k * s - bend / s2;
    r.q_x = s - k * rho * rho;
    r.q_y = k * rho * rho1;
    r.omega_size = 1 + k * s + std::abs(bend) / s2;
    r.q_size = s + k * rho * rho + k * rho * std::abs(rho1);
    return r;
}

/// Angle of a vector against a unit vector, of which @p along and @p across are its parts, by halving three times and
/// Taylor's series; not a number beyond a quarter turn.
inline double angle_of(double along, double across)
{
    double const half = across / (1 + along);
    double const quarter = half / (1 + std::sqrt(1 + half * half));
    double const w = quarter / (1 + std::sqrt(1 + quarter * quarter));
    double const z = w * w;
    constexpr double a3 = -1.0 / 3, a5 = 1.0 / 5, a7 = -1.0 / 7, a9 = 1.0 / 9, a11 = -1.0 / 11, a13 = 1.0 / 13,
                     a15 = -1.0 / 15, a17 = 1.0 / 17, a19 = -1.0 / 19, a21 = 1.0 / 21, a23 = -1.0 / 23;
    double const series =
        w + w * z *
                (a3 +
                 z * (a5 +
                      z * (a7 + z * (a9 + z * (a11 +
                                               z * (a13 + z * (a15 + z * (a17 + z * (a19 + z * (a21 + z * a23))))))))));
    return along >= 0 ? 8 * series : std::numeric_limits<double>::quiet_NaN();
}

constexpr double roundings = 8;

inline void put(Columns& out, std::size_t i, State const& at, double x, double y, double n_x, double n_y, double t,
                double rounding)
{
    double const p_x = at.cosine * x + at.sine * y + at.p_x;
    double const p_y = -at.sine * x + at.cosine * y + at.p_y;
    out.t[i] = t;
    out.x[i] = p_x;
    out.y[i] = p_y;
    out.n_x[i] = at.cosine * n_x + at.sine * n_y;
    out.n_y[i] = -at.sine * n_x + at.cosine * n_y;
    out.error[i] = roundings * unit_roundoff * std::sqrt(p_x * p_x + p_y * p_y) + roundings * unit_roundoff * rounding;
}

/// arc_contact() and the point there.
HDCONJ_TARGETS
void on_arc(ContactBatch::Numbers const& given, Columns& out, std::size_t count)
{
    // a copy: nothing that is written may be taken for one of these
    ContactBatch::Numbers const n = given;
    for (std::size_t i = 0; i < count; ++i) {
        State const at = state_at(n.motion, out.u[i]);
        double const v_x = at.omega * n.a_y + at.q_x;
        double const v_y = at.q_y - at.omega * n.a_x;
        double const speed = std::sqrt(v_x * v_x + v_y * v_y);
        double const scale = n.side / speed;
        double const n_x = scale * -v_y, n_y = scale * v_x;
        double const t = 0.5 + angle_of(n.n_x * n_x + n.n_y * n_y, n.n_x * n_y - n.n_y * n_x) / n.span;
        double const v_size = at.omega_size * n.size + at.q_size;
        put(out, i, at, n.a_x + n.radius * n_x, n.a_y + n.radius * n_y, n_x, n_y, t,
            std::abs(n.radius) * v_size / speed);
    }
}

/// line_contact() and the point there.
HDCONJ_TARGETS
void on_line(ContactBatch::Numbers const& given, Columns& out, std::size_t count)
{
    ContactBatch::Numbers const n = given;
    for (std::size_t i = 0; i < count; ++i) {
        State const at = state_at(n.motion, out.u[i]);
        double const f = n.n_x * (at.omega * n.a_y + at.q_x) + n.n_y * (at.q_y - at.omega * n.a_x);
        double const s = f / at.omega;
        double const x = n.a_x + s * n.t_x, y = n.a_y + s * n.t_y;
        double const size = std::sqrt(x * x + y * y);
        double const v_size = at.omega_size * size + at.q_size + std::abs(n.radius) * at.omega_size;
        constexpr double square_root = 0x1p26;
        double const fast = v_size / std::abs(at.omega), most = square_root * size;
        put(out, i, at, x + n.radius * n.n_x, y + n.radius * n.n_y, n.n_x, n.n_y, s / n.span,
            fast < most ? fast : most);
    }
}

HDCONJ_TARGETS
void angles(motion::CosineForm const& given, double const* u, double* phi, std::size_t count)
{
    motion::CosineForm const m = given;
#ifndef __clang__
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < count; ++i)
        phi[i] = wave_at(m, u[i]).phi;
}

}  // namespace

void undeformed_angles(motion::CosineForm const& motion, std::span<double const> u, std::span<double> phi)
{
    angles(motion, u.data(), phi.data(), u.size());
}

ContactBatch::ContactBatch(motion::CosineForm const& motion, profile::PieceShape const& shape, int side, double offset)
    : numbers_{}, line_(std::holds_alternative<profile::LinePiece>(shape))
{
    numbers_.motion = motion;
    if (line_) {
        auto const& line = std::get<profile::LinePiece>(shape);
        Vec2 const n = line.normal(), t = line.tangent();
        numbers_ = {motion, line.a.x(), line.a.y(), n.x(), n.y(), t.x(), t.y(), offset, 0, line.length(), 0};
        return;
    }
    auto const& arc = std::get<profile::ArcPiece>(shape);
    Vec2 const middle = direction(0.5 * (arc.from + arc.to));
    numbers_ = {motion,
                arc.centre.x(),
                arc.centre.y(),
                middle.x(),
                middle.y(),
                0,
                0,
                arc.radius + offset,
                static_cast<double>(side),
                arc.to - arc.from,
                arc.centre.norm()};
}

void ContactBatch::operator()(std::span<double const> u, std::span<EnvelopePoint> points) const
{
    Columns columns;
    for (std::size_t first = 0; first < u.size(); first += block) {
        std::size_t const count = std::min(block, u.size() - first);
        std::copy_n(u.begin() + static_cast<std::ptrdiff_t>(first), count, columns.u);
        line_ ? on_line(numbers_, columns, count) : on_arc(numbers_, columns, count);
        for (std::size_t i = 0; i < count; ++i)
            points[first + i] = {columns.u[i],
                                 columns.t[i],
                                 {columns.x[i], columns.y[i]},
                                 {columns.n_x[i], columns.n_y[i]},
                                 columns.error[i]};
    }
}

}  // namespace hdconj::envelope
