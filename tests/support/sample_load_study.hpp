// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A load study to write, made without the solver: the inextensional cup, two-stage curves and pressures by formulas
/// that look like a short cup's. Right shape and size for files and pictures, not a reference for numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hdconj/load.hpp"
#include "sample_contact_study.hpp"

namespace hdconj::sample {

inline constexpr double nm = 1000;                    // N mm
inline constexpr double nm_per_degree = nm / degree;  // N mm/rad
inline constexpr double rated_torque = 28 * nm;
inline constexpr double minute = degree / 60;

/// Two lines that meet at @p knee, from half the play on.
struct TwoStages
{
    double backlash = 6.2 * minute, first = 98.7 * nm_per_degree, second = 182.8 * nm_per_degree, knee = 12 * nm;

    [[nodiscard]] double twist(double torque) const
    {
        double const size = std::abs(torque);
        double const elastic = size <= knee ? size / first : knee / first + (size - knee) / second;
        return torque == 0 ? 0 : std::copysign(backlash / 2 + elastic, torque);
    }
};

inline LoadedState loaded_state(TwoStages const& stages, double torque, double side)
{
    LoadedState state;
    double const share = std::abs(torque) / rated_torque;
    state.torque = torque;
    state.twist = torque == 0 ? side * stages.backlash / 2 : stages.twist(torque);
    state.stiffness = std::abs(torque) <= stages.knee ? stages.first : stages.second;
    state.teeth = static_cast<int>(58 * std::sqrt(share));
    state.contact_area = 21 * share;
    state.contact_fraction = 0.023 * share;
    state.fraction_within_gap = 0.11 * std::sqrt(share);
    state.carrying_fraction = 0.19 * share;
    state.largest_pressure = 1210 * std::sqrt(share);
    state.pressure_space = 61;
    state.pressure_z = -half_width;
    state.largest_force = 31.5 * share;
    state.largest_line_load = 24 * share;
    state.flank_pressure = 850 * std::sqrt(share);
    state.edge_force = 8 * share;
    state.edge_fraction = 0.4;
    state.flowing_fraction = 0.15;
    state.wave_generator_force = 3992 + 1800 * share;
    state.wave_generator_torque = torque / 100;
    state.largest_stress = 454 + 40 * share;
    state.stress_z = -4.4;
    state.stress_r = 24.4;
    state.stress_phi = 0.1;
    state.iterations = 4;
    state.steps = 19;
    state.gap_mismatch = 2e-7;
    state.complementarity = 3e-12;
    return state;
}

/// Flank pressures about 20 degrees behind the major axis, more at the rear edge.
inline LoadMap load_map(std::vector<double> const& z, int spaces)
{
    LoadMap map;
    map.torque = rated_torque;
    map.z = z;
    for (int s = 0; s < spaces; ++s)
        map.angle.push_back(std::numbers::pi * ((s + 0.5) / spaces - 0.5));
    for (double const angle : map.angle) {
        for (int const flank : {GapMap::left, GapMap::right}) {
            for (double const height : z) {
                double const hill = std::cos(angle - 0.35),
                             edge = 0.5 - 0.5 * height / half_width * std::cos(2 * angle);
                double const load = flank == GapMap::right ? std::max(0.0, std::pow(hill, 3) * edge - 0.25) * 9 : 0.0;
                map.line_load.push_back(load);
                map.force.push_back(load * 2 * half_width / static_cast<double>(z.size()));
                map.pressure.push_back(480 * std::sqrt(load));
                map.gap.push_back(load > 0 ? -1e-4 * load : 0.004);
                map.height.push_back(0.4);
            }
        }
    }
    return map;
}

inline LoadCase load_case(ToothSurface surface, std::optional<TiltKind> kind, double tilt, TwoStages const& stages,
                          std::vector<double> const& z)
{
    LoadCase result;
    result.surface = surface;
    result.kind = kind;
    result.tilt = tilt;
    result.backlash_offset = 0.009;
    result.backlash = stages.backlash;
    constexpr int points = 14;
    auto const run = [&](double from, double to, double side) {
        for (int i = 1; i <= points; ++i)
            result.curve.push_back(loaded_state(stages, from + (to - from) * i / points, side));
    };
    result.curve.push_back(loaded_state(stages, -rated_torque, -1));
    run(-rated_torque, 0, -1);
    run(0, rated_torque, 1);
    result.rated = result.curve.size() - 1;
    result.map = load_map(z, 101);
    result.contacts = {{0, 1, 0, Vec2(-0.1, 25), Vec2(1, 0), 25, 3, 0.01}};
    result.stages = {
        stages.first, stages.second, stages.knee, stages.twist(stages.knee), 0.4 * nm_per_degree, 0.6 * nm_per_degree,
        0.1 * nm,     0.05 * nm,     true};
    result.seconds = 0.9;
    return result;
}

/// Bottom plate and barrel wall of quadrilaterals; every fourth node is a corner of nothing, as the middle of a side
/// is.
inline CupShape cup_shape()
{
    CupShape shape;
    constexpr double bottom = -9, thickness = 0.5, clamp = 13, inner = 24;
    auto const node = [&](double r, double z) {
        if (shape.r.size() % 4 == 3) {
            shape.r.push_back(r);
            shape.z.push_back(z);
        }
        shape.r.push_back(r);
        shape.z.push_back(z);
        return static_cast<int>(shape.r.size()) - 1;
    };
    // Sections across plate and wall, from the clamp to the open end: the first of each pair on the outside of the cup.
    std::vector<std::array<int, 2>> across;
    for (int i = 0; i <= 11; ++i) {
        double const r = clamp + i * (inner - clamp) / 11;
        across.push_back({node(r, bottom), node(r, bottom + thickness)});
    }
    for (int i = 0; i <= 24; ++i) {
        double const z = -8.2 + i * (6 + 8.2) / 24;
        double const wall = z > -4.6 && z < 4.6 ? 0.7 : 0.4;
        across.push_back({node(inner + wall, z), node(inner, z)});
    }
    for (std::size_t i = 0; i + 1 < across.size(); ++i) {
        shape.cells.push_back({across[i][0], across[i + 1][0], across[i + 1][1], across[i][1]});
    }
    constexpr int angles = 36;
    for (int a = 0; a < angles; ++a)
        shape.phi.push_back(std::numbers::pi * a / angles);
    for (double const phi : shape.phi) {
        for (std::size_t p = 0; p < shape.r.size(); ++p) {
            double const factor = std::max(0.0, (shape.z[p] - apex) / (0 - apex));
            shape.u_r.push_back(deformation * factor * std::cos(2 * phi));
            shape.u_t.push_back(-deformation / 2 * factor * std::sin(2 * phi) + 0.01 * factor);
            shape.u_z.push_back(-0.18 * std::cos(2 * phi) * shape.r[p] / inner *
                                std::min(1.0, (shape.r[p] - clamp) / 5));
            shape.stress.push_back(120 +
                                   330 * std::exp(-std::pow((shape.z[p] + 4.6) / 1.5, 2)) * std::pow(std::cos(phi), 2) +
                                   90 * (inner + 1 - shape.r[p]) / (inner - clamp));
        }
    }
    return shape;
}

inline LoadStudy load_study(int slice_count = 9)
{
    LoadStudy study;
    study.solution = solution();
    study.solution.scene.slices = Slices{slice_count, ToothSurface::tilted, 5};
    study.solution.circular_spline = slices(study.solution.circular_spline, slice_count, 0.2 * degree);
    auto const& z = study.solution.circular_spline.z;
    study.cases = {load_case(ToothSurface::tilted, std::nullopt, 0,
                             {7.8 * minute, 55.6 * nm_per_degree, 131.5 * nm_per_degree, 13 * nm}, z),
                   load_case(ToothSurface::tilted, TiltKind::radial, 0.2 * degree, {}, z),
                   load_case(ToothSurface::tilted, TiltKind::draft, 0.2 * degree,
                             {5.1 * minute, 120 * nm_per_degree, 240 * nm_per_degree, 11 * nm}, z)};
    study.cases[0].side_clearance_increased = true;
    study.cases[0].tip = 25.107695;
    study.cases[0].cleared = true;
    study.cases[0].given_tips = TipInterference{0.0004, 25.1004};
    study.cases[2].tip = 25.03;
    study.cases[2].tip_radius_increase = 0.0827;
    constexpr double nm_per_rad = 1000;
    study.cases[1].catalogue = CatalogueFigures{.torque = {4.9 * nm, 17.5 * nm, 1.12 * nm},
                                                .k1 = {5600 * nm_per_rad, 300 * nm_per_rad},
                                                .k2 = {10500 * nm_per_rad, 500 * nm_per_rad},
                                                .k3 = {12000 * nm_per_rad, 900 * nm_per_rad},
                                                .lost_motion = 7 * minute,
                                                .lost_motion_error = 0.3 * minute,
                                                .estimated = true};
    study.cases[1].members = {{"half of the backlash", 0, 3.1 * minute, 0.3},
                              {"shaft", 13.3e3 * nm_per_rad, 7.23 * minute, 0.7}};
    study.written_case = 1;
    study.shape = cup_shape();
    auto& cup = study.cup;
    cup.coning_major = 1.244 * degree;
    cup.coning_minor = -1.293 * degree;
    cup.z = z;
    for (double const height : z) {
        cup.w_major.push_back(amplitude_at(height));
        cup.w_minor.push_back(-0.84 * amplitude_at(height));
    }
    cup.wave_generator_force = 3992;
    cup.contacts = 212;
    cup.largest_stress = 454;
    study.harmonics = 24;
    study.sectors = 2;
    study.contact_gap = contact_gap;
    study.rated_torque = rated_torque;
    study.pitch_radius = 25;
    return study;
}

}  // namespace hdconj::sample
