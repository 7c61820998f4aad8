// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Wire programs to write, made by formulas without the solver: a square hole, and a toothed ring r = R + a cos(z
/// theta) whose parallel curves are known exactly.
#pragma once

#include <cmath>
#include <numbers>

#include "hdconj/wedm.hpp"

namespace hdconj::sample {

inline constexpr double wire_tilt = 0.2 * std::numbers::pi / 180;

inline WireMachine wire_machine()
{
    return {7, 20, 30};
}

/// A square hole of 10 mm, smaller at the top: 0.2 degrees inwards over 7 mm, wire 0.100 mm, gap 0.012 mm.
inline WireProgram square_hole(double tilt = wire_tilt)
{
    WireProgram program;
    program.name = "square";
    program.machine = wire_machine();
    program.wire_diameter = 0.1;
    program.spark_gap = 0.012;
    double const half = 5, offset = 0.062, shift = program.machine.thickness * std::tan(tilt);
    auto const square = [](double h) { return std::vector<Vec2>{{-h, -h}, {h, -h}, {h, h}, {-h, h}}; };
    program.nominal = {square(half), square(half - shift), {0, 1, 2, 3}};
    WirePass pass;
    pass.offset = offset;
    double const low = half - offset, up = low - shift;
    auto const add = [&](double x, double y, WireTag tag) {
        pass.moves.push_back({Vec2(low * x, low * y), Vec2(up * x, up * y), tag, -1});
    };
    add(0, 0, WireTag::thread);
    add(0, -1, WireTag::lead_in);
    add(1, -1, WireTag::contour);
    add(1, 1, WireTag::contour);
    add(-1, 1, WireTag::contour);
    add(-1, -1, WireTag::contour);
    add(0, -1, WireTag::contour);
    add(0, 0, WireTag::lead_out);
    program.passes.push_back(pass);
    return program;
}

inline constexpr int wire_teeth = 24;
inline constexpr double ring_radius = 12, ring_depth = 0.35;

/// Point of the ring and its outward normal.
struct RingPoint
{
    Vec2 point, normal;
};

inline RingPoint ring_point(double theta, double lowered)
{
    double const r = ring_radius - lowered + ring_depth * std::cos(wire_teeth * theta);
    double const slope = -ring_depth * wire_teeth * std::sin(wire_teeth * theta);
    Vec2 const out = direction(theta), along = left_of(out);
    return {r * out, (r * out - slope * along).normalized()};
}

/// @p points per tooth space; passes leave the stock given; the upper face is smaller by T tan(tilt) along the radii.
inline WireProgram wire_ring(double tilt = wire_tilt, int points = 48,
                             std::vector<double> const& stock = {0.02, 0.005, 0})
{
    WireProgram program;
    program.teeth = wire_teeth;
    program.name = "ring";
    program.machine = wire_machine();
    program.wire_diameter = 0.1;
    program.spark_gap = 0.006;
    double const shift = program.machine.thickness * std::tan(tilt);
    int const count = wire_teeth * points;
    // Tooth space t is centred on theta = 2 pi t / z; the path begins on the land before space 0.
    auto const theta = [&](int k) { return (2 * std::numbers::pi * k / points - std::numbers::pi) / wire_teeth; };
    for (int k = 0; k < count; ++k) {
        program.nominal.lower.push_back(ring_point(theta(k), 0).point);
        program.nominal.upper.push_back(ring_point(theta(k), shift).point);
        if (k % (points / 4) == 0)
            program.nominal.sync.push_back(static_cast<std::size_t>(k));
    }
    Vec2 const start = (ring_radius - 3) * direction(theta(0));
    int number = 0;
    for (double const left : stock) {
        WirePass pass;
        pass.number = ++number;
        pass.stock = left;
        pass.offset = program.wire_diameter / 2 + program.spark_gap + left;
        pass.reversed = number % 2 == 0;
        pass.moves.push_back({start, start, WireTag::thread, -1});
        constexpr int overlap = 5, before_end = 12;
        for (int i = 0; i <= count + overlap; ++i) {
            int const k = pass.reversed ? -i : i;
            auto const low = ring_point(theta(k), 0), up = ring_point(theta(k), shift);
            WireTag tag = i == 0 ? WireTag::lead_in : i > count ? WireTag::overlap : WireTag::contour;
            tag = number == 1 && i == count - before_end ? WireTag::stop : tag;
            int const space = ((k % count + count) % count) / points;
            pass.moves.push_back({Vec2(low.point - pass.offset * low.normal), Vec2(up.point - pass.offset * up.normal),
                                  tag, i == 0 ? -1 : space});
        }
        pass.moves.push_back({start, start, WireTag::lead_out, -1});
        program.passes.push_back(pass);
    }
    return program;
}

/// Residuals such as a thick wire leaves: at the roots of the teeth, some of them at flanks.
inline std::vector<Residual> residuals()
{
    std::vector<Residual> all;
    for (int t = 0; t < wire_teeth; ++t) {
        for (bool const upper : {false, true}) {
            Vec2 const where = ring_point(2 * std::numbers::pi * t / wire_teeth, 0).point;
            all.push_back({3, t, where, upper, 0.004 + 0.0005 * std::sin(t) + (upper ? 0.001 : 0), false});
            if (t % 5 == 0) {
                all.push_back({3, t, where, upper, 0.0012, true});
            }
        }
    }
    return all;
}

}  // namespace hdconj::sample
