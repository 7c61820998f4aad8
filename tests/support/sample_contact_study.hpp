// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A contact study to write, made without the solver: slices of the sample's outline moved as a radial tilt does, gaps
/// by a formula that looks like a short cup's. Right shape and size for files and pictures, not a reference for
/// numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hdconj/contact.hpp"
#include "sample_solution.hpp"

namespace hdconj::sample {

inline constexpr double degree = std::numbers::pi / 180;
inline constexpr double apex = -8.57;      // z of the cone's apex
inline constexpr double half_width = 3.5;  // of the circular spline
inline constexpr double contact_gap = 1e-3;

inline double amplitude_at(double z)
{
    return deformation * (z - apex) / (0 - apex);
}

/// Slices at equal distances, the outline moved radially by z tan(tilt). Landmarks of a whole outline: land corners,
/// ends of the flanks.
inline CircularSplineOutline slices(CircularSplineOutline const& one, int count, double tilt)
{
    CircularSplineOutline result;
    auto const& flat = one.outline.front();
    for (int k = 0; k < count; ++k) {
        double const z = count == 1 ? 0 : half_width * (2.0 * k / (count - 1) - 1);
        result.z.push_back(z);
        result.outline.push_back(flat);
        for (auto& point : result.outline.back())
            point.y() += z * std::tan(tilt);
        // Still from mid-land to mid-land.
        double const half_pitch = std::numbers::pi / circular_spline_teeth;
        for (auto* const end : {&result.outline.back().front(), &result.outline.back().back()})
            *end = end->norm() * Vec2(std::copysign(std::sin(half_pitch), end->x()), std::cos(half_pitch));
    }
    int const last = static_cast<int>(flat.size()) - 1, middle = last / 2;
    int end = last - 1;
    while (end > middle + 2 &&
           flat[static_cast<std::size_t>(end - 1)].x() > flat[static_cast<std::size_t>(middle + 1)].x()) {
        --end;
    }
    result.landmarks = {1, last - end, middle, end, last - 1};
    result.pieces = one.pieces;
    return result;
}

/// Gap of the driving (right) or the other flank: closed about @p angle 20 deg behind the major axis, opening to both
/// sides, tipped in z by a cone that the tilt meets only in part.
inline double gap_at(double angle, int flank, double z, double station, double deepest)
{
    double const turned = std::remainder(angle - 0.3, std::numbers::pi);
    double const opening = 0.16 * std::pow(std::sin(turned), 4) + 0.002 * std::pow(std::sin(turned), 2);
    double const cone = 0.0045 * std::pow(z / half_width - 0.55 * std::cos(2 * turned), 2);
    double const form = 0.006 * std::pow(station - 0.42 - 0.22 * std::sin(turned) - 0.06 * z, 2);
    double const ripple = 0.00025 * (1 + std::cos(23 * turned)) + 0.0001 * std::pow(std::sin(angle / 2), 2);
    return (flank == GapMap::right ? 0 : 0.052) + deepest + opening + cone + form + ripple;
}

inline GapMap gap_map(std::vector<double> const& z, int spaces, int stations, double deepest = 0)
{
    GapMap map;
    map.z = z;
    for (int p = 0; p < stations; ++p)
        map.station.push_back(static_cast<double>(p) / (stations - 1));
    for (int s = 0; s < spaces; ++s)
        map.angle.push_back(std::remainder(2 * std::numbers::pi * s / spaces - 0.01, 2 * std::numbers::pi));
    for (double const angle : map.angle) {
        for (int const flank : {GapMap::left, GapMap::right}) {
            for (double const height : map.z) {
                for (double const station : map.station)
                    map.gap.push_back(gap_at(angle, flank, height, station, deepest));
            }
        }
    }
    return map;
}

inline ContactState contact_state(double share, double play)
{
    ContactState state;
    state.wave_generator = 0.01;
    state.turn_to_contact = 0.6 * play;
    state.reverse_turn_to_contact = 0.4 * play;
    state.contact_fraction = share;
    state.contact_fraction_error = 4e-4;
    state.contact_area = share * 915.5;
    state.contact_area_error = 0.3;
    state.teeth = static_cast<int>(300 * share);
    state.teeth_least = state.teeth - 1;
    state.teeth_most = state.teeth + 2;
    state.turn_to_contact_error = 1e-7;
    state.reverse_turn_to_contact_error = 2e-7;
    state.smallest_gap = 2.5e-4;
    state.smallest_gap_error = 3e-6;
    state.smallest_space = 7;
    state.smallest_z = -half_width;
    return state;
}

/// @param best  tilt where its least side clearance is smallest and its area largest [rad]
inline ContactCase contact_case(ToothSurface surface, std::optional<TiltKind> kind, double tilt, double best,
                                std::vector<double> const& z)
{
    ContactCase result;
    result.surface = surface;
    result.kind = kind;
    result.tilt = tilt;
    double const off = std::abs(tilt - best) / degree;
    double const offset =
        surface == ToothSurface::per_slice ? 0 : 0.009 + (kind == TiltKind::draft ? 0.14 : 0.045) * off;
    result.least_side_clearance = result.backlash_offset = offset;
    result.side_clearance_increased = off > 1.5;
    result.least_tip_radius = tip_radius + (off > 1 ? 0.02 : 0);
    result.tip = tip_radius + (off > 1 ? 0.01 : 0);
    result.backlash_of_least_side_clearance = 2.1 * offset / 25.25;
    for (double const height : z) {
        SliceClearance slice;
        slice.z = height;
        slice.amplitude = amplitude_at(height);
        slice.flank = {-offset * std::abs(height) / half_width + 1e-10, Vec2(-0.21, 25.31), 0.4 + 0.05 * height};
        slice.root = {0.012 - 0.004 * height, Vec2(0.03, 25.47), 0.02};
        slice.flank_error = 1e-6 * (1 + static_cast<double>(result.slices.size()));
        slice.root_error = 2 * slice.flank_error;
        result.slices.push_back(slice);
    }
    double const share = surface == ToothSurface::per_slice
                             ? 0.31
                             : 0.05 + 0.17 / (1 + std::pow(off / (kind == TiltKind::draft ? 0.1 : 0.35), 2));
    result.state = contact_state(share, result.backlash_of_least_side_clearance);
    result.state.flank_area = 915.5;
    result.state.flank_area_error = 0.07;
    result.ruled_deviation = surface == ToothSurface::ruled ? 0.0034 : 0;
    result.clearance_error = 2e-5;
    result.root_clearance_error = 3e-5;
    result.least_side_clearance_error = 1.2e-5;
    result.least_tip_radius_error = 1e-6;
    result.least_root_clearance_error = 4e-6;
    result.backlash_of_least_side_clearance_error = 5e-7;
    result.ruled_deviation_error = surface == ToothSurface::ruled ? 1e-5 : 0;
    result.seconds = 0.11;
    return result;
}

inline ContactStudy contact_study(int slice_count = 9)
{
    ContactStudy study;
    study.solution = solution();
    study.solution.scene.coning.emplace().model = ConingModel::linear;
    study.solution.scene.tilt = Tilt{0.6 * degree, TiltKind::radial, 4};
    study.solution.scene.slices = Slices{slice_count, ToothSurface::tilted, 5};
    study.solution.circular_spline = slices(study.solution.circular_spline, slice_count, 0.6 * degree);
    auto const& z = study.solution.circular_spline.z;
    for (int i = 0; i <= 10; ++i)
        study.cases.push_back(contact_case(ToothSurface::tilted, TiltKind::radial, 0.2 * i * degree, 0.77 * degree, z));
    for (int i = 0; i <= 10; ++i)
        study.cases.push_back(contact_case(ToothSurface::tilted, TiltKind::draft, 0.2 * i * degree, 0.21 * degree, z));
    study.cases.push_back(contact_case(ToothSurface::ruled, std::nullopt, 0, 0.05 * degree, z));
    study.cases.push_back(contact_case(ToothSurface::per_slice, std::nullopt, 0, 0, z));
    study.written_case = 3;
    for (int i = 0; i < 5; ++i)
        study.cases[3].revolution.push_back(contact_state(0.19 + 0.01 * i, 0.002));
    study.best = {
        {TiltGoal::contact_area, TiltKind::radial, 0.77 * degree, 1e-4 * degree, 0.22, 0.004, false, 0, 2 * degree},
        {TiltGoal::least_side_clearance, TiltKind::radial, 0.77 * degree, 1e-4 * degree, 0.009, 1e-5, false, 0,
         2 * degree},
        {TiltGoal::contact_area, TiltKind::draft, 0.21 * degree, 1e-4 * degree, 0.22, 0.004, true, 0, 2 * degree}};
    study.contact_gap = contact_gap;
    study.pitch_radius = 25;
    study.map = gap_map(z, static_cast<int>(circular_spline_teeth), 41);
    return study;
}

}  // namespace hdconj::sample
