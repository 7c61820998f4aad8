// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a test rig would log of a drive with play, two stages and friction.
#pragma once

#include <cmath>
#include <random>

#include "hdconj/measured.hpp"
#include "sample_load_study.hpp"

namespace hdconj::sample {

struct Rig
{
    TwoStages drive;
    double torque = rated_torque;
    int cycles = 4;
    int per_branch = 200;
    double angle_noise = 0;    ///< standard deviation [rad]
    double angle_step = 0;     ///< readings to the next step [rad]; 0: exact
    double friction = 0;       ///< the angle lags by this on either side [rad]
    double coulomb = 0;        ///< torque that friction takes on either side [N mm]
    double drift = 0;          ///< of the angle from the first reading to the last [rad]
    double strays = 0;         ///< fraction of readings that are off
    double stray_size = 0;     ///< by this, either way [rad]
    double offset = 0;         ///< of the angle [rad]
    double torque_offset = 0;  ///< what the torque reads without load [N mm]
    bool last_stretch = true;  ///< up to 1/28 of the torque again, as the thesis does
    unsigned seed = 1;
};

inline MeasuredCurve rig_loop(Rig const& rig)
{
    MeasuredCurve curve;
    curve.file = "curve.csv";
    curve.columns = "angle [rad], torque [N mm]";
    std::mt19937 random(rig.seed);
    std::normal_distribution<double> noise;
    double play = 1;  // side of the play that the drive lies at
    auto const add = [&](double torque, double lag) {
        double const elastic = torque + lag * rig.coulomb;
        play = elastic > 0 ? 1 : elastic < 0 ? -1 : play;
        double twist = elastic == 0 ? play * rig.drive.backlash / 2 : rig.drive.twist(elastic);
        twist += rig.offset + lag * rig.friction + rig.angle_noise * noise(random);
        curve.twist.push_back(twist);
        curve.torque.push_back(torque + rig.torque_offset);
        curve.line.push_back(static_cast<int>(curve.line.size()) + 2);
    };
    auto const run = [&](double from, double to, int steps) {
        for (int i = 1; i <= steps; ++i)
            add(from + (to - from) * i / steps, to > from ? -1 : 1);
    };
    add(0, -1);
    for (int i = 0; i < rig.cycles; ++i) {
        run(0, rig.torque, rig.per_branch);
        run(rig.torque, 0, rig.per_branch);
        run(0, -rig.torque, rig.per_branch);
        run(-rig.torque, 0, rig.per_branch);
    }
    if (rig.last_stretch)
        run(0, rig.torque / 28, std::max(1, rig.per_branch / 28));
    std::uniform_real_distribution<double> chance(0, 1);
    for (std::size_t i = 0; i < curve.twist.size(); ++i) {
        curve.twist[i] += rig.drift * static_cast<double>(i) / static_cast<double>(curve.twist.size() - 1);
        if (rig.strays > 0 && chance(random) < rig.strays)
            curve.twist[i] += chance(random) < 0.5 ? -rig.stray_size : rig.stray_size;
        if (rig.angle_step > 0)
            curve.twist[i] = rig.angle_step * std::round(curve.twist[i] / rig.angle_step);
    }
    return curve;
}

}  // namespace hdconj::sample
