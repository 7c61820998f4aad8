// SPDX-License-Identifier: GPL-3.0-or-later
// Loops of plain arithmetic over columns, compiled as contact_batch.cpp is.
#include "hdconj/envelope/chord_bound.hpp"

#include "sine_cosine.hpp"

namespace hdconj::envelope {
namespace {

constexpr std::size_t block = 256;

struct Columns
{
    alignas(64) double x[block + 1];
    double y[block + 1], n_x[block + 1], n_y[block + 1];
};

/// chord_error() and the bend of each chord; what the branches of that one keep apart is computed and not chosen.
HDCONJ_TARGETS
void look_at_chords(Columns const& given, double* errors, double* bends, std::size_t count)
{
#ifndef __clang__
#pragma GCC ivdep
#endif
    for (std::size_t i = 0; i < count; ++i) {
        double const x = given.x[i + 1] - given.x[i], y = given.y[i + 1] - given.y[i];
        double const a_x = given.n_x[i], a_y = given.n_y[i], b_x = given.n_x[i + 1], b_y = given.n_y[i + 1];
        double const length = std::sqrt(x * x + y * y);
        double const across_a = x * a_y - y * a_x, across_b = x * b_y - y * b_x;
        double const m0 = (x * a_x + y * a_y) / across_a, m1 = (x * b_x + y * b_y) / across_b;
        double const p = 3 * (m0 + m1), q = -2 * (2 * m0 + m1);
        double const under = q * q - 4 * p * m0;
        double const w = -0.5 * (q + std::copysign(std::sqrt(under > 0 ? under : 0.0), q));
        double const s = w / p, t = m0 / w;  // not finite where there is none, and then not inside
        double const at_s = std::abs(m0 * s * (1 - s) * (1 - s) - m1 * s * s * (1 - s));
        double const at_t = std::abs(m0 * t * (1 - t) * (1 - t) - m1 * t * t * (1 - t));
        double const first = s > 0 && s < 1 ? at_s : 0.0, second = t > 0 && t < 1 ? at_t : 0.0;
        double const error = next_order * length * (first > second ? first : second);
        double const graph = across_a * across_b > 0 ? error : length;
        errors[i] = length == 0 ? 0.0 : graph;
        double const bend = (a_x * b_y - a_y * b_x) / length;
        double const turned = length > 0 ? bend : 0.0;
        bends[i] = a_x * b_x + a_y * b_y > 0 ? turned : 0.0;
    }
}

}  // namespace

void chord_errors(std::span<EnvelopePoint const> points, std::span<double> errors, std::span<double> bends)
{
    Columns columns;
    for (std::size_t first = 0; first < errors.size(); first += block) {
        std::size_t const count = std::min(block, errors.size() - first);
        for (std::size_t i = 0; i <= count; ++i) {
            EnvelopePoint const& e = points[first + i];
            columns.x[i] = e.p.x();
            columns.y[i] = e.p.y();
            columns.n_x[i] = e.n.x();
            columns.n_y[i] = e.n.y();
        }
        look_at_chords(columns, &errors[first], &bends[first], count);
    }
}

}  // namespace hdconj::envelope
